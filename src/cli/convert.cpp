#include <array>
#include <utility>
#include <variant>

#include "../methods/method_conversion.hpp"
#include "row_options.hpp"

namespace rotconv::cli {
namespace {

/// What is written where -t is not given.
std::vector<Spec> all_forms() {
    constexpr std::array<std::string_view, 8> forms{
        {"dcm", "quat", "axis-angle:deg", "rotvec:deg", "rpy:deg", "euler:ZYX:deg", "cayley", "mrp"}};
    return mapped(forms, [](std::string_view text) { return std::get<Spec>(parse_spec(text)); });
}

/// Names of methods of any pair, and the words that stand for several.
std::vector<std::string_view> method_names() {
    std::vector<std::string_view> names{fast_method, all_methods, default_method};
    for (const Method& each : methods()) {
        if (std::ranges::count(names, each.name) == 0) {
            names.push_back(each.name);
        }
    }
    return names;
}

struct ConvertOptions final : RowOptions {
    ConvertOptions() {
        to.about = "The representation to write: NAME[:MODIFIER]...; several with commas";
        to.is_list = true;
        method.choices = method_names();
        add("What", {&from, &to});
        add_attitudes();
        add("What", {&continuous});
        add_reading();
        add_writing();
        add("Errors", {&lock_margin});
        add("More", {&method});
    }

    [[nodiscard]] Command command() const override {
        if (!from.given() && !to.given()) {
            throw MissingSpec("{} SPEC and {} SPEC are missing; see rotconv --help", from.name(), to.name());
        }
        const bool is_block = !to.given() && !values.empty();
        const Spec read = spec_of(from);
        const std::vector<Spec> written = is_block ? all_forms() : specs_of(to, degrees.given());
        const std::string& name = method.text();
        ConversionSettings conversion = attitude_settings();
        conversion.fast = name == fast_method;
        if (written.size() > 1 && method.given() && name != default_method && name != fast_method) {
            throw Usage("{} {} is for one SPEC after -t", method.name(), name);
        }
        operations::Operation operation = operations::several(
            mapped(written, [&](const Spec& each) { return by_method(Conversion(read, each, conversion)); }));
        if (operation->is_continuous && operation->text) {
            throw Usage("{} cannot be combined with {} all, which writes several answers to a row", continuous.name(),
                        method.name());
        }
        RowsCommand made = rows_command(std::move(operation));
        if (name == all_methods && made.options.format == stream::Format::f64) {
            throw Usage("{} f64 cannot be combined with {} all, which writes names", format.name(), method.name());
        }
        if (is_block) {
            write_block(made);
        }
        return made;
    }

private:
    /// By a method of rotconv's own, a published one, or all.
    [[nodiscard]] operations::Operation by_method(const Conversion& conversion) const {
        const std::string& name = method.text();
        if (name == all_methods) {
            return operations::method(MethodConversion::all(conversion), true, continuous.given());
        }
        if (!method.given() || name == default_method || name == fast_method) {
            return operations::convert(conversion, continuous.given());
        }
        const Method* found = find_method(conversion.from().name, conversion.to().name, name);
        if (found == nullptr) {
            throw Usage("{} {}", method.name(),
                        messages::no_such_method(conversion.from().name, conversion.to().name, name));
        }
        return operations::method(MethodConversion(conversion, *found), false, continuous.given());
    }

    /// The attitude of VALUEs in all forms, for people or as one object.
    void write_block(RowsCommand& made) const {
        constexpr int most_digits = 9;
        for (const Option* option : {&append, &header}) {
            if (option->given()) {
                throw Usage("{} needs -t SPEC", option->name());
            }
        }
        if (format.text() == "csv" || format.text() == "f64") {
            throw Usage("{} {} needs -t SPEC", format.name(), format.text());
        }
        stream::Options& options = made.options;
        options.format = format.text() == "json" ? stream::Format::json : stream::Format::pretty;
        options.block = "";
        if (options.format == stream::Format::pretty && options.digits.shortest()) {
            options.digits.significant = most_digits;
            options.block = fmt::format("At most {} digits: -t SPEC or --format json gives all of them\n", most_digits);
        }
        if (options.format == stream::Format::pretty &&
            (made.diagnostics == ShowDiagnostics::summary || made.diagnostics == ShowDiagnostics::rows)) {
            made.diagnostics = ShowDiagnostics::off; // which are in the block
        }
    }

    Option method{"--method", "METHOD", "A published formula (see rotconv list methods), fast, or all of them"};
};

} // namespace

CommandEntry convert_command() {
    return {"", "Converts rotations from any representation into any other.",
            "Usage: rotconv -f FROM -t TO [OPTION]... [VALUE]...\n"
            "       rotconv -f FROM [OPTION]... VALUE...\n"
            "       rotconv -f FROM -t TO [OPTION]... [FILE]\n"
            "       rotconv COMMAND [OPTION]...              (rotconv COMMAND --help)\n",
            make_options<ConvertOptions>};
}

} // namespace rotconv::cli
