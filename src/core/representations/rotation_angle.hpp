#pragma once

#include <cmath>

#include <rotconv/reading.hpp>

#include "../numerics/elementary.hpp"

namespace rotconv {

/// The sine, of radians, with the same bits on every machine.
inline double sine_of(double angle) noexcept {
    return sine_cosine<double>(DoubleDouble(angle), AngleUnit::radians).sine;
}

/// The rotation of w, x, y, z in a row; |q|^2 in [1/4, 4), or nan.
inline Rotation rotation_at(const double* q) noexcept { return Rotation::near_unit(q[0], q[1], q[2], q[3]); }

/// sin^2 of half its angle.
inline double squared_sine_of_half(const Rotation& q) noexcept {
    return (q.x() * q.x() + q.y() * q.y() + q.z() * q.z()) / q.squared_norm();
}

/// The angle of a rotation of which this is that, to rounding.
inline double angle_of_squared_sine(double square) noexcept {
    return 2.0 * angle_of(std::sqrt(std::fmax(0.0, 1.0 - square)), std::sqrt(square), AngleUnit::radians).hi;
}

/// The angle of the rotation, in [0, pi].
inline double angle_of(const Rotation& rotation) noexcept {
    return 2.0 * angle_of(std::fabs(rotation.w()), rotation.vector_length(), AngleUnit::radians).hi;
}

/// The unit quaternion q/|q|.
inline Eigen::Vector4d unit(const Rotation& rotation) noexcept {
    return Eigen::Map<const Eigen::Vector4d>(rotation.components().data()) / std::sqrt(rotation.squared_norm());
}

/// The angle to the nearest half-turn, pi less its own angle, without cancellation.
inline double angle_to_half_turn(const Rotation& rotation) noexcept {
    return 2.0 * angle_of(rotation.vector_length(), std::fabs(rotation.w()), AngleUnit::radians).hi;
}

} // namespace rotconv
