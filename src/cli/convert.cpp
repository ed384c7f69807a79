#include <utility>

#include "../methods/method_conversion.hpp"
#include "row_options.hpp"

namespace rotconv::cli {
namespace {

/// A method of rotconv's own, a published one, or all.
operations::Operation by_method(const std::string& name, const Conversion& conversion, bool is_continuous) {
    if (name == all_methods) {
        return operations::method(MethodConversion::all(conversion), true, is_continuous);
    }
    if (name.empty() || name == default_method || name == fast_method) {
        return operations::convert(conversion, is_continuous);
    }
    const Method* method = find_method(conversion.from().name, conversion.to().name, name);
    if (method == nullptr) {
        throw Usage("--method " + messages::no_such_method(conversion.from().name, conversion.to().name, name));
    }
    return operations::method(MethodConversion(conversion, *method), false, is_continuous);
}

/// What is written where -t is not given.
std::vector<Spec> all_forms() {
    std::vector<Spec> specs;
    for (const std::string_view text :
         {"dcm", "quat", "axis-angle:deg", "rotvec:deg", "rpy:deg", "euler:ZYX:deg", "cayley", "mrp"}) {
        specs.push_back(spec_of("--to", std::string(text), false));
    }
    return specs;
}

/// The attitude of VALUEs in all forms, for people or as one object.
void write_block(const Given& given, RowsCommand& command) {
    constexpr int most_digits = 9;
    for (const std::string_view option : {"--append", "--header"}) {
        if (given.has(option)) {
            throw Usage("{} needs -t SPEC", option);
        }
    }
    stream::Options& options = command.options;
    const std::string& format = given.text("--format");
    if (format == "csv" || format == "f64") {
        throw Usage("--format {} needs -t SPEC", format);
    }
    options.format = format == "json" ? stream::Format::json : stream::Format::pretty;
    options.block = "";
    if (options.format == stream::Format::pretty && options.digits.shortest()) {
        options.digits.significant = most_digits;
        options.block = fmt::format("At most {} digits: -t SPEC or --format json gives all of them\n", most_digits);
    }
    if (options.format == stream::Format::pretty &&
        (command.diagnostics == ShowDiagnostics::summary || command.diagnostics == ShowDiagnostics::rows)) {
        command.diagnostics = ShowDiagnostics::off; // which are in the block
    }
}

Command convert(const Given& given) {
    if (!given.has("--from") && !given.has("--to")) {
        throw MissingSpec("--from SPEC and --to SPEC are missing; see rotconv --help");
    }
    const bool is_block = !given.has("--to") && !given.values.empty();
    const Spec from = spec_of(given, "--from");
    const std::vector<Spec> to = is_block ? all_forms() : specs_of(given, "--to");
    const std::string& method = given.text("--method");
    ConversionSettings conversion = attitude_settings_of(given);
    conversion.fast = method == fast_method;
    if (to.size() > 1 && !method.empty() && method != default_method && method != fast_method) {
        throw Usage("--method {} is for one SPEC after -t", method);
    }
    operations::Operation operation = operations::several(mapped(to, [&](const Spec& each) {
        return by_method(method, Conversion(from, each, conversion), given.has("--continuous"));
    }));
    if (operation->is_continuous && !operation->answers.empty()) {
        throw Usage("--continuous cannot be combined with --method all, which writes several answers to a row");
    }
    RowsCommand command = rows_command(given, {.list = given.text("--columns")}, operations::attitude_numbers(from),
                                       std::move(operation), messages::subject_of(from, conversion.tolerance));
    if (method == all_methods && command.options.format == stream::Format::f64) {
        throw Usage("--format f64 cannot be combined with --method all, which writes names");
    }
    if (is_block) {
        write_block(given, command);
    }
    return command;
}

} // namespace

CommandEntry convert_command() {
    OptionSet set;
    set.add("-f,--from", "SPEC", "The representation to read: NAME[:MODIFIER]...");
    set.add("-t,--to", "SPEC", "The representation to write: NAME[:MODIFIER]...; several with commas");
    add_attitudes(set);
    add_continuous(set);
    add_reading(set);
    add_writing(set);
    add_lock_margin(set);
    set.begin_group("More");
    set.add("--method", "METHOD", "A published formula (see rotconv list methods), fast, or all of them");
    return {"", "Converts rotations from any representation into any other.",
            "Usage: rotconv -f FROM -t TO [OPTION]... [VALUE]...\n"
            "       rotconv -f FROM [OPTION]... VALUE...\n"
            "       rotconv -f FROM -t TO [OPTION]... [FILE]\n"
            "       rotconv COMMAND [OPTION]...              (rotconv COMMAND --help)\n",
            std::move(set), convert};
}

} // namespace rotconv::cli
