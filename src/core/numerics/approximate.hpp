#pragma once

#include <cstdint>

#include "double_double.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// A sum hi + lo that is not normalised: the scalar of a first phase, whose numbers count only where the bound on their
/// error proves that the exact ones round to them. With u = 2^-53, |a.lo| <= 2^-50 |a| and no product out of
/// DoubleDouble's range:
///     a b        to 2^-99 |a b|: a.lo b.lo is left out, and the low part, below 2^-49 |a b|, is rounded three times
///     a + b      to 2^-101 (|a| + |b|): of its parts only the low ones are rounded
///     root(a)    to 2^-99 root(a)
struct Approximate : TwoParts {
    using TwoParts::TwoParts;
    ROTCONV_INLINE constexpr Approximate(DoubleDouble value) noexcept : TwoParts(value.hi, value.lo) {}
};

ROTCONV_INLINE Approximate operator+(Approximate a, Approximate b) noexcept {
    const DoubleDouble high = two_sum(a.hi, b.hi);
    return {high.hi, high.lo + (a.lo + b.lo)};
}
ROTCONV_INLINE Approximate operator-(Approximate a, Approximate b) noexcept { return a + -b; }
ROTCONV_INLINE Approximate operator*(Approximate a, Approximate b) noexcept {
    const DoubleDouble high = two_prod(a.hi, b.hi);
    return {high.hi, __builtin_fma(a.hi, b.lo, __builtin_fma(a.lo, b.hi, high.lo))};
}
ROTCONV_INLINE Approximate root(Approximate a) noexcept {
    const double high = __builtin_sqrt(a.hi);
    return {high, (__builtin_fma(-high, high, a.hi) + a.lo) / (high + high)};
}
/// Where they differ by more than their errors.
ROTCONV_INLINE bool is_at_most(Approximate a, Approximate b) noexcept { return a.hi <= b.hi; }
/// What cancels is part of the bound.
ROTCONV_INLINE Approximate clean_difference(Approximate a, Approximate b) noexcept { return a - b; }

/// The same with |lo| <= ulp(hi)/2.
ROTCONV_INLINE Approximate normalized(Approximate a) noexcept {
    const DoubleDouble sum = fast_two_sum(a.hi, a.lo);
    return {sum.hi, sum.lo};
}

/// A sum hi + lo for formulas in which nothing is large. Products, below 8, have a high part that is a multiple of
/// 2^-48, so that sums of them, below 32, add the high parts without a rounding. Factors may be any numbers.
struct Fixed : TwoParts {
    using TwoParts::TwoParts;
};

ROTCONV_INLINE Fixed operator+(Fixed a, Fixed b) noexcept { return {a.hi + b.hi, a.lo + b.lo}; }
ROTCONV_INLINE Fixed operator-(Fixed a, Fixed b) noexcept { return {a.hi - b.hi, a.lo - b.lo}; }
/// The multiple of 2^-48 next to a b.
ROTCONV_INLINE double fixed_part(double a, double b) noexcept {
    constexpr double last_place = 0x1.8p4; // a number whose last place is 2^-48
    return __builtin_fma(a, b, last_place) - last_place;
}
ROTCONV_INLINE Fixed operator*(Fixed a, double b) noexcept {
    const double high = fixed_part(a.hi, b);
    return {high, __builtin_fma(a.lo, b, __builtin_fma(a.hi, b, -high))};
}
ROTCONV_INLINE Fixed operator*(Fixed a, Fixed b) noexcept {
    const double high = fixed_part(a.hi, b.hi);
    return {high, __builtin_fma(a.hi, b.lo, __builtin_fma(a.lo, b.hi, __builtin_fma(a.hi, b.hi, -high)))};
}
/// Each number over the divisor. The quotients are not for sums.
// NOLINTNEXTLINE(*-avoid-c-arrays): numbers of a row, as everywhere in the core
template <std::size_t N> ROTCONV_INLINE void divide(Fixed (&numbers)[N], const Fixed& divisor) noexcept {
    const DoubleDouble whole = fast_two_sum(divisor.hi, divisor.lo);
    const double inverse = 1.0 / whole.hi;
    const double rest = inverse * __builtin_fma(-whole.lo, inverse, __builtin_fma(-whole.hi, inverse, 1.0));
    for (std::size_t k = 0; k < N; ++k) {
        const double high = numbers[k].hi;
        const double quotient = high * inverse;
        numbers[k].lo =
            __builtin_fma(numbers[k].lo, inverse, __builtin_fma(high, rest, __builtin_fma(high, inverse, -quotient)));
        numbers[k].hi = quotient;
    }
}

/// Whether all numbers within `error` of one round to the same double.
ROTCONV_INLINE bool rounds_alike(DoubleDouble a, double error) noexcept {
    return a.hi + (a.lo + error) == a.hi + (a.lo - error);
}
/// The doubt that is not about a number.
inline constexpr std::uint64_t other_doubt = std::uint64_t{1} << 31U;
/// What of a number, with a bound on its error, is in doubt: nothing where all numbers within it round to the same
/// double; bit k where the number k may be 0, and is below 2^-66; otherwise bit 32 + k. Bit 16 + k: whether the
/// component k of the attitude is exactly 0.
ROTCONV_INLINE std::uint64_t doubt_of(DoubleDouble number, double error, unsigned k) noexcept {
    const bool is_near_0 = __builtin_fabs(number.hi) <= error && error < 0x1p-66;
    return rounds_alike(number, error) ? 0U : std::uint64_t{1} << (is_near_0 ? k : 32U + k);
}

/// A bound on the error of numbers: so much, and so much of a number itself.
struct ErrorBound {
    double absolute, relative;
};

template <class T> ROTCONV_INLINE T normalized(const T& a) noexcept { return a; } // DoubleDouble and double are

/// The size of a number: a formula over it gives the sums of the sizes of its products.
struct Magnitude {
    double value = 0.0;

    ROTCONV_INLINE constexpr Magnitude() noexcept = default;
    ROTCONV_INLINE constexpr Magnitude(double number) noexcept : value(__builtin_fabs(number)) {}
};
ROTCONV_INLINE Magnitude operator-(Magnitude a) noexcept { return a; }
ROTCONV_INLINE Magnitude operator*(Magnitude a, Magnitude b) noexcept { return a.value * b.value; }
ROTCONV_INLINE Magnitude scaled(Magnitude a, double /*sign*/) noexcept { return a; }
ROTCONV_INLINE Magnitude clean_difference(Magnitude a, Magnitude b) noexcept { return a.value + b.value; }

} // namespace ROTCONV_TARGET
} // namespace rotconv
