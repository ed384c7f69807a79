// write_completion SCRIPT: the completion of bash and zsh, with the words of the program's own tables in the place of
// @words@. write_completion SCRIPT FISH: that of fish, with SCRIPT up to "# The rest ..." in the place of @candidates@,
// quoted.

#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <variant>

#include "../core/projects.hpp"
#include "command.hpp"

namespace rotconv::cli {
namespace {

/// Words, in a list, as one word of the shell.
std::string as_word(const auto& words) { return in_shell(joined(words, " ")); }

/// The modifiers that each representation takes.
std::string modifiers() {
    std::string text = "    modifiers= sequences=\n    case ${2-} in\n";
    for (const Representation& entry : mapped(all_representations, representation)) {
        text += fmt::format("    {}) modifiers={}{} ;;\n", fmt::join(messages::names_of(entry), " | "),
                            as_word(messages::words_of(entry.modifiers)),
                            entry.takes_sequence ? " sequences=" + as_word(messages::all_sequences()) : "");
    }
    for (const Project& project : filtered(projects(), &Project::is_spec)) {
        const Spec spec = std::get<Spec>(parse_spec(project.text));
        text += fmt::format("    {}) modifiers={} ;;\n", project.text,
                            as_word(messages::words_of(representation(spec.name).modifiers)));
    }
    return text + "    esac\n";
}

/// What may be an option's argument: -, a word that stands for it in the help, or = and words with commas between;
/// with a comma in front if there may be several.
std::string argument_of(const Option& option) {
    return (option.is_list ? "," : "") + (!option.choices.empty()   ? "=" + joined(option.choices)
                                          : option.takes_argument() ? std::string(option.argument)
                                                                    : "-");
}

/// A line for each name of each option: the name, what may be the argument, and its text in the help.
std::string lines_of(const OptionSet& options) {
    std::string lines;
    for (const Option* option : options.all()) {
        for (const std::string_view name : split(option->names, ',')) {
            lines += fmt::format("{} {} {}\n", name, argument_of(*option), option->about);
        }
    }
    return in_shell(lines);
}

/// The names that completion offers, as a function of the shell.
std::string completion_words() {
    std::string commands;
    std::string options = "    operands=\n    case ${1-} in\n";
    for (const CommandEntry& command : command_table()) {
        const auto own = command.options();
        if (!command.name.empty()) {
            commands += fmt::format("{} - {}\n", command.name, command.about);
        }
        options += fmt::format(
            "    {})\n        options={}\n{}        ;;\n", in_shell(command.name), lines_of(*own),
            own->takes_names() ? "        operands=\"$names $presets $projects methods presets projects\"\n" : "");
    }
    const auto listed_only =
        filtered(projects().subspan(presets().size()), [](const Project& project) { return !project.is_spec(); });
    return fmt::format(
        "# _rotconv_words COMMAND NAME: the words of a command, and of a representation.\n_rotconv_words() {{\n"
        "    names={}\n    presets={}\n    projects={}\n    commands={}\n{}    "
        "esac\n{}}}\n",
        as_word(messages::all_names()), as_word(messages::all_presets()), as_word(mapped(listed_only, &Project::text)),
        in_shell(commands), options, modifiers());
}

/// The lines of a file up to one that begins with `end`; what is `mark` becomes `words`.
std::string filled(const char* file, std::string_view mark, const std::string& words, std::string_view end) {
    std::ifstream lines(file);
    std::string text;
    std::string line;
    while (std::getline(lines, line) && (end.empty() || !line.starts_with(end))) {
        text += line == mark ? words : line + "\n";
    }
    return text;
}

std::string in_fish(const std::string& script) {
    std::string text;
    for (const char c : script) {
        text += c == '\'' || c == '\\' ? std::string{'\\', c} : std::string{c};
    }
    return text;
}

} // namespace
} // namespace rotconv::cli

int main(int argc, char** argv) {
    const bool is_fish = argc > 2;
    const std::string script =
        rotconv::cli::filled(argv[1], "@words@", rotconv::cli::completion_words(), is_fish ? "# The rest" : "");
    std::cout << (is_fish ? rotconv::cli::filled(argv[2], "@candidates@", rotconv::cli::in_fish(script), "") : script);
    return !script.empty() && std::cout.flush() ? 0 : 1;
}
