#include "utf8.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace rotconv::stream {
namespace {

struct Character {
    std::size_t length = 0;
    std::uint32_t code = 0;
};

/// The character that the text begins with; its length is 0 if it is not UTF-8.
Character first_of(std::string_view text) noexcept {
    const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const auto length = static_cast<std::size_t>(std::countl_one(byte(0))); // if there are several bytes
    if (length == 0) {
        return {1, byte(0)};
    }
    // Refused are longer forms than are needed, surrogates, and code points past U+10FFFF.
    static constexpr std::array<std::uint32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    if (length == 1 || length >= least.size() || text.size() < length) {
        return {};
    }
    std::uint32_t code = byte(0) & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) {
            return {};
        }
        code = (code << 6U) | (byte(i) & 0x3FU);
    }
    const bool is_legal = code >= least.at(length) && (code < 0xD800 || code > 0xDFFF) && code <= 0x10FFFF;
    return is_legal ? Character{length, code} : Character{};
}

} // namespace

std::size_t utf8_length(std::string_view text) noexcept { return first_of(text).length; }

std::size_t printable_length(std::string_view text) noexcept {
    // Control characters and Unicode's for formatting: marks, line ends, directions, joiners, annotations, tags.
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
    const Character first = first_of(text);
    const bool shows_nothing = std::ranges::any_of(
        unprintable, [&first](const Range& range) { return range.first <= first.code && first.code <= range.second; });
    return shows_nothing ? 0 : first.length;
}

} // namespace rotconv::stream
