#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grammar/words.hpp"

namespace rotconv::cli {

/// The end of a word of the command line, from one of its characters on: an argument, or the whole word.
struct WordEnd {
    std::size_t word = 0;
    std::size_t begin = 0;
};

/// Words of a command line that others replace, perhaps none.
struct Edit {
    static constexpr std::size_t at_end = std::string::npos; ///< as a word: behind the last, where an option may stand

    WordEnd at{};
    std::size_t count = 1; ///< of words from there on
    std::vector<std::string> by{};
};

/// What makes another command line of one that is wrong: see answers().
struct Mend {
    std::vector<Edit> edits{};
    std::string pipe{};                ///< commands whose output it reads; empty: there are none
    bool keeps_lines = false;          ///< they change characters alone: other mends may follow
    std::optional<std::string> text{}; ///< what they make of the beginning of the input, if that is known
    std::vector<Edit> order{};         ///< made once the command serves: it must not choose among more numbers

    /// None where it edits nothing.
    [[nodiscard]] static std::vector<Mend> unless_empty(Mend mend) {
        return mend.edits.empty() ? std::vector<Mend>() : std::vector<Mend>{std::move(mend)};
    }
};

/// Those of a group are as good as each other; the first group of which one serves counts.
using MendGroups = std::vector<std::vector<Mend>>;

/// Thrown while the command line is read, with words for the user.
class Usage : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
    template <class... Values> explicit Usage(fmt::format_string<const Values&...> format, const Values&... values)
        : std::runtime_error(fmt::format(format, values...)) {}

    /// @param hint said where none of them helps
    [[nodiscard]] Usage with(std::vector<Mend> known, std::string hint = {}) && {
        mends = std::move(known);
        otherwise = std::move(hint);
        return std::move(*this);
    }

    [[nodiscard]] Usage of(std::vector<std::string> others) && {
        specs = std::move(others);
        return std::move(*this);
    }

    std::vector<Mend> mends{};
    std::string otherwise{};
    std::vector<std::string> specs{}; ///< that may be meant in the place of --from
    bool guesses_spec = false;        ///< the mends are SPECs of which nothing is known
    bool is_choice = false;           ///< nothing is wrong if one of the mends alone serves
};

/// The same, where a SPEC is not given.
class MissingSpec : public Usage {
    using Usage::Usage;
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

/// What is given beside options, and what is wrong with those.
struct Operands {
    std::vector<std::string> values{};
    std::vector<std::string> files{};
    std::vector<WordEnd> file_words{};  ///< of FILEs
    std::vector<WordEnd> value_words{}; ///< of VALUEs
    std::string first_option{};
    std::string unknown{}; ///< the first option that the command does not have
    WordEnd unknown_place{};
    std::string misuse{};             ///< what is wrong with an option, in words
    std::vector<std::string> words{}; ///< all
    std::size_t begin = 0;            ///< the first word behind the name of the command

    /// Empty for the conversion.
    [[nodiscard]] std::string_view command_name() const {
        return begin > 0 ? std::string_view(words[begin - 1]) : std::string_view();
    }
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
    [[nodiscard]] bool has(std::string_view name) const { return find(name) != nullptr; }
    /// Null for an option that the command does not have, or that is not given.
    [[nodiscard]] const Option* given(std::string_view name) const {
        const Option* const option = find(name);
        return option != nullptr && option->given() ? option : nullptr;
    }
    /// Null for an option that the command does not have, or that is given.
    [[nodiscard]] const Option* missing(std::string_view name) const {
        const Option* const option = find(name);
        return option == nullptr || option->given() ? nullptr : option;
    }
    /// Also by a second name.
    [[nodiscard]] bool knows(std::string_view name) const;
    /// These words in the place of VALUEs; without words the VALUEs go.
    [[nodiscard]] Mend with_values(const std::vector<std::string>& instead) const;
    /// Has the option, which is given, have that argument; without one it goes.
    [[nodiscard]] static Edit changing(const Option& option, const std::string& argument);
    /// Another option with that argument, in the place of one that is given.
    [[nodiscard]] static Edit instead_of(const Option& option, std::string_view name, const std::string& argument) {
        Edit edit = changing(option, "");
        edit.by = {std::string(name), argument};
        return edit;
    }
    /// The same for an option that may not be given.
    [[nodiscard]] static Edit setting(const Option& option, const std::string& argument) {
        return option.given() ? changing(option, argument)
                              : Edit{{Edit::at_end}, 0, {std::string(option.name()), argument}};
    }
    /// @param other if given, options of which its help says the same are only named
    [[nodiscard]] std::string help(const OptionSet* other = nullptr) const;

    /// Reads words from the one at `first` on, and keeps what is given. A word that is_value() is a VALUE, except where
    /// an option awaits its argument. Any other word that is not an option is a FILE, or ends the reading if it comes
    /// first and names a command. Where a word is a VALUE, or holds a number and is not a file, all are VALUEs, if no
    /// other is a file or means something by itself.
    /// @return the word at which reading ended: the name of a command, or none
    /// @throw Usage where an option lacks its argument
    [[nodiscard]] std::size_t read(const std::vector<std::string>& all_words, std::size_t first,
                                   const std::function<bool(std::string_view)>& is_command);

private:
    std::vector<Option*> options_;
    std::string_view names_; ///< of the NAMEs in the help
};

} // namespace rotconv::cli
