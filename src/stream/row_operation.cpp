#include "row_operation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>

#include <rotconv/quaternion.hpp>

#include "decimal.hpp"

namespace rotconv::stream {
namespace {

constexpr std::size_t time_and_velocity = 4;

std::vector<std::string> column_names(const Spec& spec) {
    const auto columns = spec.columns();
    return {columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(spec.size())};
}

std::vector<std::string> rate_names(const Spec& spec) {
    auto names = column_names(spec);
    std::ranges::for_each(names, [](std::string& name) { name += "_rate"; });
    return names;
}

/// A conversion from the unit quaternion, which is never refused.
Conversion conversion_to(const Spec& to, Settings settings) {
    settings.tolerance = std::numeric_limits<double>::infinity();
    return {Spec{}, to, settings};
}

Report failed(Error error) {
    Report report;
    report.error = error;
    return report;
}

/// The times of rows that are accepted.
class Clock {
public:
    explicit Clock(int power) : power_(power) {
        for (int i = power; i < 0; ++i) {
            per_second_ *= 10.0;
        }
    }

    /// Seconds since the last accepted time, rounded once where times are texts; nan for a time that is none.
    double seconds_to(double time, const std::string_view* text) {
        if (!std::isfinite(time)) {
            return std::numeric_limits<double>::quiet_NaN();
        }
        if (text != nullptr) {
            next_text_ = Decimal::parse(*text).value_or(Decimal());
            return (next_text_ - last_text_).rounded(power_);
        }
        next_ = time;
        return (next_ - last_) / per_second_;
    }
    void accept() {
        std::swap(last_text_, next_text_);
        last_ = next_;
    }

private:
    int power_;
    double per_second_ = 1.0;
    Decimal last_text_;
    Decimal next_text_;
    double last_ = 0.0;
    double next_ = 0.0;
};

/// The rows of a propagation and the propagator that remembers them.
class Propagation {
public:
    explicit Propagation(const PropagationRows& rows)
        : clock_(rows.time_power), velocity_unit_(rows.degrees ? radians_per_degree : 1.0),
          tolerance_(rows.conversion.tolerance), stop_at_error_(rows.stop_at_error), propagator_(rows.settings),
          conversion_(conversion_to(rows.to, rows.conversion)) {}

    std::size_t run(const NumberRows& rows, std::span<double> out, std::span<Report> reports) {
        answered_ = 0;
        bool flush = rows.flush;
        while (pushed_.size() < reports.size()) {
            const auto row = rows.numbers.subspan(pushed_.size() * time_and_velocity, time_and_velocity);
            const double interval = clock_.seconds_to(row[0], rows.kept.empty() ? nullptr : &rows.kept[pushed_.size()]);
            const Pushed pushed = propagator_.push(interval, velocity_unit_ * Eigen::Vector3d(row[1], row[2], row[3]));
            if (pushed.refused == Error::none) {
                clock_.accept();
            }
            pushed_.push_back(pushed.refused);
            settle(pushed.answer, out, reports);
            if (stop_at_error_ && pushed.refused != Error::none) {
                flush = true;
                break;
            }
        }
        if (flush) {
            settle(propagator_.settle(), out, reports);
        }
        pushed_.erase(pushed_.begin(), pushed_.begin() + static_cast<std::ptrdiff_t>(answered_));
        return answered_;
    }

private:
    /// The answer is that of the first row that was not refused and has none.
    void settle(const std::optional<Propagated>& answer, std::span<double> out, std::span<Report> reports) {
        report_refused(reports);
        if (answer) {
            const std::size_t size = conversion_.to().size();
            write(*answer, out.subspan(answered_ * size, size), reports[answered_]);
            ++answered_;
            report_refused(reports);
        }
    }

    void report_refused(std::span<Report> reports) {
        for (; answered_ < pushed_.size() && pushed_[answered_] != Error::none; ++answered_) {
            reports[answered_] = failed(pushed_[answered_]);
        }
    }

    void write(const Propagated& answer, std::span<double> out, Report& report) {
        if (ended_) {
            report = failed(Error::ended);
            return;
        }
        const bool drifted = answer.defect > tolerance_;
        ended_ = drifted || answer.error != Error::none;
        if (ended_) {
            report = failed(drifted ? Error::defect : answer.error);
            report.defect = answer.defect;
            return;
        }
        const Eigen::Quaterniond q = quaternion::from_rotation(answer.rotation);
        const std::array<double, 4> numbers{q.w(), q.x(), q.y(), q.z()};
        conversion_.run(numbers, out, {&report, 1});
        report.defect = answer.defect;
        report.deviation = answer.step_error;
        report.diagnostics |= {DiagnosticKind::normalized, answer.defect > reported_defect};
        report.diagnostics |= {DiagnosticKind::coarse_step, answer.step_error > reported_step_error};
    }

    Clock clock_;
    double velocity_unit_;
    double tolerance_;
    bool stop_at_error_;
    bool ended_ = false; ///< an answer has failed: the attitude is lost
    Propagator propagator_;
    Conversion conversion_;
    std::vector<Error> pushed_; ///< why each row that is pushed and not answered was refused
    std::size_t answered_ = 0;  ///< of the rows at hand
};

/// What a conversion makes of its rows, whether rotconv's own or a method's.
template <class AnyConversion> RowOperation operation_of(const AnyConversion& conversion) {
    return {.inputs = conversion.from().size(),
            .input_names = column_names(conversion.from()),
            .from = conversion.from(),
            .names = column_names(conversion.to()),
            .attitude = conversion.to(),
            .run = [conversion](const NumberRows& rows, std::span<double> out, std::span<Report> reports) {
                conversion.run(rows.numbers, out, reports);
                return reports.size();
            }};
}

} // namespace

RowOperation conversion_operation(const Conversion& conversion) { return operation_of(conversion); }

RowOperation method_operation(const MethodConversion& conversion) { return operation_of(conversion); }

RowOperation rates_operation(const Spec& spec, const RateSettings& settings) {
    const Rates rates(spec, settings);
    const bool has_lock = representation(spec.name).has_gimbal_lock;
    const std::vector<std::string> velocity{"wx", "wy", "wz"};
    auto input_names = column_names(spec);
    std::ranges::copy(settings.inverse ? rate_names(spec) : velocity, std::back_inserter(input_names));
    return {
        .inputs = rates.in_size(),
        .input_names = std::move(input_names),
        .from = spec,
        .names = settings.inverse ? velocity : rate_names(spec),
        .run = [rates, has_lock, found = std::vector<RateReport>()](const NumberRows& rows, std::span<double> out,
                                                                    std::span<Report> reports) mutable {
            found.resize(reports.size());
            rates.run(rows.numbers, out, found);
            std::ranges::transform(found, reports.begin(), [has_lock](const RateReport& rate) {
                DiagnosticSet notes(DiagnosticKind::normalized, rate.defect > reported_defect);
                notes |=
                    {DiagnosticKind::near_gimbal_lock, has_lock && rate.sensitivity.condition > near_lock_condition};
                return Report{
                    .error = rate.error, .diagnostics = notes, .defect = rate.defect, .sensitivity = rate.sensitivity};
            });
            return reports.size();
        }};
}

RowOperation propagation_operation(const PropagationRows& rows) {
    return {.inputs = time_and_velocity,
            .input_names = {"t", "wx", "wy", "wz"},
            .kept = 1,
            .names = column_names(rows.to),
            .attitude = rows.to,
            .in_order = true,
            .run = [state = std::make_shared<Propagation>(rows)](const NumberRows& given, std::span<double> out,
                                                                 std::span<Report> reports) {
                return state->run(given, out, reports);
            }};
}

RowOperation reading_operation(const Spec& from, double tolerance,
                               std::function<void(const Rotation& rotation, std::size_t line)> take) {
    const Conversion conversion(from, Spec{}, {.tolerance = tolerance});
    return {.inputs = from.size(),
            .input_names = column_names(from),
            .from = from,
            .names = column_names(Spec{}),
            .attitude = Spec{},
            .in_order = true,
            .run = [conversion, take = std::move(take)](const NumberRows& rows, std::span<double> out,
                                                        std::span<Report> reports) {
                conversion.run(rows.numbers, out, reports);
                for (std::size_t i = 0; i < reports.size(); ++i) {
                    if (reports[i].error == Error::none) {
                        const auto q = out.subspan(4 * i, 4);
                        take(Rotation::from_components(q[0], q[1], q[2], q[3]), rows.lines[i]);
                    }
                }
                return reports.size();
            }};
}

} // namespace rotconv::stream
