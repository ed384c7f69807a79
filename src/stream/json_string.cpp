#include "json_string.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "utf8.hpp"

namespace rotconv::stream {
namespace {

/// Takes the digits off the text that it begins with.
std::string_view take_digits(std::string_view& text) noexcept {
    const std::string_view digits = text.substr(0, text.find_first_not_of("0123456789"));
    text.remove_prefix(digits.size());
    return digits;
}

bool take(std::string_view& text, std::string_view any_of) noexcept {
    const bool found = !text.empty() && any_of.find(text.front()) != std::string_view::npos;
    text.remove_prefix(found ? 1 : 0);
    return found;
}

} // namespace

bool is_json_number(std::string_view text) noexcept {
    constexpr std::string_view largest = "9007199254740992"; // 2^53
    take(text, "-");
    const std::string_view whole = take_digits(text);
    if (whole.empty() || (whole.size() > 1 && whole.front() == '0')) {
        return false;
    }
    if (text.empty()) {
        return whole.size() < largest.size() || (whole.size() == largest.size() && whole <= largest);
    }
    if (take(text, ".") && take_digits(text).empty()) {
        return false;
    }
    if (take(text, "eE")) {
        take(text, "+-");
        if (take_digits(text).empty()) {
            return false;
        }
    }
    return text.empty();
}

void append_json_string(Buffer& to, std::string_view text) {
    to.push_back('"');
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const char c = text[0];
        if (length == 0) {
            append(to, "\xEF\xBF\xBD");
        } else if (c == '"' || c == '\\') {
            to.push_back('\\');
            to.push_back(c);
        } else if (static_cast<unsigned char>(c) < 0x20U) {
            fmt::format_to(std::back_inserter(to), "\\u{:04x}", static_cast<unsigned>(c));
        } else {
            append(to, text.substr(0, length));
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    to.push_back('"');
}

} // namespace rotconv::stream
