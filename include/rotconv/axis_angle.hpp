#pragma once

#include <Eigen/Core>

#include <rotconv/angle.hpp>
#include <rotconv/reading.hpp>

namespace rotconv {

/// An axis n of any length but 0 and the angle about it.
struct AxisAngle {
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
    double angle = 0.0;
    AngleUnit unit = AngleUnit::radians;
};

/// Euler's axis and angle. Singular at the identity, where any axis serves, and two-valued at a half-turn.
namespace axis_angle {

/// q ~ (|n| cos(angle/2), n sin(angle/2)) for an angle of any size. The axis may be 0 if the angle is 0 (degrees: 0
/// after reduction). Errors: not_finite, zero_axis.
[[nodiscard]] Reading to_rotation(const AxisAngle& value) noexcept;

/// n = v/|v| of the quaternion with the canonical sign, see Rotation::sign(), which at a half-turn chooses between n
/// and -n; angle = 2 atan2(|v|, w) in [0, pi] or [0, 180]; axis (1, 0, 0) if v is exactly 0. Accuracy: the table of
/// examples/accuracy.md.
[[nodiscard]] AxisAngle from_rotation(const Rotation& rotation, AngleUnit unit = AngleUnit::radians) noexcept;

/// Margin min(theta, pi - theta), condition max(1, 1/(2 sin(theta/2))).
[[nodiscard]] Sensitivity sensitivity(const Rotation& rotation) noexcept;

} // namespace axis_angle
} // namespace rotconv
