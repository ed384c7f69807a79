#include "utf8.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
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
    // Controls, and what Unicode has for formatting: marks, line ends, directions, joiners, annotations, tags.
    using Range = std::pair<std::uint32_t, std::uint32_t>;
    static constexpr auto unprintable = std::to_array<Range>({{0x0, 0x1F},
                                                              {0x7F, 0x9F},
                                                              {0xAD, 0xAD},
                                                              {0x61C, 0x61C},
                                                              {0x180E, 0x180E},
                                                              {0x200B, 0x200F},
                                                              {0x2028, 0x202E},
                                                              {0x2060, 0x206F},
                                                              {0xFEFF, 0xFEFF},
                                                              {0xFFF9, 0xFFFB},
                                                              {0xE0000, 0xE0FFF}});
    const std::size_t length = utf8_length(text);
    std::uint32_t code =
        length > 1 ? static_cast<unsigned char>(text[0]) & (0x7FU >> length) : static_cast<unsigned char>(text[0]);
    for (std::size_t i = 1; i < length; ++i) {
        code = (code << 6U) | (static_cast<unsigned char>(text[i]) & 0x3FU);
    }
    const bool shows_nothing = std::ranges::any_of(
        unprintable, [code](const Range& range) { return range.first <= code && code <= range.second; });
    return shows_nothing ? 0 : length;
}

} // namespace rotconv::stream
