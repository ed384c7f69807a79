#include <rotconv/mrp.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "../numerics/double_double.hpp"
#include "../numerics/scaling.hpp"
#include "codec.hpp"
#include "half_turn.hpp"

namespace rotconv::mrp {
namespace {

/// B v, or B' v.
Eigen::Vector3d turned(const Eigen::Vector3d& m, const Eigen::Vector3d& v, bool transposed) noexcept {
    const Eigen::Vector3d turn = transposed ? v.cross(m) : m.cross(v);
    return (1.0 - m.squaredNorm()) * v + 2.0 * (turn + m.dot(v) * m);
}

ROTCONV_TARGET_CLONES void write(const Spec& /*spec*/, double /*lock_margin*/, const Rotations& rotations,
                                 std::size_t rows, double* numbers, DiagnosticSet* diagnostics) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        const double sign = rotations.at(i).sign();
        const Split w = split(rotations.w[i] * sign);
        const Split x = split(rotations.x[i] * sign);
        const Split y = split(rotations.y[i] * sign);
        const Split z = split(rotations.z[i] * sign);
        const Root norm = root_of((w.high * w.high + x.high * x.high) + (y.high * y.high + z.high * z.high),
                                  (rest_of_square(w) + rest_of_square(x)) + (rest_of_square(y) + rest_of_square(z)));
        const DoubleDouble divisor = exact_sum(norm.hi, w.value);
        const DoubleDouble inverse = quotient(1.0, 0.0, {divisor.hi, divisor.lo + norm.lo, 1.0 / divisor.hi});
        numbers[3 * i] = product(x, inverse);
        numbers[3 * i + 1] = product(y, inverse);
        numbers[3 * i + 2] = product(z, inverse);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        diagnostics[i] = note_half_turn(rotations.at(i));
    }
}

} // namespace

Reading to_rotation(const Eigen::Vector3d& m) noexcept {
    if (!m.allFinite()) {
        return Error::not_finite;
    }
    // Times the square of a power of two f <= 1, so that |m|^2 cannot overflow.
    const auto scale = PowerOfTwo::to_unit(std::max(0.5, m.cwiseAbs().maxCoeff()));
    const double f = scale(1.0);
    const Split x = split(scale(m.x()));
    const Split y = split(scale(m.y()));
    const Split z = split(scale(m.z()));
    // The rounding of |m|^2 would be the largest part of the error where |m| is about 1 or more.
    const double w = (f * f - ((x.high * x.high + y.high * y.high) + z.high * z.high)) -
                     ((rest_of_square(x) + rest_of_square(y)) + rest_of_square(z));
    return Rotation::from_components(w, 2.0 * f * x.value, 2.0 * f * y.value, 2.0 * f * z.value);
}

Eigen::Vector3d from_rotation(const Rotation& rotation) noexcept {
    Eigen::Vector3d m;
    codecs::mrp.write_row({}, rotation, m.data());
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
                                  .read = read_each<Vector3d, mrp::to_rotation>,
                                  .write = mrp::write,
                                  .sensitivity = sensitivity_of<mrp::sensitivity>,
                                  .rate = rate_of<Vector3d, mrp::rate>,
                                  .angular_velocity = angular_velocity_of<Vector3d, mrp::angular_velocity>,
                                  .greatest_distance = std::numbers::pi,
                                  .switch_chart = switch_to_shadow};

} // namespace rotconv
