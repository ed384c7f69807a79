#pragma once

#include <cstdint>

#include "../numerics/real.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// A power of two and its inverse.
struct Scale {
    double there;
    double back;
};

/// Brings a magnitude between 2^-1000 and 2^1000 into [1/2, 1), by 2^1000 at most.
[[nodiscard]] ROTCONV_INLINE Scale scale_to_unit(double magnitude) noexcept {
    const double at_least = magnitude > 0x1p-1000 ? magnitude : 0x1p-1000;
    const double limited = at_least < 0x1p1000 ? at_least : 0x1p1000;
    const std::uint64_t exponent = __builtin_bit_cast(std::uint64_t, limited) & 0x7ff0000000000000U;
    return {__builtin_bit_cast(double, 0x7fd0000000000000U - exponent),
            __builtin_bit_cast(double, exponent + 0x0010000000000000U)};
}

[[nodiscard]] ROTCONV_INLINE double larger_of(double a, double b) noexcept { return a > b ? a : b; }

[[nodiscard]] ROTCONV_INLINE double largest_magnitude(double x, double y, double z) noexcept {
    return larger_of(larger_of(__builtin_fabs(x), __builtin_fabs(y)), __builtin_fabs(z));
}

/// A vector times a power of two, the larger component of size 1/2 to 1, and its length without it.
template <class T> struct ScaledVector {
    ROTCONV_INLINE ScaledVector(T x_, T y_) noexcept {
        const Scale scale = scale_to_unit(largest_magnitude(nearly(x_), nearly(y_), 0.0));
        x = scaled(x_, scale.there);
        y = scaled(y_, scale.there);
        length = scaled(root(quick_sum(square(x), square(y))), scale.back);
    }

    T x, y, length;
};

template <class T> [[nodiscard]] ROTCONV_INLINE Real sum_of_squares(T x, T y, T z) noexcept {
    return quick_sum(quick_sum(exact_square(x), exact_square(y)), exact_square(z));
}

[[nodiscard]] ROTCONV_INLINE bool all_finite(double x, double y, double z) noexcept {
    return (x - x) + (y - y) + (z - z) == 0.0;
}

} // namespace ROTCONV_TARGET
} // namespace rotconv
