#include "row_transformer.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace rotconv::stream {
namespace {

/// Adds the diagnostics of the row's result, those of a row and of its partner separately.
/// @param operation outlives the events
void add_diagnostics(std::vector<Event>& events, std::size_t line, const Pair& pair, const RowReport& report,
                     const RowOperation& operation) {
    for_each_diagnostic(report, line, [&](Diagnostic diagnostic) {
        diagnostic.unit = diagnostic.kind == DiagnosticKind::beyond ? operation.unit : "";
        const std::array<std::pair<const UnusualNumbers*, Place>, 3> attitudes{
            {{&report.references[0].unusual, {pair.partner.number, Side::reference}},
             {&report.references[1].unusual, {pair.later.number, Side::reference}},
             {&report.unusual, {line}}}};
        bool is_told = false;
        for (const auto& [unusual, place] : attitudes) {
            if (const double figure = unusual->figure_of(diagnostic.kind); pair.partner.number > 0 && figure > 0.0) {
                events.emplace_back(Diagnostic{.place = place, .kind = diagnostic.kind, .figure = figure});
                is_told = true;
            }
        }
        if (!is_told) {
            events.emplace_back(diagnostic);
        }
    });
}

} // namespace

RowTransformer::RowTransformer(const Options& options, const Layout& layout, const Layout* reference_layout)
    : options_(&options), layout_(&layout),
      operation_(options.operation->in_order ? options.operation : std::make_shared<RowOperation>(*options.operation)),
      width_(operation_->width()), readers_{RowReader(options.input, layout)}, writer_(options, layout),
      are_doubles_alone_(options.input.width > 0 && options.format == Format::f64 && writer_.writes_results_alone() &&
                         !writer_.has_open_ends() && !options.fold && options.writes_rows),
      no_partner_(options.writes_partners() ? fmt::format("{0}nan{0}nan{0}nan", layout.delimiter.text()) : ""),
      nans_(width_, std::numeric_limits<double>::quiet_NaN()) {
    if (reference_layout != nullptr) {
        readers_.emplace_back(options.pairing->reference, *reference_layout);
    }
}

void RowTransformer::transform(ReadRows& pairs, Output& output, const Ordered& ordered) {
    std::swap(read_, pairs);
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
            gather_numbers(text, line, limit);
        } else {
            gather(text, line, limit, limit == every_row ? text.size() : most_waiting);
        }
        const bool is_whole = text.empty();
        const bool at_error = options_->on_error == OnError::stop && !read_.errors.empty();
        std::size_t answered = answer(at_error || (is_end && is_whole), output, ordered);
        if (answered == 0 && all.size() - text.size() >= most_waiting) {
            answered = answer(true, output, ordered);
        }
        if (answered < read_.lines.size()) {
            line = read_.lines[answered];
            const auto first = std::ranges::find(read_.rows, line, &Row::number); // of those left to a later batch
            text = all.substr(static_cast<std::size_t>(first->line.text.data() - all.data()));
            read_.rows.erase(first, read_.rows.end());
        }
        finish_batch(all, output);
        if (is_whole) {
            waiting_ = text;
            waiting_line_ = line;
            return;
        }
        limit = answered == 0 && read_.rows.empty() ? 2 * limit : rows_at_once();
    }
}

void RowTransformer::gather(std::string_view& text, std::size_t& line, std::size_t most_rows, std::size_t most_bytes) {
    read_.clear();
    const std::size_t size = text.size();
    while (!text.empty() && read_.rows.size() < most_rows && size - text.size() < most_bytes) {
        Row& row = read_.rows.emplace_back(Line(), line++);
        row.index = read_.lines.size();
        if (readers_[0].take(text, row, read_)) {
            read_.lines.push_back(row.number);
        } else if (!row.passes) {
            read_.kept.resize(read_.lines.size() * options_->input.numbers.kept);
            read_.error.place = {row.number};
            read_.fail(std::exchange(read_.error, {}));
            if (options_->on_error == OnError::stop) {
                return;
            }
        }
    }
}

void RowTransformer::gather_numbers(std::string_view& doubles, std::size_t& line, std::size_t most_rows) {
    read_.clear();
    read_.lines.resize(std::min(most_rows, doubles.size() / (layout_->count * sizeof(double))));
    std::iota(read_.lines.begin(), read_.lines.end(), line);
    line += read_.lines.size();
    read_.numbers.resize(read_.lines.size() * layout_->count);
    const std::size_t size = read_.numbers.size() * sizeof(double);
    std::memcpy(read_.numbers.data(), doubles.data(), size);
    doubles.remove_prefix(size);
}

void RowTransformer::add_rows(std::string_view doubles) {
    for (const std::size_t number : read_.lines) {
        Row& row = read_.rows.emplace_back(next_row(doubles, options_->input.width), number);
        row.numbers = row.line.text;
        row.index = read_.rows.size() - 1;
    }
}

std::size_t RowTransformer::answer(bool flush, Output& output, const Ordered& ordered) {
    results_.resize(read_.lines.size() * width_);
    read_.are_last = flush;
    return operation_->run(read_, results_, reports_, [&](const auto& what) {
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
        output.rows += read_.lines.size();
        output.answered += read_.lines.size();
        return;
    }
    if (are_doubles_alone_) {
        add_rows(text);
    }
    write(output);
    if (options_->fold && !read_.lines.empty()) { // operations with a fold answer all rows at once
        output.batches.push_back({std::exchange(static_cast<NumberRows&>(read_), NumberRows()),
                                  std::exchange(results_, Numbers()), std::exchange(reports_, {})});
    }
}

void RowTransformer::write(Output& output) {
    next_report_ = 0;
    auto& rows = read_.rows;
    const bool is_clean = rows.size() == read_.lines.size() && reports_.empty();
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
        split(row);
    }
    const Pair& pair = pair_of(row);
    const RowReport& report = report_of(row);
    const bool failed = !row.has_numbers() || report.error != Error::none;
    if (failed) {
        const RowError error = error_of(row, report, given);
        if (error.what == RowError::What::no_partner && !options_->pairing->needs_partner) {
            output.unpaired[0].add({1, row.number});
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
                                     .fields = std::span(read_.fields).subspan(row.first_field, row.field_count),
                                     .result = failed ? std::span<const double>(nans_)
                                                      : std::span(results_).subspan(row.index * width_, width_),
                                     .report = &report,
                                     .failed = failed,
                                     .partner = pair.fields.empty() ? std::string_view(no_partner_) : pair.fields});
    }
    if (!failed) {
        ++output.answered;
        add_diagnostics(output.events, row.number, pair, report, *options_->operation);
    }
}

const RowReport& RowTransformer::report_of(const Row& row) noexcept {
    static constexpr RowReport nothing{};
    return is_reported(row) ? reports_[next_report_++] : nothing;
}

const Pair& RowTransformer::pair_of(const Row& row) const noexcept {
    static const Pair none;
    return read_.pairs.empty() ? none : read_.pairs[static_cast<std::size_t>(&row - read_.rows.data())];
}

RowError RowTransformer::error_of(const Row& row, const RowReport& report, std::string_view given) const {
    if (row.error != nullptr) {
        return *row.error;
    }
    if (options_->pairing && report.error == Error::past_half_turn) { // between neighbours half a turn apart
        return {.place = {row.number},
                .what = RowError::What::no_partner,
                .text = std::string(given),
                .error = report.error};
    }
    const Pair& pair = pair_of(row);
    const bool is_partner = report.at_fault > 0 && pair.partner.number > 0;
    const bool is_second = report.at_fault > 0 && !options_->pairing; // of the attitudes of a row
    const Partner& at = report.at_fault == 2 ? pair.later : pair.partner;
    const Side side = is_partner ? Side::reference : Side::stream;
    const std::string_view text = is_partner ? at.text : given;
    return {.place = {row.number},
            .cause = {is_partner ? at.number : 0, Side::reference},
            .what = RowError::What::attitude,
            .text = readers_[index_of(side)].selected_text(text),
            .error = report.error,
            .defect = report.defect,
            .norm = report.error == Error::defect && !is_second ? norm_of(side, text) : 0.0};
}

double RowTransformer::norm_of(Side side, std::string_view row) const {
    const RowNumbers& read = (side == Side::stream ? options_->input : options_->pairing->reference).numbers;
    if (!read.attitude || read.attitude->name != RepresentationId::quat) {
        return 0.0;
    }
    Row again;
    ReadRows parts;
    static_cast<void>(readers_[index_of(side)].take(row, again, parts));
    const auto q = std::span<const double>(parts.numbers).first(4);
    const double largest = std::abs(std::ranges::max(q, {}, [](double number) { return std::abs(number); }));
    double squares = 0.0; // scaled, so that they neither overflow nor underflow
    for (const double number : q) {
        squares += (number / largest) * (number / largest);
    }
    return largest * std::sqrt(squares);
}

void RowTransformer::split(Row& row) {
    const std::size_t width = options_->input.width;
    auto& fields = read_.fields;
    if (row.field_count > 0) {
        return;
    }
    row.first_field = fields.size();
    if (width > 0 && options_->format == Format::f64) {
        for (std::size_t i = 0; i < width; ++i) {
            fields.push_back(row.line.text.substr(i * sizeof(double), sizeof(double)));
        }
    } else {
        if (width > 0) {
            std::vector<double> numbers(width);
            std::memcpy(numbers.data(), row.line.text.data(), row.line.text.size());
            made_.clear();
            append_numbers(made_, numbers, layout_->delimiter.text(), {});
            row.line.text = {made_.data(), made_.size()};
        }
        static_cast<void>(layout_->delimiter.split(row.line.text, fields));
    }
    row.field_count = fields.size() - row.first_field;
}

} // namespace rotconv::stream
