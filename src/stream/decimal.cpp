#include "decimal.hpp"

#include <array>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <limits>

#include "number_text.hpp"

namespace rotconv::stream {
namespace {

/// Twice this, and the length of any text, stay within 64 bits.
constexpr std::int64_t largest_power = 1'000'000'000'000'000'000;
/// More digits than the longest number halfway between two doubles (767).
constexpr std::int64_t widest_gap = 800;

std::string_view leading_digits(std::string_view text) noexcept {
    return {text.begin(), std::ranges::find_if_not(text, [](char c) { return c >= '0' && c <= '9'; })};
}

/// The number after the e; nothing where there is none.
std::optional<std::int64_t> read_power(std::string_view text) noexcept {
    text.remove_prefix(text.starts_with('+') && !text.starts_with("+-") ? 1 : 0);
    std::int64_t power = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), power);
    if (error == std::errc::invalid_argument || end != text.data() + text.size()) {
        return std::nullopt;
    }
    if (error == std::errc::result_out_of_range) {
        return text.starts_with('-') ? -largest_power : largest_power;
    }
    return std::clamp(power, -largest_power, largest_power);
}

} // namespace

std::optional<Decimal> Decimal::parse(std::string_view text) {
    text = trimmed(text);
    Decimal number;
    number.negative_ = text.starts_with('-');
    if (number.negative_ || text.starts_with('+')) {
        text.remove_prefix(1);
    }
    const std::string_view whole = leading_digits(text);
    text.remove_prefix(whole.size());
    const std::string_view fraction = leading_digits(text.substr(text.starts_with('.') ? 1 : 0));
    text.remove_prefix(fraction.size() + (text.starts_with('.') ? 1 : 0));
    number.digits_.assign(whole).append(fraction);
    if (number.digits_.empty()) {
        return std::nullopt;
    }
    number.point_ = static_cast<std::int64_t>(whole.size());
    if (!text.empty()) {
        const auto power = text[0] == 'e' || text[0] == 'E' ? read_power(text.substr(1)) : std::nullopt;
        if (!power) {
            return std::nullopt;
        }
        number.point_ += *power;
    }
    number.strip();
    return number;
}

void Decimal::strip() {
    const std::size_t first = std::min(digits_.find_first_not_of('0'), digits_.size());
    if (first == digits_.size()) {
        *this = {};
        return;
    }
    digits_.resize(digits_.find_last_not_of('0') + 1);
    digits_.erase(0, first);
    point_ -= static_cast<std::int64_t>(first);
}

std::strong_ordering Decimal::compare_magnitudes(const Decimal& a, const Decimal& b) noexcept {
    if (a.digits_.empty() || b.digits_.empty()) {
        return a.digits_.size() <=> b.digits_.size();
    }
    const auto order = a.point_ <=> b.point_;
    return std::is_neq(order) ? order : std::string_view(a.digits_) <=> b.digits_;
}

std::strong_ordering operator<=>(const Decimal& a, const Decimal& b) noexcept {
    if (a.negative_ != b.negative_) {
        return a.negative_ ? std::strong_ordering::less : std::strong_ordering::greater;
    }
    return a.negative_ ? Decimal::compare_magnitudes(b, a) : Decimal::compare_magnitudes(a, b);
}

Decimal operator-(const Decimal& a, const Decimal& b) {
    const bool a_is_larger = std::is_gteq(Decimal::compare_magnitudes(a, b));
    const Decimal& larger = a_is_larger ? a : b;
    const Decimal& smaller = a_is_larger ? b : a;
    const bool subtracts = a.negative_ == b.negative_;
    std::string_view lower = smaller.digits_;
    std::int64_t lower_end = smaller.end();
    if (lower.empty()) {
        lower_end = larger.end();
    } else if (smaller.point_ < larger.end() - widest_gap) {
        lower = "1";
        lower_end = larger.end() - widest_gap - 1;
    }
    std::size_t same = 0; // digits in front, as most of two times are
    if (subtracts && larger.point_ == smaller.point_) {
        const auto [end, other] = std::ranges::mismatch(larger.digits_, lower);
        same = static_cast<std::size_t>(end - larger.digits_.begin());
        lower.remove_prefix(same);
    }
    // As on paper: the digits of both in their places, one more in front for what is carried there.
    const std::int64_t end = std::min(larger.end(), lower_end);
    Decimal result;
    result.negative_ = a_is_larger ? a.negative_ : !b.negative_;
    result.point_ = larger.point_ - static_cast<std::int64_t>(same) + 1;
    std::string& digits = result.digits_;
    digits.assign(1, '0').append(larger.digits_, same).append(static_cast<std::size_t>(larger.end() - end), '0');
    auto place = digits.end() - static_cast<std::ptrdiff_t>(lower_end - end);
    int carried = 0;
    for (auto digit = lower.rbegin(); digit != lower.rend() || carried != 0;) {
        int value = *--place - '0' + carried;
        if (digit != lower.rend()) {
            const int other = *digit++ - '0';
            value += subtracts ? -other : other;
        }
        carried = value < 0 ? -1 : value / 10;
        *place = static_cast<char>('0' + value - 10 * carried);
    }
    result.strip();
    return result;
}

int Decimal::sign_of_sum(std::initializer_list<Term> terms) noexcept {
    constexpr auto none = std::numeric_limits<std::int64_t>::min();
    std::int64_t place = std::numeric_limits<std::int64_t>::max(); // of the digits not yet added, the first or above it
    int most = 0; // what follows a place is less than so many units of it: a sum that large is decided
    for (const auto& [number, times] : terms) {
        most += std::abs(times);
    }
    int sum = 0; // in units of the last place
    while (std::abs(sum) < most) {
        if (sum == 0) { // over the places without digits, of which there may be any number
            std::int64_t first = none;
            for (const auto& [number, times] : terms) {
                first = number->end() < place ? std::max(first, std::min(number->point_, place)) : first;
            }
            if (first == none) {
                return 0;
            }
            place = first;
        }
        sum *= 10;
        for (const auto& [number, times] : terms) {
            if (number->end() < place && place <= number->point_) {
                const int digit = number->digits_[static_cast<std::size_t>(number->point_ - place)] - '0';
                sum += number->negative_ ? -times * digit : times * digit;
            }
        }
        --place;
    }
    return sum;
}

Time read_time(std::string_view text) {
    using namespace std::chrono;
    if (auto number = Decimal::parse(text)) {
        return {*std::move(number)};
    }
    text = trimmed(text);
    std::string form(text); // 0 for any digit
    std::ranges::replace_if(
        form, [](char c) { return c >= '0' && c <= '9'; }, '0');
    const bool is_ordinal = !form.starts_with("0000-00-00");
    const std::size_t hour = is_ordinal ? 9 : 11;
    if (is_ordinal && !form.starts_with("0000-000")) {
        return {.error = TimeError::not_a_time};
    }
    if (form.size() < hour || form[hour - 1] == ' ') {
        return {.error = TimeError::blank};
    }
    const bool has_seconds = form.compare(hour, 8, "00:00:00") == 0;
    const std::size_t end = hour + (has_seconds ? 8 : 5);
    if (form[hour - 1] != 'T' || !(has_seconds || form.compare(hour, 5, "00:00") == 0)) {
        return {.error = TimeError::not_a_time};
    }
    const bool has_fraction = has_seconds && (form.substr(end, 2) == ".0" || form.substr(end, 2) == ",0");
    const std::string_view fraction =
        text.substr(end, has_fraction ? std::min(form.find_first_not_of('0', end + 1), form.size()) - end : 0);
    const std::string zone = form.substr(end + fraction.size());
    if (zone.starts_with("+0") || zone.starts_with("-0")) {
        return {.error = TimeError::offset};
    }
    if (!zone.empty() && zone != "Z") {
        return {.error = TimeError::not_a_time};
    }
    if (fraction.starts_with(',')) {
        return {.error = TimeError::decimal_comma};
    }
    const auto number = [&text](std::size_t at, std::size_t size) {
        unsigned value = 0;
        std::from_chars(text.data() + at, text.data() + at + size, value);
        return value;
    };
    const year first(static_cast<int>(number(0, 4)));
    const year_month_day date = is_ordinal ? first / January / 1 : first / month(number(5, 2)) / day(number(8, 2));
    const days later(is_ordinal ? static_cast<int>(number(5, 3)) - 1 : 0);
    const unsigned second = has_seconds ? number(hour + 6, 2) : 0;
    const bool is_date =
        date.ok() && later >= days(0) && sys_days(date) + later < sys_days((first + years(1)) / January / 1);
    if (!is_date || number(hour, 2) > 23 || number(hour + 3, 2) > 59 || second > 60) {
        return {.error = TimeError::no_such_time};
    }
    if (second == 60) {
        return {.error = TimeError::leap_second};
    }
    // The fraction goes forward from the second before it, also before 1970.
    constexpr sys_days origin = year(0) / January / 1;
    const seconds whole =
        sys_days(date) + later - origin + hours(number(hour, 2)) + minutes(number(hour + 3, 2)) + seconds(second);
    static const Decimal from_origin = *Decimal::parse(std::to_string(seconds(sys_days{} - origin).count()));
    return {*Decimal::parse(std::to_string(whole.count()).append(fraction)) - from_origin};
}

Decimal Decimal::scaled(std::int64_t power) const {
    Decimal result = *this;
    result.point_ += digits_.empty() ? 0 : power;
    return result;
}

std::string Decimal::text() const {
    constexpr std::int64_t most_zeros = 20;
    const auto size = static_cast<std::int64_t>(digits_.size());
    std::string text = digits_.empty() ? "0" : digits_;
    if (point_ > size + most_zeros || point_ < -most_zeros) {
        text = digits_.substr(0, 1) + (size > 1 ? "." : "") + digits_.substr(1) + "e" + std::to_string(point_ - 1);
    } else if (point_ >= size) {
        text.append(static_cast<std::size_t>(point_ - size), '0');
    } else {
        text.insert(0, static_cast<std::size_t>(std::max<std::int64_t>(1 - point_, 0)), '0');
        text.insert(static_cast<std::size_t>(std::max<std::int64_t>(point_, 1)), 1, '.');
    }
    return negative_ ? "-" + text : text;
}

double Decimal::difference(const Decimal& a, const Decimal& b, std::int64_t power) {
    constexpr std::int64_t most_digits = 19;
    constexpr std::array powers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22}; // all exact
    const std::int64_t last = std::min(a.end(), b.end());
    const auto shift = static_cast<std::size_t>(std::abs(last + power));
    if (std::max(a.point_, b.point_) - last <= most_digits && a.negative_ == b.negative_ && shift < powers.size()) {
        const auto units_of = [last](const Decimal& number) {
            std::uint64_t units = 0;
            for (const char digit : number.digits_) {
                units = 10 * units + static_cast<std::uint64_t>(digit - '0');
            }
            for (std::int64_t place = number.end(); place > last; --place) {
                units *= 10;
            }
            return units;
        };
        const auto units = static_cast<std::int64_t>(units_of(a) - units_of(b));
        if (constexpr std::int64_t most = std::int64_t{1} << 53U; units >= -most && units <= most) {
            const auto whole = static_cast<double>(a.negative_ ? -units : units);
            return last + power < 0 ? whole / powers[shift] : whole * powers[shift];
        }
    }
    const Decimal exact = a - b;
    const std::string text =
        (exact.negative_ ? "-0." : "0.") + exact.digits_ + "e" + std::to_string(exact.point_ + power);
    double value = 0.0;
    if (!exact.digits_.empty() && read_number(text, value) == NumberError::too_large) {
        value = std::numeric_limits<double>::infinity();
        value = exact.negative_ ? -value : value;
    }
    return value;
}

} // namespace rotconv::stream
