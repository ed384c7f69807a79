#pragma once

#include <cstdint>

// The sources of ../batch and the elementary functions are compiled twice where that pays, for every processor and for
// those that have fused multiply-add as an instruction, each time in a namespace of its own, so that no function of one
// takes the place of one of the other. Both give the same numbers. All else is compiled for every processor.
#ifndef ROTCONV_TARGET
#define ROTCONV_TARGET any_processor
#endif

#if defined(__FMA__) || defined(__aarch64__)
#define ROTCONV_HAS_FMA 1
#else
#define ROTCONV_HAS_FMA 0
#endif

/// Of functions that stand in loops over rows, which vectorise only where all is inline.
#if defined(__GNUC__)
#define ROTCONV_INLINE __attribute__((always_inline)) inline
#else
#define ROTCONV_INLINE inline
#endif

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// An unevaluated sum hi + lo with |lo| <= ulp(hi)/2: 106 bits. hi is the sum rounded to double. Needs
/// -ffp-contract=off. The bounds below hold where products and their low parts neither overflow nor underflow:
/// operands between 2^-450 and 2^450, or 0. See Wide for others.
struct Real {
    double hi = 0.0;
    double lo = 0.0;

    ROTCONV_INLINE constexpr Real() noexcept = default;
    ROTCONV_INLINE constexpr Real(double value) noexcept : hi(value) {}
    ROTCONV_INLINE constexpr Real(double high, double low) noexcept : hi(high), lo(low) {}
};

/// a + b exactly (Knuth 1969).
ROTCONV_INLINE Real exact_sum(double a, double b) noexcept {
    const double sum = a + b;
    const double b_seen = sum - a;
    return {sum, (a - (sum - b_seen)) + (b - b_seen)};
}

/// a + b exactly where |a| >= |b| or a is 0 (Dekker 1971).
ROTCONV_INLINE Real exact_sum_of_ordered(double a, double b) noexcept {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// a b exactly, for products above 2^-960: by a fused multiply-add, else Dekker's way with Veltkamp's split (1971), for
/// factors below 2^996.
ROTCONV_INLINE Real exact_product(double a, double b) noexcept {
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

ROTCONV_INLINE Real operator-(Real a) noexcept { return {-a.hi, -a.lo}; }

/// To 3 x 2^-106, whatever cancels.
ROTCONV_INLINE Real operator+(Real a, Real b) noexcept {
    const Real high = exact_sum(a.hi, b.hi);
    const Real low = exact_sum(a.lo, b.lo);
    const Real first = exact_sum_of_ordered(high.hi, high.lo + low.hi);
    return exact_sum_of_ordered(first.hi, first.lo + low.lo);
}
ROTCONV_INLINE Real operator-(Real a, Real b) noexcept { return a + -b; }

/// To 2 x 2^-106, whatever cancels.
ROTCONV_INLINE Real operator+(Real a, double b) noexcept {
    const Real high = exact_sum(a.hi, b);
    return exact_sum_of_ordered(high.hi, high.lo + a.lo);
}
ROTCONV_INLINE Real operator+(double a, Real b) noexcept { return b + a; }
ROTCONV_INLINE Real operator-(Real a, double b) noexcept { return a + -b; }
ROTCONV_INLINE Real operator-(double a, Real b) noexcept { return -b + a; }

/// To 2^-104 of the larger operand, for sums that do not cancel or whose operands are no better.
ROTCONV_INLINE Real quick_sum(Real a, Real b) noexcept {
    const Real high = exact_sum(a.hi, b.hi);
    return exact_sum_of_ordered(high.hi, high.lo + (a.lo + b.lo));
}

/// The same where |a| >= 2 |b| or a is 0.
ROTCONV_INLINE Real quick_sum_of_ordered(Real a, Real b) noexcept {
    const Real high = exact_sum_of_ordered(a.hi, b.hi);
    return exact_sum_of_ordered(high.hi, high.lo + (a.lo + b.lo));
}

/// To 7 x 2^-106; exact where both factors are doubles.
ROTCONV_INLINE Real operator*(Real a, Real b) noexcept {
    const Real high = exact_product(a.hi, b.hi);
    return exact_sum_of_ordered(high.hi, high.lo + (a.hi * b.lo + a.lo * b.hi));
}
/// To 3 x 2^-106.
ROTCONV_INLINE Real operator*(Real a, double b) noexcept {
    const Real high = exact_product(a.hi, b);
    return exact_sum_of_ordered(high.hi, high.lo + a.lo * b);
}
ROTCONV_INLINE Real operator*(double a, Real b) noexcept { return b * a; }

/// 2^exponent, for a normal result.
ROTCONV_INLINE double power_of_two(int exponent) noexcept {
    return __builtin_bit_cast(double, static_cast<std::uint64_t>(1023 + exponent) << 52U);
}

/// Times a power of two: exact.
ROTCONV_INLINE Real scaled(Real a, double power_of_two) noexcept { return {a.hi * power_of_two, a.lo * power_of_two}; }

/// To 16 x 2^-106. Not finite where b is 0.
ROTCONV_INLINE Real operator/(Real a, Real b) noexcept {
    const double high = a.hi / b.hi;
    const Real back = exact_product(high, b.hi);
    const double rest = ((a.hi - back.hi) - back.lo) + (a.lo - high * b.lo);
    return exact_sum_of_ordered(high, rest / b.hi);
}

/// To 4 x 2^-106; 0 of 0.
ROTCONV_INLINE Real root(Real a) noexcept {
    const double high = __builtin_sqrt(a.hi);
    const Real square = exact_product(high, high);
    const double rest = ((a.hi - square.hi) - square.lo) + a.lo;
    return exact_sum_of_ordered(high, a.hi > 0.0 ? rest / (2.0 * high) : 0.0);
}

ROTCONV_INLINE Real square(Real a) noexcept { return a * a; }

/// `yes` or `no`; both are worked out.
ROTCONV_INLINE Real choose(bool condition, Real yes, Real no) noexcept {
    return {condition ? yes.hi : no.hi, condition ? yes.lo : no.lo};
}

// The same for doubles, so that a formula may be written once for both: each rounds once.

ROTCONV_INLINE double quick_sum(double a, double b) noexcept { return a + b; }
ROTCONV_INLINE double quick_sum_of_ordered(double a, double b) noexcept { return a + b; }
ROTCONV_INLINE double scaled(double a, double power_of_two) noexcept { return a * power_of_two; }
ROTCONV_INLINE double root(double a) noexcept { return __builtin_sqrt(a); }
ROTCONV_INLINE double square(double a) noexcept { return a * a; }
ROTCONV_INLINE double choose(bool condition, double yes, double no) noexcept { return condition ? yes : no; }

/// a^2 to 106 bits; of a double exactly.
ROTCONV_INLINE Real exact_square(double a) noexcept { return exact_product(a, a); }
ROTCONV_INLINE Real exact_square(Real a) noexcept { return a * a; }

/// The nearest double.
ROTCONV_INLINE double nearly(double a) noexcept { return a; }
ROTCONV_INLINE double nearly(Real a) noexcept { return a.hi; }

/// a <= b.
ROTCONV_INLINE bool is_at_most(double a, double b) noexcept { return a <= b; }
ROTCONV_INLINE bool is_at_most(Real a, Real b) noexcept { return a.hi < b.hi || (a.hi == b.hi && a.lo <= b.lo); }

/// A number in fewer digits.
template <class T> ROTCONV_INLINE T rounded_to(Real a) noexcept = delete;
template <> ROTCONV_INLINE double rounded_to<double>(Real a) noexcept { return a.hi; }
template <> ROTCONV_INLINE Real rounded_to<Real>(Real a) noexcept { return a; }

} // namespace ROTCONV_TARGET
} // namespace rotconv
