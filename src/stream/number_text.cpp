#include "number_text.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <system_error>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <dragonbox/dragonbox.h>
#include <fmt/compile.h>

#include "scan_number.hpp"

namespace rotconv::stream {
namespace {

static_assert(std::endian::native == std::endian::little, "f64 is little-endian, and digits stand in words");

__extension__ using Uint128 = unsigned __int128;

constexpr int most_digits = 17;

// Numbers of attitudes and angles have a form without an exponent, if they are no smaller than
constexpr double smallest_plain = 1e-4;
// and smaller than
constexpr double plain_end = 1e15;
// fmt writes the others, in the same form, but for small ones in their shortest.

constexpr int lowest_point = -3; // digits before the point, less zeros behind it

double without_sign_of_nan(double value) noexcept { return std::isnan(value) ? std::abs(value) : value; }

/// Sixteen digits.
struct Digits16 {
    Uint128 text; ///< the first in its lowest byte
    int count;    ///< of them, less zeros at the end
};

/// The digits of two numbers below 10^8: they are halved until each digit stands alone, all of them at once. Quotients
/// are products with the reciprocal, rounded up, and exact for all that come.
Digits16 split(std::uint64_t first, std::uint64_t second) noexcept {
#ifdef __SSE2__
    __m128i parts = _mm_set_epi64x(static_cast<std::int64_t>(second), static_cast<std::int64_t>(first));
    const __m128i myriads = _mm_srli_epi64(_mm_mul_epu32(parts, _mm_set1_epi64x(3'518'437'209)), 45);
    parts = _mm_sub_epi64(parts, _mm_mul_epu32(myriads, _mm_set1_epi64x(10'000)));
    parts = _mm_or_si128(myriads, _mm_slli_epi64(parts, 32));
    const __m128i hundreds = _mm_srli_epi16(_mm_mulhi_epu16(parts, _mm_set1_epi16(5243)), 3);
    parts = _mm_sub_epi16(parts, _mm_mullo_epi16(hundreds, _mm_set1_epi16(100)));
    parts = _mm_or_si128(hundreds, _mm_slli_epi32(parts, 16));
    const __m128i tens = _mm_mulhi_epu16(parts, _mm_set1_epi16(6554));
    parts = _mm_sub_epi16(parts, _mm_mullo_epi16(tens, _mm_set1_epi16(10)));
    parts = _mm_or_si128(tens, _mm_slli_epi16(parts, 8));
    const auto zeros = static_cast<unsigned>(_mm_movemask_epi8(_mm_cmpeq_epi8(parts, _mm_setzero_si128())));
    return {std::bit_cast<Uint128>(_mm_or_si128(parts, _mm_set1_epi8('0'))),
            static_cast<int>(std::bit_width(zeros ^ 0xffffU))};
#else
    const auto eight_digits = [](std::uint64_t number) {
        std::uint64_t parts = number / 10'000 | (number % 10'000) << 32U;
        const std::uint64_t hundreds = parts * 5243 >> 19U & 0x7f'0000'007f;
        parts = hundreds | (parts - 100 * hundreds) << 16U;
        const std::uint64_t tens = parts * 103 >> 10U & 0x000f'000f'000f'000f;
        return tens | (parts - 10 * tens) << 8U;
    };
    const std::uint64_t high = eight_digits(first);
    const std::uint64_t low = eight_digits(second);
    constexpr std::uint64_t ascii = 0x3030'3030'3030'3030;
    return {static_cast<Uint128>(low | ascii) << 64U | (high | ascii),
            16 - (low != 0 ? std::countl_zero(low) : 64 + std::countl_zero(high)) / 8};
#endif
}

/// 17 digits, of which the first is not 0 and `point` (-3 to 15) stand before the point, without zeros at their end.
/// Writes beyond the end that it returns.
char* write_digits(char* to, std::uint64_t digits, int point, bool negative) noexcept {
    constexpr std::uint64_t half = powers_of_ten[8];
    const auto first = static_cast<char>('0' + digits / powers_of_ten[16]);
    const std::uint64_t sixteen = digits % powers_of_ten[16];
    const auto [others, count] = split(sixteen / half, sixteen % half);

    *to = '-';
    to += negative ? 1 : 0;
    if (point <= 0) {
        constexpr std::array leading{'0', '.', '0', '0', '0'};
        std::memcpy(to, leading.data(), leading.size());
        to += 2 - point;
        *to = first;
        std::memcpy(to + 1, &others, sizeof others);
        return to + 1 + count;
    }
    *to = first;
    std::memcpy(to + 1, &others, sizeof others);
    if (count < point) {
        return to + point;
    }
    to[point] = '.';
    const Uint128 decimals = others >> static_cast<unsigned>(8 * (point - 1));
    std::memcpy(to + point + 1, &decimals, sizeof decimals);
    return to + count + 2;
}

/// The shortest digits in the form of fmt's {}.
char* write_shortest(char* to, double value) {
    const double magnitude = std::abs(value);
    constexpr auto end = std::bit_cast<std::uint64_t>(plain_end);
    if (std::bit_cast<std::uint64_t>(magnitude) - 1 >= end - 1) { // 0, or not below it
        return fmt::format_to(to, FMT_COMPILE("{}"), without_sign_of_nan(value));
    }
    namespace policy = jkj::dragonbox::policy;
    auto [digits, exponent] =
        jkj::dragonbox::to_decimal(magnitude, policy::sign::ignore, policy::trailing_zero::ignore);
    int count = static_cast<int>(std::bit_width(digits)) * 1233 >> 12; // log10(2) is 1233 / 4096
    count += digits >= powers_of_ten[static_cast<std::size_t>(count)] ? 1 : 0;
    digits *= powers_of_ten[static_cast<std::size_t>(most_digits - count)];
    const int point = count + exponent;
    if (point >= lowest_point) {
        return write_digits(to, digits, point, std::signbit(value));
    }
    to = std::ranges::copy(std::string_view("e-0"), write_digits(to, digits, 1, std::signbit(value))).out;
    const int power = 1 - point; // of two digits or three
    return std::to_chars(power < 10 ? to : to - 1, to + 3, power).ptr;
}

/// A power of ten that is significand 2^exponent.
struct PowerOfTen {
    std::uint64_t significand; ///< of 64 bits
    int exponent;
};

constexpr auto scales = [] {
    std::array<PowerOfTen, most_digits - lowest_point + 1> powers{};
    std::uint64_t power_of_five = 1;
    for (std::size_t i = 0; i < powers.size(); ++i) {
        const int zeros = std::countl_zero(power_of_five);
        powers[i] = {power_of_five << static_cast<unsigned>(zeros), static_cast<int>(i) - zeros};
        power_of_five *= 5;
    }
    return powers;
}();

/// How many digits a plain number has before the point.
int point_of(double magnitude) noexcept {
    // Below 1 they are a little more than the powers, and no double lies between: it is the powers that are compared.
    static constexpr std::array ends{1e-4, 1e-3, 1e-2, 1e-1, 1e0,  1e1,  1e2,  1e3,  1e4,  1e5,
                                     1e6,  1e7,  1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const int exponent = static_cast<int>(std::bit_cast<std::uint64_t>(magnitude) >> 52U) - 1023;
    const int point = (exponent * 1233 >> 12) + 1; // or one more
    const int place = point - lowest_point + 1;
    return point + (magnitude >= ends[static_cast<std::size_t>(place)] ? 1 : 0);
}

/// The number times 10^decimals (up to 20), rounded to an integer, to even where it is a tie; the result has at most 17
/// digits.
///
/// The double and the power of ten are significands of 64 bits with exponents, exact both: their product, in two words,
/// is the exact value.
std::uint64_t round_to_units(double magnitude, int decimals) noexcept {
    const auto bits = std::bit_cast<std::uint64_t>(magnitude);
    const int exponent = static_cast<int>(bits >> 52U) - 1023;
    const std::uint64_t significand = bits << 11U | std::uint64_t{1} << 63U;
    const PowerOfTen& scale = scales[static_cast<std::size_t>(decimals)];
    const auto shift = static_cast<unsigned>(-1 - exponent - scale.exponent); // 6 or more: digits take up to 57 bits
    if (shift > 64) {
        return 0; // below half a unit
    }
    const Uint128 product = static_cast<Uint128>(significand) * scale.significand;
    const auto high = static_cast<std::uint64_t>(product >> 64U);
    const auto low = static_cast<std::uint64_t>(product);
    const std::uint64_t units = shift < 64 ? high >> shift : 0;
    const bool half = (high >> (shift - 1) & 1U) != 0;
    const bool more = (high << (65 - shift) | low) != 0;
    return units + (half && (more || (units & 1U) != 0) ? 1 : 0);
}

/// Significant digits in the form of fmt's {:g}.
char* write_rounded(char* to, double value, int precision) {
    const double magnitude = std::abs(value);
    if (magnitude >= smallest_plain && magnitude < plain_end && precision <= most_digits) {
        int point = point_of(magnitude);
        std::uint64_t digits = point <= precision ? round_to_units(magnitude, precision - point) : 0;
        digits *= powers_of_ten[static_cast<std::size_t>(most_digits - precision)];
        if (digits == powers_of_ten[most_digits]) { // carried to the front
            ++point;
            digits /= 10;
        }
        if (point <= precision) {
            return write_digits(to, digits, point, std::signbit(value));
        }
    }
    return fmt::format_to(to, FMT_COMPILE("{:.{}g}"), without_sign_of_nan(value), precision);
}

/// With so many digits after the point. What rounds to 0 has no sign. Writes beyond the end that it returns.
char* write_fixed(char* to, double value, int decimals) {
    constexpr int most_decimals = 16;
    const double magnitude = std::abs(value);
    const std::uint64_t unit = powers_of_ten[static_cast<std::size_t>(std::min(decimals, most_digits))];
    constexpr auto end_of_digits = static_cast<double>(powers_of_ten[most_digits]);
    if (decimals > most_decimals || !(magnitude * static_cast<double>(unit) < end_of_digits)) {
        char* const end = fmt::format_to(to, FMT_COMPILE("{:.{}f}"), without_sign_of_nan(value), decimals);
        const bool is_zero = std::string_view(to, end).find_first_not_of("-0.") == std::string_view::npos;
        return is_zero && *to == '-' ? std::copy(to + 1, end, to) : end;
    }
    const std::uint64_t units = round_to_units(magnitude, decimals);
    *to = '-';
    to += value < 0.0 && units > 0 ? 1 : 0;
    const std::uint64_t whole = units / unit;
    *to = static_cast<char>('0' + whole);
    to = whole < 10 ? to + 1 : fmt::format_to(to, FMT_COMPILE("{}"), whole);
    if (decimals == 0) {
        return to;
    }
    constexpr std::uint64_t half = powers_of_ten[8];
    const std::uint64_t fraction = units % unit * powers_of_ten[static_cast<std::size_t>(most_decimals - decimals)];
    const Uint128 digits = split(fraction / half, fraction % half).text;
    *to++ = '.';
    std::memcpy(to, &digits, sizeof digits);
    return to + decimals;
}

/// Not by scan_number(): most such texts are too short for it.
bool scan_whole(std::string_view text, double& value) noexcept {
    const char* const end = text.data() + text.size();
    const auto [stop, error] = fast_float::from_chars(text.data(), end, value);
    return error != std::errc::invalid_argument && stop == end;
}

} // namespace

const char* scan_any_number(const char* begin, const char* end, double& value) noexcept {
    const auto [stop, error] = fast_float::from_chars(begin, end, value); // later versions tell what is out of range
    return error == std::errc::invalid_argument ? nullptr : stop;
}

std::string_view trimmed(std::string_view text) noexcept {
    const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
    if (!text.empty() && !is_blank(text.front()) && !is_blank(text.back())) {
        return text; // as nearly all are
    }
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

NumberError read_number(std::string_view text, double& value) noexcept {
    if (scan_whole(text, value) && std::isfinite(value)) {
        return NumberError::none; // as nearly all are
    }
    text = trimmed(text);
    if (text.starts_with('+')) {
        text.remove_prefix(1);
        if (text.starts_with('-')) {
            return NumberError::not_a_number;
        }
    }
    if (!scan_whole(text, value)) {
        return NumberError::not_a_number;
    }
    const bool is_spelt_out = text.find_first_of("123456789") == std::string_view::npos; // inf
    return std::isinf(value) && !is_spelt_out ? NumberError::too_large : NumberError::none;
}

bool is_number(std::string_view text) noexcept {
    double value = 0.0;
    return read_number(text, value) != NumberError::not_a_number;
}

char* write_numbers(char* to, std::span<const double> numbers, char delimiter, Digits digits) {
    const auto write_all = [&](const auto& write) {
        for (const double number : numbers) {
            to = write(number);
            *to++ = delimiter;
        }
        return numbers.empty() ? to : to - 1;
    };
    if (digits.decimals >= 0) {
        return write_all([&](double number) { return write_fixed(to, number, digits.decimals); });
    }
    if (digits.shortest()) {
        return write_all([&](double number) { return write_shortest(to, number); });
    }
    return write_all([&](double number) { return write_rounded(to, number, digits.significant); });
}

void append_numbers(Buffer& to, std::span<const double> numbers, char delimiter, Digits digits) {
    const std::size_t size = to.size();
    to.reserve(size + room_for(numbers.size(), digits));
    to.resize(static_cast<std::size_t>(write_numbers(to.data() + size, numbers, delimiter, digits) - to.data()));
}

void append_number(Buffer& to, double value, Digits digits) { append_numbers(to, {&value, 1}, ' ', digits); }

std::string number_text(double value, Digits digits) {
    Buffer text;
    append_number(text, value, digits);
    return fmt::to_string(text);
}

void append_bytes(Buffer& to, std::span<const double> numbers) {
    const auto bytes = std::as_bytes(numbers);
    append(to, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}); // NOLINT(*-reinterpret-cast)
}

} // namespace rotconv::stream
