#pragma once

#include <string_view>

namespace rotconv::cli {

/// Writes `rotconv: message` and a line end to stderr, in one piece. Where stderr cannot be written there is nobody to
/// tell.
void print_error(std::string_view message);

} // namespace rotconv::cli
