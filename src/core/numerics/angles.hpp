#pragma once

#include <cstddef>

#include <rotconv/angle.hpp>

#include "double_double.hpp"
#include "row_batch.hpp"

namespace rotconv {

/// Plane vectors (x, y), one a row, not set at first. For `angles_of` both may be squared where they are not negative.
struct PlaneVectors {
    BatchColumn x, y;
    BatchColumn sine; ///< of the acute angle to the nearer axis: the smaller of |x| and |y| over the vector's length

    /// From x and y, for lengths between 2^-460 and 2^500.
    void set_sines(std::size_t rows) noexcept;
};

/// Angles as unevaluated sums.
struct Angles {
    BatchColumn hi, lo;
};

/// pi or 180, as hi + lo.
[[nodiscard]] DoubleDouble pi_in(AngleUnit unit) noexcept;

/// The angles of the vectors (x, |y|) from the x axis, in [0, pi] or [0, 180]. Multiples of 45 degrees are exact.
///
/// The arc sine, at half the price of std::atan2, multiplies the rounding of the acute angle's sine by at most 1; the
/// angle is counted from the nearer axis.
void angles_of(const PlaneVectors& vectors, std::size_t rows, AngleUnit unit, Angles& angles) noexcept;

} // namespace rotconv
