#pragma once

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

} // namespace rotconv
