#include <cmath>
#include <deque>
#include <limits>
#include <utility>

#include <rotconv/quaternion.hpp>

#include "between.hpp"
#include "operations.hpp"

namespace rotconv::operations {
namespace {

/// The numbers of a row: the angle and both attitudes.
constexpr std::size_t numbers_of_pair = 9;
constexpr double no_angle = std::numeric_limits<double>::quiet_NaN();

/// Compares the rotations from each pair of attitudes to the N-th pair after it. Remembers N pairs.
class RelativeComparison {
public:
    RelativeComparison(std::size_t delta, ComparisonSettings settings)
        : delta_(delta), rotations_([&] {
              settings.reading.left = {}; // they have turned the attitudes
              settings.reading.right = {};
              settings.reading.tolerance = any_defect;
              settings.attitudes = false;
              return function_of(Comparison({}, {}, settings));
          }()) {}

    /// @param compared rows of an angle, nan if there is none, and both attitudes
    /// @param out the angle between the rotations becomes the first number of each row
    void compare(std::span<const double> compared, std::span<double> out, std::size_t out_width,
                 std::vector<RowReport>& reports) {
        rotations_.clear();
        for (std::size_t row = 0; row < compared.size() / numbers_of_pair; ++row) {
            const double* numbers = compared.data() + row * numbers_of_pair;
            const bool has_angle = !std::isnan(numbers[0]);
            out[row * out_width] = no_angle; // may be the angle of `compared`
            if (!has_angle) {
                continue;
            }
            const Pair pair{rotation_at(numbers + 1), rotation_at(numbers + 5)};
            if (kept_.size() == delta_) {
                for (const std::size_t side : {0U, 1U}) {
                    const Eigen::Quaterniond q = quaternion::from_rotation(kept_.front()[side].inverse() * pair[side]);
                    append(rotations_.numbers, std::array{q.w(), q.x(), q.y(), q.z()});
                }
                rotations_.rows.push_back(row);
                kept_.pop_front();
            }
            kept_.push_back(pair);
        }
        rotations_.run(1, out, out_width);
        for (const RowReport& report : rotations_.reports) {
            RowReport& of_attitudes = stream::report_of(report.row, reports);
            of_attitudes.diagnostics |= report.diagnostics;
            of_attitudes.deviation = report.deviation;
        }
    }

private:
    using Pair = std::array<Rotation, 2>;

    std::size_t delta_;
    RowSubset rotations_;
    std::deque<Pair> kept_; ///< at most N, the oldest first
};

} // namespace

Operation compare(const Comparison& comparison, const ComparisonRows& rows) {
    const Spec& reference = comparison.reference();
    ComparisonSettings settings = comparison.settings();
    settings.within = rows.delta > 0 ? std::numeric_limits<double>::infinity() : settings.within;
    settings.attitudes = rows.with_attitudes || rows.delta > 0;
    const Comparison compares(comparison.from(), reference, settings);
    RowFunction function = of_pairs(function_of(compares), function_of(Comparison(comparison.from(), Spec{}, settings)),
                                    rows, comparison.from().size(), reference, settings.reading);
    const std::size_t width = rows.with_attitudes ? numbers_of_pair : 1;
    if (rows.delta > 0) {
        function = [pairs = std::move(function), room = std::vector<double>(),
                    relative = RelativeComparison(rows.delta, comparison.settings()),
                    width](const stream::NumberRows& numbers, auto out, auto& reports, auto rest) mutable {
            room.resize(width == numbers_of_pair ? 0 : numbers.lines.size() * numbers_of_pair);
            const std::span<double> compared = room.empty() ? out : std::span(room);
            pairs(numbers, compared, reports, rest);
            relative.compare(compared, out, width, reports);
            return numbers.lines.size();
        };
    }
    std::vector<std::string> names{"angle"};
    names.resize(width);
    Operation made = operation_of(std::move(function),
                                  pair_numbers(attitude_numbers(comparison.from()), rows, reference), std::move(names));
    made->unit = rows.unit;
    made->in_order = rows.delta > 0;
    return made;
}

} // namespace rotconv::operations
