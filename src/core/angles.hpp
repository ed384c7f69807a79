#pragma once

#include <array>
#include <cstddef>

#include <rotconv/angle.hpp>

#include "double_double.hpp"

namespace rotconv {

/// Rows that are worked on together, so that loops over them vectorise and stay in the first cache.
inline constexpr std::size_t block = 128;

/// One number of each row of a block.
using Lane = std::array<double, block>;

/// Plane vectors (x, y), one a row, with what x and y were rounded by; lengths between 2^-3 and 2^2.
struct PlaneVectors {
    Lane x, x_low, y, y_low; // written before they are read
};

/// Angles as unevaluated sums.
struct Angles {
    Lane hi, lo;
};

/// pi or 180, as hi + lo.
[[nodiscard]] DoubleDouble half_turn_in(AngleUnit unit) noexcept;

/// The angles of the vectors (x, |y|) from the x axis, in [0, pi] or [0, 180], to 2^-54 of the true angle and the
/// rounding of the arc sine. Multiples of 45 degrees are exact.
///
/// With m the smaller of |x| and |y|, it is the arc sine of m/|(x, y)| that is taken (at half the price of std::atan2),
/// corrected by what the quotient was rounded by, and counted from the nearer axis.
void angles_of(const PlaneVectors& vectors, std::size_t rows, AngleUnit unit, Angles& angles) noexcept;

} // namespace rotconv
