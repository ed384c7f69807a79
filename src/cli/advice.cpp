#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <rotconv/spec.hpp>

#include "../stream/file.hpp"
#include "../stream/io_block.hpp"
#include "../stream/number_text.hpp"
#include "../stream/preamble.hpp"
#include "../stream/run.hpp"
#include "column_names.hpp"
#include "messages.hpp"
#include "values.hpp"

namespace rotconv::cli::messages {
namespace {

constexpr std::size_t most_kept = std::size_t{64} << 10U;

using Fields = std::vector<std::string_view>;

Fields split(std::string_view line, const stream::InputOptions& input) {
    Fields fields;
    input.delimiter.value_or(stream::Delimiter::of_row(line)).split(line, fields);
    return fields;
}

bool is_row(const Fields& fields) {
    return 2 * static_cast<std::size_t>(std::ranges::count_if(fields, stream::is_number)) > fields.size();
}

std::vector<stream::Line> lines_of(std::string_view text) {
    std::vector<stream::Line> lines;
    while (!text.empty()) {
        lines.push_back(stream::next_line(text));
    }
    return lines;
}

/// The first of the last rows that have one number of fields; none where rows before them have it too.
std::size_t last_block(const std::vector<stream::Line>& lines, const stream::InputOptions& input) {
    std::size_t first = lines.size();
    std::size_t width = 0;
    for (; first > 0; --first) {
        const std::string_view text = lines[first - 1].text;
        const Fields fields = split(text, input);
        if (input.is_row(text) && (!is_row(fields) || (width != 0 && fields.size() != width))) {
            break;
        }
        width = input.is_row(text) ? fields.size() : width;
    }
    const auto is_alike = [&](const stream::Line& each) { return split(each.text, input).size() == width; };
    return std::any_of(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(first), is_alike) ? lines.size()
                                                                                                    : first;
}

/// Makes nothing of the rows' numbers.
class Nothing final : public stream::RowOperation {
public:
    Nothing() { names = {"nothing"}; }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Nothing>(*this); }
    std::size_t run(const stream::NumberRows& rows, std::span<double> /*out*/,
                    std::vector<RowReport>& /*reports*/) override {
        return rows.lines.size();
    }
};

/// Whether the text has rows, and the numbers of all of them can be read.
bool reads(std::string_view text, stream::InputOptions input,
           std::shared_ptr<stream::RowOperation> operation = std::make_shared<Nothing>()) {
    if (input.take_count) {
        input.take_count = [](std::size_t fields) { return fields; };
    }
    const stream::Options options{.input = std::move(input), .operation = std::move(operation)};
    stream::TextSource source(text);
    const auto result = stream::run(source, nullptr, options, [](const stream::Event&) {});
    return !result.error && !result.stopped && result.answered > 0;
}

/// Whether also none of its rows fails; an operation that remembers its rows is not asked.
bool converts(std::string_view text, const stream::Options& options) {
    const bool only_reads = options.operation->in_order || options.pairing || options.input.take_count;
    return only_reads ? reads(text, options.input) : reads(text, options.input, options.operation->copy());
}

/// Advice on numbers as programs print them for people; otherwise empty.
std::string advice_on_print(std::string_view text, const std::vector<stream::Line>& lines,
                            const stream::InputOptions& input, const std::string& name) {
    if (std::ranges::count(lines, "---", &stream::Line::text) > 0) {
        return "messages that are parted by --- are printed as rows by ros2 topic echo --csv";
    }
    Values values = values_of({std::string(text)}, std::nullopt);
    if (input.numbers.attitude && values.labels.empty()) {
        take_attitude(values, *input.numbers.attitude);
    }
    Fields fields;
    static_cast<void>(values.delimiter.split(values.row, fields));
    return fields.size() == input.numbers.names.size() && std::ranges::all_of(fields, stream::is_number)
               ? "numbers as programs print them can be given as one VALUE, in quotes" +
                     (name.empty() ? "" : fmt::format(": rotconv ... \"$(cat{})\"", name))
               : "";
}

/// The option that selects the numbers of a SPEC by their names; empty if the names are not all there.
std::string columns_option(const Spec& spec, const std::vector<std::string>& names) {
    const auto known = find_names(spec, names);
    return known ? "--columns " + in_shell(joined(known->of(names))) : "";
}

/// What a command of the shell, which reads stdin, makes of a text.
struct Filter {
    std::string_view told;
    std::string_view command;
    char from = '\0'; ///< the character that it replaces
    char to = '\0';   ///< '\0': it takes the character out
};
constexpr auto filters = std::to_array<Filter>({
    {"", ""},
    {"to turn decimal commas into points", "tr , .", ',', '.'},
    {"commas and tabs part the numbers", R"(tr , '\t')", ',', '\t'},
    {"to take numbers out of quotes", "tr -d '\"'", '"'},
});
std::string filtered_text(std::string_view text, const Filter& filter) {
    std::string made(text);
    if (filter.to == '\0') {
        std::erase(made, filter.from);
    } else {
        std::ranges::replace(made, filter.from, filter.to);
    }
    return made;
}

} // namespace

std::string advice(std::string_view beginning, std::size_t line, bool has_header, const stream::Options& options,
                   const std::string& file) {
    const stream::InputOptions& input = options.input;
    if (beginning.find('\0') != std::string_view::npos) {
        return "the input is not text: rows of numbers are read, as NumPy's savetxt or ros2 topic echo --csv write "
               "them";
    }
    if (beginning.size() >= most_kept) { // its last line is cut
        beginning = beginning.substr(0, beginning.rfind('\n') + 1);
    }
    const auto lines = lines_of(beginning);
    const std::size_t at = line - 1;
    if (at >= lines.size() || reads(beginning, input)) { // what is wrong is not how the numbers stand
        return {};
    }
    const auto fields_of = [&](std::size_t index) { return split(lines[index].text, input); };
    const auto is_first_row = [&input](const stream::Line& each) {
        return input.is_row(each.text) && is_row(split(each.text, input));
    };
    const auto first_row = std::ranges::find_if(lines, is_first_row);
    const auto row = static_cast<std::size_t>(first_row - lines.begin());
    const std::string name = file == "-" ? "" : " " + file_in_shell(file);
    const bool by_name = input.columns.has_names();
    const std::size_t count = input.numbers.names.size();
    const auto header_of = [&input](const stream::Line& each) {
        return stream::HeaderLine(each, input.delimiter.value_or(stream::Delimiter::of_row(each.text)));
    };
    if (by_name) {
        const auto later =
            std::find_if(lines.begin() + static_cast<std::ptrdiff_t>(line), lines.end(), [&](const auto& each) {
                return std::holds_alternative<std::vector<std::size_t>>(
                    input.columns.positions(header_of(each).names()));
            });
        if (later != lines.end()) {
            return fmt::format("line {0} has them: tail -n +{0}{1} | rotconv ...", later - lines.begin() + 1, name);
        }
    }
    const Fields fields = row < lines.size() ? fields_of(row) : Fields();
    if (at > row || (has_header && fields_of(at).size() == fields.size())) {
        return {};
    }

    // The header right before the rows.
    const auto names = row == 0 || row == lines.size() || row > at + 1
                           ? std::vector<std::string>()
                           : header_of(lines[row - 1]).without_mark().names();
    std::string of_header;
    if (!by_name && !names.empty() && std::ranges::none_of(names, stream::is_number)) {
        stream::InputOptions with_header = input;
        with_header.header = stream::HeaderMode::yes;
        if (names.size() == fields.size()) {
            const std::string option = input.numbers.attitude ? columns_option(*input.numbers.attitude, names) : "";
            of_header = !input.columns.empty() || names.size() <= count ? ""
                        : option.empty()                                ? "the columns are " + numbered(names)
                                                                        : "the header has them: " + option;
        } else {
            const bool helps = reads(beginning, with_header);
            const bool selects = input.columns.empty() && names.size() == count;
            of_header = fmt::format("the header has {} and the rows {}{}", counted(names.size(), "name"),
                                    counted(fields.size(), "field"), helps || selects ? ": add --header yes" : "") +
                        (selects && !helps ? " --columns LIST" : "");
        }
    }

    std::string found;
    const auto offer = [&found](std::string_view text, const stream::InputOptions& reading, const std::string& told) {
        if (found.empty() && reads(text, reading)) {
            found = told;
        }
    };
    const std::string_view text = lines[at].text;
    stream::InputOptions reading = input;
    reading.delimiter = stream::Delimiter::blanks();
    if (text.find('\t') != std::string_view::npos && text.find(' ') != std::string_view::npos) {
        offer(beginning, reading, "tabs and blanks part the numbers: add --delimiter blank");
    }
    reading = input;
    const std::size_t size = std::min(text.find_first_not_of("/%!*;|"), text.size());
    reading.comment = size > 0 ? text.substr(0, size) : "COMMENT";
    if (text.starts_with(reading.comment)) {
        offer(beginning, reading,
              fmt::format("lines that begin with {} are not rows: add --comment {}", reading.comment,
                          in_shell(reading.comment)));
    }
    found = found.empty() && of_header.find(": ") != std::string::npos ? of_header : found;

    // What is made of the text; by index, and with LIST, where the columns that are given do not serve.
    const auto try_text = [&](std::string_view made, std::size_t first, const std::string& told, bool whole) {
        if (first >= lines.size() || !found.empty()) {
            return;
        }
        if (!by_name && (whole ? converts(made, options) : reads(made, input))) {
            found = told + " | rotconv ...";
            return;
        }
        std::vector<std::size_t> columns; // those that are numbers
        const Fields own = fields_of(first);
        for (std::size_t i = 0; i < own.size() && columns.size() < count; ++i) {
            if (stream::is_number(own[i])) {
                columns.push_back(i + 1);
            }
        }
        auto list = stream::ColumnList::parse(joined(columns), count);
        if ((by_name || input.columns.empty()) && std::holds_alternative<stream::ColumnList>(list)) {
            stream::InputOptions selecting = input;
            selecting.columns = std::get<stream::ColumnList>(std::move(list));
            offer(made, selecting, told + " | rotconv ... --columns LIST");
        }
    };
    const auto try_kinds = [&] { // rows that begin with the name of their kind
        for (std::size_t i = row; i < lines.size() && found.empty(); ++i) {
            const Fields own = is_first_row(lines[i]) ? fields_of(i) : Fields();
            if (!own.empty() && !own[0].empty() && is_alphanumeric(own[0][0]) && !stream::is_number(own[0])) {
                const std::string_view line_text = lines[i].text;
                const std::string kind(
                    line_text.substr(0, static_cast<std::size_t>(own[0].end() - line_text.begin()) + 1));
                const auto begins = [&kind](const stream::Line& each) { return each.text.starts_with(kind); };
                const auto of_kind = std::ranges::count_if(lines, begins);
                if (of_kind < 2 || of_kind == std::ranges::count_if(lines, is_first_row) ||
                    std::any_of(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(i), begins)) {
                    continue; // a name of its own, the only kind, or one that was tried
                }
                std::string rows;
                for (const stream::Line& each : lines) {
                    rows.append(begins(each) ? each.text : "").append(each.end);
                }
                try_text(rows, i, fmt::format("to keep only one kind of row: grep {}{}", in_shell("^" + kind), name),
                         false);
            }
        }
    };
    if (row == at) {
        try_kinds();
    }
    // The rows from a line on, perhaps up to another; numbers may also be described by rows.
    for (const std::size_t first : {std::size_t{0}, last_block(lines, input), row}) {
        if (first >= lines.size() || (first > 0 && first <= at)) {
            continue;
        }
        const auto begin = lines.begin() + static_cast<std::ptrdiff_t>(first);
        const auto end = first > 0 ? std::find_if_not(begin, lines.end(), is_first_row) : lines.end();
        const bool is_rest =
            std::all_of(end, lines.end(), [&input](const auto& each) { return !input.is_row(each.text); });
        const char* const stop = is_rest ? beginning.data() + beginning.size() : end->text.data();
        const std::string_view part(begin->text.data(), static_cast<std::size_t>(stop - begin->text.data()));
        const std::string cut = is_rest ? fmt::format("tail -n +{}{}", first + 1, name)
                                        : fmt::format("sed -n {},{}p{}", first + 1, end - lines.begin(), name);
        for (const Filter& filter : filters) {
            if (first > 0) {
                try_text(filtered_text(part, filter), first,
                         fmt::format("the first row of numbers is line {}: {}{}{}", first + 1, cut,
                                     filter.command.empty() ? "" : " | ", filter.command),
                         true);
            } else if (!filter.command.empty()) {
                offer(filtered_text(part, filter), input,
                      fmt::format("{}: {}{}{} | rotconv ...", filter.told, filter.command, name.empty() ? "" : " <",
                                  name));
            }
        }
    }
    try_kinds();
    found = found.empty() && input.columns.empty() ? advice_on_print(beginning, lines, input, name) : found;
    return found.empty() ? of_header : found;
}

std::string contents_advice(const std::string& path) {
    stream::File file(path.c_str(), stream::File::Mode::read);
    std::string text(file.is_open() ? std::min(file.size(), most_kept) : 0, '\0');
    const std::ptrdiff_t count = text.empty() ? 0 : file.read(text);
    if (count <= 0) {
        return {};
    }
    text.resize(static_cast<std::size_t>(count));
    const stream::InputOptions input;
    stream::Preamble preamble(input);
    std::string_view rest = text;
    std::size_t line = 1;
    stream::Output nowhere;
    const bool has_row = preamble.read(rest, line, nowhere);
    const Fields fields = has_row ? split(stream::next_line(rest).text, input) : Fields();
    if (!is_row(fields)) {
        return fmt::format("; {} does not begin with a row of numbers", quoted(path));
    }
    auto names = preamble.names();
    if (names.empty()) {
        names.assign(fields.begin(), fields.end());
    }
    std::string told = fmt::format("; {} has {}: {}", quoted(path), counted(fields.size(), "column"), numbered(names));
    for (const char* spec : {"quat", "dcm", "rpy"}) {
        if (const std::string option = columns_option(std::get<Spec>(parse_spec(spec)), names); !option.empty()) {
            return fmt::format("{}; perhaps -f {} {}", told, spec, option);
        }
    }
    return told;
}

} // namespace rotconv::cli::messages
