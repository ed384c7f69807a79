#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
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

/// The end of a word of the command line, from one of its characters on: an argument, or the whole word.
struct WordEnd {
    std::size_t word = 0;
    std::size_t begin = 0;
};

/// An option of a command: what its help says, and what it is given.
struct Option {
    std::string_view names;    ///< such as "-f,--from"
    std::string_view argument; ///< what stands for it in the help; empty if the option takes none
    std::string_view about;
    std::vector<std::string_view> choices{}; ///< words for the argument, the default first; empty: it may be any text
    std::string_view group{};                ///< its title in the help; empty: the command does not have the option
    bool repeats = false;                    ///< it may be given several times
    bool is_list = false;                    ///< the argument may be several, with commas between
    std::vector<std::string> texts{};        ///< the arguments; of an option that takes none, its name
    WordEnd place{};                         ///< of the last argument

    [[nodiscard]] bool takes_argument() const noexcept { return !argument.empty(); }
    /// "--from".
    [[nodiscard]] std::string_view name() const { return names.substr(names.find(',') + 1); }
    [[nodiscard]] bool given() const noexcept { return !texts.empty(); }
    /// The first argument; empty if the option is not given.
    [[nodiscard]] const std::string& text() const noexcept;
};

/// The words of a command line that are not options, and what is wrong with those that are.
struct Operands {
    std::vector<std::string> values{};
    std::vector<std::string> files{};
    std::vector<WordEnd> file_words{}; ///< of FILEs
    std::string first_option{};
    std::string unknown{}; ///< the first option that the command does not have
    std::string misuse{};  ///< what is wrong with an option, in words
};

/// The options of a command, in the order of its help, and what is given beside them.
class OptionSet : public Operands {
public:
    OptionSet() = default;
    OptionSet(const OptionSet&) = delete;
    OptionSet& operator=(const OptionSet&) = delete;
    virtual ~OptionSet() = default;

    /// Adds options under that title. They will have what is given, and must outlive the set.
    void add(std::string_view group, std::initializer_list<Option*> options) {
        for (Option* const option : options) {
            option->group = group;
            options_.push_back(option);
        }
    }
    /// The command takes NAMEs in the place of FILEs and VALUEs.
    void take_names(std::string_view about) { names_ = about; }

    [[nodiscard]] bool takes_names() const noexcept { return !names_.empty(); }
    [[nodiscard]] const std::vector<Option*>& all() const noexcept { return options_; }
    /// By one of its names, or null.
    [[nodiscard]] Option* find(std::string_view name) const;
    /// @param other if given, options of which its help says the same are only named
    [[nodiscard]] std::string help(const OptionSet* other = nullptr) const;

    /// Reads words from the one at `begin` on, and keeps what is given. A word that is_value() is a VALUE, except where
    /// an option awaits its argument. Any other word that is not an option is a FILE, or ends the reading if it comes
    /// first and names a command. Where a word is a VALUE, or holds a number and is not a file, all are VALUEs, if no
    /// other is a file or means something by itself.
    /// @return the word at which reading ended: the name of a command, or none
    /// @throw Usage where an option lacks its argument
    [[nodiscard]] std::size_t read(const std::vector<std::string>& words, std::size_t begin,
                                   const std::function<bool(std::string_view)>& is_command,
                                   const std::function<bool(std::string_view)>& has_meaning);

private:
    std::vector<Option*> options_;
    std::string_view names_; ///< of the NAMEs in the help
};

} // namespace rotconv::cli
