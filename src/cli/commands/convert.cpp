#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "../../methods/method_conversion.hpp"
#include "../../stream/rows/row_writer.hpp"
#include "../grammar/column_names.hpp"
#include "../grammar/values.hpp"
#include "../row_options.hpp"

namespace rotconv::cli {
namespace {

/// What is written where -t is not given.
std::vector<Spec> all_forms() {
    constexpr std::array<std::string_view, 8> forms{
        {"dcm", "quat", "axis-angle:deg", "rotvec:deg", "rpy:deg", "euler:ZYX:deg", "cayley", "mrp"}};
    return mapped(forms, [](std::string_view text) { return std::get<Spec>(parse_spec(text)); });
}

/// The answers of methods to a row, in lines for people.
std::string lines_of(const std::vector<MethodConversion>& methods, const operations::MethodAnswers& answers,
                     const stream::Options& options) {
    const stream::Layout layout;
    const stream::RowWriter writer(options, layout);
    const auto names = mapped(methods, &MethodConversion::name);
    const std::size_t size = methods.front().to().size();
    const auto number = [&](std::size_t i) {
        stream::Buffer text;
        writer.write_number(text, answers.numbers[i], i % size);
        return fmt::to_string(text);
    };
    std::vector<std::size_t> widths(size); // of the columns
    for (std::size_t i = 0; i < answers.numbers.size(); ++i) {
        widths[i % size] = std::max(widths[i % size], number(i).size());
    }
    const std::size_t longest = std::ranges::max(names, {}, &std::string_view::size).size();
    std::string lines;
    for (std::size_t k = 0; k < names.size(); ++k) {
        lines += fmt::format("{:<{}}", names[k], longest);
        for (std::size_t i = 0; i < size; ++i) {
            lines += fmt::format("  {:>{}}", number(k * size + i), widths[i]);
        }
        lines += fmt::format("  error {} rad\n", stream::number_text(answers.angles[k], options.digits));
    }
    return lines;
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

/// A text that is one attitude, as VALUEs may be, as a row, and what is to be said of that.
std::optional<std::pair<std::string, std::vector<stream::Note>>> row_of_text(std::string_view text,
                                                                             const stream::RowNumbers& numbers,
                                                                             const std::string& from,
                                                                             std::string_view comment) {
    bool has_marks = text.find_first_of("[](){}<>:=") != std::string_view::npos;
    for (std::size_t i = 1; i < text.size() && !has_marks; ++i) { // of a sum: 0.6k
        has_marks = text[i] >= 'i' && text[i] <= 'k' && text[i - 1] >= '0' && text[i - 1] <= '9';
    }
    bool is_matrix = numbers.attitude->name == RepresentationId::dcm; // of three or four lines
    std::string rows;
    std::size_t lines = 0;
    std::size_t width = 0;
    while (!text.empty()) {
        const std::string_view line = stream::next_line(text).text;
        if (stream::is_blank(line) || (!comment.empty() && line.starts_with(comment))) {
            continue;
        }
        rows.append(line).append("\n");
        std::vector<std::string_view> fields;
        static_cast<void>(stream::Delimiter::of_row(line).split(line, fields));
        if (lines > 0 || fields.size() != 1) {                 // not the name of a matrix
            std::erase_if(fields, [](std::string_view field) { // brackets
                return field.find_first_of("0123456789") == std::string_view::npos;
            });
            is_matrix =
                is_matrix && (fields.size() == 3 || fields.size() == 4) && (lines == 0 || fields.size() == width);
            width = fields.size();
            ++lines;
        }
    }
    if (is_matrix && lines == 3 && width == 4) { // a pose, of which the last line is not written
        rows += rows.find(',') == std::string::npos ? "0 0 0 1" : "0,0,0,1";
    }
    if (!has_marks && !(is_matrix && (lines == 3 || lines == 4))) {
        return std::nullopt;
    }
    bool means_other = false; // and is no row of this one
    auto values = attitude_in(rows, numbers, from, means_other);
    if (!values) {
        return std::nullopt;
    }
    values->notes.insert(values->notes.begin(), {stream::Note::Kind::text, "the input is one attitude, not rows of "
                                                                           "numbers, and is read like VALUEs"});
    return std::pair(std::move(values->row), std::move(values->notes));
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
        if (!from.given() && !to.given() && values.empty()) {
            throw MissingSpec("{} SPEC and {} SPEC are missing", from.name(), to.name());
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
        if (name == all_methods) {
            return all_answers(Conversion(read, written[0], conversion));
        }
        RowsCommand made = rows_command(operations::several(
            mapped(written, [&](const Spec& each) { return by_method(Conversion(read, each, conversion)); })));
        read_files(made.options.input, read);
        if (is_block) {
            write_block(made);
        }
        return made;
    }

private:
    /// By a method of rotconv's own or a published one.
    [[nodiscard]] operations::Operation by_method(const Conversion& conversion) const {
        const std::string& name = method.text();
        if (!method.given() || name == default_method || name == fast_method) {
            return operations::convert(conversion, continuous.given());
        }
        const Method* found = find_method(conversion.from().name, conversion.to().name, name);
        if (found == nullptr) {
            throw messages::no_such_method(conversion.from().name, conversion.to().name, method);
        }
        return operations::method(MethodConversion(conversion, *found), continuous.given());
    }

    /// Reads files of the project that --from is, and inputs that are one attitude in another form than a row.
    void read_files(stream::InputOptions& in, const Spec& read) const {
        if (!columns.given() && values.empty() && read.project != nullptr) {
            in.project_columns = [read](std::size_t fields) { return columns_of_project(read, fields); };
        }
        if (to.given() && !columns.given() && !header.given() && !append.given()) {
            in.read_text = [numbers = in.numbers, spec = from.text(), comment = in.comment](std::string_view text) {
                return row_of_text(text, numbers, spec, comment);
            };
        }
    }

    /// The answers of all methods to VALUEs, a line for each.
    [[nodiscard]] RowsCommand all_answers(const Conversion& conversion) const {
        if (values.empty()) {
            throw Usage("{0} all is for VALUEs; for a stream, a loop: for method in $(rotconv list methods {1} {2} | "
                        "awk '/^  / {{ print $1 }}'); do rotconv -f {1} -t {2} {0} $method FILE; done",
                        method.name(), from.text(), to.text());
        }
        if (append.given() || header.given() || diagnostics.text() == "columns" ||
            (format.given() && format.text() != "pretty")) {
            throw Usage("{} all writes lines for people, without {}, {}, {} columns or a {} other than pretty",
                        method.name(), append.name(), header.name(), diagnostics.name(), format.name());
        }
        const auto methods = MethodConversion::all(conversion);
        const auto answers = std::make_shared<operations::MethodAnswers>();
        RowsCommand made = rows_command(operations::all_methods(methods, answers));
        made.options.writes_rows = false;
        made.conclude = [methods, answers](const RowsCommand& command, const RowsResult& result) {
            return Conclusion{.text = result.failed[0] == 0 ? lines_of(methods, *answers, command.options) : "",
                              .holds = true};
        };
        return made;
    }

    /// The attitude of VALUEs in all forms, for people or as one object.
    void write_block(RowsCommand& made) const {
        constexpr int most_digits = 9;
        for (const Option* option : {&append, &header}) {
            if (option->given()) {
                throw Usage("{} needs -t SPEC", option->name());
            }
        }
        stream::Options& options = made.options;
        if (format.given() && options.format != stream::Format::json && options.format != stream::Format::pretty) {
            throw Usage("{} {} needs -t SPEC", format.name(), format.text());
        }
        options.format = format.given() ? options.format : stream::Format::pretty;
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

    Option method{"--method", "METHOD", "A published formula (rotconv list methods), fast, or all for VALUEs"};
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
