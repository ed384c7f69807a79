#pragma once

#include <string_view>

/// Words of other programs.
namespace rotconv::cli {

/// What a word means here, or why there is no such thing.
struct Meaning {
    std::string_view words; ///< without marks and in lower case, or as they are typed; with blanks between
    /// What to write in its place: a SPEC, options or a command, or several such with " | " between; empty: `about`
    /// says it. :WORD is a modifier of a SPEC on the command line, - nothing at all; ARG stands for what follows the
    /// word (@ARG: at the end, as VALUEs), FROM for the SPEC of --from, ~ for a blank. tail leaves out as many lines.
    std::string_view instead;
    std::string_view about;
    bool is_verb = false; ///< people write it in the place of a command
    bool in_spec = false; ///< it has the meaning only in a SPEC
};

/// Null for other words. Marks and capitals do not count if a word has letters: "--max-error", "scalar_last".
[[nodiscard]] const Meaning* find_meaning(std::string_view word);

} // namespace rotconv::cli
