#pragma once

#include <string>
#include <vector>

namespace rotconv::cli {

/// What `rotconv list WORD...` prints: the table of representations, or what one of them or a preset is, the presets,
/// or the methods, of all pairs or of those named. Throws Usage where a word is none of that.
[[nodiscard]] std::string list(const std::vector<std::string>& words);

/// The end of --help: the names, and commands to copy.
[[nodiscard]] std::string help_footer();

} // namespace rotconv::cli
