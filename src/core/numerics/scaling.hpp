#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace rotconv {

/// Largest magnitude among the arguments.
template <class... Rest> double largest_magnitude(double first, Rest... rest) noexcept {
    double largest = std::fabs(first);
    ((largest = std::max(largest, std::fabs(rest))), ...);
    return largest;
}

/// An exact scaling by a power of two, in two factors because one alone cannot span from 2^-1074 to 2^1023.
class PowerOfTwo {
public:
    /// The power that brings the finite `magnitude` into [1/2, 1); 1 for 0.
    static PowerOfTwo to_unit(double magnitude) noexcept {
        const auto biased = static_cast<int>(std::bit_cast<std::uint64_t>(magnitude) >> 52U);
        if (biased > 0 && biased < 2045) { // the usual case: one normal factor
            return {power(1022 - biased), 1.0, power(biased - 1022), 1.0};
        }
        int exponent = 0;
        std::frexp(magnitude, &exponent);
        const int half = -exponent / 2;
        const int other = -exponent - half;
        return {power(half), power(other), power(-half), power(-other)};
    }

    [[nodiscard]] double operator()(double value) const noexcept { return (value * first_) * second_; }
    [[nodiscard]] double undone(double value) const noexcept { return (value * first_back_) * second_back_; }

private:
    PowerOfTwo(double first, double second, double first_back, double second_back) noexcept
        : first_(first), second_(second), first_back_(first_back), second_back_(second_back) {}

    /// 2^exponent, for a normal result.
    static double power(int exponent) noexcept {
        return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52U);
    }

    double first_;
    double second_;
    double first_back_;
    double second_back_;
};

} // namespace rotconv
