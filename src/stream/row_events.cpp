#include "row_events.hpp"

#include <algorithm>

namespace rotconv::stream {

double figure_of(const RowReport& report, const Sensitivity& sensitivity, DiagnosticKind kind) noexcept {
    switch (kind) {
    case DiagnosticKind::normalized:
    case DiagnosticKind::axis_length:
    case DiagnosticKind::large_angle:
        return std::max(report.unusual.figure_of(kind), report.reference_unusual.figure_of(kind));
    case DiagnosticKind::near_gimbal_lock: return sensitivity.condition;
    case DiagnosticKind::method_error:
    case DiagnosticKind::coarse_step:
    case DiagnosticKind::beyond: return report.deviation;
    default: return sensitivity.margin;
    }
}

void add_diagnostics(std::vector<Event>& events, std::size_t line, const Pair& pair, const RowReport& report,
                     const RowOperation& operation) {
    for_each_diagnostic(report, line, [&](Diagnostic diagnostic) {
        diagnostic.unit = diagnostic.kind == DiagnosticKind::beyond ? operation.unit : "";
        const double own = report.unusual.figure_of(diagnostic.kind);
        const double reference = report.reference_unusual.figure_of(diagnostic.kind);
        if (pair.partner.number == 0 || (own == 0.0 && reference == 0.0)) {
            events.emplace_back(diagnostic);
            return;
        }
        const auto add = [&](double figure, Place place) {
            if (figure > 0.0) {
                events.emplace_back(Diagnostic{.place = place, .kind = diagnostic.kind, .figure = figure});
            }
        };
        add(reference, {pair.partner.number, Side::reference});
        add(own, {line});
    });
}

} // namespace rotconv::stream
