#include "row_events.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace rotconv::stream {

double figure_of(const RowReport& report, const Sensitivity& sensitivity, DiagnosticKind kind) noexcept {
    switch (kind) {
    case DiagnosticKind::normalized:
    case DiagnosticKind::axis_length:
    case DiagnosticKind::large_angle:
        return std::max({report.unusual.figure_of(kind), report.references[0].unusual.figure_of(kind),
                         report.references[1].unusual.figure_of(kind)});
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

} // namespace rotconv::stream
