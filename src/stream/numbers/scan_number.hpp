#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <fast_float/fast_float.h>

namespace rotconv::stream {

/// All that a word of 64 bits holds.
constexpr auto powers_of_ten = [] {
    std::array<std::uint64_t, 20> powers{1};
    for (std::size_t i = 1; i < powers.size(); ++i) {
        powers[i] = 10 * powers[i - 1];
    }
    return powers;
}();

/// Those that a double holds exactly.
constexpr std::array exact_powers_of_ten{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                         1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// The same as scan_number(), by fast_float alone.
[[gnu::cold, gnu::noinline]] const char* scan_any_number(const char* begin, const char* end, double& value) noexcept;

/// Reads a number as most are: a digit first, and no more than 19 digits without leading zeros.
///
/// Its digits are an integer below 10^19, which a word of 64 bits holds exactly. So the integer and the exponent of ten
/// are the number itself, and fast_float's compute_float() either rounds their product correctly or says that it
/// cannot. Sixteen or eight digits are taken at once, and the last ones without a loop: a loop over 15, 16 or 17 digits
/// spends most of its time on an end that the processor did not predict.
class NumberScan {
public:
    /// Bytes that may be read: a sign, 23 digits, a point, 39 digits, e, a sign, 24 digits.
    static constexpr std::ptrdiff_t reach = 90;

    explicit NumberScan(const char* begin) noexcept : at_(begin) {}

    /// @return the place after the number; null where none begins, or one that is left to scan_any_number()
    const char* scan(double& value) noexcept {
        const bool is_negative = take('-');
        std::uint64_t digits = static_cast<unsigned char>(*at_ - '0');
        if (digits > 9) {
            return nullptr;
        }
        if (at_[1] == '.') {
            ++at_;
        } else if (digits = 0; !take_digits(digits)) {
            return nullptr;
        }
        std::int64_t exponent = 0;
        if (take('.')) {
            const char* const decimals = at_;
            if (!take_sixteen(digits) || !take_digits(digits)) {
                return nullptr;
            }
            exponent = decimals - at_;
        }
        if (take('e') || take('E')) {
            const bool is_small = take('-');
            static_cast<void>(is_small || take('+'));
            std::uint64_t power = 0;
            if (!take_power(power)) {
                return nullptr;
            }
            exponent += is_small ? -static_cast<std::int64_t>(power) : static_cast<std::int64_t>(power);
        }
        if (digits < std::uint64_t{1} << 53U && exponent <= 0 && exponent >= -22) { // both exact: one rounding
            const double magnitude = static_cast<double>(static_cast<std::int64_t>(digits)) /
                                     exact_powers_of_ten[static_cast<std::size_t>(-exponent)];
            value = is_negative ? -magnitude : magnitude;
            return at_;
        }
        const auto result = fast_float::compute_float<fast_float::binary_format<double>>(exponent, digits);
        if (result.power2 < 0) { // too close to a tie
            return nullptr;
        }
        fast_float::to_float(is_negative, result, value);
        return at_;
    }

private:
    bool take(char c) noexcept {
        const bool is_there = *at_ == c;
        at_ += is_there ? 1 : 0;
        return is_there;
    }

    /// The number of eight digits, the first in the lowest byte: two digits become one number, then two of these, then
    /// two of those.
    static std::uint64_t number_of(std::uint64_t eight) noexcept {
        eight = eight * (10 << 8U | 1) >> 8U & 0x00ff'00ff'00ff'00ff;
        eight = eight * (100 << 16U | 1) >> 16U & 0x0000'ffff'0000'ffff;
        return eight * (std::uint64_t{10'000} << 32U | 1) >> 32U;
    }

    /// Appends the digits that stand here to a number.
    /// @return false where there are more than 23, or too many for a word
    bool take_digits(std::uint64_t& number) noexcept {
        for (int words = 0; words < 3; ++words, at_ += 8) {
            std::uint64_t eight = 0;
            std::memcpy(&eight, at_, sizeof eight);
            eight ^= 0x3030'3030'3030'3030; // digits become 0 to 9
            // The highest bit of what is above 9. The sum of such a byte may carry into the next one: up to the first
            // such byte all bits are right.
            const std::uint64_t others = ((eight + 0x7676'7676'7676'7676) | eight) & 0x8080'8080'8080'8080;
            if (others != 0) {
                const auto zeros = static_cast<unsigned>(std::countr_zero(others)); // 8 count + 7
                const unsigned count = zeros / 8;
                if (number >= powers_of_ten[19 - count]) {
                    return false;
                }
                number = number * powers_of_ten[count] + number_of(eight << 8U << (63 - zeros)); // behind zeros
                at_ += count;
                return true;
            }
            if (number >= powers_of_ten[11]) {
                return false;
            }
            number = number * powers_of_ten[8] + number_of(eight);
        }
        return false;
    }

    /// The digits of an exponent: two, as C prints it, or else any up to four that count.
    bool take_power(std::uint64_t& power) noexcept {
        const auto digit = [this](std::ptrdiff_t i) { return static_cast<unsigned char>(at_[i] - '0'); };
        if (digit(0) <= 9 && digit(1) <= 9 && digit(2) > 9) {
            power = 10U * digit(0) + digit(1);
            at_ += 2;
            return true;
        }
        const char* const first = at_;
        return take_digits(power) && at_ != first && power <= 9999;
    }

    /// Appends sixteen digits, where as many stand here: 5 % of the time of a conversion of text.
    /// @return false where they are too many for a word
    bool take_sixteen([[maybe_unused]] std::uint64_t& number) noexcept {
#ifdef __SSE2__
        __m128i parts;
        std::memcpy(&parts, at_, sizeof parts);
        parts = _mm_xor_si128(parts, _mm_set1_epi8('0'));
        const __m128i excess = _mm_subs_epu8(parts, _mm_set1_epi8(9));
        if (_mm_movemask_epi8(_mm_cmpeq_epi8(excess, _mm_setzero_si128())) != 0xffff) {
            return true;
        }
        if (number >= powers_of_ten[3]) {
            return false;
        }
        parts = _mm_add_epi16(_mm_mullo_epi16(parts, _mm_set1_epi16(10)), _mm_srli_epi16(parts, 8));
        parts = _mm_madd_epi16(_mm_and_si128(parts, _mm_set1_epi16(0xff)), _mm_set1_epi32(1 << 16 | 100));
        parts = _mm_madd_epi16(_mm_packs_epi32(parts, parts), _mm_set1_epi32(1 << 16 | 10'000));
        const auto halves = static_cast<std::uint64_t>(_mm_cvtsi128_si64(parts));
        number = number * powers_of_ten[16] + (halves & 0xffff'ffff) * powers_of_ten[8] + (halves >> 32U);
        at_ += 16;
#endif
        return true;
    }

    const char* at_;
};

/// Reads the number at the beginning of a text as read_number() would, except that it takes no plus sign and no blanks.
/// What is too large is infinite. If the text goes on for NumberScan::reach bytes after the number, reading it takes
/// half the time.
/// @return the place after the number; null if there is none
inline const char* scan_number(const char* begin, const char* end, double& value) noexcept {
    const char* const stop = end - begin >= NumberScan::reach ? NumberScan(begin).scan(value) : nullptr;
    return stop != nullptr ? stop : scan_any_number(begin, end, value);
}

} // namespace rotconv::stream
