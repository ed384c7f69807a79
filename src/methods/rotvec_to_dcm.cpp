#include "formulas.hpp"

#include "../core/numerics/elementary.hpp"
#include "../core/numerics/power_of_two.hpp"
#include "../core/numerics/quaternion_algebra.hpp"

namespace rotconv::formula::rotvec_to_dcm {
namespace {

/// I + a [r]_x + b [r]_x^2
void second_degree(const double* r, double a, double b, double* m) noexcept {
    const double x = r[0];
    const double y = r[1];
    const double z = r[2];
    Eigen::Map<RowMajor>{m} << 1.0 - b * (y * y + z * z), b * (x * y) - a * z, b * (x * z) + a * y, //
        b * (x * y) + a * z, 1.0 - b * (x * x + z * z), b * (y * z) - a * x,                        //
        b * (x * z) - a * y, b * (y * z) + a * x, 1.0 - b * (x * x + y * y);
}

} // namespace

/// Rodrigues 1840; Stuelpnagel 1964, section 6, exp: I + sin t/t [r]_x + (1 - cos t)/t^2 [r]_x^2.
void rodrigues(const double* r, double* m) noexcept {
    const double t = length(r);
    second_degree(r, std::sin(t) / t, (1.0 - std::cos(t)) / (t * t), m);
}

/// Rodrigues 1840 with 1 - cos t = 2 sin^2(t/2), which does not cancel.
void half_angle(const double* r, double* m) noexcept {
    const double t = length(r);
    const double half_sine = std::sin(0.5 * t);
    second_degree(r, std::sin(t) / t, 2.0 * (half_sine * half_sine) / (t * t), m);
}

/// Euler-Rodrigues parameters times t, t (cos t/2, sin t/2 n), over their squared norm; t by Dekker's products of 1971:
/// its rounding times t would be an error of the attitude.
void compensated(const double* r, double* m) noexcept {
    const double size = largest_magnitude(r[0], r[1], r[2]);
    if (size == 0.0) { // no axis
        second_degree(r, 1.0, 0.5, m);
        return;
    }
    const auto scale = PowerOfTwo::to_unit(size);
    const double v[3] = {scale(r[0]), scale(r[1]), scale(r[2])};
    const DoubleDouble t = root(sum_of_squares(v[0], v[1], v[2]));
    const auto half = sine_cosine<double>({0.5 * scale.undone(t.hi), 0.5 * scale.undone(t.lo)}, AngleUnit::radians);
    const double q[4] = {t.hi * half.cosine + t.lo * half.cosine, half.sine * v[0], half.sine * v[1], half.sine * v[2]};
    quat_to_dcm::homogeneous(q, m);
}

} // namespace rotconv::formula::rotvec_to_dcm
