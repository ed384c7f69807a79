#include "number_text.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <system_error>
#include <type_traits>

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

/// Writes the sixteen digits of two numbers below 10^8: they are halved until each digit stands alone, all of them at
/// once. Quotients are products with the reciprocal, rounded up, and exact for all that come.
/// @return a bit for each digit that is not 0; the first digit has the lowest
[[gnu::always_inline]] inline unsigned split(std::uint64_t first, std::uint64_t second, char* to) noexcept {
#ifdef __SSE2__
    __m128i parts = _mm_set_epi64x(static_cast<std::int64_t>(second), static_cast<std::int64_t>(first));
    const __m128i myriads = _mm_srli_epi64(_mm_mul_epu32(parts, _mm_set1_epi64x(3'518'437'209)), 45);
    parts = _mm_sub_epi64(parts, _mm_mul_epu32(myriads, _mm_set1_epi64x(10'000)));
    parts = _mm_or_si128(myriads, _mm_slli_epi64(parts, 32));
    const __m128i hundreds = _mm_srli_epi16(_mm_mulhi_epu16(parts, _mm_set1_epi16(5243)), 3);
    parts = _mm_sub_epi16(parts, _mm_madd_epi16(hundreds, _mm_set1_epi16(100))); // of a product gcc makes six shifts
    parts = _mm_or_si128(hundreds, _mm_slli_epi32(parts, 16));
    const __m128i tenth = _mm_set1_epi16(6554);
    const __m128i tens = _mm_mulhi_epu16(parts, tenth);
    parts = _mm_mulhi_epu16(_mm_mullo_epi16(parts, tenth), _mm_set1_epi16(10)); // the fractions tenfold
    parts = _mm_or_si128(tens, _mm_slli_epi16(parts, 8));
    const auto zeros = static_cast<unsigned>(_mm_movemask_epi8(_mm_cmpeq_epi8(parts, _mm_setzero_si128())));
    // NOLINTNEXTLINE(*-reinterpret-cast)
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm_or_si128(parts, _mm_set1_epi8('0')));
    return zeros ^ 0xffffU;
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
    const std::array<std::uint64_t, 2> text{high | ascii, low | ascii};
    std::memcpy(to, text.data(), sizeof text);
    const auto bits = [](std::uint64_t parts) { // that are not 0, from the first
        return static_cast<unsigned>(
            ((parts + 0x7f7f'7f7f'7f7f'7f7f) & 0x8080'8080'8080'8080) * 0x0002'0408'1020'4081 >> 56U);
    };
    return bits(low) << 8U | bits(high);
#endif
}

/// A number as 17 digits, of which the first is 0 only for 0, and where its point stands.
struct Decimal {
    std::uint64_t digits;
    std::ptrdiff_t point; ///< so many digits stand before it
};

constexpr int most_point = 15;
constexpr int not_decimal = 1000; ///< a point: what fmt writes

/// The shortest digits of any number that is not 0.
[[gnu::noinline]] Decimal shortest_of_any(double magnitude) noexcept {
    namespace policy = jkj::dragonbox::policy;
    auto [digits, exponent] =
        jkj::dragonbox::to_decimal(magnitude, policy::sign::ignore, policy::trailing_zero::ignore);
    for (; digits < powers_of_ten[most_digits - 1]; --exponent) {
        digits *= 10;
    }
    return {digits, exponent + most_digits};
}

constexpr std::uint64_t smallest_normal = std::uint64_t{1} << 52U;

/// The same for normal numbers: the common path of Dragonbox (Jeon 2020, algorithm 5.1) in its terms, with its powers
/// as version 1.1.3 has them. Whether digits have a last one takes no branch: it would be mispredicted for a third of
/// all numbers. What is not clear at once, 1 % of numbers, is left to Dragonbox.
[[gnu::always_inline]] inline Decimal shortest_of_normal(std::uint64_t bits) noexcept {
    const std::uint64_t fraction = bits & (smallest_normal - 1);
    if (fraction == 0) [[unlikely]] {
        return shortest_of_any(std::bit_cast<double>(bits));
    }
    const int exponent = static_cast<int>(bits >> 52U) - 1075;
    const int minus_k = (exponent * 315'653 >> 20) - 2;       // log10(2) is 315653 / 2^20
    const int beta = exponent + (-minus_k * 1'741'647 >> 19); // log2(10) is 1741647 / 2^19
    using Powers = std::remove_cv_t<decltype(jkj::dragonbox::policy::cache::full)>;
    const auto power = Powers::get_cache<jkj::dragonbox::ieee754_binary64>(-minus_k);
    const auto delta = static_cast<std::uint32_t>(power.high() >> static_cast<unsigned>(63 - beta)); // 100 to 999
    const std::uint64_t end = (2 * (fraction | smallest_normal) | 1U) << static_cast<unsigned>(beta);
    const Uint128 product = static_cast<Uint128>(end) * power.high() + (static_cast<Uint128>(end) * power.low() >> 64U);
    const auto z = static_cast<std::uint64_t>(product >> 64U);
    const std::uint64_t thousands = z / 1000; // of 15 digits or 16
    const auto rest = static_cast<std::uint32_t>(z - 1000 * thousands);
    const std::uint32_t hundredths = (rest - delta / 2 + 50) * 656;                // of 65536
    if (rest == 0 || rest == delta || (hundredths & 0xffffU) < 656) [[unlikely]] { // hundreds exactly
        return shortest_of_any(std::bit_cast<double>(bits));
    }
    // Signs of differences: of comparisons compilers make branches.
    const std::uint32_t has_last = (delta - rest) >> 31U;
    const std::uint64_t last = hundredths >> 16U & (0U - has_last);
    const auto has_all = static_cast<std::size_t>((powers_of_ten[15] - 1 - thousands) >> 63U);
    static constexpr std::array<std::uint64_t, 3> factors{100, 10, 1};
    return {thousands * factors[has_all] + last * factors[has_all + 1],
            minus_k + 2 + most_digits - 1 + static_cast<int>(has_all)};
}

/// The shortest digits.
[[gnu::always_inline]] inline Decimal shortest(double value) noexcept {
    constexpr auto end = std::bit_cast<std::uint64_t>(plain_end);
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(value) & ~(std::uint64_t{1} << 63U);
    if (bits - smallest_normal < end - smallest_normal) [[likely]] {
        return shortest_of_normal(bits);
    }
    if (bits == 0 || bits >= end) {
        return {0, bits == 0 ? 1 : not_decimal};
    }
    return shortest_of_any(std::abs(value));
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
    const std::uint64_t half = high >> (shift - 1) & 1U;
    const std::uint64_t more = (high << (65 - shift) | low) != 0 ? 1 : 0;
    return units + (half & (more | units)); // no branches, of which half would be mispredicted
}

/// Significant digits.
[[gnu::always_inline]] inline Decimal rounded(double value, int precision) noexcept {
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
            return {digits, point};
        }
    }
    return {0, magnitude == 0.0 ? 1 : not_decimal};
}

/// 17 digits as they are written. In memory, not in values: of these gcc makes stores of bytes that loads of words wait
/// for.
struct DecimalText {
    static constexpr std::size_t first = 15;
    alignas(16) std::array<char, 48> digits; ///< 17 from the first; what follows is read, but not used
    unsigned not_zero;                       ///< a bit for each digit but the first; the second has the lowest

    [[gnu::always_inline]] void set(std::uint64_t number) noexcept {
        constexpr std::uint64_t half = powers_of_ten[8];
        const std::uint64_t nine = number / half;
        const std::uint64_t one = static_cast<std::uint32_t>(nine) / static_cast<std::uint32_t>(half);
        digits[first] = static_cast<char>('0' + one);
        not_zero = split(nine - one * half, number - nine * half, digits.data() + first + 1);
    }
};

/// Where the parts of a number stand, by its point.
struct alignas(8) Arrangement {
    std::uint8_t first; ///< digit
    std::uint8_t point;
    std::uint8_t decimals;   ///< for a second time
    std::uint8_t shift;      ///< bits of the digits that stand before the point, but the first
    std::uint8_t characters; ///< that are no significant digits, if one of these stands behind the point
};

constexpr auto arrangements = [] {
    std::array<Arrangement, most_point - lowest_point + 1> all{};
    for (int point = lowest_point; point <= most_point; ++point) {
        const auto at = static_cast<std::uint8_t>(point);
        const auto leading = static_cast<std::uint8_t>(2 - point);
        all[static_cast<std::size_t>(point - lowest_point)] =
            point > 0 ? Arrangement{0, at, static_cast<std::uint8_t>(at + 1), static_cast<std::uint8_t>(at - 1), 1}
                      : Arrangement{leading, 1, static_cast<std::uint8_t>(leading + 1), 0, leading};
    }
    return all;
}();

/// Without zeros at the end, and without branches. Writes beyond the end that it returns.
[[gnu::always_inline]] inline char* write_plain(char* to, const DecimalText& text, std::ptrdiff_t point) noexcept {
    const Arrangement& place = arrangements[static_cast<std::size_t>(point - lowest_point)];
    constexpr std::array leading{'0', '.', '0', '0', '0', '0', '0', '0'};
    std::memcpy(to, leading.data(), leading.size());
    to[place.first] = text.digits[DecimalText::first];
    std::memcpy(to + place.first + 1, text.digits.data() + DecimalText::first + 1, 16);
    to[place.point] = '.';
    std::memcpy(to + place.decimals, text.digits.data() + DecimalText::first + 1 + place.shift, 16);
    const std::ptrdiff_t count = std::bit_width(2 * text.not_zero + 1); // 1 at least: of 0 it takes a branch
    return to + (count > point ? count + place.characters : point);
}

[[gnu::noinline]] char* write_with_exponent(char* to, const DecimalText& text, std::ptrdiff_t point) noexcept {
    to = std::ranges::copy(std::string_view("e-0"), write_plain(to, text, 1)).out;
    const std::ptrdiff_t power = 1 - point; // of two digits or three
    return std::to_chars(power < 10 ? to : to - 1, to + 3, power).ptr;
}

[[gnu::noinline]] char* write_by_fmt(char* to, double value, int precision) {
    value = without_sign_of_nan(value);
    return precision == 0 ? fmt::format_to(to, FMT_COMPILE("{}"), value)
                          : fmt::format_to(to, FMT_COMPILE("{:.{}g}"), value, precision);
}

/// Any number but those that fmt writes.
[[gnu::always_inline]] inline char* write_decimal(char* to, double value, const DecimalText& text,
                                                  std::ptrdiff_t point) {
    *to = '-';
    to += std::bit_cast<std::uint64_t>(value) >> 63U;
    return point >= lowest_point ? write_plain(to, text, point) : write_with_exponent(to, text, point);
}

constexpr int most_decimals = 16;

/// All digits, with so many after the point.
[[gnu::always_inline]] inline Decimal fixed(double value, int decimals) noexcept {
    const double magnitude = std::abs(value);
    const auto unit = static_cast<double>(powers_of_ten[static_cast<std::size_t>(std::min(decimals, most_digits))]);
    constexpr auto end_of_digits = static_cast<double>(powers_of_ten[most_digits]);
    if (decimals > most_decimals || !(magnitude * unit < end_of_digits)) [[unlikely]] {
        return {0, not_decimal};
    }
    const std::uint64_t units = round_to_units(magnitude, decimals);
    return {units, 0};
}

/// What rounds to 0 has no sign. Writes beyond the end that it returns.
[[gnu::always_inline]] inline char* write_fixed(char* to, double value, const Decimal& decimal, const DecimalText& text,
                                                int decimals) noexcept {
    *to = '-';
    to += std::bit_cast<std::uint64_t>(value) >> 63U & (decimal.digits != 0 ? 1U : 0U);
    const int whole = most_digits - decimals;
    const int zeros = std::countr_zero(2 * text.not_zero | (text.digits[DecimalText::first] != '0' ? 1U : 0U) |
                                       1U << (static_cast<unsigned>(whole) - 1U) % 32U); // that are not written
    std::memcpy(to, text.digits.data() + DecimalText::first + zeros, most_digits);
    to += whole - zeros;
    if (decimals == 0) {
        return to;
    }
    *to++ = '.';
    std::memcpy(to, text.digits.data() + DecimalText::first + whole, most_decimals);
    return to + decimals;
}

[[gnu::noinline]] char* write_fixed_by_fmt(char* to, double value, int decimals) {
    char* const end = fmt::format_to(to, FMT_COMPILE("{:.{}f}"), without_sign_of_nan(value), decimals);
    const bool is_zero = std::string_view(to, end).find_first_not_of("-0.") == std::string_view::npos;
    return is_zero && *to == '-' ? std::copy(to + 1, end, to) : end;
}

/// In steps, each for several numbers: all that one number takes waits for itself.
template <class DecimalOf, class Write, class WriteOther>
char* write_steps(char* to, std::span<const double> numbers, char delimiter, const DecimalOf& decimal_of,
                  const Write& write, const WriteOther& write_other) {
    constexpr std::size_t most = 16;
    std::array<Decimal, most> decimals;  // NOLINT(*-member-init)
    std::array<DecimalText, most> texts; // NOLINT(*-member-init)
    while (!numbers.empty()) {
        const std::size_t count = std::min(numbers.size(), most);
        for (std::size_t i = 0; i < count; ++i) {
            decimals[i] = decimal_of(numbers[i]);
        }
        for (std::size_t i = 0; i < count; ++i) {
            texts[i].set(decimals[i].digits);
        }
        for (std::size_t i = 0; i < count; ++i) {
            if (decimals[i].point == not_decimal) [[unlikely]] {
                to = write_other(to, numbers[i]);
            } else {
                to = write(to, numbers[i], decimals[i], texts[i]);
            }
            *to++ = delimiter;
        }
        numbers = numbers.subspan(count);
    }
    return to - 1;
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
    if (numbers.empty()) {
        return to;
    }
    if (const int decimals = digits.decimals; decimals >= 0) {
        return write_steps(
            to, numbers, delimiter, [=](double number) { return fixed(number, decimals); },
            [=](char* at, double number, const Decimal& decimal, const DecimalText& text) {
                return write_fixed(at, number, decimal, text, decimals);
            },
            [=](char* at, double number) { return write_fixed_by_fmt(at, number, decimals); });
    }
    const auto write = [](char* at, double number, const Decimal& decimal, const DecimalText& text) {
        return write_decimal(at, number, text, decimal.point);
    };
    const int precision = digits.significant;
    const auto write_other = [=](char* at, double number) { return write_by_fmt(at, number, precision); };
    if (precision == 0) {
        return write_steps(
            to, numbers, delimiter, [](double number) { return shortest(number); }, write, write_other);
    }
    return write_steps(
        to, numbers, delimiter, [=](double number) { return rounded(number, precision); }, write, write_other);
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
