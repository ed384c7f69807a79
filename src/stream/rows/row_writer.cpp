#include "row_writer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <variant>

#include "../../core/projects.hpp"
#include "../../core/representations/codec.hpp"
#include "../../core/text.hpp"
#include "../numbers/json.hpp"

namespace rotconv::stream {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The names of the kinds of the row's diagnostics, each once, joined by '+'.
std::string notes_of(const ConvertedRow& row) {
    if (row.failed) {
        return "error";
    }
    std::string notes;
    for_each_diagnostic(*row.report, row.number, [&](const Diagnostic& diagnostic) {
        if (const std::string_view name = name_of(diagnostic.kind); name != notes) { // such kinds are the first
            notes.append(notes.empty() ? "" : "+").append(name);
        }
    });
    return notes;
}

/// Margin, condition and defect.
std::array<double, 3> figures_of(const ConvertedRow& row) noexcept {
    if (row.failed) {
        return {nan, nan, nan};
    }
    return {row.report->sensitivity.margin, row.report->sensitivity.condition,
            std::max({row.report->defect, row.report->references[0].defect, row.report->references[1].defect})};
}

std::string_view without_trailing_blanks(std::string_view row, char delimiter) noexcept {
    return row.substr(0, row.find_last_not_of(delimiter == '\t' ? " " : " \t") + 1);
}

/// Writes the fields that are not replaced and the result, in its place or at the end of the row less trailing blanks.
/// `write_result` gets a function to be called before each of its fields.
template <class WriteResult> void write_fields(Buffer& to, const Layout& layout, std::string_view row,
                                               std::span<const std::string_view> fields, char delimiter,
                                               const WriteResult& write_result) {
    bool first = true;
    const auto begin_field = [&] {
        if (!std::exchange(first, false)) {
            to.push_back(delimiter);
        }
    };
    const auto other = [&](std::size_t i) {
        begin_field();
        append(to, fields[i]);
    };
    if (layout.appends) {
        begin_field();
        append(to, without_trailing_blanks(row, delimiter));
        write_result(begin_field);
    } else {
        for_each_output(layout, fields.size(), other, [&] { write_result(begin_field); });
    }
}

/// Copies the fields between the first and the last replaced one that are not replaced, each after a delimiter.
char* copy_others(char* to, const Layout& layout, std::string_view numbers) {
    const char delimiter = layout.delimiter.text();
    const char* at = numbers.data();
    const char* const end = at + numbers.size();
    auto replaced = layout.replaced.begin();
    for (std::size_t field = *replaced;; ++field) {
        const std::string_view rest(at, end); // whose find() is quicker than std::find
        const char* const stop = at + std::min(rest.find(delimiter), rest.size());
        if (field == *replaced) {
            ++replaced;
        } else {
            *to++ = delimiter;
            to = std::copy(at, stop, to);
        }
        if (stop == end) {
            return to;
        }
        at = stop + 1;
    }
}

/// Writes a line with the result, of at most `room` bytes, in the place of `numbers` or at its end.
template <class WriteResult> void write_around(Buffer& to, const Layout& layout, const Line& line,
                                               std::string_view numbers, std::size_t room,
                                               const WriteResult& write_result) {
    std::string_view before(line.text.data(), numbers.data());
    const char* const end = line.text.data() + line.text.size() + line.end.size();
    std::string_view after(numbers.data() + numbers.size(), end);
    if (layout.appends) {
        before = without_trailing_blanks(line.text, layout.delimiter.text());
        after = line.end;
    }
    const std::size_t size = to.size();
    to.reserve(size + before.size() + 1 + room + numbers.size() + after.size());
    char* at = std::ranges::copy(before, to.data() + size).out;
    if (layout.appends) {
        *at++ = layout.delimiter.text();
    }
    at = write_result(at);
    if (layout.is_scattered && !layout.appends) {
        at = copy_others(at, layout, numbers);
    }
    at = std::ranges::copy(after, at).out;
    to.resize(static_cast<std::size_t>(at - to.data()));
    if (line.end.empty()) {
        append(to, layout.line_end);
    }
}

/// The name of the project that a SPEC is, otherwise its text.
std::string label_of(const Spec& spec) {
    const bool is_project = spec.project != nullptr && spec.project->specs.find(' ') == std::string_view::npos &&
                            spec.project->is_spec() &&
                            std::get<Spec>(parse_spec(spec.project->text)).text() == spec.text();
    return is_project ? std::string(spec.project->text) : spec.text();
}

/// The names of an attitude's numbers, as short as people know them.
std::string names_for_people(const Spec& spec) {
    using enum RepresentationId;
    const auto columns = spec.columns();
    const std::string axes = lower(spec.sequence.text());
    return spec.name == dcm     ? "body to reference"
           : spec.name == quat  ? "w x y z"
           : spec.name == euler ? fmt::format("about {}", fmt::join(axes, " "))
                                : fmt::format("{}", fmt::join(std::span(columns).first(spec.size()), " "));
}

/// The columns of the result, its diagnostics and its partner, if they are written.
std::vector<std::string> result_columns(const Options& options, const Layout& layout) {
    auto columns = layout.kept_names.empty() ? options.operation->names() : layout.kept_names;
    if (options.diagnostic_columns) {
        columns.insert(columns.end(), diagnostic_names.begin(), diagnostic_names.end());
    }
    if (options.writes_partners()) {
        columns.insert(columns.end(), partner_names.begin(), partner_names.end());
    }
    return columns;
}

/// Separates a member of an object of JSON from the one before.
void begin_member(Buffer& to) {
    if (to[to.size() - 1] != '{') {
        append(to, ", ");
    }
}

/// Writes a line with the columns of the result in their place.
void write_columns(Buffer& to, const Layout& layout, const HeaderLine& line, const std::vector<std::string>& columns) {
    const auto write = [&columns, &to](const auto& begin_field) {
        for (const std::string& column : columns) {
            begin_field();
            append(to, column);
        }
    };
    append(to, layout.appends ? "" : line.prefix);
    write_fields(to, layout, line.line.text, line.fields, line.delimiter.text(), write);
    append(to, line.line.end.empty() ? std::string_view("\n") : line.line.end);
}

} // namespace

double figure_of(const RowReport& report, const Sensitivity& sensitivity, DiagnosticKind kind) noexcept {
    switch (kind) {
    case DiagnosticKind::normalized:
    case DiagnosticKind::axis_length:
    case DiagnosticKind::large_angle:
        return std::max({report.unusual.figure_of(kind), report.references[0].unusual.figure_of(kind),
                         report.references[1].unusual.figure_of(kind)});
    case DiagnosticKind::near_gimbal_lock: return sensitivity.condition;
    case DiagnosticKind::method_error:
    case DiagnosticKind::coarse_step:
    case DiagnosticKind::beyond: return report.deviation;
    default: return sensitivity.margin;
    }
}

std::vector<std::string> result_keys(const Options& options, const Layout& layout, Delimiter delimiter) {
    std::vector<std::string> keys;
    for (const std::string& column : result_columns(options, layout)) {
        keys.push_back(json_string(delimiter.unquoted(column)));
    }
    return keys;
}

void write_header(Buffer& to, const Options& options, const Layout& layout, const HeaderLine& header) {
    write_columns(to, layout, header, result_columns(options, layout));
}

void write_units(Buffer& to, const Options& options, const Layout& layout, const HeaderLine& units) {
    const bool has_brackets = units.line.text.find('[') != std::string_view::npos;
    std::vector<std::string> own;
    for (const ResultPart& part : options.operation->parts) {
        for (std::size_t i = 0; i < part.names.size(); ++i) {
            const Representation* const entry = part.attitude ? &representation(part.attitude->name) : nullptr;
            const bool is_angle = entry != nullptr && entry->has_angles() && i >= entry->first_angle;
            own.emplace_back(!is_angle ? "-" : part.attitude->unit == AngleUnit::degrees ? "deg" : "rad");
        }
    }
    own.resize(result_columns(options, layout).size(), "-");
    for (std::string& unit : own) {
        unit = has_brackets ? fmt::format("[{}]", unit) : unit;
    }
    write_columns(to, layout, units, own);
}

void write_added_header(Buffer& to, const Options& options, const Layout& layout) {
    std::string indices;
    for (std::size_t i = 0; i < layout.field_count; ++i) {
        if (i > 0) {
            indices += layout.delimiter.text();
        }
        indices += std::to_string(i + 1);
    }
    write_header(to, options, layout, HeaderLine({indices, layout.line_end}, layout.delimiter));
}

void RowWriter::add_open_ends(const ResultPart& part, std::size_t first) {
    const auto ends_of = part.attitude ? codec_of(part.attitude->name).open_ends : nullptr;
    if (ends_of == nullptr) {
        return;
    }
    const auto& [numbers, end, other] = ends_of(*part.attitude);
    const Digits digits = options_->digits;
    const int whole_digits = std::abs(end) < 10.0 ? 1 : 3; // of radians or degrees
    const int decimals = digits.decimals >= 0 ? digits.decimals : digits.significant - whole_digits;
    double half_a_digit = -1.0; // one digit does not show the end
    if (whole_digits + decimals > 1) {
        static_cast<void>(read_number(fmt::format("5e{}", -decimals - 1), half_a_digit)); // the nearest double
    }
    for (const std::size_t number : numbers) {
        open_ends_.push_back({first + number, end, half_a_digit, number_text(end, digits), number_text(other, digits)});
    }
}

RowWriter::RowWriter(const Options& options, const Layout& layout)
    : options_(&options), layout_(&layout),
      is_plain_((options.format == Format::csv || options.format == Format::f64) && !options.diagnostic_columns &&
                !options.pairing && (options.input.width == 0 || !layout.has_other_fields())) {
    std::size_t first = 0;
    for (const ResultPart& part : options.operation->parts) {
        if (!options.digits.shortest() && !options.operation->is_continuous()) {
            add_open_ends(part, first);
        }
        first += part.names.size();
    }
    for (const std::string& key : result_keys(options, layout, layout.delimiter)) {
        json_keys_.push_back(fmt::format(", {}: ", key));
        size_of_json_keys_ += json_keys_.back().size();
    }
}

void RowWriter::write(Buffer& to, const ConvertedRow& row) const {
    switch (options_->format) {
    case Format::csv: write_csv(to, row); break;
    case Format::json: write_json(to, row); break;
    case Format::pretty: write_pretty(to, row); break;
    case Format::f64: write_f64(to, row); break;
    }
}

void RowWriter::write(Buffer& to, std::span<const Row> rows, std::span<const double> results) const {
    const Layout& layout = *layout_; // this and copies in the function below save 4 % of this loop
    const char delimiter = layout.delimiter.text();
    const Digits digits = options_->digits;
    const std::size_t width = options_->operation->width();
    if (options_->format == Format::f64) {
        append_bytes(to, results.subspan(rows.front().index * width, rows.size() * width));
        return;
    }
    const std::size_t room = room_for(width, digits);
    for (const Row& row : rows) {
        const auto result = results.subspan(row.index * width, width);
        write_around(to, layout, row.line, row.numbers, room,
                     [=](char* at) { return write_numbers(at, result, delimiter, digits); });
    }
}

void RowWriter::write_number(Buffer& to, double value, std::size_t column) const {
    const std::size_t start = to.size();
    append_number(to, value, options_->digits);
    for (const auto& [number, end, half_a_digit, text, other] : open_ends_) {
        if (column == number && std::abs(value - end) <= half_a_digit &&
            std::string_view(to.data() + start, to.size() - start) == text) {
            to.resize(start);
            append(to, other);
        }
    }
}

bool RowWriter::is_near_open_end(std::span<const double> result) const noexcept {
    return std::ranges::any_of(open_ends_, [result](const OpenEnd& each) {
        return std::abs(result[each.number] - each.end) <= each.half_a_digit;
    });
}

void RowWriter::write_csv(Buffer& to, const ConvertedRow& row) const {
    const char delimiter = layout_->delimiter.text();
    write_fields(to, *layout_, row.line.text, row.fields, delimiter, [&](const auto& begin_field) {
        const bool one_by_one = is_near_open_end(row.result);
        if (!one_by_one) {
            begin_field();
            append_numbers(to, row.result, delimiter, options_->digits);
        }
        for (std::size_t i = 0; i < row.result.size() && one_by_one; ++i) {
            begin_field();
            write_number(to, row.result[i], i);
        }
        if (options_->diagnostic_columns) {
            begin_field();
            append_numbers(to, figures_of(row), delimiter, options_->digits);
            begin_field();
            const std::string notes = notes_of(row);
            append(to, notes.empty() && layout_->delimiter.is_blanks() ? "-" : notes);
        }
        append(to, row.partner);
    });
    append(to, row.line.end.empty() ? std::string_view(layout_->line_end) : row.line.end);
}

void RowWriter::write_json_number(Buffer& to, double number, std::size_t column) const {
    if (std::isfinite(number)) {
        write_number(to, number, column);
    } else {
        append(to, std::isnan(number) ? "null" : number > 0 ? "\"inf\"" : "\"-inf\"");
    }
}

void RowWriter::write_json(Buffer& to, const ConvertedRow& row) const {
    to.push_back('{');
    const auto other = [&](std::size_t i) {
        begin_member(to);
        layout_->keys.append_to(to, i, row.fields.size());
        append(to, ": ");
        const std::string_view text = trimmed(row.fields[i]);
        is_json_number(text) ? append(to, text) : append_json_string(to, layout_->delimiter.unquoted(row.fields[i]));
    };
    for_each_output(*layout_, row.fields.size(), other, [] {});
    if (options_->block) {
        write_json_parts(to, row.result);
    } else {
        write_json_members(to, row.result);
    }
    if (options_->diagnostic_columns) {
        auto next_key = json_keys_.begin() + static_cast<std::ptrdiff_t>(row.result.size());
        for (const double figure : figures_of(row)) {
            append(to, *next_key++);
            write_json_number(to, figure, row.result.size());
        }
        append(to, *next_key);
        append_json_string(to, notes_of(row));
    }
    append(to, "}\n");
}

void RowWriter::write_json_members(Buffer& to, std::span<const double> numbers) const {
    const std::size_t start = to.size();
    const std::size_t comma = to[start - 1] == '{' ? 2 : 0; // that the first key does not need
    if (is_near_open_end(numbers) || !std::ranges::all_of(numbers, [](double each) { return std::isfinite(each); })) {
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            append(to, std::string_view(json_keys_[i]).substr(i == 0 ? comma : 0));
            write_json_number(to, numbers[i], i);
        }
        return;
    }
    // The numbers all at once, which is quicker, behind the place where they are copied to.
    const std::size_t room = size_of_json_keys_ + room_for(numbers.size(), options_->digits);
    to.reserve(start + 2 * room);
    char* at = to.data() + start;
    char* const texts = at + room;
    std::string_view rest(texts, write_numbers(texts, numbers, '\n', options_->digits));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::string_view text = rest.substr(0, rest.find('\n'));
        at = std::ranges::copy(std::string_view(json_keys_[i]).substr(i == 0 ? comma : 0), at).out;
        at = std::ranges::copy(text, at).out;
        rest.remove_prefix(std::min(text.size() + 1, rest.size()));
    }
    to.resize(static_cast<std::size_t>(at - to.data()));
}

void RowWriter::write_json_parts(Buffer& to, std::span<const double> numbers) const {
    std::size_t column = 0;
    for (const ResultPart& part : options_->operation->parts) {
        begin_member(to); // the numbers of a SPEC have one key
        append_json_string(to, part.attitude->text());
        append(to, ": [");
        for (std::size_t i = 0; i < part.names.size(); ++i) {
            append(to, i > 0 ? ", " : "");
            write_json_number(to, numbers[column], column);
            ++column;
        }
        append(to, "]");
    }
}

void RowWriter::write_attitude(Buffer& to, const Spec& spec, std::span<const std::string> texts, std::string_view label,
                               std::size_t label_width, std::string_view names) {
    const auto out = std::back_inserter(to);
    const bool is_matrix = spec.name == RepresentationId::dcm;
    std::array<std::string_view, 9> in_rows;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        in_rows.at(is_matrix ? spec.order().at(i) : i) = texts[i];
    }
    const std::size_t width = is_matrix ? std::ranges::max(texts, {}, &std::string::size).size() : 0;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (i == 0 || (is_matrix && i % 3 == 0)) {
            fmt::format_to(out, "{:<{}}", i == 0 ? label : "", label_width);
        }
        const bool ends_line = i + 1 == texts.size() || (is_matrix && i % 3 == 2);
        const bool is_named = !names.empty() && ends_line && (!is_matrix || i == 2);
        fmt::format_to(out, "  {:>{}}{}{}{}", in_rows.at(i), width, is_named ? "   " : "", is_named ? names : "",
                       ends_line ? "\n" : "");
    }
}

void RowWriter::write_pretty(Buffer& to, const ConvertedRow& row) const {
    const auto out = std::back_inserter(to);
    const std::vector<ResultPart>& parts = options_->operation->parts;
    if (!options_->block) {
        fmt::format_to(out, "line {}\n", row.number);
    }
    std::vector<std::string> labels(parts.size());
    for (std::size_t k = 0; k < parts.size() && parts.size() > 1; ++k) {
        labels[k] = (options_->block ? "" : "  ") + label_of(*parts[k].attitude);
    }
    const std::size_t longest = std::ranges::max(labels, {}, &std::string::size).size();
    std::size_t column = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const auto& names = layout_->kept_names.empty() ? parts[k].names : layout_->kept_names;
        std::vector<std::string> texts;
        for (std::size_t i = 0; i < names.size(); ++i, ++column) {
            Buffer text;
            write_number(text, row.result[column], column);
            texts.push_back(fmt::to_string(text));
        }
        const std::optional<Spec>& spec = parts[k].attitude;
        if (parts.size() > 1 || (spec && spec->name == RepresentationId::dcm)) {
            write_attitude(to, *spec, texts, labels[k], longest, options_->block ? names_for_people(*spec) : "");
            continue;
        }
        for (std::size_t i = 0; i < names.size(); ++i) {
            fmt::format_to(out, "  {:<9}  {}\n", names[i], texts[i]);
        }
    }
    if (options_->diagnostic_columns) {
        const auto figures = figures_of(row);
        for (std::size_t i = 0; i < figures.size(); ++i) {
            fmt::format_to(out, "  {:<9}  {}\n", diagnostic_names[i], number_text(figures[i], options_->digits));
        }
    }
    if (row.failed) {
        append(to, "  error\n");
    } else if (options_->show_diagnostics) {
        for_each_diagnostic(*row.report, row.number, [&](const Diagnostic& diagnostic) {
            fmt::format_to(out, "{}{}\n", options_->block ? "" : "  ", options_->describe(diagnostic));
        });
    }
    append(to, options_->block.value_or("\n"));
}

void RowWriter::write_f64(Buffer& to, const ConvertedRow& row) const {
    const auto result = [&] {
        append_bytes(to, row.result);
        if (options_->diagnostic_columns) {
            append_bytes(to, figures_of(row));
        }
    };
    if (options_->input.width == 0) { // other fields are text, and are left out
        result();
    } else {
        for_each_output(
            *layout_, row.fields.size(), [&](std::size_t i) { append(to, row.fields[i]); }, result);
    }
}

} // namespace rotconv::stream
