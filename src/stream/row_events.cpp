#include "row_events.hpp"

#include <algorithm>

namespace rotconv::stream {

double figure_of(const RowReport& report, const Sensitivity& sensitivity, DiagnosticKind kind) noexcept {
    switch (kind) {
    case DiagnosticKind::normalized: return std::max(report.unusual.defect, report.reference_unusual.defect);
    case DiagnosticKind::large_angle: return std::max(report.unusual.angle, report.reference_unusual.angle);
    case DiagnosticKind::near_gimbal_lock: return sensitivity.condition;
    case DiagnosticKind::method_error:
    case DiagnosticKind::coarse_step:
    case DiagnosticKind::beyond: return report.deviation;
    default: return sensitivity.margin;
    }
}

void add_diagnostics(std::vector<Event>& events, const Row& row, const RowReport& report, std::size_t index,
                     const RowOperation& operation) {
    for_each_diagnostic(report, row.number, [&](Diagnostic diagnostic) {
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
