#include <algorithm>
#include <cmath>
#include <iterator>

#include "between.hpp"
#include "operations.hpp"

namespace rotconv::operations {

void PairFold::add(const stream::AnsweredRows& rows) {
    const std::size_t count = rows.lines.size();
    const std::size_t width = rows.results.size() / count;
    for (std::size_t i = 0; i < count; ++i) {
        const double* const pair = rows.results.data() + i * width;
        const double angle = pair[0];
        if (std::isnan(angle)) {
            continue;
        }
        angles_.add(angle);
        if (finds_means_) {
            const Rotation inverse = rotation_at(pair + 1).inverse();
            const Rotation reference = rotation_at(pair + 5);
            left_.add(reference * inverse);
            right_.add(inverse * reference);
        }
        const std::size_t line = rows.lines[i];
        for (PairLimit& limit : limits_) {
            if (angle > limit.angle) {
                limit.first_beyond = limit.beyond++ == 0 ? line : std::min(limit.first_beyond, line);
            }
        }
        if (worst_.size() < most_ || WorstPair{.angle = angle, .line = line} < *worst_.rbegin()) {
            keep(rows, i);
        }
    }
}

void PairFold::keep(const stream::AnsweredRows& rows, std::size_t row) {
    const auto row_of = [row, count = rows.lines.size()](std::span<const double> numbers) {
        return numbers.subspan(row * (numbers.size() / count), numbers.size() / count);
    };
    const auto numbers = row_of(rows.numbers);
    const auto result = row_of(rows.results);
    WorstPair pair{.angle = result[0],
                   .line = rows.lines[row],
                   .reference_line = rows.reference_lines.empty() ? 0 : rows.reference_lines[row]};
    const bool is_between = interpolates_ && result.size() > 1;
    append(pair.attitudes[0], numbers.first(first_size_));
    append(pair.attitudes[1], is_between ? result.last(4) : numbers.subspan(first_size_));
    for (const std::size_t side : {0U, 1U}) {
        pair.keys.at(side) = rows.kept.empty() ? "" : rows.kept[2 * row + side].written();
    }
    worst_.insert(std::move(pair));
    if (worst_.size() > most_) {
        worst_.erase(std::prev(worst_.end()));
    }
}

void AlignmentFold::add(const stream::AnsweredRows& rows) {
    const std::size_t width = rows.results.size() / rows.lines.size();
    for (std::span<const double> pairs = rows.results; !pairs.empty(); pairs = pairs.subspan(width)) {
        if (!std::isnan(pairs[0])) {
            alignment.add(rotation_at(pairs.data() + 1), rotation_at(pairs.data() + 5));
        }
    }
}

void SurveyFold::add(const stream::AnsweredRows& rows) {
    for (std::size_t i = 0; i < rows.lines.size(); ++i) {
        const auto q = std::span(rows.results).subspan(4 * i, 4);
        if (!std::isnan(q[0])) {
            survey.add(Rotation::from_components(q[0], q[1], q[2], q[3]), rows.lines[i]);
        }
    }
}

} // namespace rotconv::operations
