#include "words.hpp"

#include <algorithm>
#include <cmath>

#include "../stream/fmt.hpp"
#include "../stream/utf8.hpp"

namespace rotconv::cli {

std::string shown(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = stream::printable_length(text);
        if (length > 0) {
            result += text.substr(0, length);
        } else {
            result += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result;
}

std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 80;
    return fmt::format("'{}{}'", shown(text.substr(0, longest)), text.size() > longest ? "..." : "");
}

std::string quoted_list(const std::vector<std::string>& texts) {
    std::string list;
    for (const std::string& text : texts) {
        list += (list.empty() ? "" : ", ") + quoted(text);
    }
    return list.empty() ? "none" : list;
}

std::string numbered(const std::vector<std::string>& texts) {
    constexpr std::size_t longest = 500;
    std::string list;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (list.size() > longest) {
            return list + ", ...";
        }
        list += fmt::format("{}{} {}", i == 0 ? "" : ", ", i + 1, shown(std::string_view(texts[i]).substr(0, longest)));
    }
    return list;
}

std::string counted(std::size_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string in_shell(std::string_view word) {
    const bool is_plain = !word.empty() && std::ranges::all_of(word, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("-_./:,=+@").find(c) != std::string_view::npos;
    });
    std::string text;
    for (const char c : word) {
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return is_plain ? text : fmt::format("'{}'", text);
}

std::string json_number(double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : fmt::format("\"{}\"", value);
}

} // namespace rotconv::cli
