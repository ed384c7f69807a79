#include "key.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <optional>

#include "../../core/text.hpp"
#include "../numbers/fmt.hpp"
#include "../numbers/number_text.hpp"
#include "../numbers/scan_number.hpp"

namespace rotconv::stream {
namespace {

constexpr int key_decimals = 18;
constexpr std::int64_t most_whole_digits = 20; // with the key_decimals 38, and all such numbers are below 2^127
constexpr Uint128 largest_exact = Uint128{1} << 53U;

bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

/// Takes the leading digits off a text, and appends them to a number, of which only the last 64 bits are kept.
std::string_view take_digits(std::string_view& text, std::uint64_t& number) noexcept {
    std::size_t size = 0;
    for (; size < text.size() && is_digit(text[size]); ++size) {
        number = 10 * number + static_cast<std::uint64_t>(text[size] - '0');
    }
    const std::string_view digits = text.substr(0, size);
    text.remove_prefix(size);
    return digits;
}

/// The number after the e, bounded; nothing if there is none.
std::optional<std::int64_t> exponent_of(std::string_view text) noexcept {
    constexpr std::int64_t bound = std::int64_t{1} << 60U; // twice it, and the length of a text, fit 64 bits
    text.remove_prefix(text.starts_with('+') && !text.starts_with("+-") ? 1 : 0);
    std::int64_t power = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), power);
    if (error == std::errc::invalid_argument || end != text.data() + text.size()) {
        return std::nullopt;
    }
    const bool is_in_range = error == std::errc();
    return is_in_range ? std::clamp(power, -bound, bound) : text.starts_with('-') ? -bound : bound;
}

/// Rounds 0.DIGITS times 10^point to whole units.
ReadKey rounded_units(std::string_view digits, std::int64_t point, int power) {
    const std::size_t zeros = std::min(digits.find_first_not_of('0'), digits.size());
    digits.remove_prefix(zeros);
    point -= static_cast<std::int64_t>(zeros);
    if (digits.empty()) {
        return {};
    }
    point += power;
    if (point > most_whole_digits) {
        return {.error = KeyError::too_large};
    }
    const std::int64_t places = point + key_decimals;
    if (places < 0) {
        return {};
    }
    const auto kept = static_cast<std::size_t>(places);
    Int128 units = 0;
    for (std::size_t i = 0; i < kept; ++i) {
        units = 10 * units + (i < digits.size() ? digits[i] - '0' : 0);
    }
    if (kept < digits.size()) {
        const bool is_half = digits.find_first_not_of('0', kept + 1) == std::string_view::npos;
        units += digits[kept] > '5' || (digits[kept] == '5' && (!is_half || units % 2 != 0)) ? 1 : 0;
    }
    return {.value = {units}};
}

ReadKey decimal_key(std::string_view text, int power) {
    const bool is_negative = text.starts_with('-');
    text.remove_prefix(is_negative || text.starts_with('+') ? 1 : 0);
    std::uint64_t number = 0;
    const std::string_view whole = take_digits(text, number);
    text.remove_prefix(text.starts_with('.') ? 1 : 0);
    const std::string_view fraction = take_digits(text, number); // without a point there are none
    const auto exponent = text.empty()                       ? std::optional<std::int64_t>(0)
                          : text[0] == 'e' || text[0] == 'E' ? exponent_of(text.substr(1))
                                                             : std::nullopt;
    if (!exponent || (whole.empty() && fraction.empty())) {
        return {.error = KeyError::not_a_number};
    }
    ReadKey key;
    const int places = key_decimals + power - static_cast<int>(fraction.size());
    if (text.empty() && whole.size() + fraction.size() <= 19 && places >= 0) { // as most are: the digits fit 64 bits
        key.value.units = Int128{number} * powers_of_ten.at(static_cast<std::size_t>(places));
    } else {
        const auto point = static_cast<std::int64_t>(whole.size()) + *exponent;
        key = rounded_units(std::string(whole).append(fraction), point, power);
    }
    key.value.units = is_negative ? -key.value.units : key.value.units;
    return key;
}

/// Reads a text that begins with a date, in the form 0000-00-00 or 0000-000 where 0 stands for any digit.
ReadKey time_key(std::string_view text, std::string_view form) {
    using namespace std::chrono;
    const std::size_t hour = form.starts_with("0000-00-00") ? 11 : 9;
    if (form.size() < hour || form[hour - 1] == ' ') {
        return {.error = KeyError::blank};
    }
    const bool has_seconds = form.substr(hour - 1).starts_with("T00:00:00");
    std::string_view fraction = text.substr(std::min(text.size(), hour + (has_seconds ? 8 : 5)));
    fraction.remove_suffix(fraction.ends_with('Z') ? 1 : fraction.ends_with("+00:00") ? 6 : 0);
    const bool has_fraction = has_seconds && fraction.size() > 1 && fraction[0] == '.' && is_digits(fraction.substr(1));
    const auto number = [text](std::size_t at, std::size_t size) {
        unsigned value = 0;
        std::from_chars(text.data() + at, text.data() + at + size, value);
        return value;
    };
    const year first(static_cast<int>(number(0, 4)));
    const bool is_ordinal = hour == 9;
    const year_month_day date = is_ordinal ? first / January / 1 : first / month(number(5, 2)) / day(number(8, 2));
    const days later(is_ordinal ? static_cast<int>(number(5, 3)) - 1 : 0);
    const unsigned second = has_seconds ? number(hour + 6, 2) : 0;
    if (!form.substr(hour - 1).starts_with("T00:00") || !(fraction.empty() || has_fraction) || !date.ok() ||
        later < days(0) || sys_days(date) + later >= sys_days((first + years(1)) / January / 1) ||
        number(hour, 2) > 23 || number(hour + 3, 2) > 59 || second > 59) {
        return {.error = KeyError::not_a_time};
    }
    const seconds whole = (sys_days(date) + later).time_since_epoch() + hours(number(hour, 2)) +
                          minutes(number(hour + 3, 2)) + seconds(second);
    ReadKey key = has_fraction ? rounded_units(fraction.substr(1), 0, 0) : ReadKey();
    key.value.units += Int128{whole.count()} * 1'000'000'000'000'000'000; // forward from it, also before 1970
    return key;
}

} // namespace

double KeyDistance::rounded() const {
    constexpr Uint128 nano = 1'000'000'000;
    const bool is_whole = units % nano == 0; // as most times are
    const Uint128 number = is_whole ? units / nano : units;
    if (number <= largest_exact) {
        return static_cast<double>(number) / (is_whole ? 1e9 : 1e18);
    }
    double value = 0.0;
    static_cast<void>(read_number(text(), value));
    return value;
}

std::string KeyDistance::text() const {
    std::string digits = fmt::format("{:019}", units);
    digits.insert(digits.size() - key_decimals, 1, '.');
    digits.resize(digits.find_last_not_of('0') + 1);
    digits.resize(digits.size() - (digits.ends_with('.') ? 1 : 0));
    return digits;
}

double Key::rounded() const {
    const double size = distance(*this, {}).rounded();
    return units < 0 ? -size : size;
}

double ratio(KeyDistance a, KeyDistance b) {
    constexpr Uint128 thousand = 1000;
    while (b.units > largest_exact && a.units % thousand == 0 && b.units % thousand == 0) {
        a.units /= thousand;
        b.units /= thousand;
    }
    return static_cast<double>(a.units) / static_cast<double>(b.units);
}

ReadKey read_key(std::string_view text, int power) {
    text = trimmed(text);
    ReadKey key = decimal_key(text, power);
    if (key.error != KeyError::not_a_number) {
        return key;
    }
    std::string form(text); // 0 for any digit
    std::ranges::replace_if(form, is_digit, '0');
    return form.starts_with("0000-00-00") || form.starts_with("0000-000") ? time_key(text, form) : key;
}

KeyDistance read_distance(std::string_view text) {
    const ReadKey key = decimal_key(trimmed(text), 0);
    return {key.error == KeyError::too_large ? ~Uint128{0}
                                             : static_cast<Uint128>(std::max(key.value.units, Int128{0}))};
}

} // namespace rotconv::stream
