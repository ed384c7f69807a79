#pragma once

#include <cstddef>
#include <string_view>

namespace rotconv::stream {

/// Bytes of the UTF-8 character that a text, which is not empty, begins with; 0 if there is none.
[[nodiscard]] std::size_t utf8_length(std::string_view text) noexcept;

/// The same for characters that only show something; 0 for those that move a cursor, end a line or change the direction
/// of writing.
[[nodiscard]] std::size_t printable_length(std::string_view text) noexcept;

} // namespace rotconv::stream
