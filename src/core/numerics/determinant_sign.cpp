#include "determinant_sign.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "power_of_two.hpp"

namespace rotconv {
namespace {

__extension__ using Uint128 = unsigned __int128;

/// The exact sum of products of three doubles: a number wide enough for all of them (Kulisch 1981), as two's complement
/// in words of rising weight.
class ExactSum {
public:
    void add_product(double a, double b, double c, bool subtracts) noexcept {
        const Binary x(a);
        const Binary y(b);
        const Binary z(c);
        const Uint128 xy = static_cast<Uint128>(x.digits) * y.digits;
        const Uint128 low = static_cast<Uint128>(static_cast<std::uint64_t>(xy)) * z.digits;
        const Uint128 high = (xy >> 64U) * z.digits + (low >> 64U);
        const std::array<std::uint64_t, 3> product{static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(high),
                                                   static_cast<std::uint64_t>(high >> 64U)};
        add(product, static_cast<unsigned>(x.exponent + y.exponent + z.exponent + 3 * 1074),
            (x.is_negative != y.is_negative) != (z.is_negative != subtracts));
    }
    [[nodiscard]] int sign() const noexcept {
        if ((words_.back() >> 63U) != 0) {
            return -1;
        }
        return words_ == std::array<std::uint64_t, words>{} ? 0 : 1;
    }

private:
    static constexpr std::size_t words = (3 * 2046 + 3 * 53) / 64 + 2; // from a third power of the smallest number on

    void add(const std::array<std::uint64_t, 3>& digits, unsigned place, bool negative) noexcept {
        const unsigned shift = place % 64U;
        std::size_t word = place / 64U;
        std::uint64_t below = 0;
        Uint128 carry = negative ? 1 : 0; // of the complement, whose lower words are all ones and carry it on
        for (std::size_t i = 0; word < words; ++i, ++word) {
            const std::uint64_t digit = i < digits.size() ? digits[i] : 0;
            const std::uint64_t moved = shift == 0 ? digit : (digit << shift) | (below >> (64U - shift));
            below = digit;
            carry += static_cast<Uint128>(words_[word]) + (negative ? ~moved : moved);
            words_[word] = static_cast<std::uint64_t>(carry);
            carry >>= 64U;
        }
    }

    std::array<std::uint64_t, words> words_{};
};

} // namespace

int determinant_sign(const double* m) noexcept {
    // Cofactors of the first row, as indices of the other two factors of each product.
    constexpr std::array<std::array<std::size_t, 3>, 6> products{
        {{0, 4, 8}, {1, 5, 6}, {2, 3, 7}, {0, 5, 7}, {1, 3, 8}, {2, 4, 6}}};
    double sum = 0.0;
    double size = 0.0;
    for (std::size_t i = 0; i < products.size(); ++i) {
        const auto [a, b, c] = products[i];
        const double product = m[a] * m[b] * m[c];
        sum += i < 3 ? product : -product;
        size += std::fabs(product);
    }
    constexpr double surely = 1e-14; // some thirty times the rounding of these sums
    if (std::fabs(sum) > surely * size && size > 1e-280 && std::isfinite(size)) {
        return sum > 0.0 ? 1 : -1;
    }
    ExactSum exact;
    for (std::size_t i = 0; i < products.size(); ++i) {
        const auto [a, b, c] = products[i];
        exact.add_product(m[a], m[b], m[c], i >= 3);
    }
    return exact.sign();
}

} // namespace rotconv
