#include <optional>

#include <rotconv/quaternion.hpp>

#include "clock.hpp"
#include "operations.hpp"

namespace rotconv::operations {
namespace {

using stream::NumberRows;

Eigen::Vector3d velocity_of(const NumberRows& rows, std::size_t row) noexcept {
    return Eigen::Map<const Eigen::Vector3d>(rows.numbers.data() + 3 * row);
}

/// A conversion from the unit quaternion, which is never refused.
Conversion conversion_to(const Spec& to, ConversionSettings settings) {
    settings.tolerance = any_defect;
    return {Spec{}, to, settings};
}

class Propagate {
public:
    explicit Propagate(const PropagationRows& rows)
        : clock_(rows.time_power), velocity_unit_(rows.degrees ? radians_per_degree : 1.0), settings_(rows.conversion),
          stop_at_error_(rows.stop_at_error), propagator_(rows.settings),
          conversion_(conversion_to(rows.to, rows.conversion)) {}

    [[nodiscard]] const auto& first_step() const noexcept { return clock_.first_step(); }

    std::size_t operator()(const NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports,
                           std::span<double> rest) {
        bool flush = rows.are_last;
        answered_ = 0;
        quaternions_.clear();
        reports.clear();
        while (pushed_.size() < rows.lines.size()) {
            const std::size_t row = pushed_.size();
            const double interval = clock_.seconds_to(rows, row);
            const PushResult pushed = propagator_.push(interval, velocity_unit_ * velocity_of(rows, row));
            if (pushed.refused == Error::none) {
                clock_.accept(interval, rows.lines[row]);
            }
            pushed_.push_back(pushed.refused);
            take(pushed.answer, reports);
            if (stop_at_error_ && pushed.refused != Error::none) {
                flush = true;
                break;
            }
        }
        if (flush) {
            take(propagator_.flush(), reports);
        }
        convert(rows, out, reports, rest);
        pushed_.erase(pushed_.begin(), pushed_.begin() + static_cast<std::ptrdiff_t>(answered_));
        return answered_;
    }

private:
    /// An attitude belongs to the first row that was not refused and has no result yet.
    void take(const std::optional<Propagated>& made, std::vector<RowReport>& reports) {
        report_refused(reports);
        if (made) {
            RowReport& report = reports.emplace_back(
                RowReport{.row = answered_, .defect = made->attitude.defect(), .deviation = made->step_error});
            report.error = ended_                                ? Error::ended
                           : report.defect > settings_.tolerance ? Error::defect
                                                                 : made->attitude.error();
            ended_ = report.error != Error::none;
            report.unusual.defect = !ended_ && report.defect > reported_defect ? report.defect : 0.0;
            report.report_numbers();
            report.diagnostics |= {DiagnosticKind::coarse_step, !ended_ && made->step_error > reported_step_error};
            add(ended_ ? Rotation() : *made->attitude);
            report_refused(reports);
        }
    }

    void report_refused(std::vector<RowReport>& reports) {
        while (answered_ < pushed_.size() && pushed_[answered_] != Error::none) {
            reports.push_back({.row = answered_, .error = pushed_[answered_]});
            add({});
        }
    }

    void add(const Rotation& attitude) {
        const Eigen::Quaterniond q = quaternion::from_rotation(attitude);
        quaternions_.insert(quaternions_.end(), {q.w(), q.x(), q.y(), q.z()});
        ++answered_;
    }

    /// Converts the attitudes of the answered rows; of their reports, one for each, the empty ones are removed.
    void convert(const NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports,
                 std::span<double> rest) {
        conversion_.run(quaternions_, out, converted_, rest);
        for (const RowReport& converted : converted_) {
            RowReport& report = reports[converted.row];
            if (report.error == Error::none) {
                report.diagnostics |= converted.diagnostics;
                report.sensitivity = converted.sensitivity;
            }
        }
        for (RowReport& report : reports) {
            report.unusual.angle = velocity_unit_ == 1.0 ? velocity_of(rows, report.row).norm() : 0.0;
            report.diagnostics |=
                {DiagnosticKind::large_angle, report.error == Error::none && report.unusual.angle > reported_velocity};
        }
        if (!settings_.sensitivity) {
            std::erase_if(reports, [](const RowReport& report) {
                return report.error == Error::none && report.diagnostics.empty();
            });
        }
    }

    Clock clock_;
    double velocity_unit_;
    ConversionSettings settings_;
    bool stop_at_error_;
    bool ended_ = false; ///< an attitude has failed: those after it are lost
    Propagator propagator_;
    Conversion conversion_;
    std::vector<double> quaternions_; ///< of the answered rows; the identity for those with errors
    std::vector<RowReport> converted_;
    std::vector<Error> pushed_; ///< for each row pushed and not answered, why it was refused
    std::size_t answered_ = 0;  ///< how many of the rows at hand are answered
};

} // namespace

Operation propagate(const PropagationRows& rows) {
    const Propagate function(rows);
    Operation made = operation_of(function, {.names = {"t", "wx", "wy", "wz"}, .kept = 1}, rows.to, rows.continuous);
    made->in_order = true;
    made->first_step = function.first_step();
    return made;
}

} // namespace rotconv::operations
