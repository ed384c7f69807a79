#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include <rotconv/quaternion.hpp>

#include "../core/interpolation.hpp"
#include "../stream/fmt.hpp"
#include "operations.hpp"

namespace rotconv::operations {
namespace {

constexpr double no_angle = std::numeric_limits<double>::quiet_NaN();

void append(std::vector<double>& to, std::span<const double> numbers) {
    to.insert(to.end(), numbers.begin(), numbers.end());
}

Rotation rotation_at(const double* q) noexcept { return Rotation::near_unit(q[0], q[1], q[2], q[3]); }

std::array<double, 4> components_of(const Rotation& q) noexcept { return {q.w(), q.x(), q.y(), q.z()}; }

/// The report on the row among reports in the order of the rows; an empty one is added if there is none.
RowReport& report_of(std::size_t row, std::vector<RowReport>& reports) {
    const auto place = std::ranges::lower_bound(reports, row, {}, &RowReport::row);
    return place != reports.end() && place->row == row ? *place : *reports.insert(place, {.row = row});
}

/// The comparison of some of the rows at hand.
struct SomeRows {
    explicit SomeRows(const Comparison& comparison_) : comparison(comparison_) {}

    void clear() noexcept {
        rows.clear();
        numbers.clear();
    }
    /// Compares them, and puts the results in their places among rows of `width` numbers.
    void run(std::span<double> to, std::size_t width) {
        const std::size_t size = comparison.outputs();
        out.resize(rows.size() * size);
        comparison.run(numbers, out, reports);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            std::copy_n(out.data() + i * size, size, to.data() + rows[i] * width);
        }
        std::ranges::for_each(reports, [this](RowReport& report) { report.row = rows[report.row]; });
    }

    Comparison comparison;
    std::vector<std::size_t> rows; ///< their indices among all
    std::vector<double> numbers;
    std::vector<double> out;
    std::vector<RowReport> reports; ///< by the indices among all
};

/// Compares attitudes with a reference that lies between two rows.
class ComparisonBetween {
public:
    explicit ComparisonBetween(const Comparison& comparison)
        : at_(comparison), between_(Comparison(comparison.from(), Spec{}, comparison.settings())),
          reading_(comparison.reference(), Spec{},
                   {.tolerance = comparison.settings().reading.tolerance,
                    .sensitivity = comparison.settings().reading.sensitivity}) {}

    /// Like Comparison::run(), of rows as stream::Pairing has them. A row between attitudes that are half a turn apart
    /// has the error past_half_turn.
    void run(std::span<const double> rows, std::span<double> out, std::vector<RowReport>& reports) {
        const std::size_t n = at_.comparison.from().size();
        const std::size_t m = at_.comparison.reference().size();
        const std::size_t width = 1 + n + 1 + m + m + 1;
        const std::size_t count = rows.size() / width;
        numbers_.clear();
        for (std::size_t i = 0; i < count; ++i) {
            append(numbers_, rows.subspan(i * width + 2 + n, 2 * m));
        }
        neighbours_.resize(8 * count);
        reading_.run(numbers_, neighbours_, neighbour_reports_);
        at_.clear();
        between_.clear();
        reports.clear();
        for (std::size_t i = 0; i < count; ++i) {
            const auto row = rows.subspan(i * width, width);
            SomeRows& some = row.back() > 0.0 ? between_ : at_; // the reference has the row's key: its own numbers
            some.rows.push_back(i);
            append(some.numbers, row.subspan(1, n));
            if (row.back() > 0.0) {
                append(some.numbers, attitude_between(i, row.back(), reports));
            } else {
                append(some.numbers, row.subspan(2 + n, m));
            }
        }
        const std::size_t size = at_.comparison.outputs();
        for (SomeRows* some : {&at_, &between_}) {
            some->run(out, size);
            for (const RowReport& report : some->reports) { // its own error counts before those of the neighbours
                RowReport& found = report_of(report.row, reports);
                found = found.error != Error::none && report.error == Error::none ? found : report;
            }
        }
        for (const RowReport& report : neighbour_reports_) {
            const std::size_t row = report.row / 2;
            const bool is_later = report.row % 2 == 1;
            const bool is_between = rows[(row + 1) * width - 1] > 0.0;
            if (!is_between || (is_later && report.error == Error::none)) { // the row after it tells of the later
                continue;
            }
            RowReport& found = report_of(row, reports);
            if (found.error == Error::none && report.error != Error::none) {
                found = {.row = row,
                         .error = report.error,
                         .of_reference = true,
                         .of_later = is_later,
                         .defect = report.defect};
            } else if (found.error == Error::none) {
                found.reference_defect = report.defect;
                found.reference_unusual = report.unusual;
                found.diagnostics |= report.diagnostics;
            }
        }
        for (const RowReport& report : reports) {
            if (report.error != Error::none) {
                std::fill_n(out.data() + report.row * size, size, no_angle);
            }
        }
    }

private:
    /// The quaternion at the fraction; the identity where there is none.
    [[nodiscard]] std::array<double, 4> attitude_between(std::size_t row, double fraction,
                                                         std::vector<RowReport>& reports) const {
        const Rotation earlier = rotation_at(neighbours_.data() + 8 * row);
        const Rotation later = rotation_at(neighbours_.data() + 8 * row + 4);
        if (std::isnan(earlier.w()) || std::isnan(later.w())) {
            return {1.0}; // which is reported of them
        }
        const auto found = interpolated(earlier, later, fraction);
        if (!found) {
            reports.push_back({.row = row, .error = Error::past_half_turn, .of_reference = true});
        }
        return components_of(found.value_or(Rotation()));
    }

    SomeRows at_;
    SomeRows between_;   ///< with the quaternion between the neighbours
    Conversion reading_; ///< of the neighbours
    std::vector<double> numbers_;
    std::vector<double> neighbours_; ///< of each row the earlier and the later, as quaternions
    std::vector<RowReport> neighbour_reports_;
};

/// Compares the turns from pairs of attitudes to the N-th pair after them. Remembers N pairs.
class ComparisonOfTurns {
public:
    ComparisonOfTurns(std::size_t delta, ComparisonSettings settings)
        : delta_(delta), turns_([&] {
              settings.reading.left.reset(); // the attitudes are turned
              settings.reading.right.reset();
              settings.reading.tolerance = any_defect;
              settings.attitudes = false;
              return Comparison({}, {}, settings);
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
        attitude = settings.relative;
        unit = settings.unit == AngleUnit::degrees ? "deg" : "rad";
        if (attitude) {
            names = joined(names, names_of(*attitude));
        }
        if (rows.delta > 0) {
            turns_.emplace(rows.delta, settings);
            in_order = true;
            settings.within = std::numeric_limits<double>::infinity();
        }
        if (rows.as_numbers || rows.delta > 0) {
            settings.attitudes = true;
            settings.relative.reset();
        }
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
        compared_.resize(turns_ ? rows.lines.size() * comparison_.outputs() : 0);
        const std::span<double> compared = turns_ ? std::span(compared_) : out;
        std::span<const double> attitudes = rows.numbers;
        if (between_) {
            between_->run(rows.numbers, compared, reports);
            attitudes = comparison_.settings().attitudes ? with_quaternions(rows, compared) : attitudes;
        } else {
            if (rows_.by_key) {
                attitudes_ = without_keys(rows.numbers, comparison_.from().size(), comparison_.reference().size());
                attitudes = attitudes_;
            }
            comparison_.run(attitudes, compared, reports);
        }
        if (turns_) {
            turns_->compare(compared, out, names.size(), reports);
        }
        watch_->add(rows, attitudes, comparison_.from().size(), rows_.by_key, out, names.size());
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
    std::optional<ComparisonBetween> between_; ///< where the reference is interpolated
    std::optional<ComparisonOfTurns> turns_;   ///< where there is a delta
    std::vector<double> compared_;             ///< before the turns
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
        beyond_ += angle > limit_ ? 1 : 0;
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
