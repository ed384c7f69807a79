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

Command convert(const Given& given) {
    if (!given.has("--from") && !given.has("--to")) {
        throw MissingSpec("--from SPEC and --to SPEC are missing; see rotconv --help");
    }
    const Spec from = spec_of(given, "--from");
    const Spec to = spec_of(given, "--to");
    const std::string& method = given.text("--method");
    ConversionSettings conversion = attitude_settings_of(given);
    conversion.fast = method == fast_method;
    operations::Operation operation = by_method(method, Conversion(from, to, conversion), given.has("--continuous"));
    if (operation->is_continuous && !operation->answers.empty()) {
        throw Usage("--continuous cannot be combined with --method all, which writes several answers to a row");
    }
    RowsCommand command = rows_command(given, {.list = given.text("--columns")}, operations::attitude_numbers(from),
                                       std::move(operation), messages::subject_of(from, conversion.tolerance));
    if (method == all_methods && command.options.format == stream::Format::f64) {
        throw Usage("--format f64 cannot be combined with --method all, which writes names");
    }
    return command;
}

} // namespace

CommandEntry convert_command() {
    OptionSet set;
    set.add("-f,--from", "SPEC", "The representation to read: NAME[:MODIFIER]...");
    set.add("-t,--to", "SPEC", "The representation to write: NAME[:MODIFIER]...");
    add_attitudes(set);
    add_continuous(set);
    add_reading(set);
    add_writing(set);
    add_lock_margin(set);
    set.begin_group("More");
    set.add("--method", "METHOD", "A published formula (see rotconv list methods), fast, or all of them");
    return {"", "Converts rotations from any representation into any other.",
            "Usage: rotconv -f FROM -t TO [OPTION]... [VALUE]...\n"
            "       rotconv -f FROM -t TO [OPTION]... [FILE]\n"
            "       rotconv list [NAME]\n"
            "       rotconv rates|propagate|survey [OPTION]... [FILE]\n"
            "       rotconv compare|identify [OPTION]... [FILE [REFERENCE]]\n"
            "       rotconv sample -t SPEC [OPTION]...\n",
            std::move(set), convert};
}

} // namespace rotconv::cli
