#include "formulas.hpp"

#include <numbers>

#include "../core/numerics/power_of_two.hpp"
#include "../core/numerics/quaternion_algebra.hpp"

namespace rotconv::formula::quat_to_rotvec {
namespace {

void along_vector_part(const double* q, double length, double angle, double* r) noexcept {
    Vector{r} = angle / length * Eigen::Map<const Eigen::Vector3d>(q + 1);
}

/// Twice the angle of (w, s.hi + s.lo), both positive: the arc tangent of an acute angle up to 45 degrees, where its
/// rounding is least, and what s.lo adds to it.
DoubleDouble twice_the_angle(double w, DoubleDouble s) noexcept {
    constexpr double pi_low = 1.2246467991473532e-16;
    const double norm = std::hypot(w, s.hi);
    const double added = 2.0 * (w / norm) * (s.lo / norm);
    if (s.hi <= w) {
        return {2.0 * std::atan2(s.hi, w), added};
    }
    const DoubleDouble angle = fast_two_sum(std::numbers::pi, -2.0 * std::atan2(w, s.hi));
    return {angle.hi, angle.lo + (pi_low + added)};
}

} // namespace

/// The angle from w = cos(theta/2), common property (in Shuster's survey of 1993 among others): 2 acos(w) v/|v|. The
/// quaternion is taken as it is: with w < 0 the vector is longer than pi, the same attitude.
void acos(const double* q, double* r) noexcept { along_vector_part(q, length(q + 1), 2.0 * std::acos(q[0]), r); }

/// The quaternion's logarithm, as in Sola 2017, logarithmic maps: 2 atan2(|v|, w) v/|v|, and for small angles, which
/// the library manif begins at |v|^2 = 1e-10, 2 v/w (1 - |v|^2/(3 w^2)). As there, a quaternion with w < 0 is
/// otherwise taken as it is: the vector is longer than pi, the same attitude.
void atan2(const double* q, double* r) noexcept {
    const double size = length(q + 1);
    const double tangent = size / q[0];
    if (std::fabs(tangent) < 1e-5) {
        along_vector_part(q, q[0], 2.0 * (1.0 - tangent * tangent / 3.0), r);
        return;
    }
    along_vector_part(q, size, 2.0 * std::atan2(size, q[0]), r);
}

/// The same of the quaternion with w >= 0, |v| by Dekker's products of 1971: angle and direction both have it as a
/// factor, and near a half-turn its rounding would be the largest part of the error.
void compensated(const double* q, double* r) noexcept {
    const double size = largest_magnitude(q[1], q[2], q[3]);
    if (size == 0.0) { // no direction
        r[0] = r[1] = r[2] = 0.0;
        return;
    }
    const auto scale = PowerOfTwo::to_unit(size);
    const double sign = q[0] < 0.0 ? -1.0 : 1.0;
    const double v[3] = {scale(sign * q[1]), scale(sign * q[2]), scale(sign * q[3])};
    const DoubleDouble s = root(sum_of_squares(v[0], v[1], v[2]));
    const DoubleDouble angle = twice_the_angle(sign * q[0], {scale.undone(s.hi), scale.undone(s.lo)});
    const double ratio = angle.hi / s.hi;
    const DoubleDouble back = two_prod(ratio, s.hi);
    const double ratio_low = (((angle.hi - back.hi) - back.lo) + (angle.lo - ratio * s.lo)) / s.hi;
    for (int i = 0; i < 3; ++i) {
        const DoubleDouble product = two_prod(v[i], ratio);
        r[i] = product.hi + (product.lo + v[i] * ratio_low);
    }
}

} // namespace rotconv::formula::quat_to_rotvec
