#include "decimal.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

#include "number_text.hpp"

namespace rotconv::stream {
namespace {

/// Twice this, and the length of any text, stay within 64 bits.
constexpr std::int64_t largest_power = 1'000'000'000'000'000'000;
/// More digits than any number has that lies halfway between two doubles (767).
constexpr std::int64_t widest_gap = 800;

bool are_digits(std::string_view text) noexcept {
    return std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// The number after the e; nothing where there is none.
std::optional<std::int64_t> read_power(std::string_view text) noexcept {
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) {
        text.remove_prefix(1);
    }
    if (text.empty() || !are_digits(text)) {
        return std::nullopt;
    }
    std::int64_t power = 0;
    if (std::from_chars(text.data(), text.data() + text.size(), power).ec != std::errc{}) {
        power = largest_power;
    }
    power = std::min(power, largest_power);
    return negative ? -power : power;
}

} // namespace

std::optional<Decimal> Decimal::parse(std::string_view text) {
    text = trimmed(text);
    Decimal number;
    number.negative_ = text.starts_with('-');
    if (number.negative_ || text.starts_with('+')) {
        text.remove_prefix(1);
    }
    const std::string_view mantissa = text.substr(0, text.find_first_of("eE"));
    const std::string_view whole = mantissa.substr(0, mantissa.find('.'));
    const std::string_view fraction = mantissa.substr(std::min(whole.size() + 1, mantissa.size()));
    number.digits_.reserve(mantissa.size());
    number.digits_.append(whole).append(fraction);
    if (number.digits_.empty() || !are_digits(number.digits_)) {
        return std::nullopt;
    }
    number.point_ = static_cast<std::int64_t>(whole.size());
    if (mantissa.size() < text.size()) {
        const auto power = read_power(text.substr(mantissa.size() + 1));
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
        return b.digits_.empty() <=> a.digits_.empty();
    }
    const auto order = a.point_ <=> b.point_;
    return order != 0 ? order : a.digits_.compare(b.digits_) <=> 0;
}

std::strong_ordering operator<=>(const Decimal& a, const Decimal& b) noexcept {
    if (a.negative_ != b.negative_) {
        return b.negative_ <=> a.negative_;
    }
    return a.negative_ ? Decimal::compare_magnitudes(b, a) : Decimal::compare_magnitudes(a, b);
}

Decimal operator-(const Decimal& a, const Decimal& b) {
    const bool a_is_larger = Decimal::compare_magnitudes(a, b) >= 0;
    const Decimal& larger = a_is_larger ? a : b;
    Decimal smaller = a_is_larger ? b : a;
    Decimal result = larger;
    result.negative_ = a_is_larger ? a.negative_ : !b.negative_;
    if (smaller.digits_.empty()) {
        result.strip(); // no -0
        return result;
    }
    if (smaller.point_ < larger.end() - widest_gap) {
        smaller.digits_ = "1";
        smaller.point_ = larger.end() - widest_gap;
    }
    // As on paper: the digits of both in their places, one more in front for what is carried there.
    const std::int64_t end = std::min(larger.end(), smaller.end());
    std::string& digits = result.digits_;
    digits.insert(0, 1, '0').append(static_cast<std::size_t>(larger.end() - end), '0');
    ++result.point_;
    const int sign = a.negative_ == b.negative_ ? -1 : 1;
    auto place = digits.end() - static_cast<std::ptrdiff_t>(smaller.end() - end);
    int carried = 0;
    for (auto digit = smaller.digits_.rbegin(); digit != smaller.digits_.rend() || carried != 0;) {
        int value = *--place - '0' + carried;
        if (digit != smaller.digits_.rend()) {
            value += sign * (*digit++ - '0');
        }
        carried = value < 0 ? -1 : value / 10;
        *place = static_cast<char>('0' + value - 10 * carried);
    }
    result.strip();
    return result;
}

double Decimal::rounded(int power) const {
    const std::string text = (negative_ ? "-0." : "0.") + digits_ + "e" + std::to_string(point_ + power);
    double value = 0.0;
    if (!digits_.empty() && read_number(text, value) == NumberFault::too_large) {
        value = std::numeric_limits<double>::infinity();
        value = negative_ ? -value : value;
    }
    return value;
}

} // namespace rotconv::stream
