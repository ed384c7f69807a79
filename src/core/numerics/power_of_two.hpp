#pragma once

#include <cstddef>
#include <cstdint>

#include "double_double.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

[[nodiscard]] ROTCONV_INLINE double larger_of(double a, double b) noexcept { return a > b ? a : b; }

/// Largest magnitude among the arguments.
template <class... Rest> [[nodiscard]] ROTCONV_INLINE double largest_magnitude(double first, Rest... rest) noexcept {
    double largest = __builtin_fabs(first);
    ((largest = larger_of(largest, __builtin_fabs(rest))), ...);
    return largest;
}

[[nodiscard]] ROTCONV_INLINE bool all_finite(const double* numbers, std::size_t count) noexcept {
    double sum = 0.0; // or nan
    for (std::size_t i = 0; i < count; ++i) {
        sum += numbers[i] - numbers[i];
    }
    return sum == 0.0;
}

/// A finite double as a whole number times a power of two.
struct Binary {
    ROTCONV_INLINE explicit Binary(double value) noexcept {
        const auto bits = __builtin_bit_cast(std::uint64_t, value);
        const auto biased = static_cast<int>((bits >> 52U) & 0x7ffU);
        digits = (bits & 0xfffffffffffffU) | (biased == 0 ? 0U : 0x10000000000000U);
        exponent = (biased == 0 ? 1 : biased) - 1075;
        is_negative = (bits >> 63U) != 0;
    }

    std::uint64_t digits; ///< below 2^53
    int exponent;         ///< from -1074 on
    bool is_negative;
};

/// The power of two that brings a plain magnitude into [1/2, 1).
[[nodiscard]] ROTCONV_INLINE double unit_scale(double magnitude) noexcept {
    const std::uint64_t exponent = __builtin_bit_cast(std::uint64_t, magnitude) & 0x7ff0000000000000U;
    return __builtin_bit_cast(double, 0x7fd0000000000000U - exponent);
}

/// An exact scaling of any number by a power of two, in two factors because one alone cannot span from 2^-1074 to
/// 2^1023.
class PowerOfTwo {
public:
    /// From 2^-2044 to 2^2046.
    explicit PowerOfTwo(int exponent) noexcept
        : first_(power_of_two(exponent / 2)), second_(power_of_two(exponent - exponent / 2)) {}
    /// e of a finite magnitude in [2^(e - 1), 2^e); 0 for 0.
    static int exponent_of_unit(double magnitude) noexcept {
        const bool tiny = magnitude < 0x1p-500;
        return magnitude == 0.0 ? 0 : exponent_of(tiny ? magnitude * 0x1p600 : magnitude) + 1 - (tiny ? 600 : 0);
    }
    /// The power that brings the finite `magnitude` into [1/2, 1); 1 for 0.
    static PowerOfTwo to_unit(double magnitude) noexcept { return PowerOfTwo(-exponent_of_unit(magnitude)); }

    [[nodiscard]] double operator()(double value) const noexcept { return (value * first_) * second_; }
    [[nodiscard]] double undone(double value) const noexcept { return (value / first_) / second_; }

private:
    double first_;
    double second_;
};

/// |(x, y, z)| of finite numbers, at any size: 0 only of 0.
[[nodiscard]] inline double norm_of(double x, double y, double z) noexcept {
    const double square = (x * x + y * y) + z * z;
    if (square > 0x1p-930 && square < 0x1p930) {
        return root(square);
    }
    const auto scale = PowerOfTwo::to_unit(largest_magnitude(x, y, z));
    const double a = scale(x);
    const double b = scale(y);
    const double c = scale(z);
    return scale.undone(root((a * a + b * b) + c * c));
}

} // namespace ROTCONV_TARGET
} // namespace rotconv
