#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rotconv::cli {

/// The table of representations.
[[nodiscard]] std::string list_all();

/// What one representation is: formula, numbers, ranges, modifiers, presets; nothing where there is none of that name.
[[nodiscard]] std::optional<std::string> list_one(std::string_view name);

/// What one preset sets; nothing where there is none of that name.
[[nodiscard]] std::optional<std::string> list_preset(std::string_view name);

/// The table of presets.
[[nodiscard]] std::string list_presets();

/// The table of methods.
[[nodiscard]] std::string list_methods();

/// The end of --help: the names, and commands to copy.
[[nodiscard]] std::string help_footer();

} // namespace rotconv::cli
