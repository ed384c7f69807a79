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

/// a + b to 2^-104 relative, for terms that do not cancel; absolute to 2^-104 of the larger term otherwise.
inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b) noexcept {
    const DoubleDouble high = exact_sum(a.hi, b.hi);
    const DoubleDouble low = exact_sum(a.lo, b.lo);
    const DoubleDouble first = exact_sum(high.hi, high.lo + low.hi);
    return exact_sum(first.hi, first.lo + low.lo);
}

/// a * b to 2^-102 relative.
inline DoubleDouble operator*(DoubleDouble a, double b) noexcept {
    const DoubleDouble high = exact_product(a.hi, b);
    return exact_sum(high.hi, high.lo + a.lo * b);
}

/// sqrt(x^2 + y^2 + z^2) to 2^-102 relative, for a largest magnitude between 2^-400 and 1.
inline DoubleDouble length(double x, double y, double z) noexcept {
    const DoubleDouble square = exact_product(x, x) + exact_product(y, y) + exact_product(z, z);
    const double root = std::sqrt(square.hi);
    const DoubleDouble root_square = exact_product(root, root);
    return exact_sum(root, ((square.hi - root_square.hi) + (square.lo - root_square.lo)) / (2.0 * root));
}

} // namespace rotconv
