#include "row_transformer.hpp"

#include <algorithm>
#include <utility>

// What RowTransformer does with rows whose answers depend on the rows after them.

namespace rotconv::stream {

void RowTransformer::transform_ahead(std::string_view next, std::size_t next_line, bool is_end, Output& output) {
    std::size_t line = waiting_.empty() ? next_line : waiting_line_;
    const std::string joined = std::exchange(waiting_, {}).append(next);
    std::string_view text = joined;
    std::size_t limit = batch_rows;
    while (!text.empty() && !output.stopped) {
        const std::string_view all = text;
        gather(text, line, limit);
        const bool is_whole = text.empty();
        const bool at_error = options_->on_error == OnError::stop && !errors_.empty();
        results_.resize(lines_.size() * operation_->names.size());
        const NumberRows rows{parts_.numbers, lines_, parts_.kept};
        std::size_t answered = operation_->run_ahead(rows, at_error || (is_end && is_whole), results_, reports_);
        if (answered == 0 && all.size() - text.size() >= most_waiting) {
            answered = operation_->run_ahead(rows, true, results_, reports_);
        }
        if (operation_->chooses) { // such rows are for one thread
            operation_->choose(std::span(results_).first(answered * operation_->names.size()), reports_);
        }
        const auto held = std::ranges::find_if(
            rows_, [answered](const Row& row) { return row.has_numbers() && row.index == answered; });
        if (held != rows_.end()) {
            line = held->number;
            text = all.substr(static_cast<std::size_t>(held->line.text.data() - all.data()));
            rows_.erase(held, rows_.end());
        }
        write(output);
        if (is_whole) {
            waiting_ = text;
            waiting_line_ = line;
            return;
        }
        limit = rows_.empty() ? 2 * limit : batch_rows;
    }
}

} // namespace rotconv::stream
