#pragma once

#include <cstddef>
#include <cstdint>

#include "double_double.hpp"

// Tables of sines and arc tangents, each value the sum of two doubles that is nearest to it. The compiler makes them.

namespace rotconv {
inline namespace ROTCONV_TARGET {

// NOLINTBEGIN(*-avoid-c-arrays): nothing inline of the standard library goes into sources of several targets

/// A number from 0 to 2^64 with 192 binary digits behind the point.
class FixedPoint {
public:
    explicit constexpr FixedPoint(std::uint64_t whole) noexcept : words_{whole, 0, 0, 0} {}

    constexpr FixedPoint operator+(const FixedPoint& other) const noexcept {
        FixedPoint sum(0);
        Uint128 carry = 0;
        for (int i = last; i >= 0; --i) {
            carry += static_cast<Uint128>(words_[i]) + other.words_[i];
            sum.words_[i] = static_cast<std::uint64_t>(carry);
            carry >>= 64U;
        }
        return sum;
    }
    /// Of a number that is not larger.
    constexpr FixedPoint operator-(const FixedPoint& other) const noexcept {
        FixedPoint complement(0);
        for (int i = 0; i <= last; ++i) {
            complement.words_[i] = ~other.words_[i];
        }
        FixedPoint one(0);
        one.words_[last] = 1;
        return *this + complement + one;
    }
    constexpr FixedPoint operator*(const FixedPoint& other) const noexcept {
        std::uint64_t words[2 * last + 2]{};
        for (int i = last; i >= 0; --i) {
            std::uint64_t carry = 0;
            for (int k = last; k >= 0; --k) {
                const Uint128 sum = static_cast<Uint128>(words_[i]) * other.words_[k] + words[i + k + 1] + carry;
                words[i + k + 1] = static_cast<std::uint64_t>(sum);
                carry = static_cast<std::uint64_t>(sum >> 64U);
            }
            words[i] = carry;
        }
        FixedPoint product(0);
        for (int i = 0; i <= last; ++i) {
            product.words_[i] = words[i + 1];
        }
        return product;
    }
    constexpr FixedPoint operator*(std::uint64_t factor) const noexcept {
        FixedPoint product(0);
        Uint128 carry = 0;
        for (int i = last; i >= 0; --i) {
            carry += static_cast<Uint128>(words_[i]) * factor;
            product.words_[i] = static_cast<std::uint64_t>(carry);
            carry >>= 64U;
        }
        return product;
    }
    constexpr FixedPoint operator/(std::uint64_t divisor) const noexcept {
        FixedPoint quotient(0);
        Uint128 rest = 0;
        for (int i = 0; i <= last; ++i) {
            rest = rest << 64U | words_[i];
            quotient.words_[i] = static_cast<std::uint64_t>(rest / divisor);
            rest %= divisor;
        }
        return quotient;
    }
    [[nodiscard]] constexpr bool is_zero() const noexcept {
        return (words_[0] | words_[1] | words_[2] | words_[3]) == 0;
    }

    /// Of a number below 2.
    [[nodiscard]] constexpr DoubleDouble rounded() const noexcept {
        const double high = nearest();
        const FixedPoint taken = of(high);
        const bool is_above = taken.words_[0] > words_[0] || (taken - *this).words_[0] == 0;
        return {high, is_above ? -(taken - *this).nearest() : (*this - taken).nearest()};
    }

private:
    __extension__ using Uint128 = unsigned __int128;
    static constexpr int last = 3;

    [[nodiscard]] constexpr bool digit(int place) const noexcept {
        return (words_[1 + place / 64] >> (63U - static_cast<unsigned>(place) % 64U) & 1U) != 0;
    }
    /// The nearest double to a number of at most 1.
    [[nodiscard]] constexpr double nearest() const noexcept {
        if (words_[0] != 0) {
            return 1.0;
        }
        double value = 0.0;
        double unit = 0.5;
        int digits = 0;
        for (int place = 0; place < 64 * last && digits < 53; ++place, unit *= 0.5) {
            value += digit(place) ? unit : 0.0;
            digits += digits > 0 || digit(place) ? 1 : 0;
            if (digits == 53 && place + 1 < 64 * last && digit(place + 1)) {
                value += unit;
            }
        }
        return value;
    }
    [[nodiscard]] static constexpr FixedPoint of(double value) noexcept {
        FixedPoint exact(value >= 1.0 ? 1 : 0);
        value -= value >= 1.0 ? 1.0 : 0.0;
        for (int i = 1; i <= last; ++i) {
            for (int place = 0; place < 64; ++place) {
                value *= 2.0;
                exact.words_[i] = exact.words_[i] << 1U | (value >= 1.0 ? 1U : 0U);
                value -= value >= 1.0 ? 1.0 : 0.0;
            }
        }
        return exact;
    }

    std::uint64_t words_[last + 1];
};

/// The arc tangent of p/q, at most 1/4, by its series.
constexpr FixedPoint small_arc_tangent(std::uint64_t p, std::uint64_t q) noexcept {
    FixedPoint power = FixedPoint(p) / q;
    FixedPoint sum(0);
    FixedPoint less(0);
    for (std::uint64_t n = 1; !power.is_zero(); n += 2) {
        (n % 4 == 1 ? sum : less) = (n % 4 == 1 ? sum : less) + power / n;
        power = power * (p * p) / (q * q);
    }
    return sum - less;
}

/// Machin's formula (1706).
inline constexpr FixedPoint fixed_pi = small_arc_tangent(1, 5) * 16 - small_arc_tangent(1, 239) * 4;

/// sin(k pi/64) for k = 0 ... 32.
struct SineTable {
    constexpr SineTable() noexcept {
        for (std::uint64_t k = 0; k < 32; ++k) {
            const FixedPoint x = fixed_pi * k / 64;
            FixedPoint power = x;
            FixedPoint sum(0);
            FixedPoint less(0);
            for (std::uint64_t n = 1; !power.is_zero(); n += 2) {
                (n % 4 == 1 ? sum : less) = (n % 4 == 1 ? sum : less) + power;
                power = power * x * x / ((n + 1) * (n + 2));
            }
            values[k] = (sum - less).rounded();
        }
        values[32] = 1.0;
    }
    DoubleDouble values[33];
};

/// atan(k/64) for k = 0 ... 64; each less the one before is atan(64/(4096 + k (k - 1))).
struct ArcTangentTable {
    constexpr ArcTangentTable() noexcept {
        FixedPoint sum(0);
        for (std::uint64_t k = 1; k <= 64; ++k) {
            sum = sum + small_arc_tangent(64, 4096 + k * (k - 1));
            values[k] = sum.rounded();
        }
    }
    DoubleDouble values[65];
};

// NOLINTEND(*-avoid-c-arrays)

} // namespace ROTCONV_TARGET
} // namespace rotconv
