#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rotconv::cli {

/// An option of a command: what the help says of it, and where what is given goes.
struct Option {
    std::string names;    ///< such as "-f,--from"; without dashes: of the words behind the command
    std::string argument; ///< what stands for it in the help; empty where it takes none
    std::string about;
    std::string group; ///< the title in the help under which it stands
    std::variant<bool*, std::string*, std::vector<std::string>*> value;

    [[nodiscard]] bool takes_argument() const noexcept { return !argument.empty(); }
    [[nodiscard]] bool is_operand() const noexcept { return !names.starts_with('-'); }
    /// "-f" and "--from".
    [[nodiscard]] std::vector<std::string> each_name() const;
    /// "--from".
    [[nodiscard]] std::string name() const { return each_name().back(); }
};

/// The options of a command, in the order of its help.
class OptionSet {
public:
    /// The title for those that follow.
    void begin_group(std::string_view title) { group_ = title; }
    void add(std::string_view names, std::string& value, std::string_view argument, std::string_view about);
    void add(std::string_view names, bool& value, std::string_view about);
    /// The words behind the command, which are no FILEs and VALUEs then.
    void add_operands(std::string_view name, std::vector<std::string>& value, std::string_view about);
    /// Says it otherwise than the command from which the option is taken.
    void describe(std::string_view name, std::string_view about);

    [[nodiscard]] const std::vector<Option>& all() const noexcept { return options_; }
    /// By one of its names, or null.
    [[nodiscard]] const Option* find(std::string_view name) const;
    [[nodiscard]] bool takes_operands() const;

    /// Sets the values that words such as "--from=quat" and "-d" give.
    /// @return the words that are no option of the set
    /// @throw Usage
    [[nodiscard]] std::vector<std::string> read(std::vector<std::string> words) const;

private:
    std::vector<Option> options_;
    std::string group_ = "Options";
};

struct HelpText {
    std::string about;
    std::string usage;
    std::vector<std::pair<std::string, std::string>> commands; ///< with what each is for
    std::string footer;
};

[[nodiscard]] std::string help_of(const OptionSet& options, const HelpText& text);

} // namespace rotconv::cli
