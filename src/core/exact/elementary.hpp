#pragma once

#include <cstddef>

#include <rotconv/angle.hpp>

#include "rotations.hpp"

namespace rotconv::ROTCONV_EXACT {

inline constexpr Real pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
inline constexpr Real radians_per_degree{0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62};
inline constexpr Real degrees_per_radian{0x1.ca5dc1a63c1f8p+5, -0x1.1e7ab456405f9p-49};

/// A half-turn.
[[nodiscard]] ROTCONV_INLINE Real half_turn_in(AngleUnit unit) noexcept {
    return unit == AngleUnit::degrees ? Real(180.0) : pi;
}

/// The cosines and sines of angles in radians or degrees, both with the wrong sign where the number of half-turns that
/// were taken off the angle is odd: a quaternion does not see that. Each to 2^-103 of itself, where the angle is a
/// double of any size or, as a sum, not nearer to a zero than to its own error. Multiples of 90 degrees are exact.
void sine_cosine(const Column& angles, std::size_t rows, AngleUnit unit, Column& cosines, Column& sines) noexcept;

/// The angles of the vectors (x, y) from the x axis, in [-pi, pi] or [-180, 180], to 2^-103 of themselves; 0 of (0, 0).
/// Components are below 2^400, the larger one above 2^-400 or 0.
void angles_of(const Column& x, const Column& y, std::size_t rows, AngleUnit unit, Column& angles) noexcept;

} // namespace rotconv::ROTCONV_EXACT
