#include "row_transformer.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>

// What RowTransformer does with rows of doubles.

namespace rotconv::stream {

void RowTransformer::gather_binary(std::string_view& text, std::size_t& line, std::size_t limit) {
    const std::size_t row_size = options_->input.width * sizeof(double);
    const std::size_t count = std::min(limit, text.size() / row_size);
    for (std::size_t i = 0; i < count; ++i) {
        rows_.push_back({.line = {text.substr(i * row_size, row_size), {}}, .number = line++});
        read_row(rows_.back());
    }
    text.remove_prefix(count * row_size);
}

void RowTransformer::make_fields(Row& row) {
    const std::string_view bytes = row.line.text;
    parts_.fields.clear();
    row.first_field = 0;
    row.field_count = options_->input.width;
    if (options_->format == Format::f64) {
        for (std::size_t i = 0; i < options_->input.width; ++i) {
            parts_.fields.push_back(bytes.substr(i * sizeof(double), sizeof(double)));
        }
        return;
    }
    constexpr std::size_t room = 40; // of a number and the delimiter, so that nothing moves
    made_.clear();
    made_.reserve(room * (options_->input.width + 1));
    for (std::size_t i = 0; i < options_->input.width; ++i) {
        if (i > 0) {
            made_.push_back(layout_->delimiter.text());
        }
        double number = 0.0;
        std::memcpy(&number, bytes.data() + i * sizeof(double), sizeof(double));
        const std::size_t begin = made_.size();
        append_number(made_, number, {});
        parts_.fields.emplace_back(made_.data() + begin, made_.size() - begin);
    }
    row.line.text = {made_.data(), made_.size()};
}

bool RowTransformer::is_doubles_alone() const noexcept {
    return options_->input.width > 0 && options_->format == Format::f64 && !needs_fields() &&
           !options_->diagnostic_columns;
}

void RowTransformer::transform_doubles(std::string_view text, std::size_t line, Output& output, const InTurn& in_turn) {
    const std::size_t row_size = options_->input.width * sizeof(double);
    const std::size_t width = operation_->names.size();
    while (!text.empty() && !output.stopped) {
        const std::size_t rows = std::min(rows_at_once(), text.size() / row_size);
        parts_.numbers.resize(rows * layout_->count);
        std::memcpy(parts_.numbers.data(), text.data(), rows * row_size);
        lines_.resize(rows);
        std::iota(lines_.begin(), lines_.end(), line);
        results_.resize(rows * width);
        operation_->run({parts_.numbers, lines_}, results_, reports_);
        choose(output, in_turn);
        next_report_ = 0;
        std::size_t next = 0;
        const auto write_clean = [&](std::size_t end) {
            append_bytes(output.bytes, std::span(results_).subspan(next * width, (end - next) * width));
            output.answered += end - next;
            next = end;
        };
        while (next_report_ < reports_.size() && !output.stopped) {
            write_clean(reports_[next_report_].row);
            Row row{.line = {text.substr(next * row_size, row_size), {}}, .number = line + next, .index = next};
            write_row(row, output);
            ++next;
        }
        if (!output.stopped) {
            write_clean(rows);
        }
        text.remove_prefix(rows * row_size);
        line += rows;
    }
}

} // namespace rotconv::stream
