#include <optional>

#include <rotconv/quaternion.hpp>

#include "clock.hpp"
#include "operations.hpp"

namespace rotconv::operations {
namespace {

using stream::NumberRows;

constexpr std::size_t time_and_velocity = 4;

/// A conversion from the unit quaternion, which is never refused.
Conversion conversion_to(const Spec& to, ConversionSettings settings) {
    settings.tolerance = any_defect;
    return {Spec{}, to, settings};
}

class Propagate final : public AttitudeOperation {
public:
    explicit Propagate(const PropagationRows& rows)
        : AttitudeOperation(rows.to, rows.continuous), clock_(rows.time_power),
          velocity_unit_(rows.degrees ? radians_per_degree : 1.0), settings_(rows.conversion),
          stop_at_error_(rows.stop_at_error), propagator_(rows.settings),
          conversion_(conversion_to(rows.to, rows.conversion)) {
        in_order = true;
        looks_ahead = rows.settings.interpolation == Interpolation::cubic;
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Propagate>(*this); }

    std::size_t run_ahead(const NumberRows& rows, bool flush, std::span<double> out,
                          std::vector<RowReport>& reports) override {
        answered_ = 0;
        reports.clear();
        while (pushed_.size() < rows.lines.size()) {
            const auto row = rows.numbers.subspan(pushed_.size() * time_and_velocity, time_and_velocity);
            const double interval = clock_.seconds_to(row[0], rows.kept.empty() ? nullptr : &rows.kept[pushed_.size()]);
            const PushResult pushed =
                propagator_.push(interval, velocity_unit_ * Eigen::Vector3d(row[1], row[2], row[3]));
            if (pushed.refused == Error::none) {
                clock_.accept();
            }
            pushed_.push_back(pushed.refused);
            take(pushed.answer, out, reports);
            if (stop_at_error_ && pushed.refused != Error::none) {
                flush = true;
                break;
            }
        }
        if (flush) {
            take(propagator_.flush(), out, reports);
        }
        pushed_.erase(pushed_.begin(), pushed_.begin() + static_cast<std::ptrdiff_t>(answered_));
        return answered_;
    }

private:
    /// The answer belongs to the first row that was not refused and has no answer yet.
    void take(const std::optional<Propagated>& answer, std::span<double> out, std::vector<RowReport>& reports) {
        report_refused(reports);
        if (answer) {
            const std::size_t size = conversion_.to().size();
            const auto rest = rest_of(out).subspan(is_continuous ? answered_ * size : 0, is_continuous ? size : 0);
            write(*answer, out.subspan(answered_ * size, size), rest, reports);
            ++answered_;
            report_refused(reports);
        }
    }

    void report_refused(std::vector<RowReport>& reports) {
        for (; answered_ < pushed_.size() && pushed_[answered_] != Error::none; ++answered_) {
            reports.push_back({.row = answered_, .error = pushed_[answered_]});
        }
    }

    void write(const Propagated& answer, std::span<double> out, std::span<double> rest,
               std::vector<RowReport>& reports) {
        RowReport& report = reports.emplace_back(
            RowReport{.row = answered_, .defect = answer.attitude.defect(), .deviation = answer.step_error});
        report.error = ended_                                ? Error::ended
                       : report.defect > settings_.tolerance ? Error::defect
                                                             : answer.attitude.error();
        ended_ = report.error != Error::none;
        if (ended_) {
            return;
        }
        const Eigen::Quaterniond q = quaternion::from_rotation(*answer.attitude);
        const std::array<double, 4> numbers{q.w(), q.x(), q.y(), q.z()};
        conversion_.run(numbers, out, converted_, rest);
        if (!converted_.empty()) {
            report.diagnostics = converted_.front().diagnostics;
            report.sensitivity = converted_.front().sensitivity;
        }
        report.diagnostics |= {DiagnosticKind::normalized, report.defect > reported_defect};
        report.diagnostics |= {DiagnosticKind::coarse_step, answer.step_error > reported_step_error};
        if (!settings_.sensitivity && report.diagnostics.empty()) {
            reports.pop_back();
        }
    }

    Clock clock_;
    double velocity_unit_;
    ConversionSettings settings_;
    bool stop_at_error_;
    bool ended_ = false; ///< an answer has failed: the attitude is lost
    Propagator propagator_;
    Conversion conversion_;
    std::vector<RowReport> converted_; ///< of one row
    std::vector<Error> pushed_;        ///< why each row that is pushed and not answered was refused
    std::size_t answered_ = 0;         ///< of the rows at hand
};

} // namespace

stream::RowNumbers propagation_numbers() { return {.names = {"t", "wx", "wy", "wz"}, .kept = 1}; }

Operation propagate(const PropagationRows& rows) { return std::make_shared<Propagate>(rows); }

} // namespace rotconv::operations
