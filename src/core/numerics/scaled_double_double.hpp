#pragma once

#include "double_double.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// Marks functions that are called for a few rows alone, and would be long in line.
#if defined(__GNUC__)
#define ROTCONV_NOINLINE __attribute__((noinline))
#else
#define ROTCONV_NOINLINE
#endif

/// A DoubleDouble with an exponent of its own, for the few rows whose products would leave its range: slow, and right
/// at any size. Errors as of DoubleDouble.
class ScaledDoubleDouble {
public:
    ScaledDoubleDouble() noexcept = default;
    ScaledDoubleDouble(double value) noexcept : ScaledDoubleDouble(DoubleDouble(value)) {}
    ScaledDoubleDouble(DoubleDouble value) noexcept : ScaledDoubleDouble(value, 0) {}

    /// Rounded once, to subnormal numbers too; infinite where it is too large.
    [[nodiscard]] ROTCONV_NOINLINE double rounded() const noexcept {
        ScaledDoubleDouble a = *this;
        a.normalize();
        if (a.exponent_ > 1023) {
            return a.part_.hi * __builtin_inf();
        }
        if (a.exponent_ >= -1022) {
            return a.part_.hi * power_of_two(a.exponent_);
        }
        if (a.exponent_ < -1080) {
            return 0.0;
        }
        // In units of 2^-1074: to the nearest whole number, of two the even one unless the low part says which.
        const DoubleDouble units = scaled(scaled(a.part_, power_of_two(a.exponent_ + 600)), 0x1p474);
        const double rounding = __builtin_copysign(0x1p52, units.hi);
        const double whole = (units.hi + rounding) - rounding;
        const double rest = units.hi - whole;
        const bool is_tie = __builtin_fabs(rest) == 0.5 && rest * units.lo > 0.0;
        return (whole + (is_tie ? 2.0 * rest : 0.0)) * 0x1p-537 * 0x1p-537;
    }
    /// What is too small for the parts is rounded away.
    [[nodiscard]] DoubleDouble rounded_parts() const noexcept {
        const double high = rounded();
        return {high, (*this - ScaledDoubleDouble(high)).rounded()};
    }
    [[nodiscard]] bool is_zero() const noexcept { return part_.hi == 0.0; }
    [[nodiscard]] bool is_negative() const noexcept { return part_.hi < 0.0; }
    [[nodiscard]] ScaledDoubleDouble magnitude() const noexcept { return is_negative() ? -*this : *this; }
    /// The exponent of the power of two that its leading bit stands for; very low for 0.
    [[nodiscard]] int exponent() const noexcept { return is_zero() ? -1'000'000 : exponent_ + exponent_of(part_.hi); }
    /// This times 2^power.
    [[nodiscard]] ScaledDoubleDouble shifted(int power) const noexcept { return {part_, exponent_ + power}; }

    friend ScaledDoubleDouble operator-(const ScaledDoubleDouble& a) noexcept { return {-a.part_, a.exponent_}; }
    ROTCONV_NOINLINE friend ScaledDoubleDouble operator+(const ScaledDoubleDouble& a,
                                                         const ScaledDoubleDouble& b) noexcept {
        if (a.is_zero() || b.is_zero()) {
            return a.is_zero() ? b : a;
        }
        const int distance = a.exponent() - b.exponent();
        const ScaledDoubleDouble& first = distance >= 0 ? a : b;
        const ScaledDoubleDouble& second = distance >= 0 ? b : a;
        if (distance > 300 || distance < -300) {
            return first;
        }
        return {first.part_ + scaled(second.part_, power_of_two(second.exponent_ - first.exponent_)), first.exponent_};
    }
    friend ScaledDoubleDouble operator-(const ScaledDoubleDouble& a, const ScaledDoubleDouble& b) noexcept {
        return a + -b;
    }
    friend ScaledDoubleDouble sloppy_sum(const ScaledDoubleDouble& a, const ScaledDoubleDouble& b) noexcept {
        return a + b;
    }
    ROTCONV_NOINLINE friend ScaledDoubleDouble operator*(const ScaledDoubleDouble& a,
                                                         const ScaledDoubleDouble& b) noexcept {
        return {a.part_ * b.part_, a.exponent_ + b.exponent_};
    }
    ROTCONV_NOINLINE friend ScaledDoubleDouble operator/(const ScaledDoubleDouble& a,
                                                         const ScaledDoubleDouble& b) noexcept {
        return {a.part_ / b.part_, a.exponent_ - b.exponent_};
    }
    ROTCONV_NOINLINE friend ScaledDoubleDouble root(const ScaledDoubleDouble& a) noexcept {
        const int odd = a.exponent_ & 1;
        return {root(scaled(a.part_, odd != 0 ? 2.0 : 1.0)), (a.exponent_ - odd) / 2};
    }
    friend ScaledDoubleDouble square(const ScaledDoubleDouble& a) noexcept { return a * a; }
    friend ScaledDoubleDouble scaled(const ScaledDoubleDouble& a, double power) noexcept {
        return {scaled(a.part_, power), a.exponent_};
    }
    friend ScaledDoubleDouble select(bool condition, const ScaledDoubleDouble& yes,
                                     const ScaledDoubleDouble& no) noexcept {
        return condition ? yes : no;
    }
    friend bool is_at_most(const ScaledDoubleDouble& a, const ScaledDoubleDouble& b) noexcept {
        return !(b - a).is_negative();
    }
    /// The nearest double, which may be 0 or infinite; see sign_of().
    friend double to_double(const ScaledDoubleDouble& a) noexcept { return a.rounded(); }
    /// A number with the sign of this one, and 0 only for 0.
    friend double sign_of(const ScaledDoubleDouble& a) noexcept { return a.part_.hi; }

private:
    /// Sums, products, quotients and roots of parts between these, and what a sum leaves where it cancels, stay in
    /// DoubleDouble's range; so do parts times a signed power of two near 1.
    static constexpr int largest_part = 100;

    ScaledDoubleDouble(DoubleDouble part, int exponent) noexcept : part_(part), exponent_(exponent) {
        const int own = exponent_of(part_.hi);
        if (own > largest_part || own < -largest_part) {
            normalize();
        }
    }
    /// Takes the exponent out of the part, which is then 0, or of size 1 to 2.
    ROTCONV_NOINLINE void normalize() noexcept {
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

    DoubleDouble part_; ///< 0, or of size 2^-100 to 2^101
    int exponent_ = 0;  ///< of 2
};

template <> struct Scalars<ScaledDoubleDouble> {
    using Precise = ScaledDoubleDouble;
    using Given = ScaledDoubleDouble;
};

} // namespace ROTCONV_TARGET
} // namespace rotconv
