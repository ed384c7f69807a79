#include "operations.hpp"

namespace rotconv::operations {

void SurveyFold::add(const stream::AnsweredRows& rows) {
    auto report = rows.reports.begin();
    for (std::size_t i = 0; i < rows.lines.size(); ++i) {
        const bool is_reported = report != rows.reports.end() && report->row == i;
        if (is_reported && (report++)->error != Error::none) {
            continue;
        }
        const auto q = std::span(rows.results).subspan(4 * i, 4);
        survey.add(Rotation::from_components(q[0], q[1], q[2], q[3]), rows.lines[i]);
    }
}

} // namespace rotconv::operations
