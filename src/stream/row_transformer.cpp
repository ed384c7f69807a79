#include "row_transformer.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <Eigen/Core>

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
        return;
    }
    if (operation_->looks_ahead) {
        transform_ahead(text, line, false, output);
        return;
    }
    while (!text.empty() && !output.stopped) {
        gather(text, line, rows_at_once());
        answer(output, in_turn);
    }
}

void RowTransformer::transform(const PairBlock& pairs, Output& output) {
    std::span<const PairedRow> rest = pairs.rows;
    while (!rest.empty() && !output.stopped) {
        gather_pairs(rest, pairs.errors);
        answer(output);
    }
}

void RowTransformer::answer(Output& output, const InTurn& in_turn) {
    results_.resize(lines_.size() * operation_->answers_of_row() * operation_->names.size());
    operation_->run({parts_.numbers, lines_, parts_.kept}, results_, reports_);
    choose(output, in_turn);
    if (!output.stopped) {
        write(output);
    }
}

void RowTransformer::choose(Output& output, const InTurn& in_turn) {
    if (!operation_->chooses) {
        return;
    }
    const auto what = [this] { operation_->choose(results_, reports_); };
    if (in_turn) {
        output.stopped = !in_turn(what);
    } else {
        what();
    }
}

void RowTransformer::finish(Output& output) {
    if (operation_->looks_ahead) {
        transform_ahead({}, 0, true, output);
    }
}

void RowTransformer::clear() noexcept {
    rows_.clear();
    parts_.clear();
    errors_.clear();
    lines_.clear();
}

void RowTransformer::gather(std::string_view& text, std::size_t& line, std::size_t limit) {
    clear();
    if (options_->input.width > 0) {
        gather_binary(text, line, limit);
        return;
    }
    const char* const begin = text.data();
    const auto most_bytes = limit == every_row ? text.size() : most_waiting;
    while (!text.empty() && rows_.size() < limit && static_cast<std::size_t>(text.data() - begin) < most_bytes) {
        const Line current = next_line(text);
        Row row{.line = current,
                .number = line++,
                .passed = is_blank(current.text) || is_comment(current.text),
                .first_field = parts_.fields.size()};
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
    row.index = lines_.size();
    if (reader_.read(row.line.text, parts_, options_->append)) {
        lines_.push_back(row.number);
    } else {
        note_error(row, std::move(parts_.error));
    }
    row.field_count = parts_.fields.size() - row.first_field;
}

void RowTransformer::gather_pairs(std::span<const PairedRow>& pairs, const std::vector<RowError>& errors) {
    clear();
    for (; !pairs.empty() && rows_.size() < batch_rows; pairs = pairs.subspan(1)) {
        const PairedRow& pair = pairs.front();
        Row row{.line = pair.row,
                .number = pair.number,
                .passed = pair.passed,
                .first_field = parts_.fields.size(),
                .pair = &pair};
        if (pair.error != PairedRow::no_error) {
            row.error = errors_.size();
            errors_.push_back(errors[pair.error]);
        } else if (!row.passed) {
            read_pair(row);
        }
        rows_.push_back(row);
    }
}

void RowTransformer::read_pair(Row& row) {
    read_row(row);
    if (!row.has_numbers()) {
        return;
    }
    const PairedRow& pair = *row.pair;
    if (!reference_reader_->read(pair.reference.text, parts_, false)) {
        parts_.numbers.resize(parts_.numbers.size() - layout_->count);
        lines_.pop_back();
        note_error(row, std::move(parts_.error));
        errors_.back().line = pair.reference_number;
        errors_.back().of_reference = true;
    }
}

void RowTransformer::note_error(Row& row, RowError error) {
    error.line = row.number;
    row.error = errors_.size();
    errors_.push_back(std::move(error));
}

double RowTransformer::norm_of(const Row& row, bool of_reference) const {
    if (of_reference && row.pair == nullptr) {
        return 0.0; // the second attitude of a row
    }
    const RowNumbers& read = of_reference ? options_->pairing->reference.numbers : options_->input.numbers;
    if (!read.attitude || read.attitude->name != RepresentationId::quat) {
        return 0.0;
    }
    const std::size_t size = parts_.numbers.size() / lines_.size();
    const double* const q = parts_.numbers.data() + row.index * size + (of_reference ? layout_->count : 0) + read.kept;
    return Eigen::Map<const Eigen::Vector4d>(q).stableNorm();
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
    const std::string_view given = row.line.text; // a binary row becomes text
    const bool is_ours = row.number > 0;          // else there is nothing but an error of the reference
    if (is_ours && options_->input.width > 0 && needs_fields() && options_->format != Format::result) {
        make_fields(row); // and other text
    }
    const std::size_t size = operation_->names.size();
    const std::size_t answers = operation_->answers_of_row();
    for (std::size_t i = 0; i < answers; ++i) {
        const std::size_t index = row.index * answers + i;
        const RowReport& report = report_of(row, index);
        const bool failed = !row.has_numbers() || report.error != Error::none;
        if (failed && i == 0) {
            tell_error(row, given, report, output);
            output.stopped = options_->on_error == OnError::stop;
        }
        if (failed && (options_->on_error != OnError::nan || !is_ours)) {
            continue; // each answer's report is passed over
        }
        writer_.write(
            output.bytes,
            {.line = row.line,
             .number = row.number,
             .fields = std::span(parts_.fields).subspan(row.first_field, row.field_count),
             .result = failed ? std::span<const double>(nans_) : std::span(results_).subspan(index * size, size),
             .report = &report,
             .failed = failed,
             .answer = operation_->answers.empty() ? std::string_view() : operation_->answers[i]});
        if (!failed) {
            output.answered += i == 0 ? 1 : 0;
            tell_diagnostics(row, report, i, output);
        }
    }
}

void RowTransformer::tell_error(const Row& row, std::string_view given, const RowReport& report, Output& output) {
    if (!row.has_numbers()) {
        output.events.emplace_back(errors_[row.error]);
        return;
    }
    const bool of_reference = report.of_reference && row.pair != nullptr;
    output.events.emplace_back(RowError{.line = of_reference ? row.pair->reference_number : row.number,
                                        .what = RowError::What::attitude,
                                        .text = of_reference
                                                    ? reference_reader_->selected_text(row.pair->reference.text)
                                                    : reader_.selected_text(given),
                                        .error = report.error,
                                        .defect = report.defect,
                                        .norm = report.error == Error::defect ? norm_of(row, report.of_reference) : 0.0,
                                        .of_reference = of_reference});
}

void RowTransformer::tell_diagnostics(const Row& row, const RowReport& report, std::size_t answer, Output& output) {
    for_each_diagnostic(report, row.number, [&](Diagnostic diagnostic) {
        if (diagnostic.kind == DiagnosticKind::method_error && !operation_->answers.empty()) {
            diagnostic.answer = options_->operation->answers[answer]; // outlives this
        } else if (answer > 0) {
            return; // that is the row's, and told
        }
        if (diagnostic.kind == DiagnosticKind::normalized && row.pair != nullptr) { // of either, or of both
            if (report.reference_defect > reported_defect) {
                output.events.emplace_back(Diagnostic{.line = row.pair->reference_number,
                                                      .kind = diagnostic.kind,
                                                      .figure = report.reference_defect,
                                                      .of_reference = true});
            }
            if (!(report.defect > reported_defect)) {
                return;
            }
            diagnostic.figure = report.defect;
        }
        output.events.emplace_back(diagnostic);
    });
}

const RowReport& RowTransformer::report_of(const Row& row, std::size_t answer) noexcept {
    static constexpr RowReport nothing{};
    const bool is_next = row.has_numbers() && next_report_ < reports_.size() && reports_[next_report_].row == answer;
    return is_next ? reports_[next_report_++] : nothing;
}

} // namespace rotconv::stream
