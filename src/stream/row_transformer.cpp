#include "row_transformer.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

namespace rotconv::stream {

RowTransformer::RowTransformer(const Options& options, const Layout& layout)
    : options_(&options), layout_(&layout), operation_(options.operation), row_text_(options, layout),
      nans_(options.operation.names.size(), std::numeric_limits<double>::quiet_NaN()) {}

void RowTransformer::transform(std::string_view text, std::size_t line, Output& output) {
    if (is_doubles_alone()) {
        transform_doubles(text, line, output);
        return;
    }
    if (operation_.run_ahead) {
        transform_ahead(text, line, false, output);
        return;
    }
    while (!text.empty() && !output.stopped) {
        gather(text, line, batch);
        results_.resize(lines_.size() * operation_.names.size());
        operation_.run({numbers_, lines_, kept_}, results_, reports_);
        write(output);
    }
}

void RowTransformer::finish(Output& output) {
    if (operation_.run_ahead) {
        transform_ahead({}, 0, true, output);
    }
}

void RowTransformer::gather(std::string_view& text, std::size_t& line, std::size_t limit) {
    rows_.clear();
    fields_.clear();
    errors_.clear();
    numbers_.clear();
    lines_.clear();
    kept_.clear();
    if (options_->width > 0) {
        gather_binary(text, line, limit);
        return;
    }
    const char* const begin = text.data();
    while (!text.empty() && rows_.size() < limit && static_cast<std::size_t>(text.data() - begin) < most_waiting) {
        const Line current = next_line(text);
        Row row{.line = current,
                .number = line++,
                .passed = is_blank(current.text) || is_comment(current.text),
                .first_field = fields_.size()};
        if (!row.passed) {
            read_row(row);
        }
        rows_.push_back(row);
        if (row.error != no_error && options_->on_error == OnError::stop) {
            return;
        }
    }
}

void RowTransformer::read_row(Row& row) {
    using What = RowError::What;
    const std::size_t needed = operation_.inputs;
    const std::size_t first_number = numbers_.size();
    row.index = lines_.size();
    if (!has_other_fields() && read_plain(row.line.text)) {
        lines_.push_back(row.number);
        return;
    }
    const bool closed = layout_->delimiter.split(row.line.text, fields_);
    row.field_count = fields_.size() - row.first_field;
    if (!closed) {
        note_error(row, {.what = What::open_quote, .text = std::string(row.line.text)});
        return;
    }
    if (layout_->positions.empty() && row.field_count != needed) {
        note_error(row, {.what = What::wrong_count,
                         .text = std::string(row.line.text),
                         .found = row.field_count,
                         .expected = needed});
        return;
    }
    if (!layout_->positions.empty() && layout_->in_row_order.back() >= row.field_count) {
        const auto missing = std::ranges::lower_bound(layout_->in_row_order, row.field_count);
        note_error(row, {.what = What::missing_column,
                         .text = std::string(row.line.text),
                         .found = row.field_count,
                         .expected = *missing + 1});
        return;
    }
    for (std::size_t i = 0; i < needed; ++i) {
        const std::size_t position = layout_->positions.empty() ? i : layout_->positions[i];
        const std::string_view field = fields_[row.first_field + position];
        double& number = numbers_.emplace_back();
        NumberError error = read_number(field, number);
        if (error == NumberError::not_a_number) { // or quoted
            error = read_number(layout_->delimiter.text_of(field), number);
        }
        if (error != NumberError::none) {
            note_error(row, {.what = error == NumberError::too_large ? What::too_large : What::not_a_number,
                             .text = std::string(field)});
            numbers_.resize(first_number);
            return;
        }
    }
    for (std::size_t i = 0; i < operation_.kept; ++i) {
        const std::size_t position = layout_->positions.empty() ? i : layout_->positions[i];
        kept_.push_back(layout_->delimiter.text_of(fields_[row.first_field + position]));
    }
    lines_.push_back(row.number);
}

bool RowTransformer::read_plain(std::string_view text) {
    const std::size_t first = numbers_.size();
    numbers_.resize(first + operation_.inputs);
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t i = first; i < numbers_.size(); ++i) {
        const auto [stop, error] = std::from_chars(at, end, numbers_[i]);
        const bool is_last = i + 1 == numbers_.size();
        if (error != std::errc{} || (stop == end) != is_last || (!is_last && *stop != layout_->delimiter.text())) {
            numbers_.resize(first);
            return false;
        }
        at = is_last ? end : stop + 1;
    }
    return true;
}

void RowTransformer::note_error(Row& row, RowError error) {
    error.line = row.number;
    row.error = errors_.size();
    errors_.push_back(std::move(error));
}

void RowTransformer::write(Output& output) {
    next_report_ = 0;
    for (Row& row : rows_) {
        if (row.passed) {
            if (options_->format == Format::csv) {
                append(output.bytes, row.line.text);
                append(output.bytes, row.line.end);
            }
            continue;
        }
        write_row(row, output);
        if (output.stopped) {
            return;
        }
    }
}

void RowTransformer::write_row(Row& row, Output& output) {
    if (options_->width > 0 && has_other_fields()) {
        make_fields(row);
    }
    const std::size_t size = operation_.names.size();
    const Report& report = report_of(row);
    const bool failed = !row.has_numbers() || report.error != Error::none;
    const ConvertedRow converted{.line = row.line,
                                 .number = row.number,
                                 .fields = std::span(fields_).subspan(row.first_field, row.field_count),
                                 .result = failed ? std::span<const double>(nans_)
                                                  : std::span(results_).subspan(row.index * size, size),
                                 .report = &report,
                                 .failed = failed};
    if (!failed) {
        row_text_.write(output.bytes, converted);
        for_each_diagnostic(report, row.number,
                            [&](const Diagnostic& diagnostic) { output.events.emplace_back(diagnostic); });
        return;
    }
    if (!row.has_numbers()) {
        output.events.emplace_back(errors_[row.error]);
    } else {
        output.events.emplace_back(RowError{.line = row.number,
                                            .what = RowError::What::attitude,
                                            .text = selected_text(row),
                                            .error = report.error,
                                            .defect = report.defect});
    }
    if (options_->on_error == OnError::stop) {
        output.stopped = true;
    } else if (options_->on_error == OnError::nan) {
        row_text_.write(output.bytes, converted);
    }
}

const Report& RowTransformer::report_of(const Row& row) noexcept {
    static constexpr Report nothing{};
    const bool is_next = row.has_numbers() && next_report_ < reports_.size() && reports_[next_report_].row == row.index;
    return is_next ? reports_[next_report_++] : nothing;
}

std::string RowTransformer::selected_text(const Row& row) const {
    std::string text;
    const auto add = [&](std::string_view field) {
        if (!text.empty()) {
            text += layout_->delimiter.text();
        }
        text += field;
    };
    if (options_->width > 0) {
        for (const double number : std::span(numbers_).subspan(row.index * operation_.inputs, operation_.inputs)) {
            add(fmt::format("{}", number));
        }
        return text;
    }
    if (layout_->positions.empty()) {
        return std::string(row.line.text);
    }
    for (const std::size_t position : layout_->positions) {
        add(fields_[row.first_field + position]);
    }
    return text;
}

} // namespace rotconv::stream
