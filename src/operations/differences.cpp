#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "clock.hpp"
#include "operations.hpp"

namespace rotconv::operations {
namespace {

using stream::NumberRows;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The rotation vector of R_BEFORE' R (the inverse of R' R_BEFORE) in body axes, or of R R_BEFORE' in reference axes,
/// from rows of R and then R_BEFORE.
Composition composition_of(const Spec& spec, const RateSettings& settings) {
    const bool of_body = settings.frame == Frame::body;
    Spec inverse = spec;
    inverse.passive = !inverse.passive;
    return {of_body ? inverse : spec,
            of_body ? spec : inverse,
            {.name = RepresentationId::rotvec,
             .unit = settings.degrees ? AngleUnit::degrees : AngleUnit::radians,
             .passive = of_body},
            {.tolerance = settings.tolerance, .sensitivity = settings.sensitivity}};
}

/// Compares each row with the last row before it that was not refused.
class Differences {
public:
    Differences(const Spec& spec, const RateSettings& settings, int time_power)
        : clock_(time_power), size_(spec.size()), composition_(composition_of(spec, settings)) {}

    [[nodiscard]] const auto& first_step() const noexcept { return clock_.first_step(); }

    std::size_t operator()(const NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports,
                           std::span<double> /*rest*/) {
        reports.clear();
        const std::size_t count = rows.lines.size();
        steps_.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            steps_[i].row = i;
        }
        compare(rows);
        Clock clock = clock_;
        refuse(rows, clock);
        if (steps_.size() < count) { // some rows have another row before them now
            compare(rows);
        }
        bool starts = last_.empty();
        const bool waits = starts && !rows.are_last && steps_.size() == 1; // the first row has the second's velocity
        const std::size_t answered = waits ? steps_.front().row : count;
        auto found = found_.cbegin();
        for (std::size_t row = 0, step = 0; row < answered; ++row) {
            if (refused_[row].error != Error::none) {
                reports.push_back(refused_[row]);
                continue;
            }
            RowReport report{.row = row};
            if (found != found_.cend() && found->row == step) {
                report.defect = found->defect;
                report.sensitivity = found->sensitivity;
                report.unusual = found->unusual;
                ++found;
            }
            report.report_numbers();
            report.error = find_velocity(step++, std::exchange(starts, false), out.subspan(row * 3, 3));
            if (composition_.settings().sensitivity || report.error != Error::none || !report.diagnostics.empty()) {
                reports.push_back(report);
            }
        }
        if (!waits && !steps_.empty()) {
            clock_ = clock;
            const auto numbers = numbers_of(rows, steps_.back().row);
            last_.assign(numbers.begin(), numbers.end());
        }
        return answered;
    }

private:
    static constexpr double half_turn = std::numbers::pi - 1e-15;

    struct Step {
        std::size_t row = 0;
        double seconds = 0.0;
    };

    [[nodiscard]] std::span<const double> numbers_of(const NumberRows& rows, std::size_t row) const {
        return std::span(rows.numbers).subspan(row * size_, size_);
    }

    /// Compares the row of each step with the row before it, and the first row with itself.
    void compare(const NumberRows& rows) {
        pairs_.clear();
        std::span<const double> before = last_;
        for (const Step& step : steps_) {
            const auto numbers = numbers_of(rows, step.row);
            before = before.empty() ? numbers : before;
            pairs_.insert(pairs_.end(), numbers.begin(), numbers.end());
            pairs_.insert(pairs_.end(), before.begin(), before.end());
            before = numbers;
        }
        rotvecs_.resize(steps_.size() * 3);
        composition_.run(pairs_, rotvecs_, found_);
    }

    /// Removes the steps of rows without an attitude, or without a time after the last.
    void refuse(const NumberRows& rows, Clock& clock) {
        refused_.assign(rows.lines.size(), {});
        for (const RowReport& report : found_) {
            if (report.error != Error::none && report.at_fault == 0) {
                refused_[report.row] = report;
            }
        }
        bool is_first = last_.empty();
        std::erase_if(steps_, [&](Step& step) {
            RowReport& refused = refused_[step.row];
            refused.row = step.row;
            if (refused.error != Error::none) {
                return true;
            }
            step.seconds = clock.seconds_to(rows, step.row);
            if (std::isnan(step.seconds)) {
                refused.error = Error::not_finite;
            } else if (!is_first && !(step.seconds > 0.0)) {
                refused.error = Error::time_order;
            } else {
                clock.accept(step.seconds, rows.lines[step.row]);
                is_first = false;
            }
            return refused.error != Error::none;
        });
    }

    /// Sets the angular velocity of a step. `starts`: it is the first row, which has the next step's velocity, or nan.
    [[nodiscard]] Error find_velocity(std::size_t step, bool starts, std::span<double> velocity) {
        const std::size_t source = starts ? 1 : step;
        bool known = source < steps_.size();
        if (known) {
            const double seconds = steps_[source].seconds;
            const Eigen::Map<const Eigen::Vector3d> rotvec(rotvecs_.data() + source * 3);
            const double angle =
                rotvec.norm() * (composition_.to().unit == AngleUnit::degrees ? radians_per_degree : 1.0);
            // from half a turn on the body may have turned the other way, also if it keeps its last rate
            known = angle < half_turn && (starts || rate_ * seconds < half_turn);
            std::ranges::transform(rotvec, velocity.begin(), [seconds](double x) { return x / seconds; });
            rate_ = known && !starts ? angle / seconds : 0.0;
        }
        if (!known) {
            std::ranges::fill(velocity, nan);
            return starts ? Error::none : Error::past_half_turn;
        }
        const bool is_finite = std::ranges::all_of(velocity, [](double x) { return std::isfinite(x); });
        return is_finite ? Error::none : Error::overflow;
    }

    Clock clock_;              ///< at the last row
    std::vector<double> last_; ///< the last row's attitude; empty before the first row
    double rate_ = 0.0;        ///< rate of the last step, radians a second; 0 if not known
    std::size_t size_;         ///< numbers of an attitude
    Composition composition_;
    // For the rows at hand, reused:
    std::vector<double> pairs_;
    std::vector<double> rotvecs_;
    std::vector<RowReport> found_;
    std::vector<RowReport> refused_; ///< why each row is not a step
    std::vector<Step> steps_;
};

} // namespace

Operation differences(const Spec& spec, const RateSettings& settings, int time_power) {
    const Differences function(spec, settings, time_power);
    Operation made = operation_of(function, {.names = concatenated({"t"}, names_of(spec)), .attitude = spec, .kept = 1},
                                  velocity_names(settings.degrees));
    made->in_order = true;
    made->first_step = function.first_step();
    return made;
}

} // namespace rotconv::operations
