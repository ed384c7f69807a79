#include <rotconv/mrp.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "../numerics/exact_number.hpp"
#include "../numerics/power_of_two.hpp"
#include "../numerics/quaternion_algebra.hpp"
#include "codec.hpp"
#include "rotation_angle.hpp"

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

/// m or its shadow -m/|m|^2, which is nearer to l if |m|^2 - 2 m l > 1.
template <class T> bool choose(const double* last, std::span<const double> rest, double* m) noexcept {
    // both at unit size: the shadow of a small vector is a large one
    const double largest = largest_magnitude(m[0], m[1], m[2]);
    const int exponent = PowerOfTwo::exponent_of_unit(largest);
    const int last_exponent = PowerOfTwo::exponent_of_unit(largest_magnitude(last[0], last[1], last[2]));
    const auto exact = exact_vector<T>(m, rest);
    const auto component = [&](std::size_t i) { return shifted(exact[i], -exponent); };
    const PowerOfTwo last_scale(-last_exponent);
    const T square = sum_of_squares(component(0), component(1), component(2));
    const T product = component(0) * T(last_scale(last[0])) + component(1) * T(last_scale(last[1])) +
                      component(2) * T(last_scale(last[2]));
    const T excess = shifted(square, 2 * std::max(exponent, -1000)) -
                     shifted(product, std::max(exponent + last_exponent + 1, -2000)) - T(1.0);
    if (!(to_double(excess) > 0.0)) {
        return true;
    }
    const T ratio = T(-1.0) / square;
    bool decided = true;
    for (std::size_t i = 0; i < 3; ++i) {
        decided = round_product(ratio, -2 * exponent, exact[i], largest, m[i]) && decided;
    }
    return decided;
}

bool choose_nearest(const Spec& /*spec*/, const double* last, DiagnosticSet /*diagnostics*/,
                    std::span<const double> rest, double* m) noexcept {
    return in_scalar_of(rest, 3, [&]<class T>(T /*scalar*/) { return choose<T>(last, rest, m); });
}

} // namespace

constinit const Codec codecs::mrp{.representation = {.name = RepresentationId::mrp,
                                                     .text = "mrp",
                                                     .size = 3,
                                                     .columns = {"mx", "my", "mz"},
                                                     .modifiers = {Modifier::passive},
                                                     .presets = presets_of_vectors},
                                  .range = "norm at most 1",
                                  .singular = "half-turn (changes to its shadow)",
                                  .singular_attitude = "a full turn",
                                  .formula = "tan(theta/4) n",
                                  .sensitivity = sensitivity_of<mrp::sensitivity>,
                                  .choose_nearest = choose_nearest,
                                  .rate = rate_of<Vector3d, mrp::rate>,
                                  .angular_velocity = angular_velocity_of<Vector3d, mrp::angular_velocity>,
                                  .greatest_distance = std::numbers::pi,
                                  .switch_chart = switch_to_shadow};

} // namespace rotconv
