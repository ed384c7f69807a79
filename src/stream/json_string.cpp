#include "json_string.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "utf8.hpp"

namespace rotconv::stream {

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
