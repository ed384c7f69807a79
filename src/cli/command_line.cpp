#include "command_line.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>
#include <rotconv/version.hpp>

#include "../stream/file.hpp"
#include "../stream/fmt.hpp"
#include "arguments.hpp"
#include "compare.hpp"
#include "first_look.hpp"
#include "identify.hpp"
#include "kinematics.hpp"
#include "list.hpp"
#include "messages.hpp"
#include "options.hpp"

namespace rotconv::cli {
namespace {

/// To be called last, so that it stands there.
void set_help(CLI::App& app) {
    begin_group(app, "More");
    app.set_help_flag("-h,--help", "Print this help and exit");
}

void define_list(CLI::App& app, RawOptions& texts) {
    app.add_option("NAME", texts.listed, "A representation, a preset, presets, or methods [FROM [TO]]")->type_name("");
}

/// A command beside the conversion.
struct Entry {
    std::string_view name;
    const char* description;
    const char* usage;
    void (*define)(CLI::App& app, RawOptions& texts);
    Command (*command)(const RawOptions& texts, const Operands& operands);
    std::size_t most_files = 1;
};

constexpr std::array<Entry, 6> commands{
    {{"list", "List the representations, methods or presets, or explain one",
      "Usage: rotconv list [NAME]\n       rotconv list methods [FROM [TO]]\n", define_list,
      [](const RawOptions& texts, const Operands& /*operands*/) -> Command {
          return PrintCommand{list(texts.listed)};
      }},
     {"rates", "Turn angular velocity into rates of change of the numbers, and back",
      "Usage: rotconv rates -f SPEC [OPTION]... [VALUE]...\n"
      "       rotconv rates -f SPEC [OPTION]... [FILE]\n"
      "       rotconv rates --differences -f SPEC [OPTION]... [FILE]\n",
      define_rates,
      [](const RawOptions& texts, const Operands& operands) -> Command { return rates_command(texts, operands); }},
     {"propagate", "Integrate angular velocities to attitudes", "Usage: rotconv propagate -t SPEC [OPTION]... [FILE]\n",
      define_propagate,
      [](const RawOptions& texts, const Operands& operands) -> Command { return propagate_command(texts, operands); }},
     {"survey", "Find the representations that serve a motion, and the smallest",
      "Usage: rotconv survey -f SPEC [OPTION]... [FILE]\n", define_survey,
      [](const RawOptions& texts, const Operands& operands) -> Command { return survey_command(texts, operands); }},
     {"compare", "Check attitudes against a reference, by the angles between them",
      "Usage: rotconv compare -f SPEC [-t SPEC] [OPTION]... FILE REFERENCE\n"
      "       rotconv compare -f SPEC [-t SPEC] [OPTION]... [FILE]\n"
      "       rotconv compare -f SPEC [-t SPEC] [OPTION]... VALUE...\n",
      define_compare,
      [](const RawOptions& texts, const Operands& operands) -> Command { return compare_command(texts, operands); }, 2},
     {"identify", "Find the convention of numbers, from the same attitudes in a known one",
      "Usage: rotconv identify -t KNOWN [-f NAME] [OPTION]... FILE [REFERENCE]\n"
      "       rotconv identify -t KNOWN [-f NAME] [OPTION]... VALUE...\n",
      define_identify,
      [](const RawOptions& texts, const Operands& operands) -> Command { return identify_command(texts, operands); },
      2}}};

/// The command of that name, or null.
const Entry* find_command(std::string_view name) {
    const auto* const found = std::ranges::find(commands, name, &Entry::name);
    return found == commands.end() ? nullptr : found;
}

/// CLI11 does not know of VALUEs.
class Formatter : public CLI::Formatter {
public:
    std::string make_usage(const CLI::App* app, std::string /*name*/) const override {
        if (const Entry* entry = find_command(app->get_name())) {
            return entry->usage;
        }
        return "Usage: rotconv -f FROM -t TO [OPTION]... [VALUE]...\n"
               "       rotconv -f FROM -t TO [OPTION]... [FILE]\n"
               "       rotconv list [NAME]\n"
               "       rotconv rates|propagate|survey [OPTION]... [FILE]\n"
               "       rotconv compare|identify [OPTION]... [FILE [REFERENCE]]\n";
    }
};

const CLI::App* add(const Entry& entry, CLI::App& app, RawOptions& texts) {
    CLI::App* command = app.add_subcommand(std::string(entry.name), entry.description);
    command->group("Commands");
    entry.define(*command, texts);
    set_help(*command);
    return command;
}

/// The conversion, without the commands: to define them all takes longer than the rest of a start, and a command line
/// names one at most.
void define(CLI::App& app, RawOptions& texts) {
    app.formatter(std::make_shared<Formatter>());
    define_from(app, texts);
    define_to(app, texts);
    define_attitudes(app, texts);
    define_input(app, texts);
    define_output(app, texts);
    define_lock_margin(app, texts);
    begin_group(app, "More");
    app.add_option("--method", texts.method, "A published formula (see rotconv list methods), fast, or all of them")
        ->type_name("METHOD");
    set_help(app);
    app.set_version_flag("--version", "rotconv " ROTCONV_VERSION, "Print the version and exit");
    app.require_subcommand(0, 1);
}

/// The help of the command that is named, which the options of others would not change; else that of the program.
std::string help(CLI::App& app, RawOptions& texts) {
    if (app.get_subcommands({}).empty()) {
        for (const Entry& entry : commands) {
            add(entry, app, texts);
        }
        app.footer(help_footer());
    }
    std::string text = app.help();
    for (auto at = text.find("\n\n\n"); at != std::string::npos; at = text.find("\n\n\n")) {
        text.erase(at, 1); // CLI11 ends a group with two
    }
    return text;
}

/// The published method of the pair, or null for rotconv's own two.
const Method* method_of(const Spec& from, const Spec& to, const std::string& text) {
    if (text == default_method || text == fast_method) {
        return nullptr;
    }
    const Method* method = find_method(from.name, to.name, text);
    if (method == nullptr) {
        throw Usage("--method " + messages::no_such_method(from.name, to.name, text));
    }
    return method;
}

/// What the method of that name makes of the rows, or all of them.
stream::RowOperation conversion_by(const Conversion& own, const std::string& method) {
    if (method == all_methods) {
        return stream::all_methods_operation(MethodConversion::all(own));
    }
    const Method* const published = method_of(own.from(), own.to(), method);
    return published == nullptr ? stream::conversion_operation(own)
                                : stream::method_operation(MethodConversion(own, *published));
}

RowsCommand convert_command(const RawOptions& texts, const Operands& operands) {
    if (texts.from.empty() && texts.to.empty()) {
        throw MissingSpec("--from SPEC and --to SPEC are missing; see rotconv --help");
    }
    const Spec from = spec_of("--from", texts.from, texts.degrees);
    const Spec to = spec_of("--to", texts.to, texts.degrees);
    ConversionSettings settings = settings_of(texts);
    settings.fast = texts.method == fast_method;
    auto operation = conversion_by(Conversion(from, to, settings), texts.method);
    if (texts.continuous) {
        operation = stream::continuous(std::move(operation));
    }
    if (operation.choose && !operation.answers.empty()) {
        throw Usage("--continuous follows one answer, and --method all writes several to a row");
    }
    RowsCommand command =
        rows_command(texts, std::move(operation), messages::subject_of(from, settings.tolerance), operands);
    if (texts.method == all_methods && command.options.format == stream::Format::f64) {
        throw Usage("--format f64 has no place for the names that --method all writes");
    }
    return command;
}

/// A word that CLI11 did not know, with the nearest option of the command that it was given to.
std::string unexpected(const CLI::App& app) {
    const auto named = app.get_subcommands();
    const CLI::App& command = named.empty() ? app : *named.front();
    const std::string word = app.remaining(true).front();
    if (!word.starts_with('-')) {
        return "unexpected argument " + messages::quoted(word);
    }
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    return messages::no_such_option(word.substr(0, word.find('=')), {names.begin(), names.end()});
}

/// Refuses operands that exclude each other, and FILEs that are none.
void check(const Operands& operands, bool has_input, std::size_t most_files) {
    for (const std::string& file : operands.files) {
        if (const int error = stream::File::why_unreadable(file.c_str()); error != 0) {
            std::vector<std::string_view> names;
            std::ranges::transform(commands, std::back_inserter(names), &Entry::name);
            throw Usage(messages::no_operand(file, error, names));
        }
    }
    const std::string file = operands.files.empty() ? std::string() : messages::quoted(operands.files[0]);
    if (operands.files.size() > 1 && most_files == 1) {
        throw Usage(fmt::format("{} and {} are two FILEs, and one is read; cat joins them: cat A B | rotconv ...", file,
                                messages::quoted(operands.files[1])));
    }
    if (operands.files.size() > most_files) {
        throw Usage(fmt::format("{} is one FILE too many", messages::quoted(operands.files[most_files])));
    }
    if (!operands.values.empty() && !operands.files.empty()) {
        throw Usage(fmt::format("VALUEs and the FILE {} exclude each other", file));
    }
    if (has_input && !operands.files.empty()) {
        throw Usage(fmt::format("the FILE {} and --input exclude each other", file));
    }
    if (has_input && !operands.values.empty()) {
        throw Usage("VALUEs and --input exclude each other");
    }
}

/// The program that prints a compressed file, by the file's name; empty for others.
std::string_view unpacker_of(std::string_view file) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> unpackers{
        {{".gz", "zcat"}, {".zst", "zstdcat"}, {".xz", "xzcat"}}};
    for (const auto& [ending, program] : unpackers) {
        if (file.ends_with(ending)) {
            return program;
        }
    }
    return {};
}

/// A word as a shell reads it.
std::string in_shell(std::string_view word) {
    const bool is_plain = !word.empty() && std::ranges::all_of(word, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("-_./:,=+@").find(c) != std::string_view::npos;
    });
    std::string text;
    for (const char c : word) {
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return is_plain ? text : fmt::format("'{}'", text);
}

/// Refuses files that their names call compressed, with the same command line behind what unpacks the first.
void refuse_compressed(const std::vector<std::string>& files, int argc, const char* const* argv) {
    const auto found = std::ranges::find_if(files, [](const auto& file) { return !unpacker_of(file).empty(); });
    if (found == files.end()) {
        return;
    }
    std::string command = fmt::format("{} {} | rotconv", unpacker_of(*found), in_shell(*found));
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        const std::string_view unpacker = std::ranges::count(files, word) > 0 ? unpacker_of(word) : "";
        command += word == *found      ? " -"
                   : !unpacker.empty() ? fmt::format(" <({} {})", unpacker, in_shell(word))
                                       : fmt::format(" {}", in_shell(word));
    }
    throw Usage(messages::shown(messages::compressed(*found, command)));
}

/// The conversion's options mean nothing to a command that follows them.
void refuse_before(const CLI::App& app, const std::string& command) {
    for (const CLI::Option* option : app.get_options()) {
        if (option->count() > 0) {
            throw Usage(
                fmt::format("{} stands before {}; options come after the command", option->get_name(), command));
        }
    }
}

CommandText text_of(const CLI::App& app, std::string name) {
    CommandText text{.name = std::move(name), .about = app.get_description(), .options = {}};
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_positional()) {
            text.takes_name = true;
            continue;
        }
        OptionText& last = text.options.emplace_back();
        for (const std::string& letter : option->get_snames()) {
            last.names.push_back("-" + letter);
        }
        for (const std::string& word : option->get_lnames()) {
            last.names.push_back("--" + word);
        }
        last.argument = option->get_items_expected_max() > 0 ? option->get_type_name() : "";
        last.about = option->get_description();
    }
    return text;
}

} // namespace

Command read_command_line(int argc, const char* const* argv) {
    CLI::App app("Converts rotations from any representation into any other.", "rotconv");
    RawOptions texts;
    define(app, texts);
    Arguments arguments = sort_arguments(app, argc, argv, [&](const std::string& word) {
        const Entry* entry = find_command(word);
        return entry == nullptr ? nullptr : add(*entry, app, texts);
    });
    if (!arguments.error.empty()) {
        return UsageError{arguments.error};
    }
    std::ranges::reverse(arguments.options); // as CLI11 wants them
    try {
        app.parse(arguments.options);
        if (!arguments.command.empty()) {
            refuse_before(app, arguments.command);
        }
        const CLI::App& command = arguments.command.empty() ? app : *app.get_subcommand(arguments.command);
        const CLI::Option* input = command.get_option_no_throw("--input");
        const Operands operands{arguments.values, arguments.files};
        const Entry* entry = find_command(arguments.command);
        check(operands, input != nullptr && input->count() > 0, entry == nullptr ? 1 : entry->most_files);
        std::vector<std::string> files = arguments.files;
        files.push_back(texts.input);
        refuse_compressed(files, argc, argv);
        try {
            return entry == nullptr ? convert_command(texts, operands) : entry->command(texts, operands);
        } catch (const MissingSpec& error) {
            const std::string beginning = beginning_of(files.front());
            return UsageError{beginning.empty() ? error.what()
                                                : fmt::format("{}; {}", error.what(),
                                                              messages::describe(files.front(), look_at(beginning)))};
        }
    } catch (const CLI::CallForHelp&) {
        return PrintCommand{help(app, texts)};
    } catch (const CLI::CallForVersion& version) {
        return PrintCommand{std::string(version.what()) + "\n"};
    } catch (const CLI::ExtrasError&) {
        return UsageError{unexpected(app)};
    } catch (const CLI::ParseError& error) {
        return UsageError{messages::shown(error.what())};
    } catch (const Usage& error) {
        return UsageError{error.what()};
    }
}

std::vector<CommandText> command_table() {
    CLI::App app;
    RawOptions texts;
    define(app, texts);
    std::vector<CommandText> table{text_of(app, "")};
    for (const Entry& entry : commands) {
        table.push_back(text_of(*add(entry, app, texts), std::string(entry.name)));
    }
    return table;
}

} // namespace rotconv::cli
