#pragma once

#include <Eigen/Core>

#include <rotconv/angle.hpp>
#include <rotconv/reading.hpp>

namespace rotconv {

/// The vector theta n.
struct RotationVector {
    Eigen::Vector3d vector = Eigen::Vector3d::Zero();
    AngleUnit unit = AngleUnit::radians;
};

/// The exponential set, R = exp [theta n]_x (Stuelpnagel 1964, section 6; his s is this vector). A ball of radius pi
/// with opposite points of its surface identified: two-valued at half-turns.
namespace rotation_vector {

/// q ~ (cos(theta/2), r sin(theta/2)/theta), theta = |r| to twice the working precision: 2.5 eps up to |r| = 1e15; past
/// that the error grows with |r| 2^-104 (none for a vector along a coordinate axis). Fault: not_finite.
[[nodiscard]] Reading to_rotation(const RotationVector& value) noexcept;

/// r = v 2 arg(w, |v|)/|v|, norm at most pi, with |v| and the quotient to twice the working precision: 2.7 eps, where
/// rounding r alone takes up to 1.4. Tiny angles keep their relative accuracy.
[[nodiscard]] RotationVector from_rotation(const Rotation& rotation, AngleUnit unit = AngleUnit::radians) noexcept;

/// Margin pi - theta, condition (theta/2)/sin(theta/2), between 1 and pi/2.
[[nodiscard]] Figures figures(const Rotation& rotation) noexcept;

} // namespace rotation_vector
} // namespace rotconv
