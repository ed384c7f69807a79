#pragma once

#include "real.hpp"

namespace rotconv {

/// a b - c d to 2^-104 of the larger product: cancellation leaves the digits that are there.
[[nodiscard]] inline double difference_of_products(double a, double b, double c, double d) noexcept {
    return quick_sum(exact_product(a, b), exact_product(-c, d)).hi;
}

/// a b + c d + e f + g h to 2^-100 of the largest product, rounded once.
[[nodiscard]] inline double sum_of_products(double a, double b, double c, double d, double e, double f, double g,
                                            double h) noexcept {
    return quick_sum(quick_sum(exact_product(a, b), exact_product(c, d)),
                     quick_sum(exact_product(e, f), exact_product(g, h)))
        .hi;
}

} // namespace rotconv
