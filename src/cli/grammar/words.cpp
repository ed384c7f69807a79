#include "words.hpp"

#include <unistd.h>

#include "../../stream/bytes/file.hpp"
#include "../../stream/bytes/utf8.hpp"

namespace rotconv::cli {

std::string shown(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = stream::printable_length(text);
        result += length > 0 ? std::string(text.substr(0, length))
                             : fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result;
}

std::string shortened(std::string_view text) {
    constexpr std::size_t longest = 80;
    return shown(text.substr(0, longest)) + (text.size() > longest ? "..." : "");
}

std::string quoted(std::string_view text) { return fmt::format("'{}'", shortened(text)); }

std::string quoted_list(const std::vector<std::string>& texts) {
    return texts.empty() ? "none" : joined(mapped(texts, quoted), ", ");
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

std::vector<std::string> words_in(std::string_view text) {
    const auto words = filtered(split(text, ' '), [](std::string_view word) { return !word.empty(); });
    return {words.begin(), words.end()};
}

std::string without_marks(std::string_view text) {
    std::string result(text);
    std::erase_if(result, [](char c) { return !is_alphanumeric(c); });
    return result;
}

std::string in_shell(std::string_view word) {
    const bool is_plain = !word.empty() && std::ranges::all_of(word, [](char c) {
        return is_alphanumeric(c) || std::string_view("-_./:,=+@").find(c) != std::string_view::npos;
    });
    std::string text;
    for (const char c : word) {
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return is_plain ? text : fmt::format("'{}'", text);
}

std::string file_in_shell(const std::string& file) { return in_shell((file.starts_with('-') ? "./" : "") + file); }

JsonValue json_object(const std::vector<std::pair<std::string_view, JsonValue>>& object) {
    std::string text;
    for (const auto& [key, value] : object) {
        const bool is_there = !value.text.empty();
        text += is_there ? fmt::format("{}\"{}\": {}", text.empty() ? "" : ", ", key, value.text) : "";
    }
    return JsonValue::as_written("{" + text + "}");
}

std::string json_line(const std::vector<std::pair<std::string_view, JsonValue>>& object) {
    return json_object(object).text + "\n";
}

void print_error(std::string_view message) {
    static_cast<void>(stream::File(STDERR_FILENO).write(fmt::format("rotconv: {}\n", message)));
}

} // namespace rotconv::cli
