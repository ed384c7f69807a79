#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "words.hpp"

namespace rotconv::cli {

/// Thrown while the command line is read, with words for the user.
class Usage : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
    template <class... Values> explicit Usage(fmt::format_string<const Values&...> format, const Values&... values)
        : std::runtime_error(fmt::format(format, values...)) {}
};

/// The same, where a SPEC is not given.
class MissingSpec : public Usage {
    using Usage::Usage;
};

/// An option of a command: its text in the help, and what was given.
struct Option {
    std::string_view names;    ///< such as "-f,--from"
    std::string_view argument; ///< what stands for it in the help; empty if the option takes none
    std::string_view about;
    std::string_view group; ///< its title in the help
    std::string given{};    ///< the argument, or the name of an option without one; empty: the option is not given
    bool repeats = false;   ///< it may be given several times...
    std::vector<std::string> more{}; ///< ...with these arguments after the first

    [[nodiscard]] bool takes_argument() const noexcept { return !argument.empty(); }
    /// "--from".
    [[nodiscard]] std::string_view name() const { return names.substr(names.find(',') + 1); }
};

/// Where in the command line a file to read is named: from a character of one of its words to the word's end.
struct FileWord {
    std::size_t word = 0;
    std::size_t begin = 0;
};

/// The words of a command line that are not options, and what is wrong with those that are.
struct Arguments {
    std::vector<std::string> values{};
    std::vector<std::string> files{};
    std::vector<FileWord> file_words{}; ///< of FILEs and of --input
    std::string first_option{};
    std::string unknown{}; ///< the first option that the command does not have
    std::string error{};   ///< what is wrong with an option, in words
    std::size_t end = 0;   ///< the word at which reading ended: the name of a command, or none
};

/// The options of a command, in the order of its help.
class OptionSet {
public:
    /// The title for the options that follow, at first "What".
    void begin_group(std::string_view title) { group_ = title; }
    /// The texts must outlive the set.
    void add(std::string_view names, std::string_view argument, std::string_view about) {
        options_.push_back({names, argument, about, group_});
    }
    void add_flag(std::string_view names, std::string_view about) { add(names, {}, about); }
    /// The option may be given several times.
    void let_repeat(std::string_view name) { find(name)->repeats = true; }
    /// Replaces the text of an option that is shared with other commands.
    void describe(std::string_view name, std::string_view about) { find(name)->about = about; }
    /// The command takes NAMEs in the place of FILEs and VALUEs.
    void take_names(std::string_view about) { names_ = about; }

    [[nodiscard]] bool takes_names() const noexcept { return !names_.empty(); }
    [[nodiscard]] const std::vector<Option>& all() const noexcept { return options_; }
    [[nodiscard]] std::string help() const;

    /// The argument of an option; empty if it is not given, or not one of these.
    [[nodiscard]] const std::string& text(std::string_view name) const;
    [[nodiscard]] bool has(std::string_view name) const { return !text(name).empty(); }
    /// All arguments of an option that may be given several times.
    [[nodiscard]] std::vector<std::string> texts(std::string_view name) const;

    /// Reads words from the one at `begin` on, and keeps what is given. A word that is_value() is a VALUE, except where
    /// an option awaits its argument. Any other word that is not an option is a FILE, or ends the reading if it comes
    /// first and names a command. Where a word is a VALUE, or holds a number and is not a file, all are VALUEs, if no
    /// other is a file or means something by itself.
    [[nodiscard]] Arguments read(const std::vector<std::string>& words, std::size_t begin,
                                 const std::function<bool(std::string_view)>& is_command,
                                 const std::function<bool(std::string_view)>& has_meaning);

private:
    /// By one of its names, or null.
    [[nodiscard]] Option* find(std::string_view name);

    std::vector<Option> options_;
    std::string_view group_ = "What";
    std::string_view names_; ///< of the NAMEs in the help
};

} // namespace rotconv::cli
