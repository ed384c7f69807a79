#include "row_transformer.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "row_events.hpp"

namespace rotconv::stream {

RowTransformer::RowTransformer(const Options& options, const Layout& layout, const Layout* reference_layout)
    : options_(&options), layout_(&layout),
      operation_(options.operation->in_order ? options.operation : std::make_shared<RowOperation>(*options.operation)),
      width_(operation_->width()), gathered_(options, layout, reference_layout), writer_(options, layout),
      are_doubles_alone_(options.input.width > 0 && options.format == Format::f64 && writer_.writes_results_alone() &&
                         !writer_.has_open_ends() && !options.fold && options.writes_rows),
      nans_(width_, std::numeric_limits<double>::quiet_NaN()) {}

void RowTransformer::transform(ReadRows& pairs, Output& output, const Ordered& ordered) {
    gathered_.take(pairs);
    answer(true, output, ordered);
    finish_batch({}, output);
}

void RowTransformer::finish(Output& output) { transform({}, waiting_line_, output, {}, true); }

void RowTransformer::transform(std::string_view text, std::size_t line, Output& output, const Ordered& ordered,
                               bool is_end) {
    std::string joined;
    if (!waiting_.empty()) {
        joined = std::exchange(waiting_, {}).append(text);
        text = joined;
        line = waiting_line_;
    }
    for (std::size_t limit = rows_at_once(); !text.empty() && !output.stopped;) {
        const std::string_view all = text;
        if (are_doubles_alone_) {
            gathered_.gather_numbers(text, line, limit);
        } else {
            gathered_.gather(text, line, limit, limit == every_row ? text.size() : most_waiting);
        }
        const bool is_whole = text.empty();
        const bool at_error = options_->on_error == OnError::stop && gathered_.has_error();
        std::size_t answered = answer(at_error || (is_end && is_whole), output, ordered);
        if (answered == 0 && all.size() - text.size() >= most_waiting) {
            answered = answer(true, output, ordered);
        }
        if (answered < gathered_.count()) {
            line = gathered_.numbers().lines[answered];
            text = all.substr(static_cast<std::size_t>(gathered_.drop_from(answered) - all.data()));
        }
        finish_batch(all, output);
        if (is_whole) {
            waiting_ = text;
            waiting_line_ = line;
            return;
        }
        limit = answered == 0 && gathered_.rows().empty() ? 2 * limit : rows_at_once();
    }
}

std::size_t RowTransformer::answer(bool flush, Output& output, const Ordered& ordered) {
    results_.resize(gathered_.count() * width_);
    NumberRows rows = gathered_.numbers();
    rows.are_last = flush;
    return operation_->run(rows, results_, reports_, [&](const auto& what) {
        if (!ordered || operation_->in_order) { // with in_order there is one thread
            what();
        } else {
            output.stopped = !ordered(what);
        }
        return !output.stopped;
    });
}

void RowTransformer::finish_batch(std::string_view text, Output& output) {
    if (are_doubles_alone_ && reports_.empty() && !output.stopped) {
        append_bytes(output.bytes, results_);
        output.rows += gathered_.count();
        output.answered += gathered_.count();
        return;
    }
    if (are_doubles_alone_) {
        gathered_.add_rows(text);
    }
    write(output);
    if (options_->fold && gathered_.count() > 0) { // operations with a fold answer all rows at once
        output.batches.push_back(
            {std::exchange(gathered_.held(), HeldRows()), std::exchange(results_, {}), std::exchange(reports_, {})});
    }
}

void RowTransformer::write(Output& output) {
    next_report_ = 0;
    auto& rows = gathered_.rows();
    const bool is_clean = rows.size() == gathered_.count() && reports_.empty();
    if (is_clean && !options_->writes_rows) {
        output.rows += rows.size();
        output.answered += rows.size();
        return;
    }
    const bool has_open_ends = writer_.has_open_ends();
    const auto stands_alone = [&](const Row& row) {
        return row.is_scanned() && !is_reported(row) &&
               !(has_open_ends && writer_.is_near_open_end(std::span(results_).subspan(row.index * width_, width_)));
    };
    for (auto row = rows.begin(); row != rows.end() && !output.stopped;) {
        const bool may_stand_alone = options_->writes_rows && writer_.writes_results_alone();
        const auto end = may_stand_alone ? std::find_if_not(row, rows.end(), stands_alone) : row;
        if (end != row) {
            writer_.write(output.bytes, {row, end}, results_);
            output.rows += static_cast<std::size_t>(end - row);
            output.answered += static_cast<std::size_t>(end - row);
            row = end;
            continue;
        }
        if (!row->passes) {
            write_row(*row, output);
        } else if (options_->writes_all_lines()) {
            append(output.bytes, row->line.text);
            append(output.bytes, row->line.end);
        }
        ++row;
    }
}

void RowTransformer::write_row(Row& row, Output& output) {
    const std::string_view given = row.line.text; // a binary row becomes text
    const bool is_ours = row.number > 0;          // otherwise it is only an error of the reference
    output.rows += is_ours ? 1 : 0;
    if (is_ours && options_->writes_rows && layout_->has_other_fields()) {
        gathered_.split(row);
    }
    if (options_->writes_partners()) {
        write_partner(gathered_.pair_of(row));
    }
    const RowReport& report = report_of(row);
    const bool failed = !row.has_numbers() || report.error != Error::none;
    if (failed) {
        const RowError error = gathered_.error_of(row, report, given);
        if (error.what == RowError::What::no_partner && !options_->pairing->needs_partner) {
            output.unpaired.add({1, row.number});
            return;
        }
        output.events.emplace_back(error);
        output.stopped = options_->on_error == OnError::stop || error.key == KeyError::has_unit;
        if (output.stopped || options_->on_error != OnError::nan || !is_ours) {
            return;
        }
    }
    if (options_->writes_rows) {
        writer_.write(output.bytes, {.line = row.line,
                                     .number = row.number,
                                     .fields = gathered_.fields_of(row),
                                     .result = failed ? std::span<const double>(nans_)
                                                      : std::span(results_).subspan(row.index * width_, width_),
                                     .report = &report,
                                     .failed = failed,
                                     .partner = partner_});
    }
    if (!failed) {
        ++output.answered;
        add_diagnostics(output.events, row.number, gathered_.pair_of(row), report, *options_->operation);
    }
}

void RowTransformer::write_partner(const Pair& pair) {
    const char delimiter = layout_->delimiter.text();
    if (pair.partner.number == 0) { // a row without a key
        partner_ = fmt::format("{0}nan{0}nan{0}nan", delimiter);
        return;
    }
    partner_ = fmt::format("{0}{1}{0}{2}{0}{3}{4}", delimiter, pair.partner.number, pair.partner_text,
                           pair.key < pair.partner_key ? "-" : "", distance(pair.key, pair.partner_key).text());
}

const RowReport& RowTransformer::report_of(const Row& row) noexcept {
    static constexpr RowReport nothing{};
    return is_reported(row) ? reports_[next_report_++] : nothing;
}

} // namespace rotconv::stream
