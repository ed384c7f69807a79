#pragma once

#include <numbers>

#include "elementary.hpp"
#include "wide.hpp"

namespace rotconv {

/// The whole turns that bring an angle nearest to another which is so far from it; none where it is half a turn.
[[nodiscard]] inline double nearest_turns(double difference, AngleUnit unit) noexcept {
    constexpr double shift = 1.5 * 0x1p52; // rounds to a whole number, halves to an even one
    return (difference / (2.0 * half_turn_in(unit).hi) + shift) - shift;
}

/// An angle plus so many half-turns, to the precision of the scalar.
[[nodiscard]] inline DoubleDouble plus_half_turns(DoubleDouble angle, double half_turns, AngleUnit unit) noexcept {
    return angle + half_turn_in(unit) * half_turns;
}
[[nodiscard]] inline Wide plus_half_turns(const Wide& angle, double half_turns, AngleUnit unit) noexcept {
    return angle + Wide::half_turn(unit == AngleUnit::degrees) * Wide(half_turns);
}

/// An angle in radians less its whole turns.
[[nodiscard]] inline double without_turns(double angle) noexcept {
    return plus_half_turns(DoubleDouble(angle), 2.0 * nearest_turns(-angle, AngleUnit::radians), AngleUnit::radians).hi;
}

/// 1 radian in the unit.
[[nodiscard]] inline double units_per_radian(AngleUnit unit) noexcept {
    return unit == AngleUnit::degrees ? degrees_per_radian : 1.0;
}

} // namespace rotconv
