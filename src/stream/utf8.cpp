#include "utf8.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace rotconv::stream {

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

std::size_t printable_length(std::string_view text) noexcept {
    // Controls of ASCII and of Latin 1, and what Unicode has for formatting: marks, line ends, directions, joiners.
    using Range = std::pair<std::string_view, std::string_view>;
    static constexpr std::array<Range, 7> unprintable{{{std::string_view("\0", 1), "\x1F"},
                                                       {"\x7F", "\x7F"},
                                                       {"\xC2\x80", "\xC2\x9F"},
                                                       {"\xE2\x80\x8B", "\xE2\x80\x8F"},
                                                       // NOLINTNEXTLINE(misc-misleading-bidirectional): it is escaped
                                                       {"\xE2\x80\xA8", "\xE2\x80\xAE"},
                                                       {"\xE2\x81\xA0", "\xE2\x81\xAF"},
                                                       {"\xEF\xBB\xBF", "\xEF\xBB\xBF"}}};
    const std::size_t length = utf8_length(text);
    const std::string_view character = text.substr(0, length);
    const bool shows_nothing = std::ranges::any_of(unprintable, [character](const Range& range) {
        return range.first <= character && character <= range.second && character.size() == range.first.size();
    });
    return shows_nothing ? 0 : length;
}

} // namespace rotconv::stream
