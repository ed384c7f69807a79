#pragma once

#include <cstdint>
#include <type_traits>

#include "wide.hpp"

#ifdef __FAST_MATH__
#error "rotconv's own sources need -fno-fast-math, which CMakeLists.txt gives after the flags of a parent project"
#endif

// The kernels (../representations/*_batch.cpp, ../kernels.cpp) and the elementary functions are compiled twice where
// that pays: for every processor, and for those that have fused multiply-add as an instruction. Each time they have a
// namespace of their own, so that no function of one takes the place of one of the other. Both give the same numbers.
// All else is compiled for every processor.
#ifndef ROTCONV_TARGET
#define ROTCONV_TARGET any_processor
#endif

#if defined(__FMA__) || defined(__aarch64__)
#define ROTCONV_HAS_FMA 1
#else
#define ROTCONV_HAS_FMA 0
#endif

/// Marks functions that stand in loops over rows, which vectorise only if all is inline.
#if defined(__GNUC__)
#define ROTCONV_INLINE __attribute__((always_inline)) inline
#else
#define ROTCONV_INLINE inline
#endif

/// Marks functions that are called for a few rows alone, and would be long in line.
#if defined(__GNUC__)
#define ROTCONV_NOINLINE __attribute__((noinline))
#else
#define ROTCONV_NOINLINE
#endif

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// A number hi + lo. What these parts are is said by the scalars that are made of them.
struct TwoParts {
    double hi = 0.0;
    double lo = 0.0;

    ROTCONV_INLINE constexpr TwoParts() noexcept = default;
    ROTCONV_INLINE constexpr TwoParts(double value) noexcept : hi(value) {}
    ROTCONV_INLINE constexpr TwoParts(double high, double low) noexcept : hi(high), lo(low) {}
};
template <class T>
concept InTwoParts = std::is_base_of_v<TwoParts, T>;

template <InTwoParts T> ROTCONV_INLINE constexpr T operator-(T a) noexcept { return {-a.hi, -a.lo}; }
/// Times a power of two: exact.
template <InTwoParts T> ROTCONV_INLINE T scaled(T a, double power_of_two) noexcept {
    return {a.hi * power_of_two, a.lo * power_of_two};
}
/// `yes` or `no`; both are computed.
template <InTwoParts T> ROTCONV_INLINE T select(bool condition, T yes, T no) noexcept {
    return {condition ? yes.hi : no.hi, condition ? yes.lo : no.lo};
}
/// The nearest double.
template <InTwoParts T> ROTCONV_INLINE double to_double(T a) noexcept { return a.hi; }
/// A number of the same sign, and 0 only for 0.
template <InTwoParts T> ROTCONV_INLINE double sign_of(T a) noexcept { return a.hi; }

/// An unevaluated sum hi + lo with |lo| <= ulp(hi)/2: 106 bits (Dekker 1971). hi is the sum rounded to double. Needs
/// -ffp-contract=off. The bounds below hold, and the numbers are the same with and without a fused multiply-add, where
/// each product is 0 or between 2^-960 and 2^960; see is_plain_number(). Wide takes any others.
struct DoubleDouble : TwoParts {
    using TwoParts::TwoParts;
};

/// a + b exactly (Knuth 1969).
ROTCONV_INLINE DoubleDouble two_sum(double a, double b) noexcept {
    const double sum = a + b;
    const double b_seen = sum - a;
    return {sum, (a - (sum - b_seen)) + (b - b_seen)};
}

/// a + b exactly where |a| >= |b| or a is 0 (Dekker 1971).
ROTCONV_INLINE DoubleDouble fast_two_sum(double a, double b) noexcept {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// a b exactly, for products above 2^-960: by a fused multiply-add, else Dekker's way with Veltkamp's split (1971), for
/// factors below 2^996.
ROTCONV_INLINE DoubleDouble two_prod(double a, double b) noexcept {
    const double product = a * b;
#if ROTCONV_HAS_FMA
    return {product, __builtin_fma(a, b, -product)};
#else
    constexpr double splitter = 134217729.0; // 2^27 + 1
    const double a_big = splitter * a;
    const double a_hi = a_big - (a_big - a);
    const double a_lo = a - a_hi;
    const double b_big = splitter * b;
    const double b_hi = b_big - (b_big - b);
    const double b_lo = b - b_hi;
    return {product, ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo};
#endif
}

/// To 3 x 2^-106, whatever cancels.
ROTCONV_INLINE DoubleDouble operator+(DoubleDouble a, DoubleDouble b) noexcept {
    const DoubleDouble high = two_sum(a.hi, b.hi);
    const DoubleDouble low = two_sum(a.lo, b.lo);
    const DoubleDouble first = fast_two_sum(high.hi, high.lo + low.hi);
    return fast_two_sum(first.hi, first.lo + low.lo);
}
ROTCONV_INLINE DoubleDouble operator-(DoubleDouble a, DoubleDouble b) noexcept { return a + -b; }

/// To 2 x 2^-106, whatever cancels.
ROTCONV_INLINE DoubleDouble operator+(DoubleDouble a, double b) noexcept {
    const DoubleDouble high = two_sum(a.hi, b);
    return fast_two_sum(high.hi, high.lo + a.lo);
}
ROTCONV_INLINE DoubleDouble operator+(double a, DoubleDouble b) noexcept { return b + a; }
ROTCONV_INLINE DoubleDouble operator-(DoubleDouble a, double b) noexcept { return a + -b; }
ROTCONV_INLINE DoubleDouble operator-(double a, DoubleDouble b) noexcept { return -b + a; }

/// A sum and a square of scalars that have no other.
template <class T> ROTCONV_INLINE T sloppy_sum(const T& a, const T& b) noexcept { return a + b; }
template <class T> ROTCONV_INLINE T square(const T& a) noexcept { return a * a; }

/// To 2^-104 of the larger operand: for sums that do not cancel, or whose operands are no better.
ROTCONV_INLINE DoubleDouble sloppy_sum(DoubleDouble a, DoubleDouble b) noexcept {
    const DoubleDouble high = two_sum(a.hi, b.hi);
    return fast_two_sum(high.hi, high.lo + (a.lo + b.lo));
}

/// The same where |a| >= 2 |b| or a is 0.
ROTCONV_INLINE DoubleDouble sloppy_sum_ordered(DoubleDouble a, DoubleDouble b) noexcept {
    const DoubleDouble high = fast_two_sum(a.hi, b.hi);
    return fast_two_sum(high.hi, high.lo + (a.lo + b.lo));
}

/// To 7 x 2^-106; exact where both factors are doubles.
ROTCONV_INLINE DoubleDouble operator*(DoubleDouble a, DoubleDouble b) noexcept {
    const DoubleDouble high = two_prod(a.hi, b.hi);
    return fast_two_sum(high.hi, high.lo + (a.hi * b.lo + a.lo * b.hi));
}
/// To 3 x 2^-106.
ROTCONV_INLINE DoubleDouble operator*(DoubleDouble a, double b) noexcept {
    const DoubleDouble high = two_prod(a.hi, b);
    return fast_two_sum(high.hi, high.lo + a.lo * b);
}
ROTCONV_INLINE DoubleDouble operator*(double a, DoubleDouble b) noexcept { return b * a; }

/// 2^exponent, for a normal result.
ROTCONV_INLINE double power_of_two(int exponent) noexcept {
    return __builtin_bit_cast(double, static_cast<std::uint64_t>(1023 + exponent) << 52U);
}

/// The exponent of a normal number's leading bit; -1023 for 0.
ROTCONV_INLINE int exponent_of(double value) noexcept {
    return static_cast<int>((__builtin_bit_cast(std::uint64_t, value) >> 52U) & 0x7ffU) - 1023;
}

/// To 16 x 2^-106. Not finite where b is 0.
ROTCONV_INLINE DoubleDouble operator/(DoubleDouble a, DoubleDouble b) noexcept {
    const double high = a.hi / b.hi;
    const DoubleDouble back = two_prod(high, b.hi);
    const double rest = ((a.hi - back.hi) - back.lo) + (a.lo - high * b.lo);
    return fast_two_sum(high, rest / b.hi);
}

/// To 4 x 2^-106; 0 of 0.
ROTCONV_INLINE DoubleDouble root(DoubleDouble a) noexcept {
    const double high = __builtin_sqrt(a.hi);
    const DoubleDouble square = two_prod(high, high);
    const double rest = ((a.hi - square.hi) - square.lo) + a.lo;
    return fast_two_sum(high, a.hi > 0.0 ? rest / (2.0 * high) : 0.0);
}

// The same for doubles, so that a formula may be written once for both: each rounds once.

ROTCONV_INLINE double scaled(double a, double power_of_two) noexcept { return a * power_of_two; }
ROTCONV_INLINE double root(double a) noexcept { return __builtin_sqrt(a); }
ROTCONV_INLINE double select(bool condition, double yes, double no) noexcept { return condition ? yes : no; }
ROTCONV_INLINE double to_double(double a) noexcept { return a; }
ROTCONV_INLINE double sign_of(double a) noexcept { return a; }

/// A number that was stored by itself a moment ago, read by itself: as part of a vector it would have to wait until it
/// is in the cache, and all that follows with it.
ROTCONV_INLINE double alone(const double& stored) noexcept {
    double number = stored;
#if defined(__x86_64__)
    __asm__("" : "+x"(number));
#endif
    return number;
}
template <class T> ROTCONV_INLINE const T& alone(const T& stored) noexcept { return stored; }

/// a <= b.
ROTCONV_INLINE bool is_at_most(double a, double b) noexcept { return a <= b; }
ROTCONV_INLINE bool is_at_most(DoubleDouble a, DoubleDouble b) noexcept {
    return a.hi < b.hi || (a.hi == b.hi && a.lo <= b.lo);
}

/// A number in as many digits as T has.
template <class T, class Number> ROTCONV_INLINE T rounded_to(const Number& a) noexcept {
    if constexpr (std::is_same_v<T, double>) {
        return to_double(a);
    } else {
        return a;
    }
}

/// The scalars of a formula over T.
template <class T> struct Scalars {
    using Precise = DoubleDouble;
    using Given = double;
};
template <> struct Scalars<Wide> {
    using Precise = Wide;
    using Given = Wide;
};
/// The scalar of what counts twice, such as a length.
template <class T> using Precise = typename Scalars<T>::Precise;
/// The scalar of the numbers that are read.
template <class T> using Given = typename Scalars<T>::Given;

/// a b, of doubles without a rounding.
ROTCONV_INLINE DoubleDouble precise_product(double a, double b) noexcept { return two_prod(a, b); }
template <class T> ROTCONV_INLINE T precise_product(const T& a, const T& b) noexcept { return a * b; }

/// 0, or of a size at which no product that a formula forms of such numbers, and of what comes of them, leaves the
/// range of DoubleDouble: of the eighth degree, or as `least` says.
ROTCONV_INLINE bool is_plain_number(double value, double least = 0x1p-112) noexcept {
    const double size = __builtin_fabs(value);
    return size == 0.0 || (size >= least && size <= 0x1p112);
}
/// The same of a component of a quaternion of ordinary length.
ROTCONV_INLINE bool is_plain_component(double value) noexcept {
    return value == 0.0 || __builtin_fabs(value) >= 0x1p-328;
}

} // namespace ROTCONV_TARGET
} // namespace rotconv
