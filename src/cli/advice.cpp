#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <rotconv/spec.hpp>

#include "../stream/file.hpp"
#include "../stream/io_block.hpp"
#include "../stream/number_text.hpp"
#include "../stream/preamble.hpp"
#include "../stream/run.hpp"
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
};

/// Whether the text has rows, and the numbers of all of them can be read.
bool reads(std::string_view text, stream::InputOptions input,
           std::shared_ptr<stream::RowOperation> operation = std::make_shared<Nothing>()) {
    if (input.take_count) {
        input.take_count = [](std::size_t fields) { return fields; };
    }
    const stream::Options options{
        .input = std::move(input), .operation = std::move(operation), .format = stream::Format::result};
    stream::TextSource source(text);
    stream::NullSink sink;
    const auto result = stream::run(source, sink, options, [](const stream::Event&) {});
    return !result.error && !result.stopped && result.answered > 0;
}

/// Whether also none of its rows fails; an operation that remembers its rows is not asked.
bool converts(std::string_view text, const stream::Options& options) {
    const bool only_reads = options.operation->in_order || options.pairing || options.input.take_count;
    return only_reads ? reads(text, options.input) : reads(text, options.input, options.operation->copy());
}

/// Advice on a header that has another width than the rows after it; otherwise empty. The first row has the index
/// `row`.
std::string advice_on_width(std::string_view text, const std::vector<stream::Line>& lines, std::size_t row,
                            const stream::InputOptions& input) {
    std::size_t header = row; // after the header, so far
    while (header > 0 && !input.is_row(lines[header - 1].text)) {
        --header;
    }
    const Fields names = header > 0 ? split(lines[header - 1].text, input) : Fields();
    const Fields fields = split(lines[row].text, input);
    if (header == 0 || std::ranges::any_of(names, stream::is_number) || names.size() == fields.size()) {
        return {};
    }
    const std::string told = fmt::format("the header has {} and the rows {}", counted(names.size(), "name"),
                                         counted(fields.size(), "field"));
    stream::InputOptions with_header = input;
    with_header.header = stream::HeaderMode::yes;
    const bool selects = input.columns.empty() && names.size() == input.numbers.names.size();
    return told + (reads(text, with_header) ? ": add --header yes"
                   : selects                ? ": add --header yes --columns LIST"
                                            : "");
}

/// Advice on numbers as programs print them for people; otherwise empty.
std::string advice_on_print(std::string_view text, const std::vector<stream::Line>& lines,
                            const stream::InputOptions& input) {
    if (std::ranges::count(lines, "---", &stream::Line::text) > 0) {
        return "messages that are parted by --- are printed as rows by ros2 topic echo --csv";
    }
    const Values values = values_of({std::string(text)}, std::nullopt);
    Fields fields;
    static_cast<void>(values.delimiter.split(values.row, fields));
    return fields.size() == input.numbers.names.size() && std::ranges::all_of(fields, stream::is_number)
               ? "numbers as programs print them can be given as one VALUE, in quotes"
               : "";
}

/// A key as jq names it.
std::string jq_path(const std::string& key) {
    const bool is_plain = !key.empty() && (key[0] < '0' || key[0] > '9') &&
                          std::ranges::all_of(key, [](char c) { return is_alphanumeric(c) || c == '_'; });
    return is_plain ? "." + key : fmt::format(".[\"{}\"]", key);
}

std::string_view after_blanks(std::string_view text) {
    return text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
}

/// The keys of the object that begins the text.
std::vector<std::string> keys_of(std::string_view object) {
    std::vector<std::string> keys;
    int depth = 0;
    for (std::size_t i = 0; i < object.size(); ++i) {
        const char c = object[i];
        if (c == '"') {
            const std::size_t begin = i + 1;
            for (++i; i < object.size() && object[i] != '"'; ++i) {
                i += object[i] == '\\' ? 1 : 0;
            }
            if (i < object.size() && depth == 1 && after_blanks(object.substr(i + 1)).starts_with(':')) {
                keys.emplace_back(object.substr(begin, i - begin));
            }
        } else if (c == '{' || c == '[') {
            ++depth;
        } else if ((c == '}' || c == ']') && --depth == 0) {
            break;
        }
    }
    return keys;
}

} // namespace

std::string advice(std::string_view beginning, std::size_t line, bool has_header, const stream::Options& options,
                   const std::string& file) {
    const stream::InputOptions& input = options.input;
    if (beginning.size() >= most_kept) { // its last line is cut
        beginning = beginning.substr(0, beginning.rfind('\n') + 1);
    }
    const auto lines = lines_of(beginning);
    const auto is_first_row = [&input](const stream::Line& each) {
        return input.is_row(each.text) && is_row(split(each.text, input));
    };
    const auto row = static_cast<std::size_t>(std::ranges::find_if(lines, is_first_row) - lines.begin());
    const std::size_t at = line - 1;
    const std::string name = file == "-" ? "" : " " + file_in_shell(file);
    const auto has_names = [&input](const stream::Line& each) {
        const stream::HeaderLine header(each, input.delimiter.value_or(stream::Delimiter::of_row(each.text)));
        return std::holds_alternative<std::vector<std::size_t>>(input.columns.positions(header.names()));
    };
    if (input.columns.has_names() && at < lines.size()) {
        const auto later = std::find_if(lines.begin() + static_cast<std::ptrdiff_t>(line), lines.end(), has_names);
        if (later != lines.end()) {
            return fmt::format("line {0} has them: tail -n +{0}{1} | rotconv ...", later - lines.begin() + 1, name);
        }
    }
    if (at >= lines.size() || at > row || has_header) {
        return {};
    }

    std::string found;
    const auto offer = [&found](std::string_view text, const stream::InputOptions& reading, const std::string& told) {
        if (found.empty() && reads(text, reading)) {
            found = told;
        }
    };
    const auto offer_lines = [&](const auto& edit, const std::string& command) { // a blank line is no row
        std::string edited;
        for (const stream::Line& each : lines) {
            edited.append(edit(each.text)).append(each.end);
        }
        offer(edited, input, command + " | rotconv ...");
    };
    const std::string_view text = lines[at].text;
    if (text.find('\t') != std::string_view::npos && text.find(' ') != std::string_view::npos) {
        stream::InputOptions with_blanks = input;
        with_blanks.delimiter = stream::Delimiter::blanks();
        offer(beginning, with_blanks, "tabs and blanks part the numbers: add --delimiter blank");
    }
    for (const std::string_view mark : {"//", "%", "COMMENT"}) {
        if (text.starts_with(mark)) {
            stream::InputOptions with_comment = input;
            with_comment.comment = mark;
            offer(beginning, with_comment,
                  fmt::format("lines that begin with {} are not rows: add --comment {}", mark, in_shell(mark)));
            offer_lines([mark](auto each) { return each.starts_with(mark) ? std::string_view() : each; },
                        fmt::format("to leave out lines that begin with {}: grep -v '^{}'{}", mark, mark, name));
            offer_lines(
                [mark](auto each) { return each.starts_with(mark) ? after_blanks(each.substr(mark.size())) : each; },
                fmt::format("to leave out the {} before the names: sed 's|^{} *||'{}", mark, mark, name));
        }
    }
    if (text.starts_with("FMT,")) {
        const std::string grep = fmt::format("for example: grep '^ATT,'{}", name);
        if (input.columns.has_names()) {
            return "keep only one kind of row of the log, and select its columns by index, " + grep + " | rotconv ...";
        }
        offer_lines([](auto each) { return each.starts_with("ATT,") ? each : std::string_view(); },
                    "keep only one kind of row of the log, " + grep);
    }
    if (text.find(',') != std::string_view::npos) {
        std::string with_points(beginning);
        std::ranges::replace(with_points, ',', '.');
        offer(with_points, input,
              fmt::format("to turn decimal commas into points: tr , .{}{} | rotconv ...", name.empty() ? "" : " <",
                          name));
    }
    bool is_inside = false;
    offer_lines(
        [&is_inside](auto each) {
            const bool is_start = each.find("DATA_START") != std::string_view::npos;
            is_inside = (is_inside || is_start) && each.find("DATA_STOP") == std::string_view::npos;
            return is_inside && !is_start ? each : std::string_view();
        },
        "to read only the rows between two lines: sed -n '/DATA_START/,/DATA_STOP/{//!p}'" + name);
    if (found.empty() && row <= at + 1 && row < lines.size() && !input.columns.has_names()) {
        found = advice_on_width(beginning, lines, row, input);
    }
    for (const std::size_t first : {row, last_block(lines, input)}) { // numbers may also be described by rows
        if (found.empty() && first > at && first < lines.size() &&
            converts(beginning.substr(static_cast<std::size_t>(lines[first].text.data() - beginning.data())),
                     options)) {
            found = fmt::format("the first row of numbers is line {0}: tail -n +{0}{1} | rotconv ...", first + 1, name);
        }
    }
    return found.empty() ? advice_on_print(beginning, lines, input) : found;
}

std::string json_advice(std::string_view beginning, const stream::InputOptions& input) {
    // from the line with the first bracket; npos + 1 is 0
    std::string_view text = after_blanks(beginning.substr(beginning.rfind('\n', beginning.find_first_of("{[")) + 1));
    const auto selected = input.columns.names();
    const std::vector<std::string> wanted =
        input.columns.has_names() ? std::vector<std::string>(selected.begin(), selected.end()) : input.numbers.names;
    const bool is_array = text.starts_with('[');
    if (is_array) {
        text = after_blanks(text.substr(1));
    }
    std::string filter;
    std::string keys_told;
    if (is_array && !text.starts_with('{')) {
        const auto numbers = std::ranges::count(text.substr(0, text.find(']')), ',') + 1;
        const bool has_rows = numbers == static_cast<std::ptrdiff_t>(wanted.size());
        filter = !text.starts_with('[') ? "@csv" : has_rows ? ".[] | @csv" : "flatten | @csv";
    } else {
        const auto keys = keys_of(text);
        const auto has = [&keys](const std::string& name) { return std::ranges::count(keys, name) > 0; };
        const bool has_all = !wanted.empty() && std::ranges::all_of(wanted, has);
        filter = fmt::format("{}[{}] | @csv", is_array ? ".[] | " : "",
                             has_all ? fmt::format("{}", fmt::join(mapped(wanted, jq_path), ", ")) : ".KEY, ...");
        if (!has_all) {
            keys_told = fmt::format(", with the keys for {}; the input has the keys {}", fmt::join(wanted, " "),
                                    quoted_list(keys));
        }
    }
    return fmt::format("; rotconv reads rows of numbers, such as those written by jq -r {}{}{}", in_shell(filter),
                       input.columns.has_names() ? ", without --columns" : "", keys_told);
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
        const Representation& entry = *find_representation(spec);
        const std::span columns(entry.columns.data(), entry.size);
        if (std::ranges::all_of(columns, [&](auto column) { return std::ranges::count(names, column) == 1; })) {
            return fmt::format("{}; perhaps -f {} --columns {}", told, spec, fmt::join(columns, ","));
        }
    }
    return told;
}

} // namespace rotconv::cli::messages
