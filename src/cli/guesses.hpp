#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rotconv/spec.hpp>

/// What somebody may have meant who typed a word that is none: by meaning before spelling.
namespace rotconv::cli {

struct Guess {
    std::string text;      ///< that is legal; empty: nothing needs to be said
    std::string_view kind; ///< what the word is elsewhere, such as "preset"; may be empty
    std::string of;        ///< of which representations it is one
};

/// The legal word that begins with the text, or else the nearest.
[[nodiscard]] std::optional<Guess> guess_by_spelling(std::string_view text, const std::vector<std::string_view>& legal);

/// `legal` has the words that could stand in the place of the one at fault.
[[nodiscard]] std::optional<Guess> guess_spec(const SpecError& error, const std::vector<std::string_view>& legal);

/// An option, perhaps with its argument.
[[nodiscard]] std::optional<Guess> guess_option(std::string_view text, const std::vector<std::string_view>& legal);

} // namespace rotconv::cli
