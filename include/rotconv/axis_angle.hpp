#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <rotconv/angle.hpp>
#include <rotconv/reading.hpp>

namespace rotconv {

/// An axis n of any length but 0 and the angle about it. Eigen's type, which is in radians and has an axis of length 1,
/// converts to this one and back.
struct AxisAngle {
    // NOLINTBEGIN(*-by-value, google-explicit-constructor, *-member-init): so that Eigen's type goes in and out
    AxisAngle(const Eigen::Vector3d& direction, double size, AngleUnit angle_unit = AngleUnit::radians) noexcept
        : axis(direction), angle(size), unit(angle_unit) {}
    AxisAngle(const DynamicMatrix auto& direction, double size, AngleUnit angle_unit = AngleUnit::radians)
        : AxisAngle(sized<Eigen::Vector3d>(direction), size, angle_unit) {}
    AxisAngle(const Eigen::AngleAxisd& value) noexcept : AxisAngle(value.axis(), value.angle()) {}
    operator Eigen::AngleAxisd() const {
        return {unit == AngleUnit::degrees ? angle * radians_per_degree : angle, axis};
    }
    // NOLINTEND(*-by-value, google-explicit-constructor, *-member-init)

    Eigen::Vector3d axis;
    double angle;
    AngleUnit unit;
};

/// Euler's axis and angle. Singular at the identity, where any axis serves, and two-valued at a half-turn.
namespace axis_angle {

/// q ~ (|n| cos(angle/2), n sin(angle/2)) for an angle of any size. The axis may be 0 if the angle is 0 (degrees: 0
/// after reduction). Errors: not_finite, zero_axis.
[[nodiscard]] Reading to_rotation(const AxisAngle& value) noexcept;

/// n = v/|v| of the quaternion with the canonical sign, see Rotation::sign(), which at a half-turn chooses between n
/// and -n; angle = 2 atan2(|v|, w) in [0, pi] or [0, 180]; axis (1, 0, 0) if v is exactly 0. Worst error found: 1.64
/// eps.
[[nodiscard]] AxisAngle from_rotation(const Rotation& rotation, AngleUnit unit = AngleUnit::radians) noexcept;

/// Margin min(theta, pi - theta), condition max(1, 1/(2 sin(theta/2))).
[[nodiscard]] Sensitivity sensitivity(const Rotation& rotation) noexcept;

} // namespace axis_angle
} // namespace rotconv
