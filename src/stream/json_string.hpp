#pragma once

#include <string_view>

#include "number_text.hpp"

namespace rotconv::stream {

/// Appends the text as a JSON string; bytes that are not UTF-8 become U+FFFD.
void append_json_string(Buffer& to, std::string_view text);

} // namespace rotconv::stream
