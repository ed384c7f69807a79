#include "json_string.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace rotconv::stream {
namespace {

/// Length of the valid UTF-8 sequence that `text` begins with; 0 where it begins with none.
std::size_t utf8_length(std::string_view text) noexcept {
    const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80U) {
        return 1;
    }
    const std::size_t length = first >= 0xC2U && first <= 0xDFU   ? 2
                               : first >= 0xE0U && first <= 0xEFU ? 3
                               : first >= 0xF0U && first <= 0xF4U ? 4
                                                                  : 0;
    if (length == 0 || text.size() < length) {
        return 0;
    }
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) {
            return 0;
        }
    }
    // no overlong forms, surrogates or code points past U+10FFFF
    const unsigned char second = byte(1);
    const bool legal = !(first == 0xE0U && second < 0xA0U) && !(first == 0xEDU && second > 0x9FU) &&
                       !(first == 0xF0U && second < 0x90U) && !(first == 0xF4U && second > 0x8FU);
    return legal ? length : 0;
}

} // namespace

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
