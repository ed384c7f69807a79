#include "rows.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace rotconv::stream {

RowTransformer::RowTransformer(const Options& options, const Layout& layout)
    : options_(&options), layout_(&layout), row_text_(options, layout) {}

void RowTransformer::transform(std::string_view text, std::size_t line, Output& output) {
    while (!text.empty() && !output.stopped) {
        gather(text, line);
        results_.resize(reports_.size() * options_->conversion.to().size());
        options_->conversion.run(numbers_, results_, reports_);
        write(output);
    }
}

void RowTransformer::gather(std::string_view& text, std::size_t& line) {
    rows_.clear();
    fields_.clear();
    faults_.clear();
    numbers_.clear();
    while (!text.empty() && rows_.size() < batch) {
        const Line current = next_line(text);
        Row row{current, line++, is_blank(current.text) || is_comment(current.text), fields_.size(), 0, no_fault};
        if (!row.passed) {
            read_row(row);
        }
        rows_.push_back(row);
    }
    reports_.resize(numbers_.size() / options_->conversion.from().size());
}

void RowTransformer::read_row(Row& row) {
    using What = RowFault::What;
    const std::size_t needed = options_->conversion.from().size();
    const std::size_t first_number = numbers_.size();
    numbers_.resize(first_number + needed); // zeros where the row fails: the conversion runs over all rows of the batch
    const bool closed = layout_->delimiter.split(row.line.text, fields_);
    row.field_count = fields_.size() - row.first_field;
    if (!closed) {
        note_fault(row, {.what = What::open_quote, .text = std::string(row.line.text)});
        return;
    }
    if (layout_->positions.empty() && row.field_count != needed) {
        note_fault(row, {.what = What::wrong_count,
                         .text = std::string(row.line.text),
                         .found = row.field_count,
                         .expected = needed});
        return;
    }
    if (!layout_->positions.empty() && layout_->in_row_order.back() >= row.field_count) {
        const auto missing = std::ranges::lower_bound(layout_->in_row_order, row.field_count);
        note_fault(row, {.what = What::missing_column,
                         .text = std::string(row.line.text),
                         .found = row.field_count,
                         .expected = *missing + 1});
        return;
    }
    for (std::size_t i = 0; i < needed; ++i) {
        const std::size_t position = layout_->positions.empty() ? i : layout_->positions[i];
        const std::string_view field = fields_[row.first_field + position];
        const NumberFault fault = read_number(field_text(field), numbers_[first_number + i]);
        if (fault != NumberFault::none) {
            note_fault(row, {.what = fault == NumberFault::too_large ? What::too_large : What::not_a_number,
                             .text = std::string(field)});
            return;
        }
    }
}

void RowTransformer::note_fault(Row& row, RowFault fault) {
    fault.line = row.number;
    row.fault = faults_.size();
    faults_.push_back(std::move(fault));
}

void RowTransformer::write(Output& output) {
    std::size_t index = 0; // among the rows with numbers
    for (const Row& row : rows_) {
        if (row.passed) {
            if (options_->format == Format::csv) {
                append(output.bytes, row.line.text);
                append(output.bytes, row.line.end);
            }
            continue;
        }
        write_row(row, index++, output);
        if (output.stopped) {
            return;
        }
    }
}

void RowTransformer::write_row(const Row& row, std::size_t index, Output& output) {
    const std::size_t size = options_->conversion.to().size();
    const Report& report = reports_[index];
    ConvertedRow converted{.line = row.line,
                           .number = row.number,
                           .fields = std::span(fields_).subspan(row.first_field, row.field_count),
                           .result = std::span(results_).subspan(index * size, size),
                           .report = &report,
                           .failed = row.fault != no_fault || report.fault != Fault::none};
    if (!converted.failed) {
        row_text_.write(output.bytes, converted);
        for_each_diagnostic(report, row.number,
                            [&](const Diagnostic& diagnostic) { output.events.emplace_back(diagnostic); });
        return;
    }
    if (row.fault != no_fault) {
        output.events.emplace_back(faults_[row.fault]);
    } else {
        output.events.emplace_back(RowFault{.line = row.number,
                                            .what = RowFault::What::attitude,
                                            .text = selected_text(row),
                                            .fault = report.fault,
                                            .defect = report.defect});
    }
    if (options_->on_error == OnError::stop) {
        output.stopped = true;
    } else if (options_->on_error == OnError::nan) {
        std::fill_n(results_.begin() + static_cast<std::ptrdiff_t>(index * size), size,
                    std::numeric_limits<double>::quiet_NaN());
        row_text_.write(output.bytes, converted);
    }
}

std::string RowTransformer::selected_text(const Row& row) const {
    if (layout_->positions.empty()) {
        return std::string(row.line.text);
    }
    std::string text;
    for (const std::size_t position : layout_->positions) {
        if (!text.empty()) {
            text += layout_->delimiter.text();
        }
        text += fields_[row.first_field + position];
    }
    return text;
}

} // namespace rotconv::stream
