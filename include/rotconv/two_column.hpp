#pragma once

#include <Eigen/Core>

#include <rotconv/dcm.hpp>
#include <rotconv/reading.hpp>

namespace rotconv {

/// The first two columns of R_ref_body, the first before the second in storage.
using TwoColumns = Eigen::Matrix<double, 3, 2>;

/// Two columns of the matrix, in nine minus three or nine minus four numbers. Both sets are one-to-one and have no
/// singular attitude (Stuelpnagel 1964, section 4).
namespace two_column {

/// Gram-Schmidt that keeps the first column's direction: e1 = c1/|c1|, e2 along c2 - (e1.c2) e1, e3 = e1 x e2.
/// The columns may have any length. The defect is exact only above `reported_defect`; below, it is an upper bound. See
/// defect(). Errors: not_finite, rank_deficient, defect above the tolerance.
[[nodiscard]] Reading to_rotation(const TwoColumns& m, double tolerance = default_tolerance) noexcept;
[[nodiscard]] Reading to_rotation(const DynamicMatrix auto& numbers, double tolerance = default_tolerance) {
    return to_rotation(sized<TwoColumns>(numbers), tolerance);
}

/// Largest singular value of M - (polar factor of M).
/// @pre to_rotation(m) has a rotation
[[nodiscard]] double defect(const TwoColumns& m) noexcept;

/// The first two columns of the matrix, as accurate as dcm::from_rotation().
[[nodiscard]] inline TwoColumns from_rotation(const Rotation& rotation) noexcept {
    return dcm::from_rotation(rotation).leftCols<2>();
}

/// Margin infinite, condition sqrt 2.
[[nodiscard]] Sensitivity sensitivity(const Rotation& rotation) noexcept;

/// The rates: both columns turn as a rigid pair, c' = w x c in reference axes, which is linear (Stuelpnagel section 4,
/// of the inverse: X0dot = Omega X0). With w in body axes, w is first turned to reference axes by the attitude of
/// to_rotation(), so that errors in the lengths of the columns and in the angle between them do not affect the motion.
/// The result is not finite where the columns' squares are 0 or not finite.
[[nodiscard]] TwoColumns rate(const TwoColumns& m, const Eigen::Vector3d& w, Frame frame = Frame::body) noexcept;

/// The angular velocity whose rate() is nearest to `rates` (least squares).
[[nodiscard]] Eigen::Vector3d angular_velocity(const TwoColumns& m, const TwoColumns& rates,
                                               Frame frame = Frame::body) noexcept;

} // namespace two_column

/// Hopf's five numbers: the entries of the two columns, over sqrt 2, are a point on the unit sphere of E6; these are
/// its stereographic projection from the pole a = (1, 0, 0, 0, 0, 0), y = (r21, r31, r12, r22, r32)/(sqrt 2 - r11). The
/// smallest set that is one-to-one and has no singular attitude (Stuelpnagel 1964, section 4; Hopf 1940).
namespace five_d {

using Vector5 = Eigen::Matrix<double, 5, 1>;

/// r11 = sqrt 2 (y'y - 1)/(y'y + 1), the other five 2 sqrt 2 y/(y'y + 1), then as two_column::to_rotation(). Worst
/// error found: 4.54 eps, and 4.34 eps on the way back.
[[nodiscard]] Reading to_rotation(const Vector5& y, double tolerance = default_tolerance) noexcept;
[[nodiscard]] Reading to_rotation(const DynamicMatrix auto& numbers, double tolerance = default_tolerance) {
    return to_rotation(sized<Vector5>(numbers), tolerance);
}

/// The defect of the two columns.
/// @pre to_rotation(y) has a rotation
[[nodiscard]] double defect(const Vector5& y) noexcept;

/// The projection in homogeneous form: the denominator (sqrt 2 - 1)(w^2 + x^2) + (sqrt 2 + 1)(y^2 + z^2) has no
/// cancellation.
[[nodiscard]] Vector5 from_rotation(const Rotation& rotation) noexcept;

/// Margin infinite, condition sqrt 2/(sqrt 2 - r11), between 0.59 and 3.41.
[[nodiscard]] Sensitivity sensitivity(const Rotation& rotation) noexcept;

/// The rates: h = ((y'y - 1)/2, y) is parallel to the columns, and y' = V h' + y h1', with h' as in two_column::rate()
/// and with V, which leaves out the first entry. In reference axes this is ((y'y - 1)/2 I - y y') V A a + V A V' y, of
/// the inverse (Stuelpnagel section 4).
[[nodiscard]] Vector5 rate(const Vector5& y, const Eigen::Vector3d& w, Frame frame = Frame::body) noexcept;

/// The angular velocity whose rate() is nearest to `rates` (least squares).
[[nodiscard]] Eigen::Vector3d angular_velocity(const Vector5& y, const Vector5& rates,
                                               Frame frame = Frame::body) noexcept;

} // namespace five_d
} // namespace rotconv
