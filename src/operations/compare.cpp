#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <rotconv/quaternion.hpp>

#include "between.hpp"
#include "operations.hpp"

namespace rotconv::operations {
namespace {

/// The numbers of a row: the angle and both attitudes.
constexpr std::size_t numbers_of_pair = 9;
constexpr double no_angle = std::numeric_limits<double>::quiet_NaN();

PairFunction function_of(const Comparison& comparison) {
    return {[comparison](auto in, auto out, auto& reports, auto /*rest*/) { comparison.run(in, out, reports); },
            comparison.outputs()};
}

/// Compares the rotations from each pair of attitudes to the N-th pair after it. Remembers N pairs.
class RelativeComparison {
public:
    RelativeComparison(std::size_t delta, ComparisonSettings settings)
        : delta_(delta), rotations_([&] {
              settings.reading.left.reset(); // they have turned the attitudes
              settings.reading.right.reset();
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
            Pair& place = kept_.size() < delta_ ? kept_.emplace_back() : kept_[next_++ % delta_];
            const Pair pair{rotation_at(numbers + 1), rotation_at(numbers + 5)};
            if (next_ > 0) {
                for (const std::size_t side : {0U, 1U}) {
                    const Eigen::Quaterniond q = quaternion::from_rotation(place[side].inverse() * pair[side]);
                    append(rotations_.numbers, std::array{q.w(), q.x(), q.y(), q.z()});
                }
                rotations_.rows.push_back(row);
            }
            place = pair;
        }
        rotations_.run(out, out_width);
        for (RowReport& report : rotations_.reports) {
            RowReport& of_attitudes = report_of(report.row, reports);
            report.diagnostics |= of_attitudes.diagnostics;
            report.defect = of_attitudes.defect;
            report.reference_defect = of_attitudes.reference_defect;
            report.unusual = of_attitudes.unusual;
            report.reference_unusual = of_attitudes.reference_unusual;
            of_attitudes = report;
        }
    }

private:
    using Pair = std::array<Rotation, 2>;

    std::size_t delta_;
    SomeRows rotations_;
    std::vector<Pair> kept_;
    std::size_t next_ = 0; ///< index of the oldest pair that is kept; 0 before N are kept
};

class Compare final : public stream::RowOperation {
public:
    Compare(const Comparison& comparison, const ComparisonRows& rows)
        : comparison_(comparison), columns_(rows.columns(comparison.from(), comparison.reference())) {
        ComparisonSettings settings = comparison.settings();
        names = {"angle"};
        unit = rows.unit;
        if (rows.delta > 0) {
            relative_.emplace(rows.delta, settings);
            in_order = true;
            settings.within = std::numeric_limits<double>::infinity();
        }
        settings.attitudes = rows.with_attitudes || rows.delta > 0;
        names.resize(rows.with_attitudes ? numbers_of_pair : 1);
        comparison_ = Comparison(comparison.from(), comparison.reference(), settings);
        if (rows.interpolates) {
            between_.emplace(function_of(comparison_),
                             function_of(Comparison(comparison_.from(), Spec{}, comparison_.settings())), columns_,
                             comparison_.reference(), comparison_.settings().reading);
        }
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Compare>(*this); }

    std::size_t run(const stream::NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) override {
        const bool has_room = names.size() == comparison_.outputs();
        compared_.resize(has_room ? 0 : rows.lines.size() * comparison_.outputs());
        const std::span<double> compared = has_room ? out : std::span(compared_);
        if (between_) {
            between_->run(rows.numbers, compared, reports);
        } else {
            comparison_.run(without_keys(rows.numbers, columns_, attitudes_), compared, reports);
        }
        if (relative_) {
            relative_->compare(compared, out, names.size(), reports);
        }
        return rows.lines.size();
    }

private:
    Comparison comparison_;
    stream::PairColumns columns_;
    std::optional<Between> between_;             ///< if the reference is interpolated
    std::optional<RelativeComparison> relative_; ///< if there is a delta
    std::vector<double> compared_;               ///< rows of `comparison_`, if they are not the result
    std::vector<double> attitudes_;
};

} // namespace

Operation compare(const Comparison& comparison, const ComparisonRows& rows) {
    return std::make_shared<Compare>(comparison, rows);
}

} // namespace rotconv::operations
