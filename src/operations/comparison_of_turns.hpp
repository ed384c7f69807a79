#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <rotconv/comparison.hpp>
#include <rotconv/quaternion.hpp>

namespace rotconv::operations {

/// Compares the turns from pairs of attitudes to the N-th pair after them. Remembers N pairs.
class ComparisonOfTurns {
public:
    ComparisonOfTurns(std::size_t delta, ComparisonSettings settings)
        : delta_(delta), turns_({}, {}, [&] {
              settings.reading.left.reset(); // the attitudes are turned
              settings.reading.right.reset();
              settings.reading.tolerance = std::numeric_limits<double>::infinity();
              settings.attitudes = false;
              return settings;
          }()) {}

    /// @param compared an angle, nan where there is none, and both attitudes: of each row the last of `compared_width`
    /// numbers
    void compare(std::span<const double> compared, std::size_t compared_width, std::span<double> out,
                 std::size_t out_width, std::vector<RowReport>& reports) {
        const std::size_t rows = compared.size() / compared_width;
        numbers_.clear();
        rows_.clear();
        for (std::size_t row = 0; row < rows; ++row) {
            const double* end = compared.data() + (row + 1) * compared_width;
            std::fill_n(out.data() + row * out_width, out_width, std::numeric_limits<double>::quiet_NaN());
            if (std::isnan(compared[row * compared_width])) {
                continue;
            }
            Pair& place = kept_.size() < delta_ ? kept_.emplace_back() : kept_[next_++ % delta_];
            const Pair pair{rotation_at(end - 8), rotation_at(end - 4)};
            if (next_ > 0) {
                for (const std::size_t side : {0U, 1U}) {
                    const Eigen::Quaterniond turn = quaternion::from_rotation(place[side].inverse() * pair[side]);
                    numbers_.insert(numbers_.end(), {turn.w(), turn.x(), turn.y(), turn.z()});
                }
                rows_.push_back(row);
            }
            place = pair;
        }
        found_.resize(rows_.size() * turns_.outputs());
        turns_.run(numbers_, found_, turn_reports_);
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            std::copy_n(found_.data() + i * turns_.outputs(), turns_.outputs(), out.data() + rows_[i] * out_width);
        }
        for (RowReport& report : turn_reports_) {
            report.row = rows_[report.row];
            const auto place = std::ranges::lower_bound(reports, report.row, {}, &RowReport::row);
            if (place == reports.end() || place->row != report.row) {
                reports.insert(place, report);
            } else { // what was said of its attitudes
                report.diagnostics |= place->diagnostics;
                report.defect = place->defect;
                report.reference_defect = place->reference_defect;
                *place = report;
            }
        }
    }

private:
    using Pair = std::array<Rotation, 2>;

    static Rotation rotation_at(const double* q) { return Rotation::near_unit(q[0], q[1], q[2], q[3]); }

    std::size_t delta_;
    Comparison turns_;
    std::vector<Pair> kept_;
    std::size_t next_ = 0; ///< of those that are kept, the oldest; 0 before all are there
    std::vector<double> numbers_;
    std::vector<std::size_t> rows_;
    std::vector<double> found_;
    std::vector<RowReport> turn_reports_;
};

} // namespace rotconv::operations
