#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "event.hpp"
#include "job.hpp"
#include "row_operation.hpp"

/// The events of a row that was answered.
namespace rotconv::stream {

/// The figure of a diagnostic of a row, or of a part of its result.
[[nodiscard]] double figure_of(const RowReport& report, const PartReport& part, DiagnosticKind kind) noexcept;

/// Visits the diagnostics of a row with their figures, in order of kind. `attitudes`: those of the result, if any.
template <class Visit> void for_each_diagnostic(const RowReport& report, std::size_t line,
                                                const std::vector<Spec>& attitudes, const Visit& visit) {
    if (report.diagnostics.empty()) {
        return;
    }
    for (const DiagnosticKind kind : all_diagnostic_kinds) {
        if (report.diagnostics.has(kind)) {
            const auto part = std::ranges::find_if(
                report.parts, [kind](const PartReport& each) { return each.diagnostics.has(kind); });
            const bool is_of_part = part != report.parts.end();
            const auto index = is_of_part ? static_cast<std::size_t>(part - report.parts.begin()) : 0;
            const PartReport of =
                is_of_part ? *part : PartReport{report.diagnostics, report.sensitivity, report.openness};
            visit(Diagnostic{{line},
                             kind,
                             figure_of(report, of, kind),
                             index < attitudes.size() ? attitudes[index].name : RepresentationId::quat});
        }
    }
}

/// Adds the diagnostics of the row's result, those of a row and of its partner separately.
/// @param operation outlives the events
void add_diagnostics(std::vector<Event>& events, const Row& row, const RowReport& report,
                     const RowOperation& operation);

} // namespace rotconv::stream
