#pragma once

#include <cmath>

namespace rotconv {

/// An unevaluated sum hi + lo with |lo| <= ulp(hi)/2: about 106 bits. Needs -ffp-contract=off.
struct DoubleDouble {
    double hi = 0.0;
    double lo = 0.0;
};

/// a + b exactly (Knuth 1969).
inline DoubleDouble exact_sum(double a, double b) noexcept {
    const double sum = a + b;
    const double b_seen = sum - a;
    return {sum, (a - (sum - b_seen)) + (b - b_seen)};
}

/// a + b exactly where |a| >= |b| or a is 0 (Dekker 1971).
inline DoubleDouble exact_sum_of_ordered(double a, double b) noexcept {
    const double sum = a + b;
    return {sum, (a - sum) + b};
}

/// a * b exactly, for magnitudes below 2^996 and products above 2^-960 (Dekker 1971, with Veltkamp's split).
inline DoubleDouble exact_product(double a, double b) noexcept {
    constexpr double splitter = 134217729.0; // 2^27 + 1
    const double a_big = splitter * a;
    const double a_hi = a_big - (a_big - a);
    const double a_lo = a - a_hi;
    const double b_big = splitter * b;
    const double b_hi = b_big - (b_big - b);
    const double b_lo = b - b_hi;
    const double product = a * b;
    return {product, ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo};
}

/// a/b to 2^-102 or so.
inline DoubleDouble quotient(DoubleDouble a, DoubleDouble b) noexcept {
    const double high = a.hi / b.hi;
    const DoubleDouble back = exact_product(high, b.hi);
    return exact_sum_of_ordered(high, (((a.hi - back.hi) - back.lo) + (a.lo - high * b.lo)) / b.hi);
}

/// a (hi + lo), rounded once.
inline double product(double a, DoubleDouble factor) noexcept {
    const DoubleDouble high = exact_product(a, factor.hi);
    return high.hi + (high.lo + a * factor.lo);
}

/// a b - c d to 2^-104 of the larger product: cancellation leaves the digits that are there.
inline double difference_of_products(double a, double b, double c, double d) noexcept {
    const DoubleDouble first = exact_product(a, b);
    const DoubleDouble second = exact_product(-c, d);
    const DoubleDouble high = exact_sum(first.hi, second.hi);
    return high.hi + (high.lo + (first.lo + second.lo));
}

/// a b + c d + e f + g h to 2^-100 of the largest product, rounded once.
inline double sum_of_products(double a, double b, double c, double d, double e, double f, double g, double h) noexcept {
    const DoubleDouble ab = exact_product(a, b);
    const DoubleDouble cd = exact_product(c, d);
    const DoubleDouble ef = exact_product(e, f);
    const DoubleDouble gh = exact_product(g, h);
    const DoubleDouble first = exact_sum(ab.hi, cd.hi);
    const DoubleDouble second = exact_sum(ef.hi, gh.hi);
    const DoubleDouble both = exact_sum(first.hi, second.hi);
    return both.hi + (both.lo + ((first.lo + second.lo) + ((ab.lo + cd.lo) + (ef.lo + gh.lo))));
}

/// sqrt(x^2 + y^2 + z^2) to 2^-102 relative, for a largest magnitude between 2^-400 and 1.
inline DoubleDouble length(double x, double y, double z) noexcept {
    const DoubleDouble xx = exact_product(x, x);
    const DoubleDouble yy = exact_product(y, y);
    const DoubleDouble zz = exact_product(z, z);
    const DoubleDouble two = exact_sum(xx.hi, yy.hi);
    const DoubleDouble three = exact_sum(two.hi, zz.hi);
    const DoubleDouble square = exact_sum(three.hi, (two.lo + three.lo) + (xx.lo + yy.lo + zz.lo));
    const double root = std::sqrt(square.hi);
    const DoubleDouble root_square = exact_product(root, root);
    return exact_sum(root, ((square.hi - root_square.hi) + (square.lo - root_square.lo)) / (2.0 * root));
}

// On a fixed grid much of the same is had for a few operations, in loops that the compiler vectorises.

/// A number in two parts, the high one on the grid: products of two high parts, and sums of such, are exact up to 16.
struct Split {
    double value;
    double high;
    [[nodiscard]] double low() const noexcept { return value - high; }
};

/// Splits a number of size up to 4 on the grid of 2^-24.
inline Split split(double value) noexcept {
    constexpr double shift = 1.5 * 0x1p28;
    return {value, (value + shift) - shift};
}

/// high^2 is exact; this is what is missing to value^2.
inline double rest_of_square(Split a) noexcept { return a.low() * (a.value + a.high); }

/// What is missing from the product of the high parts to that of the values.
inline double rest_of_product(Split a, Split b) noexcept { return a.high * b.low() + a.low() * b.value; }

/// The square root of a sum high + low of squares, high on the grid of products, with its inverse, rounded.
struct Root {
    double hi;
    double lo;
    double inverse;
};

inline Root root_of(double high, double low) noexcept {
    const Split root = split(std::sqrt(high + low));
    const double inverse = 1.0 / root.value;
    return {root.value, 0.5 * ((high - root.high * root.high) + (low - rest_of_square(root))) * inverse, inverse};
}

/// (hi + lo) / |divisor|, for a quotient of size up to 4.
inline DoubleDouble quotient(double hi, double lo, Root divisor) noexcept {
    const Split q = split(hi * divisor.inverse);
    const Split d = split(divisor.hi);
    const double rest = ((hi - q.high * d.high) - rest_of_product(q, d)) + (lo - q.value * divisor.lo);
    return {q.value, rest * divisor.inverse};
}

/// a (hi + lo), rounded once.
inline double product(Split a, DoubleDouble factor) noexcept {
    const Split f = split(factor.hi);
    return a.high * f.high + (a.high * (f.low() + factor.lo) + a.low() * f.value);
}

} // namespace rotconv
