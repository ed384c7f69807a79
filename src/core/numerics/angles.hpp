#pragma once

#include <cstddef>

#include <numbers>

#include <rotconv/angle.hpp>

#include "double_double.hpp"
#include "row_batch.hpp"

namespace rotconv {

/// pi or 180, as hi + lo.
[[nodiscard]] inline DoubleDouble pi_in(AngleUnit unit) noexcept {
    constexpr double pi_low = 1.2246467991473532e-16;
    return unit == AngleUnit::degrees ? DoubleDouble{180.0, 0.0} : DoubleDouble{std::numbers::pi, pi_low};
}

/// The whole turns that bring an angle nearest to another which is so far from it; none where it is half a turn.
[[nodiscard]] inline double nearest_turns(double difference, AngleUnit unit) noexcept {
    constexpr double shift = 1.5 * 0x1p52; // rounds to a whole number, halves to an even one
    return (difference / (2.0 * pi_in(unit).hi) + shift) - shift;
}

/// An angle plus so many half-turns, to twice the precision.
[[nodiscard]] inline DoubleDouble plus_half_turns(DoubleDouble angle, double half_turns, AngleUnit unit) noexcept {
    const DoubleDouble pi = pi_in(unit);
    const DoubleDouble turned = exact_product(half_turns, pi.hi);
    const DoubleDouble sum = exact_sum(angle.hi, turned.hi);
    return exact_sum_of_ordered(sum.hi, sum.lo + (angle.lo + (turned.lo + half_turns * pi.lo)));
}

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

/// The angles of the vectors (x, |y|) from the x axis, in [0, pi] or [0, 180]. Multiples of 45 degrees are exact.
///
/// The arc sine, at half the price of std::atan2, multiplies the rounding of the acute angle's sine by at most 1; the
/// angle is counted from the nearer axis.
void angles_of(const PlaneVectors& vectors, std::size_t rows, AngleUnit unit, Angles& angles) noexcept;

} // namespace rotconv
