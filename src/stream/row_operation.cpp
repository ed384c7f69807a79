#include "row_operation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>

#include <rotconv/continuous.hpp>
#include <rotconv/quaternion.hpp>

#include "clock.hpp"
#include "fmt.hpp"

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

/// The numbers of an attitude, perhaps after a key.
RowOperation input_of(const Spec& spec, bool with_key) {
    RowOperation operation{
        .inputs = spec.size(), .input_names = column_names(spec), .from = spec, .names = {}, .run = {}};
    if (with_key) {
        operation.inputs += 1;
        operation.input_names.insert(operation.input_names.begin(), "key");
        operation.kept = 1;
    }
    return operation;
}

/// Rows of a key, n numbers, another key and m numbers without the keys.
std::span<const double> without_keys(std::span<const double> rows, std::size_t n, std::size_t m,
                                     std::vector<double>& room) {
    room.clear();
    for (auto at = rows.begin(); at != rows.end();) {
        for (const std::size_t size : {n, m}) {
            room.insert(room.end(), at + 1, at + 1 + static_cast<std::ptrdiff_t>(size));
            at += 1 + static_cast<std::ptrdiff_t>(size);
        }
    }
    return room;
}

/// A conversion from the unit quaternion, which is never refused.
Conversion conversion_to(const Spec& to, ConversionSettings settings) {
    settings.tolerance = std::numeric_limits<double>::infinity();
    return {Spec{}, to, settings};
}

/// The rows of a propagation and the propagator that remembers them.
class Propagation {
public:
    explicit Propagation(const PropagationRows& rows)
        : clock_(rows.time_power), velocity_unit_(rows.degrees ? radians_per_degree : 1.0), settings_(rows.conversion),
          stop_at_error_(rows.stop_at_error), propagator_(rows.settings),
          conversion_(conversion_to(rows.to, rows.conversion)) {}

    std::size_t run(const NumberRows& rows, bool flush, std::span<double> out, std::vector<RowReport>& reports) {
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
    /// The answer is that of the first row that was not refused and has none.
    void take(const std::optional<Propagated>& answer, std::span<double> out, std::vector<RowReport>& reports) {
        report_refused(reports);
        if (answer) {
            const std::size_t size = conversion_.to().size();
            write(*answer, out.subspan(answered_ * size, size), reports);
            ++answered_;
            report_refused(reports);
        }
    }

    void report_refused(std::vector<RowReport>& reports) {
        for (; answered_ < pushed_.size() && pushed_[answered_] != Error::none; ++answered_) {
            reports.push_back({.row = answered_, .error = pushed_[answered_]});
        }
    }

    void write(const Propagated& answer, std::span<double> out, std::vector<RowReport>& reports) {
        RowReport report{.row = answered_, .defect = answer.attitude.defect(), .deviation = answer.step_error};
        if (ended_) {
            reports.push_back({.row = answered_, .error = Error::ended});
            return;
        }
        const bool drifted = answer.attitude.defect() > settings_.tolerance;
        ended_ = drifted || !answer.attitude;
        if (ended_) {
            report.error = drifted ? Error::defect : answer.attitude.error();
            reports.push_back(report);
            return;
        }
        const Eigen::Quaterniond q = quaternion::from_rotation(*answer.attitude);
        const std::array<double, 4> numbers{q.w(), q.x(), q.y(), q.z()};
        conversion_.run(numbers, out, converted_);
        if (!converted_.empty()) {
            report.diagnostics = converted_.front().diagnostics;
            report.sensitivity = converted_.front().sensitivity;
        }
        report.diagnostics |= {DiagnosticKind::normalized, answer.attitude.defect() > reported_defect};
        report.diagnostics |= {DiagnosticKind::coarse_step, answer.step_error > reported_step_error};
        if (settings_.sensitivity || !report.diagnostics.empty()) {
            reports.push_back(report);
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

/// What a conversion makes of its rows, but for the running.
RowOperation operation_of(const Spec& from, const Spec& to) {
    return {.inputs = from.size(),
            .input_names = column_names(from),
            .from = from,
            .names = column_names(to),
            .attitude = to,
            .run = {}};
}

} // namespace

std::vector<std::string> velocity_names(bool degrees) {
    return degrees ? std::vector<std::string>{"wx_deg_s", "wy_deg_s", "wz_deg_s"}
                   : std::vector<std::string>{"wx", "wy", "wz"};
}

RowOperation conversion_operation(const Conversion& conversion) {
    RowOperation operation = operation_of(conversion.from(), conversion.to());
    operation.run = [conversion](const NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) {
        conversion.run(rows.numbers, out, reports);
    };
    return operation;
}

RowOperation method_operation(const MethodConversion& conversion) {
    RowOperation operation = operation_of(conversion.from(), conversion.to());
    operation.run = [conversion, angles = std::vector<double>()](const NumberRows& rows, std::span<double> out,
                                                                 std::vector<RowReport>& reports) mutable {
        conversion.run(rows.numbers, out, angles, reports);
    };
    return operation;
}

RowOperation all_methods_operation(const MethodConversion& conversion) {
    RowOperation operation = operation_of(conversion.from(), conversion.to());
    const auto names = conversion.names();
    operation.answers.assign(names.begin(), names.end());
    const bool is_taken = std::ranges::find(operation.names, "angle") != operation.names.end(); // by axis-angle
    operation.names.emplace_back(is_taken ? "method_angle" : "angle");
    operation.run = [conversion, angles = std::vector<double>(), numbers = std::vector<double>()](
                        const NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) mutable {
        const std::size_t size = conversion.to().size();
        numbers.resize(out.size() / (size + 1) * size);
        conversion.run(rows.numbers, numbers, angles, reports);
        for (std::size_t i = 0; i < angles.size(); ++i) {
            std::copy_n(numbers.data() + i * size, size, out.data() + i * (size + 1));
            out[i * (size + 1) + size] = angles[i];
        }
    };
    return operation;
}

RowOperation continuous(RowOperation operation) {
    const auto chosen = std::make_shared<ContinuousNumbers>(operation.attitude.value());
    if (chosen->have_choice()) {
        operation.choose = [chosen](std::span<double> results, std::span<const RowReport> reports) {
            chosen->run(results, reports);
        };
    }
    return operation;
}

RowOperation rates_operation(const Spec& spec, const RateSettings& settings, bool sensitivity) {
    const Rates rates(spec, settings);
    const auto velocity = velocity_names(settings.degrees);
    auto input_names = column_names(spec);
    std::ranges::copy(settings.inverse ? rate_names(spec) : velocity_names(false), std::back_inserter(input_names));
    return {.inputs = rates.in_size(),
            .input_names = std::move(input_names),
            .from = spec,
            .names = settings.inverse ? velocity : rate_names(spec),
            .run = [rates, sensitivity, found = std::vector<RateReport>()](
                       const NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) mutable {
                found.resize(rows.lines.size());
                rates.run(rows.numbers, out, found);
                reports.clear();
                for (std::size_t i = 0; i < found.size(); ++i) {
                    const RateReport& rate = found[i];
                    if (sensitivity || rate.error != Error::none || !rate.diagnostics.empty()) {
                        reports.push_back({.row = i,
                                           .error = rate.error,
                                           .diagnostics = rate.diagnostics,
                                           .defect = rate.defect,
                                           .sensitivity = rate.sensitivity});
                    }
                }
            }};
}

RowOperation propagation_operation(const PropagationRows& rows) {
    const auto state = std::make_shared<Propagation>(rows);
    RowOperation operation{.inputs = time_and_velocity,
                           .input_names = {"t", "wx", "wy", "wz"},
                           .kept = 1,
                           .names = column_names(rows.to),
                           .attitude = rows.to,
                           .in_order = true,
                           .run = [state](const NumberRows& given, std::span<double> out,
                                          std::vector<RowReport>& reports) { state->run(given, true, out, reports); }};
    if (rows.settings.interpolation == Interpolation::cubic) {
        operation.run_ahead = [state](const NumberRows& given, bool flush, std::span<double> out,
                                      std::vector<RowReport>& reports) {
            return state->run(given, flush, out, reports);
        };
    }
    return operation;
}

RowOperation comparison_operation(const Comparison& comparison, const ComparisonRows& rows) {
    RowOperation operation = input_of(comparison.from(), rows.by_key);
    if (!rows.paired) {
        operation.inputs = comparison.inputs();
        std::ranges::copy(column_names(comparison.reference()), std::back_inserter(operation.input_names));
    }
    operation.names = {"angle"};
    operation.attitude = comparison.settings().relative;
    if (rows.with_line) {
        operation.names.emplace_back("line");
    } else if (operation.attitude) {
        std::ranges::copy(column_names(*operation.attitude), std::back_inserter(operation.names));
    }
    operation.run = [comparison, rows, room = std::vector<double>(), angles = std::vector<double>()](
                        const NumberRows& given, std::span<double> out, std::vector<RowReport>& reports) mutable {
        const auto numbers =
            rows.by_key ? without_keys(given.numbers, comparison.from().size(), comparison.reference().size(), room)
                        : given.numbers;
        if (!rows.with_line) {
            comparison.run(numbers, out, reports);
            return;
        }
        angles.resize(given.lines.size());
        comparison.run(numbers, angles, reports);
        for (std::size_t i = 0; i < angles.size(); ++i) {
            out[2 * i] = angles[i];
            out[2 * i + 1] = static_cast<double>(given.lines[i]);
        }
    };
    return operation;
}

RowOperation reference_operation(const Spec& spec, bool by_key) { return input_of(spec, by_key); }

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
                                                        std::vector<RowReport>& reports) {
                conversion.run(rows.numbers, out, reports);
                auto report = reports.begin();
                for (std::size_t i = 0; i < rows.lines.size(); ++i) {
                    const bool is_reported = report != reports.end() && report->row == i;
                    if (is_reported && (report++)->error != Error::none) {
                        continue;
                    }
                    const auto q = out.subspan(4 * i, 4);
                    take(Rotation::from_components(q[0], q[1], q[2], q[3]), rows.lines[i]);
                }
            }};
}

RowOperation identification_operation(const IdentificationRows& rows, Identification* identification) {
    RowOperation operation;
    operation.names = {"angle"};
    operation.in_order = true;
    if (rows.by_key) {
        operation.input_names.emplace_back("key");
        operation.kept = 1;
    }
    for (std::size_t i = 0; i < rows.count; ++i) {
        operation.input_names.push_back(fmt::format("n{}", i + 1));
    }
    if (!rows.paired) {
        std::ranges::copy(column_names(rows.known), std::back_inserter(operation.input_names));
    }
    operation.inputs = operation.input_names.size();
    operation.run = [rows, identification, room = std::vector<double>()](
                        const NumberRows& given, std::span<double> /*out*/, std::vector<RowReport>& reports) mutable {
        const auto numbers =
            rows.by_key ? without_keys(given.numbers, rows.count, rows.known.size(), room) : given.numbers;
        identification->add(numbers, given.lines, reports);
    };
    return operation;
}

} // namespace rotconv::stream
