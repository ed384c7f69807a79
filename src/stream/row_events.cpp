#include "row_events.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace rotconv::stream {

double figure_of(const RowReport& report, const PartReport& part, DiagnosticKind kind) noexcept {
    switch (kind) {
    case DiagnosticKind::normalized: return std::max(report.unusual.defect, report.reference_unusual.defect);
    case DiagnosticKind::large_angle: return std::max(report.unusual.angle, report.reference_unusual.angle);
    case DiagnosticKind::near_gimbal_lock: return part.sensitivity.condition;
    case DiagnosticKind::method_error:
    case DiagnosticKind::coarse_step:
    case DiagnosticKind::beyond: return report.deviation;
    case DiagnosticKind::few_digits: return part.openness;
    default: return part.sensitivity.margin;
    }
}

namespace {

/// The norm of a row's or its partner's quaternion; 0 if the attitude is not a quaternion.
double norm_of(const Row& row, const RowReport& report, const GatheredRows& rows, const Options& options,
               const Layout& layout) {
    if (report.of_reference && row.partner.number == 0) {
        return 0.0; // the second attitude of a row
    }
    const RowNumbers& read = report.of_reference ? options.pairing->reference.numbers : options.input.numbers;
    if (!read.attitude || read.attitude->name != RepresentationId::quat) {
        return 0.0;
    }
    const PairColumns columns{.first_size = layout.count - read.kept, .second_size = 4};
    const std::size_t first = report.of_later ? columns.later() : report.of_reference ? columns.first_size : 0;
    const auto q = rows.numbers_of(row).subspan(first, 4);
    const double largest = std::abs(std::ranges::max(q, {}, [](double number) { return std::abs(number); }));
    double squares = 0.0; // scaled, so that they neither overflow nor underflow
    for (const double number : q) {
        squares += (number / largest) * (number / largest);
    }
    return largest * std::sqrt(squares);
}

} // namespace

RowError error_of(const Row& row, std::string_view given, const RowReport& report, const GatheredRows& rows,
                  const Options& options, const Layout& layout) {
    if (!row.has_numbers()) {
        return rows.error_of(row);
    }
    if (row.fraction > 0.0 && report.error == Error::past_half_turn) {
        return {.place = {row.number}, .what = RowError::What::no_partner, .text = std::string(given)};
    }
    const Side side = report.of_reference && row.partner.number > 0 ? Side::reference : Side::stream;
    const Partner& at = side == Side::stream ? Partner{given, row.number} : report.of_later ? row.later : row.partner;
    return {.place = {at.number, side},
            .what = RowError::What::attitude,
            .text = rows.reader(side).selected_text(at.text),
            .error = report.error,
            .defect = report.defect,
            .norm = report.error == Error::defect ? norm_of(row, report, rows, options, layout) : 0.0};
}

void add_diagnostics(std::vector<Event>& events, const Row& row, const RowReport& report, std::size_t index,
                     const RowOperation& operation) {
    for_each_diagnostic(report, row.number, operation.attitudes, [&](Diagnostic diagnostic) {
        if (diagnostic.kind == DiagnosticKind::method_error && operation.text) {
            diagnostic.text = operation.text->texts[index];
        } else if (index > 0) {
            return; // the first result has told the row's diagnostics
        }
        diagnostic.unit = diagnostic.kind == DiagnosticKind::beyond ? operation.unit : "";
        const bool is_angle = diagnostic.kind == DiagnosticKind::large_angle;
        if (row.partner.number == 0 || !(is_angle || diagnostic.kind == DiagnosticKind::normalized)) {
            events.emplace_back(diagnostic);
            return;
        }
        const auto add = [&](const UnusualNumbers& unusual, Place place) {
            if (const double figure = is_angle ? unusual.angle : unusual.defect; figure > 0.0) {
                events.emplace_back(Diagnostic{.place = place, .kind = diagnostic.kind, .figure = figure});
            }
        };
        add(report.reference_unusual, {row.partner.number, Side::reference});
        add(report.unusual, {row.number});
    });
}

} // namespace rotconv::stream
