#pragma once

#include <string_view>

#include "number_text.hpp"

namespace rotconv::stream {

/// Appends the text as a JSON string; bytes that are not UTF-8 become U+FFFD.
void append_json_string(Buffer& to, std::string_view text);

/// A number of JSON (RFC 8259), and no integer beyond 2^53, which readers would round.
[[nodiscard]] bool is_json_number(std::string_view text) noexcept;

} // namespace rotconv::stream
