#include "angles.hpp"

#include <algorithm>
#include <cmath>

#include "double_double.hpp"

namespace rotconv {
namespace {

/// Radians in degrees, for an angle of up to pi/4.
DoubleDouble degrees_of(double radians) noexcept {
    constexpr double high = 0x1.ca5dc18p+5; // 180/pi to 26 bits
    constexpr double low = 0x1.31e0fbdc30a97p-22;
    const Split angle = split(radians);
    return exact_sum_of_ordered(angle.high * high, angle.low() * high + angle.value * low);
}

} // namespace

ROTCONV_TARGET_CLONES void PlaneVectors::set_sines(std::size_t rows) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        const double x_size = std::fabs(x[i]);
        const double y_size = std::fabs(y[i]);
        sine[i] = (y_size <= x_size ? y_size : x_size) / std::sqrt(x_size * x_size + y_size * y_size);
    }
}

ROTCONV_TARGET_CLONES void angles_of(const PlaneVectors& vectors, std::size_t rows, AngleUnit unit,
                                     Angles& angles) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        angles.hi[i] = std::asin(vectors.sine[i]);
    }
    if (unit == AngleUnit::degrees) {
        for (std::size_t i = 0; i < rows; ++i) {
            const DoubleDouble angle = degrees_of(angles.hi[i]);
            angles.hi[i] = angle.hi;
            angles.lo[i] = angle.lo;
        }
    } else {
        std::fill_n(angles.lo.begin(), rows, 0.0);
    }
    const DoubleDouble half_turn = pi_in(unit);
    for (std::size_t i = 0; i < rows; ++i) {
        const double x = std::fabs(vectors.x[i]);
        const double y = std::fabs(vectors.y[i]);
        const double acute = x == y ? 0.25 * half_turn.hi : angles.hi[i];
        const double acute_low = x == y ? 0.25 * half_turn.lo : angles.lo[i];
        const bool flat = y <= x;
        const bool back = vectors.x[i] < 0.0;
        // counted from 0, from a half-turn backwards, or from a quarter turn either way
        const double halves = flat ? (back ? 1.0 : 0.0) : 0.5;
        const double sign = flat == back ? -1.0 : 1.0;
        const DoubleDouble sum = exact_sum_of_ordered(halves * half_turn.hi, sign * acute);
        angles.hi[i] = sum.hi;
        angles.lo[i] = sum.lo + (halves * half_turn.lo + sign * acute_low);
    }
}

} // namespace rotconv
