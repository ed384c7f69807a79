#include "command_line.hpp"

#include <algorithm>
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
        const std::string name = app->get_name();
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

void define(CLI::App& app, Texts& texts) {
    app.formatter(std::make_shared<Formatter>());
    app.set_help_flag("-h,--help", "Print this help and exit");
    app.set_version_flag("--version", "rotconv " ROTCONV_VERSION, "Print the version and exit");
    define_from(app, texts);
    define_to(app, texts);
    define_input(app, texts);
    define_output(app, texts);
    define_lock_margin(app, texts);
    app.add_option("--method", texts.method,
                   "A published formula in the place of rotconv's own; see rotconv list methods")
        ->type_name("NAME");
    auto* list = app.add_subcommand("list", "List the representations, or explain one; list methods: the methods");
    list->add_option("NAME", texts.listed, "A representation, or methods");
    define_rates(*app.add_subcommand("rates", "Rates of the numbers from the angular velocity, and back"), texts);
    define_propagate(*app.add_subcommand("propagate", "Integrate angular velocities to attitudes"), texts);
    define_survey(*app.add_subcommand("survey", "Which sets serve a motion, and the smallest"), texts);
    for (CLI::App* command : app.get_subcommands({})) {
        command->set_help_flag("-h,--help", "Print this help and exit");
    }
    app.require_subcommand(0, 1);
    app.footer(help_footer());
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
    const auto commands = app.get_subcommands();
    const CLI::App& command = commands.empty() ? app : *commands.front();
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
    Arguments arguments = sort_arguments(app, argc, argv);
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
        return PrintCommand{app.help()};
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
