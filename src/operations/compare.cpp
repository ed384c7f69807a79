#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "../stream/fmt.hpp"
#include "comparison_between.hpp"
#include "comparison_of_turns.hpp"
#include "operations.hpp"

namespace rotconv::operations {
namespace {

class Compare final : public stream::RowOperation {
public:
    Compare(const Comparison& comparison, const ComparisonRows& rows, std::shared_ptr<PairWatch> watch)
        : comparison_(comparison), rows_(rows), watch_(std::move(watch)) {
        ComparisonSettings settings = comparison.settings();
        names = {"angle"};
        attitude = settings.relative;
        unit = settings.unit == AngleUnit::degrees ? "deg" : "rad";
        if (attitude) {
            names = joined(names, names_of(*attitude));
        }
        if (rows.delta > 0) {
            turns_.emplace(rows.delta, settings);
            in_order = true;
            settings.within = std::numeric_limits<double>::infinity();
            settings.relative.reset();
        }
        settings.attitudes = rows.as_numbers || rows.delta > 0;
        comparison_ = Comparison(comparison.from(), comparison.reference(), settings);
        if (rows.interpolates) {
            between_.emplace(comparison_);
        }
        if (rows.as_numbers) {
            names.resize(numbers_of_pair);
        }
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Compare>(*this); }

    void run(const stream::NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) override {
        const std::size_t width = names.size();
        const std::size_t compared_width = comparison_.outputs();
        const bool has_attitudes = comparison_.settings().attitudes;
        compared_.resize(has_attitudes ? rows.lines.size() * compared_width : 0);
        const std::span<double> compared = has_attitudes ? std::span(compared_) : out;
        std::span<const double> attitudes = rows.numbers;
        if (between_) {
            between_->run(rows.numbers, compared, reports);
            attitudes = has_attitudes ? with_quaternions(rows) : attitudes;
        } else {
            attitudes = rows_.by_key
                            ? without_keys_(rows.numbers, comparison_.from().size(), comparison_.reference().size())
                            : rows.numbers;
            comparison_.run(attitudes, compared, reports);
        }
        if (turns_) {
            turns_->compare(compared, compared_width, out, width, reports);
        }
        for (std::size_t i = 0; rows_.as_numbers && i < rows.lines.size(); ++i) {
            double* const result = out.data() + i * width;
            const double* const end = compared_.data() + (i + 1) * compared_width;
            result[0] = turns_ ? result[0] : *(end - static_cast<std::ptrdiff_t>(compared_width));
            std::copy_n(end - 8, 8, result + 1);
            result[numbers_of_pair - 1] = static_cast<double>(rows.lines[i]);
        }
        watch_->add(rows, attitudes, rows_.by_key ? 1 + comparison_.from().size() : 0, out, width);
    }

private:
    /// The numbers of each attitude, and the quaternion between those of the reference.
    std::span<const double> with_quaternions(const stream::NumberRows& rows) {
        attitudes_.clear();
        for (std::size_t i = 0; i < rows.lines.size(); ++i) {
            const auto row = rows.numbers.subspan(i * (rows.numbers.size() / rows.lines.size()) + 1);
            const auto own = row.first(comparison_.from().size());
            const auto q = std::span(compared_).subspan((i + 1) * comparison_.outputs() - 4, 4);
            attitudes_.insert(attitudes_.end(), own.begin(), own.end());
            attitudes_.insert(attitudes_.end(), q.begin(), q.end());
        }
        return attitudes_;
    }

    Comparison comparison_;
    ComparisonRows rows_;
    std::shared_ptr<PairWatch> watch_;
    std::optional<ComparisonBetween> between_; ///< where the reference is interpolated
    std::optional<ComparisonOfTurns> turns_;   ///< where there is a delta
    KeyRemover without_keys_;
    std::vector<double> compared_;
    std::vector<double> attitudes_;
};

} // namespace

void PairWatch::add(const stream::NumberRows& rows, std::span<const double> attitudes, std::size_t second_key,
                    std::span<const double> results, std::size_t width) {
    const std::lock_guard lock(mutex_);
    const std::size_t count = rows.lines.size();
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = results[i * width];
        if (std::isnan(angle)) {
            continue;
        }
        ++pairs_;
        beyond_ += angle > limit_ ? 1 : 0;
        if (worst_.size() == most_ && angle < worst_.rbegin()->angle) {
            continue;
        }
        WorstPair pair{.angle = angle, .line = rows.lines[i]};
        if (worst_.size() == most_ && !(pair < *worst_.rbegin())) {
            continue;
        }
        pair.reference_line = rows.reference_lines.empty() ? 0 : rows.reference_lines[i];
        const auto own = attitudes.subspan(i * attitudes.size() / count, attitudes.size() / count);
        pair.numbers.assign(own.begin(), own.end());
        for (const std::size_t side : {0U, 1U}) {
            if (second_key > 0) {
                const std::size_t key = i * (rows.numbers.size() / count) + side * second_key;
                pair.keys.at(side) = rows.kept.empty() ? fmt::format("{}", rows.numbers[key]) : rows.kept[2 * i + side];
            }
        }
        worst_.insert(std::move(pair));
        if (worst_.size() > most_) {
            worst_.erase(std::prev(worst_.end()));
        }
    }
}

stream::RowNumbers comparison_numbers(const Comparison& comparison, const ComparisonRows& rows) {
    stream::RowNumbers numbers = attitude_numbers(comparison.from(), rows.by_key);
    if (!rows.paired) {
        numbers.names = joined(numbers.names, names_of(comparison.reference()));
        numbers.second = comparison.reference();
    }
    return numbers;
}

Operation compare(const Comparison& comparison, const ComparisonRows& rows, std::shared_ptr<PairWatch> watch) {
    return std::make_shared<Compare>(comparison, rows, std::move(watch));
}

} // namespace rotconv::operations
