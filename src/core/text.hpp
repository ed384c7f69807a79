#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace rotconv {

/// What stands between the marks, which may be nothing.
[[nodiscard]] inline std::vector<std::string_view> split(std::string_view text, char mark) {
    std::vector<std::string_view> parts{text.substr(0, text.find(mark))};
    while (parts.back().end() != text.end()) {
        text.remove_prefix(parts.back().size() + 1);
        parts.push_back(text.substr(0, text.find(mark)));
    }
    return parts;
}

/// With the letters of ASCII in lower case.
[[nodiscard]] inline std::string lower(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; });
    return result;
}

/// The text as names of SPECs are held against each other: in lower case, without - and _.
[[nodiscard]] inline std::string plain_name(std::string_view text) {
    std::string result = lower(text);
    std::erase_if(result, [](char c) { return c == '-' || c == '_'; });
    return result;
}

/// A letter or a digit of ASCII.
[[nodiscard]] constexpr bool is_alphanumeric(char c) noexcept {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

/// Whether a text is digits, at least one, and nothing else.
[[nodiscard]] constexpr bool is_digits(std::string_view text) noexcept {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

} // namespace rotconv
