#include <rotconv/conversion.hpp>
#include <rotconv/rates.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "../conversion/input_batch.hpp"
#include "../numerics/power_of_two.hpp"

namespace rotconv {
namespace {

using Numbers = std::array<double, 9>;
using Eigen::Vector3d;

/// Where the equation itself is singular. A representation that switches its chart at a half-turn, where the range of
/// its numbers ends, has an equation that goes on: the condition of a rotation vector is pi/2 there, that of an mrp
/// 1/2.
bool is_singular(const Codec& codec, const Sensitivity& sensitivity) noexcept {
    return sensitivity.margin <= singular_margin && (codec.switch_chart == nullptr || sensitivity.condition > 2.0);
}

/// The axes of the inverse rotation's angular velocity where those of the rotation's are `frame`; its components are
/// the negative ones.
constexpr Frame inverse_of(Frame frame) noexcept { return frame == Frame::body ? Frame::reference : Frame::body; }

} // namespace

bool has_rates(RepresentationId name) noexcept { return codec_of(name).rate != nullptr; }

Rates::Rates(const Spec& spec, const RateSettings& settings) : spec_(checked(spec)), settings_(settings) {
    if (!has_rates(spec.name)) {
        throw std::invalid_argument("rotconv: this representation has no rates");
    }
}

void Rates::run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports) const {
    reports.clear();
    const std::size_t rows = checked_rows(in.size(), in_size(), out.size(), out_size());
    report_rows(
        0, rows, out.data(), out_size(), settings_.sensitivity, reports, [](std::size_t /*row*/) { return true; },
        [&](std::size_t row) {
            double* const to = out.data() + row * out_size();
            RowReport report = run_row(in.data() + row * in_size(), to);
            const bool overflows = report.error == Error::none && !all_finite(to, out_size());
            report.error = overflows ? Error::overflow : report.error;
            return report;
        },
        [](std::size_t /*row*/, RowReport& /*report*/) {});
}

RowReport Rates::run_row(const double* in, double* out) const noexcept {
    if (!all_finite(in, in_size())) {
        return {.error = Error::not_finite};
    }
    Numbers numbers{};
    Numbers rates{};
    to_own_order(spec_, in, 1, numbers.data());
    const double* const given = in + spec_.size(); // rates, or an angular velocity

    const Codec& codec = codec_of(spec_.name);
    const Reading reading = read_row(spec_, numbers.data());
    RowReport report =
        report_of(spec_, numbers.data(), reading.error(), reading.defect(), settings_.tolerance, settings_.sensitivity);
    if (report.error != Error::none) {
        return report;
    }
    const Sensitivity sensitivity = codec.sensitivity_of_numbers == nullptr
                                        ? codec.sensitivity(spec_, *reading)
                                        : codec.sensitivity_of_numbers(spec_, numbers.data(), *reading);
    if (is_singular(codec, sensitivity)) {
        return {.error = Error::singular, .defect = report.defect, .sensitivity = sensitivity};
    }
    report.sensitivity = sensitivity;
    const double speed = settings_.degrees || settings_.inverse ? 0.0 : Vector3d(given).norm();
    report.unusual.angle = std::max(report.unusual.angle, speed > reported_velocity ? speed : 0.0);
    report.report_numbers();
    report.diagnostics |= {DiagnosticKind::near_gimbal_lock,
                           codec.representation.has_gimbal_lock && report.sensitivity.condition > near_lock_condition};

    const Frame frame = spec_.passive ? inverse_of(settings_.frame) : settings_.frame;
    const double sign = spec_.passive ? -1.0 : 1.0;

    const double radians = settings_.degrees ? radians_per_degree : 1.0;
    if (settings_.inverse) {
        to_own_order(spec_, given, 1, rates.data());
        const Vector3d w = codec.angular_velocity(spec_, numbers.data(), rates.data(), frame);
        Eigen::Map<Eigen::Array3d>{out} = sign * w.array() / radians + 0.0; // -0 becomes 0
        return report;
    }
    const Vector3d w = (sign * radians) * Vector3d(given);
    codec.rate(spec_, numbers.data(), w, frame, rates.data());
    to_written_order(spec_, rates.data(), 1, out);
    return report;
}

} // namespace rotconv
