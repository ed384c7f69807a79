#pragma once

#include <cmath>
#include <cstdint>

#include "real.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// The exponent of a normal number's leading bit; -1023 for 0.
inline int exponent_of(double value) noexcept {
    return static_cast<int>((__builtin_bit_cast(std::uint64_t, value) >> 52U) & 0x7ffU) - 1023;
}

/// Whether products of such numbers and others of ordinary size keep their low parts: 0, or from 2^-450 to 2^450.
ROTCONV_INLINE bool is_ordinary(double value) noexcept {
    const double size = __builtin_fabs(value);
    return size == 0.0 || (size >= 0x1p-450 && size <= 0x1p450);
}

/// A Real with an exponent of its own, for the few rows whose products would overflow or underflow. Errors as of Real.
class Wide {
public:
    Wide() noexcept = default;
    Wide(double value) noexcept : Wide(Real(value)) {}
    Wide(Real value) noexcept : Wide(value, 0) {}

    /// Rounded once, to subnormal numbers too; infinite where it is too large.
    [[nodiscard]] double rounded() const noexcept {
        if (exponent_ > 1023) {
            return part_.hi * HUGE_VAL;
        }
        if (exponent_ >= -1022) {
            return part_.hi * power_of_two(exponent_);
        }
        if (exponent_ < -1080) {
            return 0.0;
        }
        // In units of 2^-1074: below 2^52, and to the nearest integer, of two the even one.
        const Real units = scaled(scaled(part_, power_of_two(exponent_ + 600)), 0x1p474);
        const double sign = units.hi < 0.0 ? -1.0 : 1.0;
        const auto whole = static_cast<std::int64_t>(sign * units.hi);
        const double rest = sign * units.hi - static_cast<double>(whole);
        const double beyond = sign * units.lo;
        const bool up = rest > 0.5 || (rest == 0.5 && (beyond > 0.0 || (beyond == 0.0 && (whole & 1) != 0)));
        return sign * static_cast<double>(whole + (up ? 1 : 0)) * 0x1p-537 * 0x1p-537;
    }

    /// What is too small for the parts of a Real is rounded away.
    [[nodiscard]] Real real() const noexcept {
        const double high = rounded();
        const Wide rest = *this - Wide(high);
        return {high, rest.rounded()};
    }

    [[nodiscard]] bool is_zero() const noexcept { return part_.hi == 0.0; }

    friend Wide operator-(const Wide& a) noexcept { return {-a.part_, a.exponent_}; }
    friend Wide operator+(const Wide& a, const Wide& b) noexcept {
        if (a.is_zero() || b.is_zero()) {
            return a.is_zero() ? b : a;
        }
        const bool a_first = a.exponent_ >= b.exponent_;
        const Wide& first = a_first ? a : b;
        const Wide& second = a_first ? b : a;
        const int distance = first.exponent_ - second.exponent_;
        if (distance > 300) {
            return first;
        }
        return {first.part_ + scaled(second.part_, power_of_two(-distance)), first.exponent_};
    }
    friend Wide operator-(const Wide& a, const Wide& b) noexcept { return a + -b; }
    friend Wide quick_sum(const Wide& a, const Wide& b) noexcept { return a + b; }
    friend Wide operator*(const Wide& a, const Wide& b) noexcept {
        return {a.part_ * b.part_, a.exponent_ + b.exponent_};
    }
    friend Wide operator/(const Wide& a, const Wide& b) noexcept {
        return {a.part_ / b.part_, a.exponent_ - b.exponent_};
    }
    friend Wide root(const Wide& a) noexcept {
        const int odd = a.exponent_ & 1;
        return {root(scaled(a.part_, odd != 0 ? 2.0 : 1.0)), (a.exponent_ - odd) / 2};
    }
    friend Wide square(const Wide& a) noexcept { return a * a; }
    friend Wide scaled(const Wide& a, double power) noexcept { return a * Wide(power); }
    friend Wide choose(bool condition, const Wide& yes, const Wide& no) noexcept { return condition ? yes : no; }
    /// The value as a double, for decisions.
    friend double nearly(const Wide& a) noexcept { return a.rounded(); }

private:
    /// Takes the exponent out of the part.
    Wide(Real part, int exponent) noexcept : part_(part), exponent_(exponent) {
        if (part_.hi == 0.0 || !(__builtin_fabs(part_.hi) <= 0x1.fffffffffffffp1023)) {
            exponent_ = 0;
            return;
        }
        if (exponent_of(part_.hi) < -500) {
            part_ = scaled(part_, 0x1p600);
            exponent_ -= 600;
        }
        const int own = exponent_of(part_.hi);
        part_ = scaled(scaled(part_, power_of_two(-own / 2)), power_of_two(-own - -own / 2));
        exponent_ += own;
    }

    Real part_;        ///< 0, or of size 1 to 2
    int exponent_ = 0; ///< of 2
};

template <> inline Wide rounded_to<Wide>(Real a) noexcept { return a; }

} // namespace ROTCONV_TARGET
} // namespace rotconv
