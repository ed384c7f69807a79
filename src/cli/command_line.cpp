#include "command_line.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "../stream/lines.hpp"
#include "../stream/number_text.hpp"
#include "arguments.hpp"
#include "list.hpp"
#include "words.hpp"

namespace rotconv::cli {
namespace {

/// What the options say, as text: CLI11 reads it, and the functions below check it.
struct Texts {
    std::string from;
    std::string to;
    std::string input = "-";
    std::string output = "-";
    std::string columns;
    std::string delimiter;
    std::string header = "auto";
    std::string format = "csv";
    std::string on_error = "stop";
    std::string diagnostics = "summary";
    std::string precision;
    std::string tolerance;
    std::string lock_margin;
    std::string threads;
    std::string method = "default";
    std::string listed;
    bool degrees = false;
    bool append = false;
    bool strict = false;
};

/// Thrown inside this file alone, with words for the user.
class Usage : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// CLI11 does not know of VALUEs.
class Formatter : public CLI::Formatter {
public:
    std::string make_usage(const CLI::App* /*app*/, std::string /*name*/) const override {
        return "Usage: rotconv -f FROM -t TO [OPTION]... [VALUE]...\n"
               "       rotconv -f FROM -t TO [OPTION]... < IN > OUT\n"
               "       rotconv list [NAME]\n";
    }
};

void define(CLI::App& app, Texts& texts) {
    app.formatter(std::make_shared<Formatter>());
    app.set_help_flag("-h,--help", "Print this help and exit");
    app.set_version_flag("--version", "rotconv " ROTCONV_VERSION, "Print the version and exit");
    app.add_option("-f,--from", texts.from, "What the input is: NAME[:MODIFIER]...")->type_name("SPEC");
    app.add_option("-t,--to", texts.to, "What to make of it: NAME[:MODIFIER]...")->type_name("SPEC");
    app.add_flag("-d,--degrees", texts.degrees, "Angles in degrees on both sides");
    app.add_option("-i,--input", texts.input, "Read FILE instead of stdin (-)")->type_name("FILE");
    app.add_option("-o,--output", texts.output, "Write FILE instead of stdout (-)")->type_name("FILE");
    app.add_option("--columns", texts.columns, "Input columns: indices from 1, ranges 5-8, names")->type_name("LIST");
    app.add_flag("--append", texts.append, "Keep the row and add the result at its end");
    app.add_option("--delimiter", texts.delimiter, "One character, or comma, tab, semicolon, blank")->type_name("D");
    app.add_option("--header", texts.header, "auto, yes, no or add")->type_name("MODE");
    app.add_option("--format", texts.format, "csv, json or pretty")->type_name("FORMAT");
    app.add_option("-p,--precision", texts.precision, "Significant digits (default: the shortest that read back equal)")
        ->type_name("N");
    app.add_option("--diagnostics", texts.diagnostics, "Where they are shown: off, summary, rows or columns")
        ->type_name("WHERE");
    app.add_flag("--strict", texts.strict, "Exit 1 where any diagnostic but normalized was met");
    app.add_option("--on-error", texts.on_error, "What becomes of a row without an attitude: stop, nan or skip")
        ->type_name("POLICY");
    app.add_option("--tolerance", texts.tolerance, "Largest accepted defect of a quaternion or matrix (default 1e-3)")
        ->type_name("T");
    app.add_option("--lock-margin", texts.lock_margin, "Radians from gimbal lock that count as locked (default 1e-15)")
        ->type_name("ANGLE");
    app.add_option("--method", texts.method,
                   "A published formula in the place of rotconv's own; see rotconv list methods")
        ->type_name("NAME");
    app.add_option("--threads", texts.threads, "At most N threads; the output does not depend on N")->type_name("N");
    auto* list = app.add_subcommand("list", "List the representations, or explain one; list methods: the methods");
    list->add_option("NAME", texts.listed, "A representation, or methods");
    list->set_help_flag("-h,--help", "Print this help and exit");
    app.require_subcommand(0, 1);
    app.footer(help_footer());
}

template <class Value> Value choose(std::string_view what, std::string_view text,
                                    std::initializer_list<std::pair<std::string_view, Value>> choices) {
    std::vector<std::string_view> legal;
    for (const auto& [word, value] : choices) {
        if (word == text) {
            return value;
        }
        legal.push_back(word);
    }
    throw Usage(words::no_such_word(what, text, legal));
}

Spec spec_of(std::string_view option, const std::string& text, bool degrees) {
    if (text.empty()) {
        throw Usage(fmt::format("{} SPEC is missing; see rotconv --help", option));
    }
    const auto parsed = parse_spec(text);
    if (const auto* fault = std::get_if<SpecFault>(&parsed)) {
        throw Usage(fmt::format("{} {}: {}", option, words::quoted(text), words::explain(*fault)));
    }
    const Spec& spec = std::get<Spec>(parsed);
    return degrees ? spec.in_degrees() : spec;
}

/// A number that is not negative; `default_value` where the option was not given.
double amount_of(std::string_view option, const std::string& text, double default_value, bool infinite) {
    if (text.empty()) {
        return default_value;
    }
    double value = 0.0;
    if (stream::read_number(text, value) != stream::NumberFault::none || !(value >= 0.0) ||
        (std::isinf(value) && !infinite)) {
        throw Usage(fmt::format("{} {} must be a {}number that is not negative", option, words::quoted(text),
                                infinite ? "" : "finite "));
    }
    return value;
}

int count_of(std::string_view option, const std::string& text, int most) {
    if (text.empty()) {
        return 0;
    }
    double value = 0.0;
    if (stream::read_number(text, value) != stream::NumberFault::none || value != std::floor(value) || value < 1 ||
        value > most) {
        throw Usage(fmt::format("{} {} must be a whole number from 1 to {}", option, words::quoted(text), most));
    }
    return static_cast<int>(value);
}

/// The method of the pair, or null for rotconv's own.
const Method* method_of(const Spec& from, const Spec& to, const std::string& text) {
    const Method* method = find_method(from.name, to.name, text);
    if (method == nullptr && text != "default") {
        throw Usage("--method " + words::no_such_method(from.name, to.name, text));
    }
    return method;
}

/// One row of numbers, whatever they are.
bool is_row(std::string_view text) {
    return !stream::is_blank(text) && !stream::is_comment(text) && text.find_first_of("\r\n") == std::string_view::npos;
}

ConvertCommand convert_command(const Texts& texts, const std::vector<std::string>& values, bool has_input) {
    if (texts.from.empty() && texts.to.empty() && !values.empty() && !stream::is_number(values[0])) {
        throw Usage(words::no_such_word("command", values[0], {"list"}));
    }
    const Spec from = spec_of("--from", texts.from, texts.degrees);
    const Spec to = spec_of("--to", texts.to, texts.degrees);
    const auto diagnostics = choose<ShowDiagnostics>("place for --diagnostics", texts.diagnostics,
                                                     {{"off", ShowDiagnostics::off},
                                                      {"summary", ShowDiagnostics::summary},
                                                      {"rows", ShowDiagnostics::rows},
                                                      {"columns", ShowDiagnostics::columns}});
    const Settings settings{.tolerance = amount_of("--tolerance", texts.tolerance, Settings{}.tolerance, true),
                            .lock_margin = amount_of("--lock-margin", texts.lock_margin, Settings{}.lock_margin, false),
                            .figures = diagnostics == ShowDiagnostics::columns,
                            .method = method_of(from, to, texts.method)};
    count_of("--threads", texts.threads, 1 << 20U);

    ConvertCommand command(Conversion(from, to, settings));
    command.settings = settings;
    command.diagnostics = diagnostics;
    command.strict = texts.strict;
    command.input = texts.input;
    command.output = texts.output;
    stream::Options& options = command.options;
    options.append = texts.append;
    options.precision = count_of("--precision", texts.precision, 100);
    options.diagnostic_columns = diagnostics == ShowDiagnostics::columns;
    options.show_diagnostics = diagnostics != ShowDiagnostics::off;
    options.describe = words::describe;
    options.header = choose<stream::HeaderMode>("mode of --header", texts.header,
                                                {{"auto", stream::HeaderMode::automatic},
                                                 {"yes", stream::HeaderMode::yes},
                                                 {"no", stream::HeaderMode::no},
                                                 {"add", stream::HeaderMode::add}});
    options.format = choose<stream::Format>(
        "format", texts.format,
        {{"csv", stream::Format::csv}, {"json", stream::Format::json}, {"pretty", stream::Format::pretty}});
    options.on_error = choose<stream::OnError>(
        "policy of --on-error", texts.on_error,
        {{"stop", stream::OnError::stop}, {"nan", stream::OnError::nan}, {"skip", stream::OnError::skip}});
    if (!texts.delimiter.empty()) {
        options.delimiter = stream::Delimiter::parse(texts.delimiter);
        if (!options.delimiter) {
            throw Usage(fmt::format(
                "--delimiter {} is neither comma, tab, semicolon or blank nor a character that can part numbers",
                words::quoted(texts.delimiter)));
        }
    }
    if (!texts.columns.empty()) {
        auto parsed = stream::ColumnList::parse(texts.columns, from.size());
        if (const auto* fault = std::get_if<stream::ColumnFault>(&parsed)) {
            throw Usage("--columns: " + words::explain(*fault, from));
        }
        options.columns = std::get<stream::ColumnList>(std::move(parsed));
    }
    const bool headless = options.header == stream::HeaderMode::no || options.header == stream::HeaderMode::add;
    if (options.columns.has_names() && (headless || !values.empty())) {
        throw Usage("--columns selects by name, and there is no header to look in; use indices");
    }
    if (!values.empty()) {
        if (has_input) {
            throw Usage("VALUEs and --input exclude each other");
        }
        command.has_values = true;
        command.values = fmt::format("{}", fmt::join(values, " "));
        if (!is_row(command.values)) {
            throw Usage(fmt::format("the VALUEs are no row of numbers: {}", words::quoted(command.values)));
        }
        if (values.size() > 1) {
            options.delimiter = stream::Delimiter::blanks();
        }
        if (options.header != stream::HeaderMode::add) {
            options.header = stream::HeaderMode::no;
        }
    }
    return command;
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
        if (arguments.is_command) {
            return ListCommand{texts.listed};
        }
        return convert_command(texts, arguments.values, app.count("--input") > 0);
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
