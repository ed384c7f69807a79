#pragma once

#include <cstddef>
#include <cstdint>

#include "double_double.hpp"

// NOLINTBEGIN(*-avoid-c-arrays): src/core/.clang-tidy allows them, but not to sources elsewhere that include this

// Tables of sines, cosines and arc tangents, each value the sum of two doubles that is nearest to it. The compiler
// makes them.

namespace rotconv {
inline namespace ROTCONV_TARGET {

template <class T> struct SineCosine { T sine, cosine; };

/// Numbers below 16, times 2^124.
namespace fixed_point {

__extension__ using Number = unsigned __int128;
__extension__ using Difference = __int128;

inline constexpr Number one = static_cast<Number>(1) << 124U;
inline constexpr Number pi = static_cast<Number>(0x3243f6a8885a308dU) << 64U | 0x313198a2e0370734U;

constexpr Number product(Number a, Number b) noexcept {
    constexpr Number word = 0xffffffffffffffffU;
    const Number middle = ((a >> 64U) * (b & word) >> 60U) + ((a & word) * (b >> 64U) >> 60U);
    return ((a >> 64U) * (b >> 64U) << 4U) + middle;
}

constexpr DoubleDouble rounded(Number a) noexcept {
    const auto high = static_cast<double>(a);
    const auto low = static_cast<double>(static_cast<Difference>(a - static_cast<Number>(high)));
    return {high * 0x1p-124, low * 0x1p-124};
}

constexpr Number sine(Number x) noexcept {
    Number sum = 0;
    Number term = x;
    for (unsigned n = 1; term != 0; n += 2) {
        sum += n % 4 == 1 ? term : -term;
        term = product(product(term, x), x) / (n + 1) / (n + 2);
    }
    return sum;
}

constexpr Number arc_tangent(Number x) noexcept {
    Number sum = 0;
    Number power = x;
    for (unsigned n = 1; power != 0; n += 2) {
        sum += n % 4 == 1 ? power / n : -(power / n);
        power = product(product(power, x), x);
    }
    return sum;
}

} // namespace fixed_point

/// The sine and cosine of k pi/64 for k = 0 ... 127.
struct TurnTable {
    constexpr TurnTable() noexcept {
        DoubleDouble sines[33];
        for (unsigned k = 0; k < 32; ++k) {
            sines[k] = fixed_point::rounded(fixed_point::sine(fixed_point::pi / 64 * k));
        }
        sines[32] = 1.0;
        for (int k = 0; k < 128; ++k) {
            const bool is_obtuse = k % 64 > 32;
            const int from_axis = is_obtuse ? 64 - k % 64 : k % 64;
            values[k] = {signed_as(k > 63, sines[from_axis]), signed_as(is_obtuse != (k > 63), sines[32 - from_axis])};
        }
    }
    SineCosine<DoubleDouble> values[128];

private:
    static constexpr DoubleDouble signed_as(bool is_negative, const DoubleDouble& a) noexcept {
        return is_negative ? -a : a;
    }
};

/// atan(k/64) for k = 0 ... 64; each less the one before is atan(64/(4096 + k (k - 1))).
struct ArcTangentTable {
    constexpr ArcTangentTable() noexcept {
        fixed_point::Number sum = 0;
        for (unsigned k = 1; k <= 64; ++k) {
            sum += fixed_point::arc_tangent(8 * fixed_point::one / (4096 + k * (k - 1)) * 8);
            values[k] = fixed_point::rounded(sum);
        }
    }
    DoubleDouble values[65];
};

} // namespace ROTCONV_TARGET
} // namespace rotconv

// NOLINTEND(*-avoid-c-arrays)
