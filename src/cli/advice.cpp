#include "advice.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <rotconv/spec.hpp>

#include "../stream/file.hpp"
#include "../stream/fmt.hpp"
#include "../stream/io_block.hpp"
#include "../stream/number_text.hpp"
#include "../stream/preamble.hpp"
#include "../stream/run.hpp"
#include "words.hpp"

namespace rotconv::cli {
namespace {

constexpr std::size_t most_kept = std::size_t{64} << 10U;

using Fields = std::vector<std::string_view>;

Fields split(std::string_view line, const stream::InputOptions& input) {
    Fields fields;
    input.delimiter.value_or(stream::Delimiter::of_row(line)).split(line, fields);
    return fields;
}

std::size_t count_numbers(const Fields& fields) {
    return static_cast<std::size_t>(std::ranges::count_if(fields, stream::is_number));
}

bool is_row(const Fields& fields) { return 2 * count_numbers(fields) > fields.size(); }

/// The first line from `line` on most of whose fields are numbers; 0 where there is none.
std::size_t first_row(std::string_view text, const stream::InputOptions& input) {
    std::size_t number = 0;
    while (!text.empty()) {
        const std::string_view line = stream::next_line(text).text;
        ++number;
        if (!stream::is_blank(line) && !stream::is_comment(line) && is_row(split(line, input))) {
            return number;
        }
    }
    return 0;
}

std::string_view from_line(std::string_view text, std::size_t line) {
    for (; line > 1 && !text.empty(); --line) {
        static_cast<void>(stream::next_line(text));
    }
    return text;
}

/// Those lines that pass.
template <class Passes> std::string lines_of(std::string_view text, const Passes& passes) {
    std::string kept;
    while (!text.empty()) {
        const stream::Line line = stream::next_line(text);
        if (passes(line.text)) {
            kept.append(line.text).append(line.end);
        }
    }
    return kept;
}

/// The text without the mark, and the blanks after it, at the beginning of lines.
std::string without(std::string_view mark, std::string_view text) {
    std::string kept;
    while (!text.empty()) {
        const stream::Line line = stream::next_line(text);
        const bool is_marked = line.text.starts_with(mark);
        const auto begin = is_marked ? line.text.find_first_not_of(' ', mark.size()) : 0;
        kept.append(line.text.substr(std::min(begin, line.text.size()))).append(line.end);
    }
    return kept;
}

/// What is between two marks.
std::string block_of(std::string_view text) {
    bool is_inside = false;
    return lines_of(text, [&is_inside](std::string_view line) {
        const bool is_start = line.find("DATA_START") != std::string_view::npos;
        const bool is_stop = line.find("DATA_STOP") != std::string_view::npos;
        is_inside = (is_inside || is_start) && !is_stop;
        return is_inside && !is_start;
    });
}

/// Takes the rows' numbers and makes nothing of them.
class Nothing final : public stream::RowOperation {
public:
    Nothing() { names = {"nothing"}; }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Nothing>(*this); }
    void run(const stream::NumberRows& /*rows*/, std::span<double> out, std::vector<RowReport>& reports) override {
        std::ranges::fill(out, 0.0);
        reports.clear();
    }
};

/// Numbers are read from all rows of the text, and there are some.
bool reads(std::string_view text, stream::InputOptions input) {
    if (input.take_count) {
        input.take_count = [](std::size_t fields) { return fields; };
    }
    const stream::Options options{
        .input = std::move(input), .operation = std::make_shared<Nothing>(), .format = stream::Format::result};
    stream::TextSource source(text);
    stream::NullSink sink;
    const auto result = stream::run(source, sink, options, [](const stream::Event&) {});
    return !result.error && !result.stopped && result.answered > 0;
}

/// A header of another width than the rows after it; empty where it is not so.
std::string advice_on_width(std::string_view text, std::size_t line, std::size_t row,
                            const stream::InputOptions& input) {
    std::string_view above; // the line, or that above the row at which reading stopped
    std::size_t number = 0;
    for (std::string_view rest = text; !rest.empty() && number < line;) {
        const std::string_view current = stream::next_line(rest).text;
        ++number;
        const bool counts = !stream::is_blank(current) && !stream::is_comment(current);
        if (counts && (number < line || row > line)) {
            above = current;
        }
    }
    const Fields names = split(above, input);
    std::string_view rest = from_line(text, row);
    const Fields fields = split(stream::next_line(rest).text, input);
    if (above.empty() || row == 0 || row > line + 1 || count_numbers(names) > 0 || names.size() == fields.size()) {
        return {};
    }
    const std::string told = fmt::format("the header has {} and the rows {}", counted(names.size(), "name"),
                                         counted(fields.size(), "field"));
    stream::InputOptions with_header = input;
    with_header.header = stream::HeaderMode::yes;
    if (reads(text, with_header)) {
        return told + ": add --header yes";
    }
    const bool selects = input.columns.empty() && names.size() == input.numbers.names.size();
    return selects ? told + ": add --header yes --columns LIST" : told;
}

/// A key as jq names it.
std::string jq_path(const std::string& key) {
    const bool is_plain = !key.empty() && (key[0] < '0' || key[0] > '9') && std::ranges::all_of(key, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
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

std::string advice(std::string_view beginning, std::size_t line, const stream::InputOptions& input,
                   const std::string& file) {
    if (beginning.size() >= most_kept) { // its last line is cut
        beginning = beginning.substr(0, beginning.rfind('\n') + 1);
    }
    const std::size_t row = first_row(beginning, input);
    const std::string_view rest = from_line(beginning, line);
    if (rest.empty() || (row > 0 && line > row)) {
        return {};
    }
    std::string_view after = rest;
    const std::string_view text = stream::next_line(after).text;
    const std::string name = file == "-" ? "" : " " + in_shell((file.starts_with('-') ? "./" : "") + file);
    for (const std::string_view mark : {"//", "%"}) {
        const auto passes = [mark](std::string_view each) { return !each.starts_with(mark); };
        if (text.starts_with(mark) && reads(lines_of(beginning, passes), input)) {
            return fmt::format("lines that begin with {} are left out by grep -v '^{}'{} | rotconv ...", mark, mark,
                               name);
        }
        if (text.starts_with(mark) && reads(without(mark, beginning), input)) {
            return fmt::format("the {} before the names is left out by sed 's|^{} *||'{} | rotconv ...", mark, mark,
                               name);
        }
    }
    if (text.starts_with("FMT,")) {
        const auto passes = [](std::string_view each) { return each.starts_with("ATT,"); };
        const bool by_name = input.columns.has_names();
        if (by_name || reads(lines_of(beginning, passes), input)) {
            return fmt::format("of a log keep one kind of rows, as grep '^ATT,'{} | rotconv ... does{}", name,
                               by_name ? ", and select its columns by index" : "");
        }
    }
    std::string with_points(beginning);
    std::ranges::replace(with_points, ',', '.');
    if (text.find(',') != std::string_view::npos && reads(with_points, input)) {
        return fmt::format("the numbers have decimal commas: tr , .{} | rotconv ... makes them points",
                           name.empty() ? "" : " <" + name);
    }
    if (reads(block_of(beginning), input)) {
        return fmt::format(
            "the rows stand between two lines: sed -n '/DATA_START/,/DATA_STOP/{{//!p}}'{} | rotconv ...", name);
    }
    if (std::string told = advice_on_width(beginning, line, row, input); !told.empty()) {
        return told;
    }
    if (row > line && reads(from_line(beginning, row), input)) {
        return fmt::format("the first row of numbers is line {}: tail -n +{}{} | rotconv ...", row, row, name);
    }
    return {};
}

std::string json_advice(std::string_view beginning, const stream::InputOptions& input) {
    const std::string_view text = after_blanks(from_line(
        beginning,
        1 + static_cast<std::size_t>(std::ranges::count(beginning.substr(0, beginning.find_first_of("{[")), '\n'))));
    const auto selected = input.columns.names();
    std::vector<std::string> wanted(selected.begin(), selected.end());
    if (!input.columns.has_names()) {
        wanted = input.numbers.names;
    }
    std::string each; // what leads to the rows
    std::string_view object = text;
    if (text.starts_with('[')) {
        const std::string_view inner = after_blanks(text.substr(1));
        if (!inner.starts_with('{')) {
            const auto numbers = std::ranges::count(inner.substr(0, inner.find(']')), ',') + 1;
            const bool has_rows = inner.starts_with('[') && numbers == static_cast<std::ptrdiff_t>(wanted.size());
            return fmt::format("; jq -r '{}@csv' writes rows of numbers", has_rows                 ? ".[] | "
                                                                          : inner.starts_with('[') ? "flatten | "
                                                                                                   : "");
        }
        each = ".[] | ";
        object = inner;
    }
    const auto keys = keys_of(object);
    const auto has = [&keys](const std::string& name) { return std::ranges::count(keys, name) > 0; };
    if (!wanted.empty() && std::ranges::all_of(wanted, has)) {
        std::vector<std::string> paths;
        std::ranges::transform(wanted, std::back_inserter(paths), jq_path);
        return fmt::format("; jq -r {} writes rows of numbers",
                           in_shell(fmt::format("{}[{}] | @csv", each, fmt::join(paths, ", "))));
    }
    return fmt::format("; of its keys {} those of {} go into jq -r '{}[.KEY, ...] | @csv'", quoted_list(keys),
                       fmt::join(wanted, " "), each);
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
        return fmt::format("; {} begins with no row of numbers", quoted(path));
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

} // namespace rotconv::cli
