#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "../event.hpp"
#include "../job.hpp"
#include "row_operation.hpp"

/// The events of a row that was answered.
namespace rotconv::stream {

/// The figure of a diagnostic of a row, from the sensitivity of its result or of the part that has it.
[[nodiscard]] double figure_of(const RowReport& report, const Sensitivity& sensitivity, DiagnosticKind kind) noexcept;

/// Visits the diagnostics of a row with their figures, in order of kind.
template <class Visit> void for_each_diagnostic(const RowReport& report, std::size_t line, const Visit& visit) {
    if (report.diagnostics.empty()) {
        return;
    }
    for (const DiagnosticKind kind : all_diagnostic_kinds) {
        if (report.diagnostics.has(kind)) {
            const auto part = std::ranges::find_if(
                report.parts, [kind](const PartReport& each) { return each.diagnostics.has(kind); });
            const Sensitivity& sensitivity = part != report.parts.end() ? part->sensitivity : report.sensitivity;
            visit(Diagnostic{{line}, kind, figure_of(report, sensitivity, kind)});
        }
    }
}

/// Adds the diagnostics of the row's result, those of a row and of its partner separately.
/// @param operation outlives the events
void add_diagnostics(std::vector<Event>& events, std::size_t line, const Pair& pair, const RowReport& report,
                     const RowOperation& operation);

} // namespace rotconv::stream
