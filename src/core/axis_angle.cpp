#include <rotconv/axis_angle.hpp>

#include <algorithm>
#include <cmath>

#include "finite.hpp"
#include "half_turn.hpp"
#include "scaling.hpp"
#include "trigonometry.hpp"

namespace rotconv::axis_angle {

Reading to_rotation(const AxisAngle& value) noexcept {
    if (!all_finite(value.axis.x(), value.axis.y(), value.axis.z(), value.angle)) {
        return Reading::failed(Fault::not_finite);
    }
    const HalfAngle half = half_of(value.angle, value.unit);
    const double size = value.axis.cwiseAbs().maxCoeff();
    if (size == 0.0) {
        const bool no_turn = value.unit == AngleUnit::degrees ? half.sine == 0.0 : value.angle == 0.0;
        return no_turn ? Reading{} : Reading::failed(Fault::zero_axis);
    }
    const Eigen::Vector3d axis = value.axis.unaryExpr(PowerOfTwo::to_unit(size));
    const Eigen::Vector3d v = axis * half.sine;
    return {.rotation = Rotation::from_components(axis.norm() * half.cosine, v.x(), v.y(), v.z())};
}

AxisAngle from_rotation(const Rotation& rotation, AngleUnit unit) noexcept {
    const double length = rotation.vector_length();
    if (length == 0.0) {
        return {.unit = unit};
    }
    return {.axis = {rotation.x() / length, rotation.y() / length, rotation.z() / length},
            .angle = 2.0 * angle_of(length, rotation.w(), unit),
            .unit = unit};
}

Notes notes(const Rotation& rotation) noexcept {
    Notes found = note_half_turn(rotation);
    found |= {Kind::identity_axis, rotation.x() == 0.0 && rotation.y() == 0.0 && rotation.z() == 0.0};
    return found;
}

Figures figures(const Rotation& rotation) noexcept {
    const double sine = rotation.vector_length() / std::sqrt(rotation.squared_norm());
    return {.margin = std::min(angle_of(rotation), angle_to_half_turn(rotation)),
            .condition = std::max(1.0, 0.5 / sine)};
}

} // namespace rotconv::axis_angle
