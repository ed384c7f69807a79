#include "command_line.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "../stream/number_text.hpp"
#include "arguments.hpp"
#include "kinematics.hpp"
#include "list.hpp"
#include "options.hpp"
#include "words.hpp"

namespace rotconv::cli {
namespace {

/// CLI11 does not know of VALUEs.
class Formatter : public CLI::Formatter {
public:
    std::string make_usage(const CLI::App* app, std::string /*name*/) const override {
        const std::string& name = app->get_name();
        if (name == "list") {
            return "Usage: rotconv list [NAME]\n";
        }
        if (name == "rates") {
            return "Usage: rotconv rates -f SPEC [OPTION]... [VALUE]...\n"
                   "       rotconv rates -f SPEC [OPTION]... < IN > OUT\n";
        }
        if (name == "propagate") {
            return "Usage: rotconv propagate -t SPEC [OPTION]... < IN > OUT\n";
        }
        if (name == "survey") {
            return "Usage: rotconv survey -f SPEC [OPTION]... < IN\n";
        }
        return "Usage: rotconv -f FROM -t TO [OPTION]... [VALUE]...\n"
               "       rotconv -f FROM -t TO [OPTION]... < IN > OUT\n"
               "       rotconv list [NAME]\n"
               "       rotconv rates|propagate|survey [OPTION]... < IN > OUT\n";
    }
};

void set_help(CLI::App& app) { app.set_help_flag("-h,--help", "Print this help and exit"); }

void define_list(CLI::App& app, Texts& texts) { app.add_option("NAME", texts.listed, "A representation, or methods"); }

/// A command beside the conversion.
struct Entry {
    const char* name;
    const char* description;
    void (*define)(CLI::App& app, Texts& texts);
};

constexpr std::array<Entry, 4> commands{
    {{"list", "List the representations, or explain one; list methods: the methods", define_list},
     {"rates", "Rates of the numbers from the angular velocity, and back", define_rates},
     {"propagate", "Integrate angular velocities to attitudes", define_propagate},
     {"survey", "Which sets serve a motion, and the smallest", define_survey}}};

const CLI::App* add(const Entry& entry, CLI::App& app, Texts& texts) {
    CLI::App* command = app.add_subcommand(entry.name, entry.description);
    entry.define(*command, texts);
    set_help(*command); // anew, so that it is the last
    return command;
}

/// The conversion, without the commands: to define them all takes longer than the rest of a start, and a command line
/// names one at most.
void define(CLI::App& app, Texts& texts) {
    app.formatter(std::make_shared<Formatter>());
    set_help(app);
    app.set_version_flag("--version", "rotconv " ROTCONV_VERSION, "Print the version and exit");
    define_from(app, texts);
    define_to(app, texts);
    define_input(app, texts);
    define_output(app, texts);
    define_lock_margin(app, texts);
    app.add_option("--method", texts.method,
                   "A published formula in the place of rotconv's own; see rotconv list methods")
        ->type_name("NAME");
    app.require_subcommand(0, 1);
}

/// The help of the command that is named, which the options of others would not change; else that of the program.
std::string help(CLI::App& app, Texts& texts) {
    if (app.get_subcommands({}).empty()) {
        for (const Entry& entry : commands) {
            add(entry, app, texts);
        }
        app.footer(help_footer());
    }
    return app.help();
}

/// The method of the pair, or null for rotconv's own.
const Method* method_of(const Spec& from, const Spec& to, const std::string& text) {
    const Method* method = find_method(from.name, to.name, text);
    if (method == nullptr && text != "default") {
        throw Usage("--method " + words::no_such_method(from.name, to.name, text));
    }
    return method;
}

RowsCommand convert_command(const Texts& texts, const Values& values) {
    if (texts.from.empty() && texts.to.empty() && !values.words.empty() && !stream::is_number(values.words[0])) {
        throw Usage(words::no_such_word("command", values.words[0], {"list", "propagate", "rates", "survey"}));
    }
    const Spec from = spec_of("--from", texts.from, texts.degrees);
    const Spec to = spec_of("--to", texts.to, texts.degrees);
    Settings settings = settings_of(texts);
    settings.method = method_of(from, to, texts.method);
    return rows_command(texts, stream::row_function(Conversion(from, to, settings)),
                        {std::string(representation(from.name).text), from.size(), from.name, settings.tolerance},
                        values);
}

/// A word that CLI11 did not know, with the nearest option of the command that it was given to.
std::string unexpected(const CLI::App& app) {
    const auto named = app.get_subcommands();
    const CLI::App& command = named.empty() ? app : *named.front();
    const std::string word = app.remaining(true).front();
    if (!word.starts_with('-')) {
        return "unexpected argument " + words::quoted(word);
    }
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    return words::no_such_word("option", word.substr(0, word.find('=')), {names.begin(), names.end()});
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

/// The command of that name; none is the conversion.
Command command_of(const std::string& name, const Texts& texts, const Values& values) {
    if (name == "list") {
        return ListCommand{texts.listed};
    }
    if (name == "rates") {
        return rates_command(texts, values);
    }
    if (name == "propagate") {
        return propagate_command(texts, values);
    }
    if (name == "survey") {
        return survey_command(texts, values);
    }
    return convert_command(texts, values);
}

} // namespace

Command read_command_line(int argc, const char* const* argv) {
    CLI::App app("Converts rotations from any representation into any other.", "rotconv");
    Texts texts;
    define(app, texts);
    Arguments arguments = sort_arguments(app, argc, argv, [&](const std::string& word) {
        const auto* const entry = std::ranges::find(commands, word, &Entry::name);
        return entry == commands.end() ? nullptr : add(*entry, app, texts);
    });
    if (!arguments.empty_option.empty()) {
        return UsageError{arguments.empty_option + " has an empty argument"};
    }
    std::ranges::reverse(arguments.options); // as CLI11 wants them
    try {
        app.parse(arguments.options);
        if (!arguments.command.empty()) {
            refuse_before(app, arguments.command);
        }
        const CLI::App& command = arguments.command.empty() ? app : *app.get_subcommand(arguments.command);
        const CLI::Option* input = command.get_option_no_throw("--input");
        return command_of(arguments.command, texts, {arguments.values, input != nullptr && input->count() > 0});
    } catch (const CLI::CallForHelp&) {
        return PrintCommand{help(app, texts)};
    } catch (const CLI::CallForVersion& version) {
        return PrintCommand{std::string(version.what()) + "\n"};
    } catch (const CLI::ExtrasError&) {
        return UsageError{unexpected(app)};
    } catch (const CLI::ParseError& error) {
        return UsageError{error.what()};
    } catch (const Usage& error) {
        return UsageError{error.what()};
    }
}

} // namespace rotconv::cli
