#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <numbers>

#include "clock.hpp"
#include "names.hpp"
#include "operations.hpp"

namespace rotconv::operations {
namespace {

using stream::NumberRows;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Comparison comparison_of(const DifferenceSettings& settings) {
    const Spec vector{.name = RepresentationId::rotvec,
                      .unit = settings.degrees ? AngleUnit::degrees : AngleUnit::radians};
    return {settings.spec,
            settings.spec,
            {.reading = {.tolerance = settings.tolerance, .sensitivity = settings.sensitivity},
             .relative = vector,
             .frame = settings.frame}};
}

/// Compares each row with the last one before it that was not refused.
class Differences final : public stream::RowOperation {
public:
    explicit Differences(const DifferenceSettings& settings)
        : clock_(settings.time_power), size_(settings.spec.size()), comparison_(comparison_of(settings)) {
        names = velocity_names(settings.degrees);
        in_order = true;
        looks_ahead = true;
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Differences>(*this); }

    void run(const NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) override {
        run_ahead(rows, true, out, reports);
    }
    /// A first row waits for the second.
    std::size_t run_ahead(const NumberRows& rows, bool flush, std::span<double> out,
                          std::vector<RowReport>& reports) override {
        reports.clear();
        const std::size_t count = rows.lines.size();
        all_.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            all_[i] = i;
        }
        compare(rows, all_);
        Clock clock = clock_;
        find_steps(rows, clock);
        if (steps_.size() < count) { // others come before some of them
            kept_.clear();
            std::ranges::transform(steps_, std::back_inserter(kept_), &Step::row);
            compare(rows, kept_);
        }
        const bool is_first = last_.empty();
        if (is_first && !flush && steps_.size() < 2) {
            return steps_.empty() ? refuse(count, reports) : refuse(steps_.front().row, reports);
        }
        report_ = found_.begin();
        std::size_t told = 0; // rows before are told of
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            tell_refused(told, steps_[i].row, reports);
            told = steps_[i].row + 1;
            answer(i, is_first, out, reports);
        }
        tell_refused(told, count, reports);
        if (!steps_.empty()) {
            clock_ = clock;
            const auto numbers = numbers_of(rows, steps_.back().row);
            last_.assign(numbers.begin(), numbers.end());
        }
        return count;
    }

private:
    static constexpr std::size_t width = 4; ///< of what is found: the angle and the rotation vector

    struct Step {
        std::size_t row = 0;
        double seconds = 0.0;
    };

    [[nodiscard]] std::span<const double> numbers_of(const NumberRows& rows, std::size_t row) const {
        return rows.numbers.subspan(row * (size_ + 1) + 1, size_);
    }

    /// Each of these rows with the one before it; the first of all with itself.
    void compare(const NumberRows& rows, const std::vector<std::size_t>& chosen) {
        pairs_.clear();
        std::span<const double> before = last_;
        for (const std::size_t row : chosen) {
            const auto numbers = numbers_of(rows, row);
            before = before.empty() ? numbers : before;
            pairs_.insert(pairs_.end(), numbers.begin(), numbers.end());
            pairs_.insert(pairs_.end(), before.begin(), before.end());
            before = numbers;
        }
        turns_.resize(chosen.size() * width);
        comparison_.run(pairs_, turns_, found_);
    }

    /// The rows that have an attitude, and a time after the last; the others are refused.
    void find_steps(const NumberRows& rows, Clock& clock) {
        steps_.clear();
        refused_.assign(rows.lines.size(), {});
        for (const RowReport& report : found_) {
            if (report.error != Error::none && !report.of_reference) {
                refused_[report.row] = report;
            }
        }
        for (std::size_t i = 0; i < rows.lines.size(); ++i) {
            RowReport& refused = refused_[i];
            refused.row = i;
            if (refused.error != Error::none) {
                continue;
            }
            const double seconds =
                clock.seconds_to(rows.numbers[i * (size_ + 1)], rows.kept.empty() ? nullptr : &rows.kept[i]);
            const bool is_first = last_.empty() && steps_.empty();
            if (std::isnan(seconds)) {
                refused.error = Error::not_finite;
            } else if (!is_first && !(seconds > 0.0)) {
                refused.error = Error::time_order;
            } else {
                clock.accept();
                steps_.push_back({i, seconds});
            }
        }
    }

    void tell_refused(std::size_t begin, std::size_t end, std::vector<RowReport>& reports) const {
        for (std::size_t i = begin; i < end; ++i) {
            reports.push_back(refused_[i]);
        }
    }

    /// Nothing but refused rows is there to tell of.
    std::size_t refuse(std::size_t count, std::vector<RowReport>& reports) const {
        tell_refused(0, count, reports);
        return count;
    }

    void answer(std::size_t step, bool is_first_row, std::span<double> out, std::vector<RowReport>& reports) {
        const std::size_t row = steps_[step].row;
        RowReport report = report_of(step);
        const bool starts = is_first_row && step == 0;
        const std::size_t source = starts ? 1 : step;
        const bool known = source < steps_.size() && turns(source, starts ? 0.0 : rate_, out.subspan(row * 3, 3));
        if (starts && !known) {
            std::fill_n(out.begin() + static_cast<std::ptrdiff_t>(row * 3), 3, nan);
        } else if (!known) {
            report.error = Error::past_half_turn;
        } else if (!std::ranges::all_of(out.subspan(row * 3, 3), [](double x) { return std::isfinite(x); })) {
            report.error = Error::overflow;
        }
        rate_ = known && !starts ? turns_[source * width] / steps_[source].seconds : 0.0;
        if (comparison_.settings().reading.sensitivity || report.error != Error::none || !report.diagnostics.empty()) {
            reports.push_back(report);
        }
    }

    /// The angular velocity of a step; false where the body may have turned by half a turn or more, as it would have at
    /// the rate before.
    bool turns(std::size_t step, double rate_before, std::span<double> velocity) const {
        const double seconds = steps_[step].seconds;
        const double* const turn = turns_.data() + step * width;
        if (turn[0] >= half_turn || rate_before * seconds >= half_turn) {
            return false;
        }
        std::transform(turn + 1, turn + width, velocity.begin(), [seconds](double x) { return x / seconds; });
        return true;
    }

    /// What the comparison has found of a step's own attitude.
    RowReport report_of(std::size_t step) {
        RowReport report;
        if (report_ != found_.end() && report_->row == step) {
            report.defect = report_->defect;
            report.sensitivity = report_->sensitivity;
            ++report_;
        }
        report.row = steps_[step].row;
        report.diagnostics |= {DiagnosticKind::normalized, report.defect > reported_defect};
        return report;
    }

    static constexpr double half_turn = std::numbers::pi - 1e-15;

    Clock clock_;              ///< of the last row
    std::vector<double> last_; ///< its attitude; empty before the first
    double rate_ = 0.0;        ///< radians a second of the last step; 0 where that is not known
    std::size_t size_;         ///< numbers of an attitude
    Comparison comparison_;
    // Of the rows at hand, reused.
    std::vector<std::size_t> all_;
    std::vector<std::size_t> kept_;
    std::vector<double> pairs_;
    std::vector<double> turns_;
    std::vector<RowReport> found_;
    std::vector<RowReport>::const_iterator report_; ///< the next of them
    std::vector<RowReport> refused_;                ///< of each row why it is no step
    std::vector<Step> steps_;
};

} // namespace

stream::RowNumbers difference_numbers(const Spec& spec) {
    return {.names = joined({"t"}, names_of(spec)), .attitude = spec, .kept = 1};
}

Operation differences(const DifferenceSettings& settings) { return std::make_shared<Differences>(settings); }

} // namespace rotconv::operations
