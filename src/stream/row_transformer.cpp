#include "row_transformer.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

namespace rotconv::stream {

RowTransformer::RowTransformer(const Options& options, const Layout& layout, const Layout* reference_layout)
    : options_(&options), layout_(&layout),
      operation_(options.operation->in_order ? options.operation : options.operation->copy()),
      reader_(options.input, layout), writer_(options, layout),
      nans_(options.operation->names.size(), std::numeric_limits<double>::quiet_NaN()) {
    if (reference_layout != nullptr) {
        reference_reader_.emplace(options.pairing->reference, *reference_layout);
    }
}

void RowTransformer::transform(std::string_view text, std::size_t line, Output& output, const InTurn& in_turn) {
    if (is_doubles_alone()) {
        transform_doubles(text, line, output, in_turn);
    } else {
        transform_all(text, line, false, output, in_turn);
    }
}

void RowTransformer::transform(const PairBlock& pairs, Output& output) {
    for (auto next = pairs.rows.begin(); next != pairs.rows.end() && !output.stopped;) {
        clear();
        for (; next != pairs.rows.end() && rows_.size() < batch_rows; ++next) {
            Row& row = rows_.emplace_back(*next);
            if (row.error != Row::no_error) {
                errors_.push_back(pairs.errors[row.error]);
                row.error = errors_.size() - 1;
            } else if (!row.passes) {
                read(row);
            }
        }
        const std::size_t answered = answer();
        write(output);
        give_away(answered, output);
    }
}

void RowTransformer::finish(Output& output) { transform_all({}, waiting_line_, true, output, {}); }

void RowTransformer::transform_all(std::string_view text, std::size_t line, bool is_end, Output& output,
                                   const InTurn& in_turn) {
    std::string joined;
    if (!waiting_.empty()) {
        joined = std::exchange(waiting_, {}).append(text);
        text = joined;
        line = waiting_line_;
    }
    for (std::size_t limit = rows_at_once(); !text.empty() && !output.stopped;) {
        const std::string_view all = text;
        gather(text, line, limit);
        const bool is_whole = text.empty();
        const bool at_error = options_->on_error == OnError::stop && !errors_.empty();
        std::size_t answered = answer(at_error || (is_end && is_whole));
        if (answered == 0 && all.size() - text.size() >= most_waiting) {
            answered = answer(true);
        }
        make_continuous(answered, output, in_turn);
        if (answered < lines_.size()) {
            const auto held = std::ranges::find_if(
                rows_, [answered](const Row& row) { return row.has_numbers() && row.index == answered; });
            line = held->number;
            text = all.substr(static_cast<std::size_t>(held->line.text.data() - all.data()));
            rows_.erase(held, rows_.end());
        }
        write(output);
        give_away(answered, output);
        if (is_whole) {
            waiting_ = text;
            waiting_line_ = line;
            return;
        }
        limit = rows_.empty() ? 2 * limit : rows_at_once();
    }
}

bool RowTransformer::is_doubles_alone() const noexcept {
    return options_->input.width > 0 && options_->format == Format::f64 && !layout_->has_other_fields() &&
           !options_->diagnostic_columns && !options_->fold;
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
        answer();
        make_continuous(rows, output, in_turn);
        next_report_ = 0;
        std::size_t next = 0;
        const auto write_clean = [&](std::size_t end) {
            append_bytes(output.bytes, std::span(results_).subspan(next * width, (end - next) * width));
            output.rows += end - next;
            output.answered += end - next;
            next = end;
        };
        while (next_report_ < reports_.size() && !output.stopped) {
            write_clean(reports_[next_report_].row);
            Row row({text.substr(next * row_size, row_size), {}}, line + next);
            row.index = next;
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

void RowTransformer::gather(std::string_view& text, std::size_t& line, std::size_t limit) {
    clear();
    const std::size_t width = options_->input.width;
    const std::size_t size = text.size();
    const auto most_bytes = limit == every_row ? size : most_waiting;
    while (!text.empty() && rows_.size() < limit && size - text.size() < most_bytes) {
        const auto scanned = options_->input.is_comment(text) ? std::nullopt : reader_.scan(text, parts_);
        if (scanned) {
            Row& row = rows_.emplace_back(scanned->line, line++);
            row.numbers = scanned->numbers;
            row.index = lines_.size();
            lines_.push_back(row.number);
            text.remove_prefix(row.line.text.size() + row.line.end.size());
            continue;
        }
        Row& row = rows_.emplace_back(next_row(text, width), line++);
        row.passes = width == 0 && !options_->input.is_row(row.line.text);
        if (!row.passes) {
            read(row);
        }
        if (row.error != Row::no_error && options_->on_error == OnError::stop) {
            return;
        }
    }
}

void RowTransformer::clear() noexcept {
    rows_.clear();
    parts_.clear();
    errors_.clear();
    lines_.clear();
    reference_lines_.clear();
}

void RowTransformer::read(Row& row) {
    const std::size_t first_number = parts_.numbers.size();
    const std::size_t first_kept = parts_.kept.size();
    row.index = lines_.size();
    row.first_field = parts_.fields.size();
    const bool is_pair = row.reference_number > 0; // others were not to be scanned
    const auto scanned = is_pair ? reader_.scan(row.line.text, parts_) : std::nullopt;
    row.numbers = scanned ? scanned->numbers : std::string_view();
    bool is_read = scanned || reader_.read(row.line.text, parts_);
    row.field_count = parts_.fields.size() - row.first_field;
    parts_.error.line = row.number;
    if (is_read && is_pair) {
        is_read = read_reference(row.reference, row.reference_number);
        if (is_read && interpolates()) {
            const std::size_t kept = parts_.kept.size();
            const std::size_t key = parts_.numbers.size();
            is_read = row.later_number > 0 ? read_reference(row.later, row.later_number)
                                           : read_reference(row.reference, row.reference_number);
            if (is_read) { // without its key, and the fraction at the end: see PairColumns
                std::copy(parts_.numbers.begin() + key + 1, parts_.numbers.end(), parts_.numbers.begin() + key);
                parts_.numbers[parts_.numbers.size() - 1] = row.fraction;
                parts_.kept.resize(kept);
            }
        }
    }
    if (!is_read) {
        parts_.numbers.resize(first_number);
        parts_.kept.resize(first_kept);
    }
    if (is_read) {
        lines_.push_back(row.number);
        if (row.reference_number > 0) {
            reference_lines_.push_back(row.reference_number);
        }
    } else {
        row.error = errors_.size();
        errors_.push_back(std::move(parts_.error));
    }
}

bool RowTransformer::read_reference(std::string_view text, std::size_t line) {
    if (reference_reader_->scan(text, parts_) || reference_reader_->read(text, parts_)) {
        return true;
    }
    parts_.error.line = line;
    parts_.error.of_reference = true;
    return false;
}

std::size_t RowTransformer::answer(bool flush) {
    results_.resize(lines_.size() * operation_->answers_of_row() * operation_->names.size());
    return operation_->run_ahead({parts_.numbers, lines_, parts_.kept, reference_lines_}, flush, results_, reports_);
}

void RowTransformer::make_continuous(std::size_t answered, Output& output, const InTurn& in_turn) {
    if (!operation_->is_continuous) {
        return;
    }
    const auto results = std::span(results_).first(answered * operation_->answers_of_row() * operation_->names.size());
    const auto what = [&] { operation_->make_continuous(results, reports_); };
    if (in_turn && !operation_->looks_ahead) { // such rows are for one thread
        output.stopped = !in_turn(what);
    } else {
        what();
    }
}

double RowTransformer::norm_of(const Row& row, const RowReport& report) const {
    if (report.of_reference && row.reference_number == 0) {
        return 0.0; // the second attitude of a row
    }
    const RowNumbers& read = report.of_reference ? options_->pairing->reference.numbers : options_->input.numbers;
    if (!read.attitude || read.attitude->name != RepresentationId::quat) {
        return 0.0;
    }
    const PairColumns columns{.first_size = layout_->count - read.kept, .second_size = 4, .by_key = read.kept > 0};
    const std::size_t first = report.of_later       ? columns.later()
                              : report.of_reference ? columns.second()
                                                    : columns.first();
    const auto q = numbers_of(row).subspan(first, 4);
    const double largest = std::abs(std::ranges::max(q, {}, [](double number) { return std::abs(number); }));
    double squares = 0.0; // of numbers that neither overflow nor underflow
    for (const double number : q) {
        squares += (number / largest) * (number / largest);
    }
    return largest * std::sqrt(squares);
}

void RowTransformer::write(Output& output) {
    next_report_ = 0;
    const bool is_clean = rows_.size() == lines_.size() && reports_.empty();
    if (is_clean && !options_->writes_rows) {
        output.rows += rows_.size();
        output.answered += rows_.size();
        return;
    }
    const auto stands_alone = [&, answers = operation_->answers_of_row()](const Row& row) {
        return row.is_scanned() && !is_reported_before(row, (row.index + 1) * answers);
    };
    for (auto row = rows_.begin(); row != rows_.end() && !output.stopped;) {
        const bool may_stand_alone = options_->writes_rows && writer_.writes_results_alone();
        const auto end = may_stand_alone ? std::find_if_not(row, rows_.end(), stands_alone) : row;
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

void RowTransformer::give_away(std::size_t answered, Output& output) {
    if (!options_->fold || answered == 0) {
        return;
    }
    const std::size_t width = parts_.numbers.size() / lines_.size();
    const std::size_t kept = parts_.kept.size() / lines_.size();
    parts_.numbers.resize(answered * width); // others come again
    parts_.kept.resize(answered * kept);
    lines_.resize(answered);
    reference_lines_.resize(std::min(answered, reference_lines_.size()));
    results_.resize(answered * operation_->answers_of_row() * operation_->names.size());
    output.batches.push_back({std::move(parts_.numbers), std::move(lines_), std::move(reference_lines_),
                              std::move(parts_.kept), std::move(results_), std::move(reports_)});
}

void RowTransformer::write_row(Row& row, Output& output) {
    const std::string_view given = row.line.text; // a binary row becomes text
    const bool is_ours = row.number > 0;          // else there is nothing but an error of the reference
    output.rows += is_ours ? 1 : 0;
    const bool writes_fields = layout_->has_other_fields() && options_->writes_rows;
    if (is_ours && writes_fields && options_->input.width > 0) {
        make_fields(row);                                          // and other text
    } else if (writes_fields && is_ours && row.field_count == 0) { // nobody has split it
        row.first_field = parts_.fields.size();
        static_cast<void>(layout_->delimiter.split(given, parts_.fields));
        row.field_count = parts_.fields.size() - row.first_field;
    }
    if (options_->writes_partners()) {
        find_partner(row, given);
    }
    const std::size_t size = operation_->names.size();
    const std::size_t answers = operation_->answers_of_row();
    for (std::size_t i = 0; i < answers; ++i) {
        const std::size_t index = row.index * answers + i;
        const RowReport& report = report_of(row, index);
        const bool failed = !row.has_numbers() || report.error != Error::none;
        const bool has_no_partner = row.later_number > 0 && report.error == Error::past_half_turn; // of its neighbours
        if (has_no_partner && !options_->pairing->needs_partner) {
            output.unpaired.add({1, row.number});
            continue;
        }
        if (failed && i == 0) {
            tell_error(row, given, report, output);
            const auto& error = std::get<RowError>(output.events.back());
            output.stopped = options_->on_error == OnError::stop || error.key == KeyError::has_unit;
        }
        if (failed && (output.stopped || options_->on_error != OnError::nan || !is_ours)) {
            continue; // each answer's report is passed over
        }
        if (options_->writes_rows) {
            writer_.write(
                output.bytes,
                {.line = row.line,
                 .number = row.number,
                 .fields = std::span(parts_.fields).subspan(row.first_field, row.field_count),
                 .result = failed ? std::span<const double>(nans_) : std::span(results_).subspan(index * size, size),
                 .report = &report,
                 .failed = failed,
                 .answer = operation_->answers.empty() ? std::string_view() : operation_->answers[i],
                 .partner = partner_});
        }
        if (!failed) {
            output.answered += i == 0 ? 1 : 0;
            tell_diagnostics(row, report, i, output);
        }
    }
}

void RowTransformer::find_partner(const Row& row, std::string_view given) {
    key_parts_.clear();
    const char delimiter = layout_->delimiter.text();
    if (row.reference_number == 0) { // a row without a key
        partner_ = fmt::format("{0}nan{0}nan{0}nan", delimiter);
        return;
    }
    const std::string key = *reader_.key(given, key_parts_);
    const std::string other = *reference_reader_->key(row.reference, key_parts_);
    const Key own = reader_.key_of(key).value;
    const Key others = reference_reader_->key_of(other).value;
    partner_ = fmt::format("{0}{1}{0}{2}{0}{3}{4}", delimiter, row.reference_number, trimmed(other),
                           own < others ? "-" : "", distance(own, others).text());
}

void RowTransformer::make_fields(Row& row) {
    const std::string_view bytes = row.line.text;
    constexpr std::size_t room = 40; // of a number and the delimiter, so that nothing moves
    const std::size_t width = options_->input.width;
    parts_.fields.clear();
    row.first_field = 0;
    row.field_count = width;
    made_.clear();
    made_.reserve(room * (width + 1));
    for (std::size_t i = 0; i < width; ++i) {
        const std::string_view field = bytes.substr(i * sizeof(double), sizeof(double));
        if (options_->format == Format::f64) {
            parts_.fields.push_back(field);
            continue;
        }
        if (i > 0) {
            made_.push_back(layout_->delimiter.text());
        }
        double number = 0.0;
        std::memcpy(&number, field.data(), sizeof(double));
        const std::size_t begin = made_.size();
        append_number(made_, number, {});
        parts_.fields.emplace_back(made_.data() + begin, made_.size() - begin);
    }
    if (options_->format != Format::f64) {
        row.line.text = {made_.data(), made_.size()};
    }
}

void RowTransformer::tell_error(const Row& row, std::string_view given, const RowReport& report, Output& output) {
    if (!row.has_numbers()) {
        output.events.emplace_back(errors_[row.error]);
        return;
    }
    if (row.later_number > 0 && report.error == Error::past_half_turn) {
        output.events.emplace_back(
            RowError{.line = row.number, .what = RowError::What::no_partner, .text = std::string(given)});
        return;
    }
    const bool of_reference = report.of_reference && row.reference_number > 0;
    const bool of_later = report.of_later && row.later_number > 0;
    output.events.emplace_back(
        RowError{.line = of_later       ? row.later_number
                         : of_reference ? row.reference_number
                                        : row.number,
                 .what = RowError::What::attitude,
                 .text = of_reference ? reference_reader_->selected_text(of_later ? row.later : row.reference)
                                      : reader_.selected_text(given),
                 .error = report.error,
                 .defect = report.defect,
                 .norm = report.error == Error::defect ? norm_of(row, report) : 0.0,
                 .of_reference = of_reference});
}

void RowTransformer::tell_diagnostics(const Row& row, const RowReport& report, std::size_t answer, Output& output) {
    for_each_diagnostic(report, row.number, operation_->attitudes, [&](Diagnostic diagnostic) {
        if (diagnostic.kind == DiagnosticKind::method_error && !operation_->answers.empty()) {
            diagnostic.answer = options_->operation->answers[answer]; // outlives this
        } else if (answer > 0) {
            return; // that is the row's, and told
        }
        diagnostic.unit = diagnostic.kind == DiagnosticKind::beyond ? operation_->unit : "";
        const bool is_angle = diagnostic.kind == DiagnosticKind::large_angle;
        if (row.reference_number == 0 || !(is_angle || diagnostic.kind == DiagnosticKind::normalized)) {
            output.events.emplace_back(diagnostic);
            return;
        }
        for (const bool of_reference : {true, false}) { // of either, or of both
            const auto& [defect, angle] = of_reference ? report.reference_unusual : report.unusual;
            const double figure = is_angle ? angle : defect;
            if (figure > 0.0) {
                output.events.emplace_back(Diagnostic{.line = of_reference ? row.reference_number : row.number,
                                                      .kind = diagnostic.kind,
                                                      .figure = figure,
                                                      .of_reference = of_reference});
            }
        }
    });
}

std::span<const double> RowTransformer::numbers_of(const Row& row) const noexcept {
    const std::size_t size = parts_.numbers.size() / lines_.size();
    return std::span<const double>(parts_.numbers).subspan(row.index * size, size);
}

const RowReport& RowTransformer::report_of(const Row& row, std::size_t answer) noexcept {
    static constexpr RowReport nothing{};
    return is_reported_before(row, answer + 1) ? reports_[next_report_++] : nothing;
}

} // namespace rotconv::stream
