#pragma once

#include <Eigen/Core>

#include <rotconv/reading.hpp>

namespace rotconv {

/// A 3x3 matrix R_ref_body, near a rotation or not.
using Dcm = Eigen::Matrix3d;

/// The direction cosine matrix: nine numbers, one-to-one, linear kinematics, no singular attitude (Stuelpnagel 1964,
/// section 3; his X is the transpose).
namespace dcm {

/// The rotation nearest to the matrix (its polar factor), for any matrix with a positive determinant.
///
/// The quaternion is the eigenvector of Davenport's symmetric matrix K to its largest eigenvalue, found by power steps.
/// They start from the column of K + I with the largest diagonal entry: Markley's choice (2008), and that of Baruh's
/// Eqs (5)-(8) made symmetric. Each step multiplies the error that the matrix's defect causes by that defect, so that
/// one step serves a matrix with a defect of up to 2e-9. For a matrix that is far from a rotation, the singular value
/// decomposition and Newton's method are used.
///
/// The defect is exact only above `reported_defect`; below, it is an upper bound. See defect().
/// Errors: not_finite; not_proper; rank_deficient, if the sum of the two smaller singular values is below 1e-12 of the
/// largest; defect above the tolerance. Worst error found: 4.27 eps.
[[nodiscard]] Reading to_rotation(const Dcm& matrix, double tolerance = default_tolerance) noexcept;
[[nodiscard]] Reading to_rotation(const DynamicMatrix auto& numbers, double tolerance = default_tolerance) {
    return to_rotation(sized<Dcm>(numbers), tolerance);
}

/// Largest singular value of M - (polar factor of M), that is max |s_i - 1| over the singular values of M.
/// @pre to_rotation(matrix) has a rotation
[[nodiscard]] double defect(const Dcm& matrix) noexcept;

/// Homogeneous form: (w^2 + x^2 - y^2 - z^2)/|q|^2 on the diagonal, 2(xy - wz)/|q|^2 and so on off it (Stuelpnagel,
/// section 3, gamma(u) transposed). Exact for quarter turns about the axes, whatever flags the caller is compiled with.
[[nodiscard]] Dcm from_rotation(const Rotation& rotation) noexcept;

/// Margin infinite, condition sqrt 2.
[[nodiscard]] Sensitivity sensitivity(const Rotation& rotation) noexcept;

/// The rates of the entries: M [w]_x, or [w]_x M in reference axes (Stuelpnagel section 1: Xdot = Omega X). Linear in
/// any matrix.
[[nodiscard]] Dcm rate(const Dcm& matrix, const Eigen::Vector3d& w, Frame frame = Frame::body) noexcept;

/// The angular velocity whose rate() is nearest to `rates` (least squares).
[[nodiscard]] Eigen::Vector3d angular_velocity(const Dcm& matrix, const Dcm& rates, Frame frame = Frame::body) noexcept;

// The rest is inline because it is short and often called.

[[gnu::always_inline]] inline Dcm from_rotation(const Rotation& rotation) noexcept {
    const double w = rotation.w();
    const double x = rotation.x();
    const double y = rotation.y();
    const double z = rotation.z();
    const double ww = rounded_product(w, w);
    const double xx = rounded_product(x, x);
    const double yy = rounded_product(y, y);
    const double zz = rounded_product(z, z);
    const double square = (ww + xx) + (yy + zz);
    const double xy = rounded_product(x, y);
    const double xz = rounded_product(x, z);
    const double yz = rounded_product(y, z);
    const double wx = rounded_product(w, x);
    const double wy = rounded_product(w, y);
    const double wz = rounded_product(w, z);
    Dcm m;                                        // times |q|^2, and half of that off the diagonal
    m << (ww - yy) + (xx - zz), xy - wz, xz + wy, //
        xy + wz, (ww - xx) + (yy - zz), yz - wx,  //
        xz - wy, yz + wx, (ww - xx) + (zz - yy);
    // An entry is 1 or -1 only where one of these four vanishes; then a division keeps it. Elsewhere the inverse is as
    // accurate, and quicker.
    if ((m(0, 0) * m(1, 1)) * (m(0, 1) * m(0, 2)) == 0.0) [[unlikely]] {
        m /= 0.5 * square;
    } else {
        m *= 2.0 / square;
    }
    m.diagonal() *= 0.5;
    return m;
}

} // namespace dcm
} // namespace rotconv
