#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Texts from outside, and counts, as sentences have them.
namespace rotconv::cli {

/// A text as messages may show it: what could move a terminal's cursor, hide or end the line is escaped.
[[nodiscard]] std::string shown(std::string_view text);

/// The same in quotes, cut where it is long.
[[nodiscard]] std::string quoted(std::string_view text);

/// The texts in quotes, or "none".
[[nodiscard]] std::string quoted_list(const std::vector<std::string>& texts);

/// The texts with their numbers from 1, as far as they fit.
[[nodiscard]] std::string numbered(const std::vector<std::string>& texts);

/// "1 row", "2 rows".
[[nodiscard]] std::string counted(std::size_t count, std::string_view noun);

/// A word as a shell reads it: in quotes where it needs them.
[[nodiscard]] std::string in_shell(std::string_view word);

/// A number in JSON; a string where it is not finite.
[[nodiscard]] std::string json_number(double value);

} // namespace rotconv::cli
