#include "formulas.hpp"

namespace rotconv::formula::quat_to_dcm {
namespace {

/// I + s (w [v]_x + [v]_x^2), which is the rotation of q for s = 2/|q|^2.
void with_scale(double s, const double* q, double* m) noexcept {
    const double w = q[0];
    const double x = q[1];
    const double y = q[2];
    const double z = q[3];
    Eigen::Map<RowMajor>{m} << 1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y), //
        s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x),                        //
        s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y);
}

double squared_norm(const double* q) noexcept { return (q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]); }

} // namespace

/// Stuelpnagel 1964, section 5, gamma(u) with |u| = 1 put into the diagonal.
void unit(const double* q, double* m) noexcept { with_scale(2.0, q, m); }

/// Shoemake 1994, Graphics Gems IV, Eul_FromQuat: the same with s = 2/|q|^2.
void two_over_norm(const double* q, double* m) noexcept { with_scale(2.0 / squared_norm(q), q, m); }

/// Baruh 1999, [R] in Euler parameters, over |q|^2.
void homogeneous(const double* q, double* m) noexcept {
    const double n = squared_norm(q);
    const double w = q[0];
    const double x = q[1];
    const double y = q[2];
    const double z = q[3];
    Eigen::Map<RowMajor>{m} << (w * w + x * x - y * y - z * z) / n, 2.0 * (x * y - w * z) / n,
        2.0 * (x * z + w * y) / n,                                                                 //
        2.0 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2.0 * (y * z - w * x) / n, //
        2.0 * (x * z - w * y) / n, 2.0 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n;
}

/// Stuelpnagel 1964, section 5, of q/|q|.
void normalise_first(const double* q, double* m) noexcept {
    const double norm = std::sqrt(squared_norm(q));
    const double normalised[4] = {q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm};
    unit(normalised, m);
}

} // namespace rotconv::formula::quat_to_dcm
