#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace rotconv::cli {

/// The words of a command line, sorted into what CLI11 reads, VALUEs and FILEs.
struct Arguments {
    std::vector<std::string> options; ///< each option that takes an argument joined with it
    std::vector<std::string> values;
    std::vector<std::string> files;
    std::string error;   ///< what is wrong with an option, in words; empty where nothing is
    std::string command; ///< the first word, where it names one: it also stands in `options`
};

/// Adds the command of that name to the app and returns it, or null where there is none.
using AddCommand = std::function<const CLI::App*(const std::string& name)>;

/// CLI11 takes `-.5` for an option and `-inf` for `-i nf`, and an option's argument `-1` for an option. Here a word
/// that reads as a number, or begins with one before a comma, semicolon, blank or tab, is a VALUE except where an
/// option awaits its argument; any other word that is no option is a FILE.
[[nodiscard]] Arguments sort_arguments(const CLI::App& app, int argc, const char* const* argv,
                                       const AddCommand& add_command);

} // namespace rotconv::cli
