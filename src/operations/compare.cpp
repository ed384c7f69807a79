#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "../stream/fmt.hpp"
#include "operations.hpp"

namespace rotconv::operations {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Rotation rotation_of(const double* q) { return Rotation::near_unit(q[0], q[1], q[2], q[3]); }

/// The turns from pairs to the N-th after them. Remembers N pairs.
class Turns {
public:
    Turns(std::size_t delta, ComparisonSettings settings)
        : delta_(delta), turns_({}, {}, [&] {
              settings.reading.left.reset(); // the attitudes are turned
              settings.reading.right.reset();
              settings.reading.tolerance = std::numeric_limits<double>::infinity();
              settings.attitudes = false;
              return settings;
          }()) {}

    /// @param compared an angle, nan where there is none, and both attitudes: of each row the last of `width` numbers
    void compare(std::span<const double> compared, std::size_t width, std::span<double> out, std::size_t out_width,
                 std::vector<RowReport>& reports) {
        const std::size_t rows = compared.size() / width;
        numbers_.clear();
        rows_.clear();
        for (std::size_t row = 0; row < rows; ++row) {
            const double* end = compared.data() + (row + 1) * width;
            std::fill_n(out.data() + row * out_width, out_width, nan);
            if (std::isnan(compared[row * width])) {
                continue;
            }
            Pair& place = kept_.size() < delta_ ? kept_.emplace_back() : kept_[next_++ % delta_];
            const Pair pair{rotation_of(end - 8), rotation_of(end - 4)};
            if (next_ > 0) {
                for (const std::size_t side : {0U, 1U}) {
                    const Rotation turn = place[side].inverse() * pair[side];
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

    std::size_t delta_;
    Comparison turns_;
    std::vector<Pair> kept_;
    std::size_t next_ = 0; ///< of those that are kept, the oldest; 0 before all are there
    std::vector<double> numbers_;
    std::vector<std::size_t> rows_;
    std::vector<double> found_;
    std::vector<RowReport> turn_reports_;
};

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
            turns_.emplace_back(rows.delta, settings);
            in_order = true;
            settings.within = std::numeric_limits<double>::infinity();
            settings.relative.reset();
        }
        settings.attitudes = rows.as_numbers || rows.delta > 0;
        comparison_ = Comparison(comparison.from(), comparison.reference(), settings);
        if (rows.as_numbers) {
            names.resize(numbers_of_pair);
        }
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Compare>(*this); }

    void run(const stream::NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) override {
        const auto numbers =
            rows_.by_key ? without_keys_(rows.numbers, comparison_.from().size(), comparison_.reference().size())
                         : rows.numbers;
        const std::size_t width = names.size();
        const std::size_t compared_width = comparison_.outputs();
        if (!comparison_.settings().attitudes) {
            comparison_.run(numbers, out, reports);
        } else {
            compared_.resize(rows.lines.size() * compared_width);
            comparison_.run(numbers, compared_, reports);
            for (auto& turns : turns_) {
                turns.compare(compared_, compared_width, out, width, reports);
            }
        }
        if (rows_.as_numbers) {
            for (std::size_t i = 0; i < rows.lines.size(); ++i) {
                double* const result = out.data() + i * width;
                const double* const compared = compared_.data() + i * compared_width;
                result[0] = turns_.empty() ? compared[0] : result[0];
                std::copy_n(compared + 1, 8, result + 1);
                result[numbers_of_pair - 1] = static_cast<double>(rows.lines[i]);
            }
        }
        watch_->add(rows, numbers, rows_.by_key ? 1 + comparison_.from().size() : 0, out, width);
    }

private:
    Comparison comparison_;
    ComparisonRows rows_;
    std::shared_ptr<PairWatch> watch_;
    std::vector<Turns> turns_; ///< at most one
    KeyRemover without_keys_;
    std::vector<double> compared_;
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
