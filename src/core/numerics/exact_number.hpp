#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>

#include "double_double.hpp"
#include "power_of_two.hpp"
#include "wide.hpp"

namespace rotconv {

/// Whether a number has no rest at all, and not only none that its bits tell: it is -0.0.
[[nodiscard]] inline bool is_exactly_none(double rest) noexcept { return rest == 0.0 && std::signbit(rest); }

/// A number with the rest of it, a sum of doubles: DoubleDouble has room for the first.
template <class T> [[nodiscard]] T exact_number(double number, std::span<const double> rest) noexcept {
    if constexpr (std::is_same_v<T, DoubleDouble>) {
        return two_sum(number, rest[0]);
    } else {
        T sum(number);
        for (const double part : rest) {
            sum = sum + T(part);
        }
        if (!is_exactly_none(rest.back())) {
            sum.widen(T(0x1p-590)); // more than what 640 bits are off by
        }
        return sum;
    }
}

template <class T>
[[nodiscard]] std::array<T, 3> exact_vector(const double* numbers, std::span<const double> rest) noexcept {
    const std::size_t size = rest.size() / 3;
    const auto component = [&](std::size_t i) { return exact_number<T>(numbers[i], rest.subspan(i * size, size)); };
    return {component(0), component(1), component(2)};
}

/// Times 2^`power`.
[[nodiscard]] inline DoubleDouble shifted(const DoubleDouble& a, int power) noexcept {
    const PowerOfTwo by(power);
    return {by(a.hi), by(a.lo)};
}
[[nodiscard]] inline Wide shifted(const Wide& a, int power) noexcept { return a.shifted(power); }

/// Rounds once; false where the bits do not tell how: those of DoubleDouble, if it is not exact but off by `error` at
/// most, next to the middle between two doubles.
[[nodiscard]] inline bool round_to(const DoubleDouble& exact, bool is_exact, double error, double& number) noexcept {
    number = exact.hi + 0.0;
    const double size = std::fabs(number);
    constexpr std::uint64_t exponent = 0x7ff0000000000000;
    const auto power = std::bit_cast<double>(std::bit_cast<std::uint64_t>(size) & exponent);
    const bool is_below = size == power && std::signbit(exact.lo) != std::signbit(number);
    const double middle = (is_below ? 0x1p-54 : 0x1p-53) * power;
    return is_exact || std::fabs(exact.lo) + error < middle;
}
[[nodiscard]] inline bool round_to(const Wide& exact, bool /*is_exact*/, double /*error*/, double& number) noexcept {
    const bool decided = exact.round(number);
    number += 0.0;
    return decided;
}

/// Calls what(T()) with the scalar for `size` numbers and the rest of each.
template <class What> bool in_scalar_of(std::span<const double> rest, std::size_t size, const What& what) noexcept {
    if (rest.size() > size) {
        const Wide::Bits enough(Wide::bits_of_rest);
        return what(Wide());
    }
    return what(DoubleDouble());
}

/// Rounds `ratio` 2^`exponent` times the component, whose sum is exact, of a vector of which the largest is `largest`;
/// false as above. The product is formed at unit size, so that nothing of it underflows.
[[nodiscard]] inline bool round_product(const DoubleDouble& ratio, int exponent, const DoubleDouble& component,
                                        double largest, double& number) noexcept {
    constexpr int least = -1200; // the result is 0 there
    const int own = PowerOfTwo::exponent_of_unit(__builtin_fabs(component.hi));
    const int power = exponent + own;
    const double error = std::fabs(ratio.hi) * (0x1p-90 * PowerOfTwo(-own)(largest) + 0x1p-69);
    const bool is_zero = component.hi == 0.0;
    const bool decided = round_to(ratio * shifted(component, -own), is_zero, error, number);
    number = PowerOfTwo(power < least ? least : power)(number) + 0.0;
    return decided && (is_zero || std::fabs(number) >= std::numeric_limits<double>::min());
}
[[nodiscard]] inline bool round_product(const Wide& ratio, int exponent, const Wide& component, double /*largest*/,
                                        double& number) noexcept {
    return round_to((ratio * component).shifted(exponent), false, 0.0, number);
}

} // namespace rotconv
