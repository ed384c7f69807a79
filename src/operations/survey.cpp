#include <cmath>

#include "operations.hpp"

namespace rotconv::operations {

void SurveyFold::add(const stream::AnsweredRows& rows) {
    for (std::size_t i = 0; i < rows.lines.size(); ++i) {
        const auto q = std::span(rows.results).subspan(4 * i, 4);
        if (!std::isnan(q[0])) {
            survey.add(Rotation::from_components(q[0], q[1], q[2], q[3]), rows.lines[i]);
        }
    }
}

} // namespace rotconv::operations
