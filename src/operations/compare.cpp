#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include <rotconv/quaternion.hpp>

#include "../stream/fmt.hpp"
#include "between.hpp"
#include "operations.hpp"

namespace rotconv::operations {
namespace {

constexpr double no_angle = std::numeric_limits<double>::quiet_NaN();

PairFunction function_of(const Comparison& comparison) {
    return {[comparison](auto in, auto out, auto& reports, auto /*rest*/) { comparison.run(in, out, reports); },
            comparison.outputs()};
}

/// Compares the turns from pairs of attitudes to the N-th pair after them. Remembers N pairs.
class ComparisonOfTurns {
public:
    ComparisonOfTurns(std::size_t delta, ComparisonSettings settings)
        : delta_(delta), turns_([&] {
              settings.reading.left.reset(); // the attitudes are turned
              settings.reading.right.reset();
              settings.reading.tolerance = any_defect;
              settings.attitudes = false;
              return function_of(Comparison({}, {}, settings));
          }()) {}

    /// @param compared of each row an angle, nan where there is none, and both attitudes
    void compare(std::span<const double> compared, std::span<double> out, std::size_t out_width,
                 std::vector<RowReport>& reports) {
        std::ranges::fill(out, no_angle);
        turns_.clear();
        for (std::size_t row = 0; row < compared.size() / numbers_of_pair; ++row) {
            const double* numbers = compared.data() + row * numbers_of_pair;
            if (std::isnan(numbers[0])) {
                continue;
            }
            Pair& place = kept_.size() < delta_ ? kept_.emplace_back() : kept_[next_++ % delta_];
            const Pair pair{rotation_at(numbers + 1), rotation_at(numbers + 5)};
            if (next_ > 0) {
                for (const std::size_t side : {0U, 1U}) {
                    const Eigen::Quaterniond turn = quaternion::from_rotation(place[side].inverse() * pair[side]);
                    append(turns_.numbers, std::array{turn.w(), turn.x(), turn.y(), turn.z()});
                }
                turns_.rows.push_back(row);
            }
            place = pair;
        }
        turns_.run(out, out_width);
        for (RowReport& report : turns_.reports) {
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
    SomeRows turns_;
    std::vector<Pair> kept_;
    std::size_t next_ = 0; ///< of those that are kept, the oldest; 0 before all are there
};

class Compare final : public stream::RowOperation {
public:
    Compare(const Comparison& comparison, const ComparisonRows& rows, std::shared_ptr<PairWatch> watch)
        : comparison_(comparison), rows_(rows), watch_(std::move(watch)) {
        ComparisonSettings settings = comparison.settings();
        names = {"angle"};
        unit = rows.unit;
        if (rows.delta > 0) {
            turns_.emplace(rows.delta, settings);
            in_order = true;
            settings.within = std::numeric_limits<double>::infinity();
        }
        if (rows.as_numbers || rows.delta > 0) {
            settings.attitudes = true;
        }
        comparison_ = Comparison(comparison.from(), comparison.reference(), settings);
        if (rows.interpolates) {
            between_.emplace(function_of(comparison_),
                             function_of(Comparison(comparison_.from(), Spec{}, comparison_.settings())),
                             comparison_.from().size(), comparison_.reference(), comparison_.settings().reading);
        }
        if (rows.as_numbers) {
            names.resize(numbers_of_pair);
        }
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Compare>(*this); }

    void run(const stream::NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) override {
        compared_.resize(turns_ ? rows.lines.size() * comparison_.outputs() : 0);
        const std::span<double> compared = turns_ ? std::span(compared_) : out;
        std::span<const double> numbers = rows.numbers;
        if (between_) {
            between_->run(rows.numbers, compared, reports);
            numbers = comparison_.settings().attitudes ? with_quaternions(rows, compared) : numbers;
        } else {
            if (rows_.by_key) {
                attitudes_ = without_keys(rows.numbers, comparison_.from().size(), comparison_.reference().size());
                numbers = attitudes_;
            }
            comparison_.run(numbers, compared, reports);
        }
        if (turns_) {
            turns_->compare(compared, out, names.size(), reports);
        }
        watch_->add(rows, numbers, comparison_.from().size(), rows_.by_key, out, names.size());
    }

private:
    /// The numbers of each attitude, and the quaternion between those of the reference.
    std::span<const double> with_quaternions(const stream::NumberRows& rows, std::span<const double> compared) {
        attitudes_.clear();
        for (std::size_t i = 0; i < rows.lines.size(); ++i) {
            const auto row = rows.numbers.subspan(i * (rows.numbers.size() / rows.lines.size()) + 1);
            append(attitudes_, row.first(comparison_.from().size()));
            append(attitudes_, compared.subspan((i + 1) * comparison_.outputs() - 4, 4));
        }
        return attitudes_;
    }

    Comparison comparison_;
    ComparisonRows rows_;
    std::shared_ptr<PairWatch> watch_;
    std::optional<Between> between_;         ///< where the reference is interpolated
    std::optional<ComparisonOfTurns> turns_; ///< where there is a delta
    std::vector<double> compared_;           ///< before the turns
    std::vector<double> attitudes_;
};

} // namespace

int PairStatistics::write(std::string_view rows) {
    std::array<double, numbers_of_pair> pair{};
    for (; !rows.empty(); rows.remove_prefix(sizeof pair)) {
        std::memcpy(pair.data(), rows.data(), sizeof pair);
        if (std::isnan(pair[0])) {
            continue;
        }
        const Rotation attitude = rotation_at(pair.data() + 1);
        const Rotation reference = rotation_at(pair.data() + 5);
        angles.add(pair[0]);
        if (alignment) {
            alignment->add(attitude, reference);
        } else if (finds_turns) {
            const Rotation inverse = attitude.inverse();
            left.add(reference * inverse);
            right.add(inverse * reference);
        }
    }
    return 0;
}

void PairWatch::add(const stream::NumberRows& rows, std::span<const double> attitudes, std::size_t size, bool by_key,
                    std::span<const double> results, std::size_t width) {
    const std::lock_guard lock(mutex_);
    const std::size_t count = rows.lines.size();
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = results[i * width];
        if (std::isnan(angle)) {
            continue;
        }
        ++pairs_;
        for (PairLimit& limit : limits_) {
            if (angle > limit.angle) {
                limit.first_beyond = limit.beyond++ == 0 ? rows.lines[i] : std::min(limit.first_beyond, rows.lines[i]);
            }
        }
        if (worst_.size() == most_ && angle < worst_.rbegin()->angle) {
            continue;
        }
        WorstPair pair{.angle = angle, .line = rows.lines[i]};
        if (worst_.size() == most_ && !(pair < *worst_.rbegin())) {
            continue;
        }
        pair.reference_line = rows.reference_lines.empty() ? 0 : rows.reference_lines[i];
        const auto both = attitudes.subspan(i * attitudes.size() / count, attitudes.size() / count);
        for (const std::size_t side : {0U, 1U}) {
            append(pair.attitudes.at(side), side == 0 ? both.first(size) : both.subspan(size));
            if (by_key) {
                const std::size_t key = i * (rows.numbers.size() / count) + side * (1 + size);
                pair.keys.at(side) = rows.kept.empty() ? fmt::format("{}", rows.numbers[key]) : rows.kept[2 * i + side];
            }
        }
        worst_.insert(std::move(pair));
        if (worst_.size() > most_) {
            worst_.erase(std::prev(worst_.end()));
        }
    }
}

Operation compare(const Comparison& comparison, const ComparisonRows& rows, std::shared_ptr<PairWatch> watch) {
    return std::make_shared<Compare>(comparison, rows, std::move(watch));
}

} // namespace rotconv::operations
