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

/// a b - c d to 2^-104 of the larger product: cancellation leaves the digits that are there.
inline double difference_of_products(double a, double b, double c, double d) noexcept {
    const DoubleDouble first = exact_product(a, b);
    const DoubleDouble second = exact_product(-c, d);
    const DoubleDouble high = exact_sum(first.hi, second.hi);
    return high.hi + (high.lo + (first.lo + second.lo));
}

/// x^2 + y^2 + z^2 to 2^-102 relative, for a largest magnitude between 2^-400 and 1.
inline DoubleDouble squared_length(double x, double y, double z) noexcept {
    const DoubleDouble xx = exact_product(x, x);
    const DoubleDouble yy = exact_product(y, y);
    const DoubleDouble zz = exact_product(z, z);
    const DoubleDouble two = exact_sum(xx.hi, yy.hi);
    const DoubleDouble three = exact_sum(two.hi, zz.hi);
    return exact_sum(three.hi, (two.lo + three.lo) + (xx.lo + yy.lo + zz.lo));
}

/// Its square root, to as much.
inline DoubleDouble length(double x, double y, double z) noexcept {
    const DoubleDouble square = squared_length(x, y, z);
    const double root = std::sqrt(square.hi);
    const DoubleDouble root_square = exact_product(root, root);
    return exact_sum(root, ((square.hi - root_square.hi) + (square.lo - root_square.lo)) / (2.0 * root));
}

} // namespace rotconv
