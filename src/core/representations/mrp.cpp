#include <rotconv/mrp.hpp>

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "codec.hpp"
#include "half_turn.hpp"

namespace rotconv::mrp {
namespace {

/// B v, or B' v.
Eigen::Vector3d turned(const Eigen::Vector3d& m, const Eigen::Vector3d& v, bool transposed) noexcept {
    const Eigen::Vector3d turn = transposed ? v.cross(m) : m.cross(v);
    return (1.0 - m.squaredNorm()) * v + 2.0 * (turn + m.dot(v) * m);
}

} // namespace

Reading to_rotation(const Eigen::Vector3d& m) noexcept { return read_row({.name = RepresentationId::mrp}, m.data()); }

Eigen::Vector3d from_rotation(const Rotation& rotation) noexcept {
    Eigen::Vector3d m;
    write_row({.name = RepresentationId::mrp}, rotation, m.data());
    return m;
}

Sensitivity sensitivity(const Rotation& rotation) noexcept {
    const double norm = std::sqrt(rotation.squared_norm());
    return {.margin = angle_to_half_turn(rotation), .condition = 0.5 * norm / (norm + std::fabs(rotation.w()))};
}

Eigen::Vector3d rate(const Eigen::Vector3d& m, const Eigen::Vector3d& w, Frame frame) noexcept {
    return 0.25 * turned(m, w, frame == Frame::reference);
}

Eigen::Vector3d angular_velocity(const Eigen::Vector3d& m, const Eigen::Vector3d& rates, Frame frame) noexcept {
    const double stretch = 0.25 * (1.0 + m.squaredNorm());
    return turned(m, rates, frame == Frame::body) / (4.0 * stretch * stretch);
}

} // namespace rotconv::mrp

namespace rotconv {
namespace {

using Eigen::Vector3d;

/// -m/|m|^2 past |m| = 1.
void switch_to_shadow(double* numbers) noexcept {
    Eigen::Map<Vector3d> m(numbers);
    if (const double square = m.squaredNorm(); square > 1.0) {
        m /= -square;
    }
}

} // namespace

constinit const Codec codecs::mrp{.representation = {.name = RepresentationId::mrp,
                                                     .text = "mrp",
                                                     .size = 3,
                                                     .columns = {"mx", "my", "mz"},
                                                     .modifiers = {Modifier::passive},
                                                     .presets = presets_of_vectors,
                                                     .range = "norm at most 1",
                                                     .singular = "half-turn (changes to its shadow)",
                                                     .singular_attitude = "a full turn",
                                                     .formula = "tan(theta/4) n"},
                                  .turn_per_error = [](const double*) noexcept { return 4.0; },
                                  .sensitivity = sensitivity_of<mrp::sensitivity>,
                                  .rate = rate_of<Vector3d, mrp::rate>,
                                  .angular_velocity = angular_velocity_of<Vector3d, mrp::angular_velocity>,
                                  .greatest_distance = std::numbers::pi,
                                  .switch_chart = switch_to_shadow};

} // namespace rotconv
