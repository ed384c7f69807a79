#pragma once

#include <Eigen/Core>

#include <rotconv/angle.hpp>
#include <rotconv/reading.hpp>

namespace rotconv {

/// The vector theta n. A vector of Eigen is one in radians.
struct RotationVector {
    // NOLINTBEGIN(*-by-value, google-explicit-constructor): so that to_rotation() takes a vector
    RotationVector(const Eigen::Vector3d& values, AngleUnit angle_unit = AngleUnit::radians) noexcept
        : vector(values), unit(angle_unit) {}
    template <class Derived>
    RotationVector(const Eigen::MatrixBase<Derived>& values, AngleUnit angle_unit = AngleUnit::radians)
        : vector(sized<Eigen::Vector3d>(values)), unit(angle_unit) {}
    // NOLINTEND(*-by-value, google-explicit-constructor)

    Eigen::Vector3d vector;
    AngleUnit unit;
};

/// The exponential set, R = exp [theta n]_x (Stuelpnagel 1964, section 6; his s is this vector). A ball of radius pi
/// with opposite points of its surface identified: two-valued at half-turns.
namespace rotation_vector {

/// q = (cos(theta/2), r sin(theta/2)/theta), with theta = |r| to twice the digits. Worst error found: 2.18 eps up to
/// |r| = 1e15. Beyond, the error grows with |r| 2^-104, except for a vector along a coordinate axis. Error: not_finite.
[[nodiscard]] Reading to_rotation(const RotationVector& value) noexcept;

/// r = v 2 arg(w, |v|)/|v| of the quaternion with the canonical sign, with a norm of at most pi, and with |v| and the
/// quotient to more digits than a double has. Worst error found: 1.48 eps, of which rounding r takes up to 1.4. Tiny
/// angles keep their relative accuracy.
[[nodiscard]] RotationVector from_rotation(const Rotation& rotation, AngleUnit unit = AngleUnit::radians) noexcept;

/// Margin pi - theta, condition (theta/2)/sin(theta/2), between 1 and pi/2.
[[nodiscard]] Sensitivity sensitivity(const Rotation& rotation) noexcept;

/// The rate of the vector, in its unit a second: g w + r x w/2 + (1 - g) n (n.w), the cross product negative in
/// reference axes, with g = (theta/2) cot(theta/2), n = r/theta. This is Stuelpnagel's equation of section 6 with the
/// sign of its second term corrected (in print it solves Xdot = X Omega), for the inverse; also Bortz (1971). Regular
/// for theta < 2 pi, with a pole at each full turn, near which theta is computed in double-double.
[[nodiscard]] Eigen::Vector3d rate(const RotationVector& value, const Eigen::Vector3d& w,
                                   Frame frame = Frame::body) noexcept;

/// The inverse of rate(), regular everywhere: s r' - c r x r' + (1 - s) n (n.r') with s = sin(theta)/theta and
/// c = (1 - cos(theta))/theta^2, the cross product positive in reference axes.
[[nodiscard]] Eigen::Vector3d angular_velocity(const RotationVector& value, const Eigen::Vector3d& rates,
                                               Frame frame = Frame::body) noexcept;

} // namespace rotation_vector
} // namespace rotconv
