#pragma once

#include <rotconv/angle.hpp>

#include "double_double.hpp"

namespace rotconv {

/// cos and sin of half an angle, times a common factor of either sign that no caller needs to know: a rotation's
/// quaternion may have any scale. As (1, tan) it carries one rounding where cos and sin carry two.
struct HalfAngle {
    double cosine;
    double sine;
};

/// Half of a finite angle of any size. In degrees it is reduced exactly, and multiples of 90 give pairs of 0, 1 and -1.
[[nodiscard]] HalfAngle half_of(double angle, AngleUnit unit) noexcept;
/// The same for an angle known to twice the precision.
[[nodiscard]] HalfAngle half_of(DoubleDouble angle, AngleUnit unit) noexcept;

/// The angle of the vector (x, y), in (-pi, pi] or (-180, 180]; multiples of 90 degrees are exact. 0 where both are 0.
[[nodiscard]] double angle_of(double y, double x, AngleUnit unit) noexcept;

/// cos and sin of an angle.
struct Direction {
    double cosine;
    double sine;
};

/// Of a finite angle of any size. In degrees it is reduced exactly, and multiples of 90 give 0, 1 and -1.
[[nodiscard]] Direction direction_of(double angle, AngleUnit unit) noexcept;

/// An angle in radians less its whole turns.
[[nodiscard]] double without_turns(double angle) noexcept;

/// 1 radian in the unit.
[[nodiscard]] double units_per_radian(AngleUnit unit) noexcept;

} // namespace rotconv
