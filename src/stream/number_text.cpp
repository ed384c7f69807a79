#include "number_text.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include <dragonbox/dragonbox.h>
#include <dragonbox/dragonbox_to_chars.h>
#include <fmt/compile.h>

namespace rotconv::stream {
namespace {

/// Whether a decimal number outside the range of double is too large, not too small: std::from_chars does not tell.
bool is_large(std::string_view digits) noexcept {
    if (digits.starts_with('-')) {
        digits.remove_prefix(1);
    }
    const auto exponent_at = digits.find_first_of("eE");
    const std::string_view mantissa = digits.substr(0, exponent_at);
    const auto point = mantissa.find('.');
    const auto whole = static_cast<long long>(point == std::string_view::npos ? mantissa.size() : point);
    const auto leading = mantissa.find_first_of("123456789");
    if (leading == std::string_view::npos) {
        return false;
    }
    const auto place = static_cast<long long>(leading);
    long long magnitude =
        place < whole ? whole - place : whole - place + 1; // the first digit is worth 10^(magnitude - 1)
    if (exponent_at != std::string_view::npos) {
        std::string_view exponent = digits.substr(exponent_at + 1);
        const bool negative = exponent.starts_with('-');
        if (negative || exponent.starts_with('+')) {
            exponent.remove_prefix(1);
        }
        long long value = 0;
        if (std::from_chars(exponent.data(), exponent.data() + exponent.size(), value).ec != std::errc{}) {
            return !negative;
        }
        return negative ? magnitude > value : magnitude > -value;
    }
    return magnitude > 0;
}

// Dragonbox writes the shortest digits as d.dddE-1 in half of the time of fmt; most numbers of attitudes and angles
// need no more than the point moved to have the form of fmt's {}.

/// From 1e-4 to below 1.
char* write_fraction(char* to, double magnitude) noexcept {
    constexpr std::ptrdiff_t exponent_size = 3; // E-1 to E-4
    const std::ptrdiff_t exponent = magnitude >= 0.1 ? 1 : magnitude >= 0.01 ? 2 : magnitude >= 0.001 ? 3 : 4;
    std::memset(to, '0', 5);
    char* const digits = to + exponent; // so that those behind the point are in their place
    const char* const end = jkj::dragonbox::to_chars_n(magnitude, digits) - exponent_size;
    digits[1] = std::exchange(digits[0], '0');
    to[1] = '.';
    return to + std::max(end - to, exponent + 2);
}

/// From 1 to below 1000; null where the digits end before the point.
char* write_whole(char* to, double magnitude) noexcept {
    constexpr std::ptrdiff_t exponent_size = 2; // E0 to E2
    const std::ptrdiff_t exponent = magnitude < 10 ? 0 : magnitude < 100 ? 1 : 2;
    char* const end = jkj::dragonbox::to_chars_n(magnitude, to) - exponent_size;
    if (end - to > exponent + 2) {
        std::copy_n(to + 2, exponent, to + 1);
        to[exponent + 1] = '.';
        return end;
    }
    return end == to + 1 && exponent == 0 ? end : nullptr;
}

/// The shortest digits in the form of fmt's {}.
char* write_shortest(char* to, double value) {
    const double magnitude = std::abs(value);
    if (magnitude >= 1e-4 && magnitude < 1e3) {
        char* const unsigned_to = to + (std::signbit(value) ? 1 : 0);
        *to = '-';
        char* const end = magnitude < 1 ? write_fraction(unsigned_to, magnitude) : write_whole(unsigned_to, magnitude);
        if (end != nullptr) {
            return end;
        }
    }
    return fmt::format_to(to, FMT_COMPILE("{}"), std::isnan(value) ? magnitude : value); // no sign for nan
}

constexpr auto powers_of_ten = [] {
    std::array<std::uint64_t, 18> powers{1};
    for (std::size_t i = 1; i < powers.size(); ++i) {
        powers[i] = 10 * powers[i - 1];
    }
    return powers;
}();

std::ptrdiff_t digits_of(std::uint64_t number) noexcept {
    return std::ranges::upper_bound(powers_of_ten, number) - powers_of_ten.begin();
}

/// Up to 15 significant digits in the form of fmt's {:g}, of a number from 1e-4 to below 1e15; null where it takes the
/// exact value to round, or the form is another.
///
/// The shortest digits, rounded, are those of the value rounded: half of a digit would be a number between the two that
/// is shorter, or nearer, than the shortest digits; only where they end in that 5 they do not tell. Up to 15 digits a
/// number that has no more is its own rounding.
char* write_rounded(char* to, double value, int precision) noexcept {
    const double magnitude = std::abs(value);
    if (!(magnitude >= 1e-4 && magnitude < 1e15) || precision > 15) {
        return nullptr;
    }
    auto [digits, exponent] = jkj::dragonbox::to_decimal(magnitude, jkj::dragonbox::policy::sign::ignore);
    if (const std::ptrdiff_t more = digits_of(digits) - precision; more > 0) {
        const std::uint64_t unit = powers_of_ten[static_cast<std::size_t>(more)];
        const std::uint64_t rest = digits % unit;
        if (2 * rest == unit) {
            return nullptr;
        }
        digits = digits / unit + (2 * rest > unit ? 1 : 0);
        exponent += static_cast<int>(more);
        for (; digits % 10 == 0; digits /= 10) {
            ++exponent;
        }
    }
    const std::ptrdiff_t count = digits_of(digits);
    const std::ptrdiff_t point = count + exponent; // digits before it
    if (point > precision) {
        return nullptr;
    }
    *to = '-';
    to += std::signbit(value) ? 1 : 0;
    if (point <= 0) {
        std::memset(to, '0', 6);
        to[1] = '.';
        to += 2 - point;
    }
    char* const end = std::to_chars(to, to + count, digits).ptr;
    if (point >= count) {
        return std::fill_n(end, point - count, '0');
    }
    if (point > 0) {
        std::copy_backward(to + point, end, end + 1);
        to[point] = '.';
        return end + 1;
    }
    return end;
}

} // namespace

std::string_view trimmed(std::string_view text) noexcept {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

NumberError read_number(std::string_view text, double& value) noexcept {
    const char* const whole_end = text.data() + text.size();
    if (const auto [stop, error] = std::from_chars(text.data(), whole_end, value);
        stop == whole_end && error == std::errc{}) {
        return NumberError::none; // as nearly all are
    }
    text = trimmed(text);
    if (text.starts_with('+')) {
        text.remove_prefix(1);
        if (text.starts_with('-')) {
            return NumberError::not_a_number;
        }
    }
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error == std::errc::invalid_argument || stop != end) {
        return NumberError::not_a_number;
    }
    if (error == std::errc::result_out_of_range) {
        if (is_large(text)) {
            return NumberError::too_large;
        }
        value = 0.0;
    }
    return NumberError::none;
}

bool is_number(std::string_view text) noexcept {
    double value = 0.0;
    return read_number(text, value) != NumberError::not_a_number;
}

void append_number(Buffer& to, double value, int precision) {
    if (precision == 0) {
        append_numbers(to, {&value, 1}, ' ');
        return;
    }
    constexpr std::size_t longest = 32;
    const std::size_t size = to.size();
    to.reserve(size + longest);
    if (const char* const end = write_rounded(to.data() + size, value, precision)) {
        to.resize(static_cast<std::size_t>(end - to.data()));
    } else if (std::isnan(value)) {
        append(to, "nan"); // whatever its sign bit
    } else {
        fmt::format_to(std::back_inserter(to), FMT_COMPILE("{:.{}g}"), value, precision);
    }
}

void append_numbers(Buffer& to, std::span<const double> numbers, char delimiter) {
    constexpr std::size_t longest = 32; // -2.2250738585072014e-308 has 24
    to.reserve(to.size() + longest * numbers.size());
    char* end = to.data() + to.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i > 0) {
            *end++ = delimiter;
        }
        end = write_shortest(end, numbers[i]);
    }
    to.resize(static_cast<std::size_t>(end - to.data()));
}

static_assert(std::endian::native == std::endian::little, "f64 is little-endian");

void append_bytes(Buffer& to, std::span<const double> numbers) {
    const auto bytes = std::as_bytes(numbers);
    append(to, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}); // NOLINT(*-reinterpret-cast)
}

} // namespace rotconv::stream
