#include "angles.hpp"

#include <cmath>
#include <numbers>

#include "double_double.hpp"

namespace rotconv {
namespace {

/// (hi + lo) radians in degrees, for an angle of up to pi/4.
DoubleDouble degrees_of(double hi, double lo) noexcept {
    constexpr double high = 0x1.ca5dc18p+5; // 180/pi to 26 bits
    constexpr double low = 0x1.31e0fbdc30a97p-22;
    const Split angle = split(hi);
    return exact_sum_of_ordered(angle.high * high, angle.low() * high + (angle.value * low + lo * (high + low)));
}

/// The acute angle between a vector and the nearer axis, as sine and what the sine was rounded by over the cosine.
struct Acute {
    Lane sine, rest;
};

void acute_sines(const PlaneVectors& vectors, std::size_t rows, Acute& acute) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        const double x_sign = std::copysign(1.0, vectors.x[i]);
        const double y_sign = std::copysign(1.0, vectors.y[i]);
        const double x = vectors.x[i] * x_sign;
        const double y = vectors.y[i] * y_sign;
        const double x_low = vectors.x_low[i] * x_sign;
        const double y_low = vectors.y_low[i] * y_sign;
        const bool flat = y <= x;
        const Split small = split(flat ? y : x);
        const Split large = split(flat ? x : y);
        const double small_low = flat ? y_low : x_low;
        const double large_low = flat ? x_low : y_low;
        const Root length = root_of(small.high * small.high + large.high * large.high,
                                    (rest_of_square(small) + rest_of_square(large)) +
                                        2.0 * (small.value * small_low + large.value * large_low));
        const Split sine = split(small.value * length.inverse);
        const Split divisor = split(length.hi);
        acute.sine[i] = sine.value;
        acute.rest[i] = ((small.high - sine.high * divisor.high) +
                         ((small.low() - rest_of_product(sine, divisor)) + (small_low - sine.value * length.lo))) /
                        large.value;
    }
}

} // namespace

DoubleDouble half_turn_in(AngleUnit unit) noexcept {
    constexpr double pi_low = 1.2246467991473532e-16;
    return unit == AngleUnit::degrees ? DoubleDouble{180.0, 0.0} : DoubleDouble{std::numbers::pi, pi_low};
}

void angles_of(const PlaneVectors& vectors, std::size_t rows, AngleUnit unit, Angles& angles) noexcept {
    Acute acute; // NOLINT(*-member-init): written before it is read
    acute_sines(vectors, rows, acute);
    for (std::size_t i = 0; i < rows; ++i) {
        angles.hi[i] = std::asin(acute.sine[i]);
    }
    if (unit == AngleUnit::degrees) {
        for (std::size_t i = 0; i < rows; ++i) {
            const DoubleDouble angle = degrees_of(angles.hi[i], acute.rest[i]);
            angles.hi[i] = angle.hi;
            acute.rest[i] = angle.lo;
        }
    }
    const DoubleDouble half_turn = half_turn_in(unit);
    for (std::size_t i = 0; i < rows; ++i) {
        const bool diagonal =
            std::fabs(vectors.x[i]) == std::fabs(vectors.y[i]) &&
            std::copysign(1.0, vectors.x[i]) * vectors.x_low[i] == std::copysign(1.0, vectors.y[i]) * vectors.y_low[i];
        angles.hi[i] = diagonal ? 0.25 * half_turn.hi : angles.hi[i];
        acute.rest[i] = diagonal ? 0.25 * half_turn.lo : acute.rest[i];
    }
    for (std::size_t i = 0; i < rows; ++i) {
        const bool flat = std::fabs(vectors.y[i]) <= std::fabs(vectors.x[i]);
        const bool back = vectors.x[i] < 0.0;
        // counted from 0, from a half-turn backwards, or from a quarter turn either way
        const double halves = flat ? (back ? 1.0 : 0.0) : 0.5;
        const double sign = flat == back ? -1.0 : 1.0;
        const double angle = sign * angles.hi[i];
        const DoubleDouble sum = exact_sum_of_ordered(halves * half_turn.hi, angle);
        angles.hi[i] = sum.hi;
        angles.lo[i] = sum.lo + (halves * half_turn.lo + sign * acute.rest[i]);
    }
}

} // namespace rotconv
