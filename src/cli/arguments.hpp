#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "option_set.hpp"

namespace rotconv::cli {

/// Where in the command line a file to read is named: from a character of one of its words to the word's end.
struct FileWord {
    std::size_t word = 0;
    std::size_t begin = 0;
};

/// The words of a command line, sorted into options, VALUEs and FILEs.
struct Arguments {
    std::vector<std::string> options{}; ///< each option that takes an argument joined with it
    std::vector<std::string> values{};
    std::vector<std::string> files{};
    std::vector<FileWord> file_words{}; ///< of FILEs and of --input
    std::string error{};                ///< what is wrong with an option, in words; empty where nothing is
    std::size_t end = 0;                ///< the first word that is not sorted: the name of a command, or none
};

/// Sorts words from the one at `begin` on. A word that reads as a number, or begins with one before a comma, semicolon,
/// blank or tab, is a VALUE except where an option awaits its argument (CLI11 takes `-.5` for an option, and `-inf` for
/// `-i nf`); any other word that is no option is a FILE, or ends the sorting where it comes first and names a command.
[[nodiscard]] Arguments sort_arguments(const OptionSet& options, const std::vector<std::string>& words,
                                       std::size_t begin, const std::function<bool(std::string_view)>& is_command);

} // namespace rotconv::cli
