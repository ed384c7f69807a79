#include "row_writer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <variant>

#include "json.hpp"
#include "row_events.hpp"

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
            std::max(row.report->defect, row.report->reference_defect)};
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
    to.reserve(size + before.size() + 1 + room + after.size());
    char* at = std::ranges::copy(before, to.data() + size).out;
    if (layout.appends) {
        *at++ = layout.delimiter.text();
    }
    at = write_result(at);
    at = std::ranges::copy(after, at).out;
    to.resize(static_cast<std::size_t>(at - to.data()));
    if (line.end.empty()) {
        append(to, layout.line_end);
    }
}

/// The name of the project that a SPEC is, otherwise its text.
std::string label_of(const Spec& spec) {
    const bool is_project = spec.project != nullptr && spec.project->is_spec() &&
                            std::get<Spec>(parse_spec(spec.project->text)).text() == spec.text();
    return is_project ? std::string(spec.project->text) : spec.text();
}

/// The columns of the result, its diagnostics and its partner, if they are written. Views into the arguments.
std::vector<std::string_view> result_columns(const Options& options, const Layout& layout) {
    const auto& names = layout.kept_names.empty() ? options.operation->names : layout.kept_names;
    std::vector<std::string_view> columns(names.begin(), names.end());
    if (options.diagnostic_columns) {
        columns.insert(columns.end(), diagnostic_names.begin(), diagnostic_names.end());
    }
    if (options.writes_partners()) {
        columns.insert(columns.end(), partner_names.begin(), partner_names.end());
    }
    return columns;
}

} // namespace

std::vector<std::string> result_keys(const Options& options, const Layout& layout, Delimiter delimiter) {
    std::vector<std::string> keys;
    for (const std::string_view column : result_columns(options, layout)) {
        keys.push_back(json_string(delimiter.unquoted(column)));
    }
    return keys;
}

void write_header(Buffer& to, const Options& options, const Layout& layout, const HeaderLine& header) {
    const char delimiter = header.delimiter.text();
    const auto write_names = [&](const auto& begin_field) {
        for (const std::string_view name : result_columns(options, layout)) {
            begin_field();
            append(to, name);
        }
    };
    append(to, layout.appends ? "" : header.prefix);
    write_fields(to, layout, header.line.text, header.fields, delimiter, write_names);
    append(to, header.line.end.empty() ? std::string_view("\n") : header.line.end);
}

void write_units(Buffer& to, const Options& options, const Layout& layout, const HeaderLine& units) {
    const char delimiter = units.delimiter.text();
    const bool has_brackets = units.line.text.find('[') != std::string_view::npos;
    std::vector<std::string_view> own;
    for (const Spec& spec : options.operation->attitudes) {
        const Representation& entry = representation(spec.name);
        for (std::size_t i = 0; i < spec.size(); ++i) {
            const bool is_angle = entry.has_angles() && i >= entry.first_angle;
            own.push_back(!is_angle ? "-" : spec.unit == AngleUnit::degrees ? "deg" : "rad");
        }
    }
    own.resize(result_columns(options, layout).size(), "-");
    const auto write_own = [&](const auto& begin_field) {
        for (const std::string_view unit : own) {
            begin_field();
            append(to, has_brackets ? fmt::format("[{}]", unit) : std::string(unit));
        }
    };
    append(to, layout.appends ? "" : units.prefix);
    write_fields(to, layout, units.line.text, units.fields, delimiter, write_own);
    append(to, units.line.end.empty() ? std::string_view("\n") : units.line.end);
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

RowWriter::RoundedEnd RowWriter::rounded(const OpenEnd& range) const {
    const Digits digits = options_->digits;
    const int whole_digits = std::abs(range.end) < 10.0 ? 1 : 3; // of radians or degrees
    const int decimals = digits.decimals >= 0 ? digits.decimals : digits.significant - whole_digits;
    double half_a_digit = -1.0; // one digit does not show the end
    if (whole_digits + decimals > 1) {
        static_cast<void>(read_number(fmt::format("5e{}", -decimals - 1), half_a_digit)); // the nearest double
    }
    return {range, half_a_digit, number_text(range.end, digits), number_text(range.other, digits)};
}

RowWriter::RowWriter(const Options& options, const Layout& layout)
    : options_(&options), layout_(&layout),
      is_plain_(options.format == Format::csv && !options.diagnostic_columns && !options.pairing) {
    if (!options.digits.shortest() && !options.operation->is_continuous) {
        std::ranges::transform(options.operation->open_ends, std::back_inserter(open_ends_),
                               [this](const OpenEnd& range) { return rounded(range); });
    }
    for (const std::string& key : result_keys(options, layout, layout.delimiter)) {
        json_keys_.push_back(key + ": ");
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
    const std::size_t width = options_->operation->names.size();
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
    for (const auto& [range, half_a_digit, text, other] : open_ends_) {
        if (column == range.number && std::abs(value - range.end) <= half_a_digit &&
            std::string_view(to.data() + start, to.size() - start) == text) {
            to.resize(start);
            append(to, other);
        }
    }
}

template <class WriteNumbers, class WriteText>
void RowWriter::for_each_column(const ConvertedRow& row, std::size_t first, const WriteNumbers& numbers,
                                const WriteText& text) const {
    numbers(row.result.subspan(first), first);
    if (options_->diagnostic_columns) {
        numbers(figures_of(row), row.result.size());
        text(notes_of(row));
    }
}

void RowWriter::write_csv(Buffer& to, const ConvertedRow& row) const {
    const char delimiter = layout_->delimiter.text();
    write_fields(to, *layout_, row.line.text, row.fields, delimiter, [&](const auto& begin_field) {
        const auto numbers = [&](std::span<const double> values, std::size_t first) {
            const bool are_figures = first == row.result.size();
            if ((open_ends_.empty() || are_figures) && !values.empty()) {
                begin_field();
                append_numbers(to, values, delimiter, options_->digits);
                return;
            }
            for (const double value : values) {
                begin_field();
                write_number(to, value, first++);
            }
        };
        const auto text = [&](std::string_view words) {
            begin_field();
            append(to, words.empty() && layout_->delimiter.is_blanks() ? "-" : words);
        };
        for_each_column(row, 0, numbers, text);
        append(to, row.partner);
    });
    append(to, row.line.end.empty() ? std::string_view(layout_->line_end) : row.line.end);
}

void RowWriter::write_json(Buffer& to, const ConvertedRow& row) const {
    to.push_back('{');
    auto next_key = json_keys_.begin(); // those of the result are not used in a block
    next_key += options_->block ? static_cast<std::ptrdiff_t>(row.result.size()) : 0;
    const auto begin_member = [&to] {
        if (to[to.size() - 1] != '{') {
            append(to, ", ");
        }
    };
    const auto key = [&] {
        begin_member();
        append(to, *next_key++);
    };
    const auto other = [&](std::size_t i) {
        begin_member();
        layout_->keys.append_to(to, i, row.fields.size());
        append(to, ": ");
        const std::string_view text = trimmed(row.fields[i]);
        if (is_json_number(text)) {
            append(to, text);
        } else {
            append_json_string(to, layout_->delimiter.unquoted(row.fields[i]));
        }
    };
    for_each_output(*layout_, row.fields.size(), other, [] {});
    const auto number = [&](double value, std::size_t column) {
        if (std::isfinite(value)) {
            write_number(to, value, column);
        } else {
            append(to, std::isnan(value) ? "null" : value > 0 ? "\"inf\"" : "\"-inf\"");
        }
    };
    std::size_t first = 0; // of a SPEC's numbers, which have one key with a block
    for (const Spec& spec : options_->block ? options_->operation->attitudes : std::vector<Spec>()) {
        begin_member();
        append_json_string(to, spec.text());
        append(to, ": [");
        for (std::size_t i = first; i < first + spec.size(); ++i) {
            append(to, i > first ? ", " : "");
            number(row.result[i], i);
        }
        append(to, "]");
        first += spec.size();
    }
    const auto numbers_with_keys = [&](std::span<const double> values, std::size_t column) {
        for (const double value : values) {
            key();
            number(value, column++);
        }
    };
    const auto text_with_key = [&](std::string_view text) {
        key();
        append_json_string(to, text);
    };
    for_each_column(row, first, numbers_with_keys, text_with_key);
    append(to, "}\n");
}

void RowWriter::write_attitudes(Buffer& to, std::span<const std::string> texts,
                                std::span<const std::string> labels) const {
    const auto out = std::back_inserter(to);
    const std::size_t longest = std::ranges::max(labels, {}, &std::string::size).size();
    for (std::size_t k = 0; k < labels.size(); ++k) {
        const Spec& spec = options_->operation->attitudes[k];
        const auto own = texts.first(spec.size());
        const bool is_matrix = spec.name == RepresentationId::dcm;
        std::array<std::string_view, 9> in_rows;
        for (std::size_t i = 0; i < own.size(); ++i) {
            in_rows.at(is_matrix ? spec.order().at(i) : i) = own[i];
        }
        const std::size_t width = is_matrix ? std::ranges::max(own, {}, &std::string::size).size() : 0;
        for (std::size_t i = 0; i < own.size(); ++i) {
            if (i == 0 || (is_matrix && i % 3 == 0)) {
                fmt::format_to(out, "{:<{}}", i == 0 ? labels[k] : "", longest);
            }
            fmt::format_to(out, "  {:>{}}{}", in_rows.at(i), width,
                           i + 1 == own.size() || (is_matrix && i % 3 == 2) ? "\n" : "");
        }
        texts = texts.subspan(own.size());
    }
}

void RowWriter::write_pretty(Buffer& to, const ConvertedRow& row) const {
    const auto out = std::back_inserter(to);
    const std::vector<Spec>& specs = options_->operation->attitudes;
    if (!options_->block) {
        fmt::format_to(out, "line {}\n", row.number);
    }
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < row.result.size(); ++i) {
        Buffer text;
        write_number(text, row.result[i], i);
        texts.push_back(fmt::to_string(text));
    }
    std::size_t labelled = 0; // the first number that is not yet written
    if (specs.size() > 1 || (specs.size() == 1 && specs[0].name == RepresentationId::dcm)) {
        std::vector<std::string> labels;
        for (const Spec& spec : specs) {
            labelled += spec.size();
            labels.push_back(specs.size() == 1 ? "" : (options_->block ? "" : "  ") + label_of(spec));
        }
        write_attitudes(to, texts, labels);
    }
    const auto& names = layout_->kept_names.empty() ? options_->operation->names : layout_->kept_names;
    for (std::size_t i = labelled; i < row.result.size(); ++i) {
        fmt::format_to(out, "  {:<9}  {}\n", names[i], texts[i]);
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
