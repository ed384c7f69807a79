#include <rotconv/conversion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>

#include "numerics/angles.hpp"
#include "representations/codec.hpp"

namespace rotconv {
namespace {

constexpr std::size_t widest = 9;

/// The order where it is not 0, 1, 2, ...
bool reordered(const Spec& spec) noexcept {
    const auto order = spec.order();
    return !std::ranges::is_sorted(order);
}

/// Takes each row from the order in which it is written to the representation's own.
void to_own_order(const Spec& spec, const double* written, std::size_t rows, double* own) noexcept {
    const auto order = spec.order();
    const std::size_t size = spec.size();
    for (std::size_t row = 0; row < rows; ++row, written += size, own += size) {
        for (std::size_t i = 0; i < size; ++i) {
            own[order[i]] = written[i];
        }
    }
}

/// The way back, in place, of rows of so many numbers.
template <std::size_t size> void to_written_order(const Spec& spec, double* numbers, std::size_t rows) noexcept {
    const auto order = spec.order();
    for (std::size_t row = 0; row < rows; ++row, numbers += size) {
        std::array<double, size> own; // NOLINT(*-member-init)
        std::copy_n(numbers, size, own.begin());
        for (std::size_t i = 0; i < size; ++i) {
            numbers[i] = own[order[i]];
        }
    }
}

/// The numbers of the inverse rotation, of a representation that methods start from.
void invert(RepresentationId name, double* numbers) noexcept {
    if (name == RepresentationId::dcm) {
        std::swap(numbers[1], numbers[3]);
        std::swap(numbers[2], numbers[6]);
        std::swap(numbers[5], numbers[7]);
        return;
    }
    const std::size_t first = name == RepresentationId::quat ? 1 : 0; // of the vector
    for (std::size_t i = first; i < first + 3; ++i) {
        numbers[i] = -numbers[i];
    }
}

/// The sign of a quaternion that is printed.
void make_sign_canonical(double* q) noexcept {
    const double* const leader = std::find_if(q, q + 4, [](double component) { return component != 0.0; });
    if (leader != q + 4 && *leader < 0.0) {
        std::transform(q, q + 4, q, std::negate<>());
    }
}

/// Rotation angle from one to the other, in radians.
double angle_between(const Rotation& p, const Rotation& q) noexcept {
    const double w = (p.w() * q.w() + p.x() * q.x()) + (p.y() * q.y() + p.z() * q.z());
    const double x = (p.w() * q.x() - p.x() * q.w()) - (p.y() * q.z() - p.z() * q.y());
    const double y = (p.w() * q.y() - p.y() * q.w()) - (p.z() * q.x() - p.x() * q.z());
    const double z = (p.w() * q.z() - p.z() * q.w()) - (p.x() * q.y() - p.y() * q.x());
    return 2.0 * std::atan2(std::sqrt((x * x + y * y) + z * z), std::fabs(w));
}

} // namespace

Conversion::Conversion(const Spec& from, const Spec& to, const Settings& settings)
    : from_(from), to_(to), settings_(settings), in_codec_(&codec_of(from.name)), out_codec_(&codec_of(to.name)) {
    if (settings.method != nullptr && !settings.method->serves(from.name, to.name)) {
        throw std::invalid_argument("a method of another pair");
    }
}

void Conversion::run(std::span<const double> in, std::span<double> out, std::span<Report> reports) const noexcept {
    const double* from = in.data();
    double* to = out.data();
    while (!reports.empty()) {
        const std::size_t rows = std::min(batch_rows, reports.size());
        run_batch(from, to, reports.first(rows));
        from += rows * from_.size();
        to += rows * to_.size();
        reports = reports.subspan(rows);
    }
}

void Conversion::run_batch(const double* in, double* out, std::span<Report> reports) const noexcept {
    const std::size_t rows = reports.size();
    std::array<double, batch_rows * widest> own_order; // NOLINT(*-member-init): written before it is read
    if (reordered(from_)) {
        to_own_order(from_, in, rows, own_order.data());
        in = own_order.data();
    }
    Readings readings; // NOLINT(*-member-init)
    in_codec_->read(from_, in, rows, readings);
    if (from_.passive != to_.passive) {
        for (std::size_t i = 0; i < rows; ++i) {
            readings.w[i] = -readings.w[i];
        }
    }
    std::array<DiagnosticSet, batch_rows> diagnostics; // NOLINT(*-member-init)
    out_codec_->write(to_, settings_.lock_margin, readings, rows, out, diagnostics.data());
    std::array<double, batch_rows> method_errors; // NOLINT(*-member-init)
    const bool by_method = settings_.method != nullptr && settings_.method->run != nullptr;
    if (by_method) {
        run_method(in, readings, rows, out, diagnostics.data(), method_errors.data());
    }
    const std::size_t width = to_.size();
    for (std::size_t i = 0; i < rows * width; ++i) {
        out[i] += 0.0; // -0 becomes 0
    }
    if (reordered(to_)) {
        (to_.size() == 4 ? to_written_order<4> : to_written_order<9>)(to_, out, rows); // a quaternion or a matrix
    }
    const double unremarkable = settings_.sensitivity ? -1.0 : std::min(settings_.tolerance, reported_defect);
    for (std::size_t i = 0; i < rows; ++i) {
        const bool remarkable =
            !(readings.defect[i] <= unremarkable) || readings.error[i] != Error::none || !diagnostics[i].empty();
        reports[i] = {};
        reports[i].defect = readings.defect[i];
        if (remarkable) {
            reports[i] = report(readings.reading(i), diagnostics[i], in + i * from_.size());
        }
        reports[i].method_error = by_method ? method_errors[i] : 0.0;
        if (reports[i].error != Error::none) {
            std::fill_n(out + i * width, width, std::numeric_limits<double>::quiet_NaN());
        }
    }
}

void Conversion::run_method(const double* in, const Rotations& rotations, std::size_t rows, double* out,
                            DiagnosticSet* diagnostics, double* errors) const noexcept {
    // What the methods do not know of is done to the numbers: the inverse, and degrees.
    std::array<double, batch_rows * widest> active; // NOLINT(*-member-init): written before it is read
    const std::size_t in_size = from_.size();
    std::copy_n(in, rows * in_size, active.begin());
    if (from_.passive != to_.passive) {
        for (std::size_t i = 0; i < rows; ++i) {
            invert(from_.name, active.data() + i * in_size);
        }
    }
    if (from_.unit == AngleUnit::degrees) {
        std::for_each_n(active.begin(), rows * in_size, [](double& v) { v *= radians_per_degree; });
    }
    settings_.method->run(to_.sequence, active.data(), rows, out);
    const std::size_t out_size = to_.size();
    if (to_.unit == AngleUnit::degrees) {
        std::for_each_n(out, rows * out_size, [](double& v) { v *= degrees_per_radian; });
    }
    Readings answers; // NOLINT(*-member-init)
    out_codec_->read(to_, out, rows, answers);
    for (std::size_t i = 0; i < rows; ++i) {
        if (to_.name == RepresentationId::quat) {
            make_sign_canonical(out + i * out_size);
        }
        if (diagnostics[i].has(DiagnosticKind::infinite)) {
            errors[i] = 0.0; // no finite number is nearer
            continue;
        }
        errors[i] = answers.error[i] == Error::none ? angle_between(answers.at(i), rotations.at(i))
                                                    : std::numeric_limits<double>::quiet_NaN();
        diagnostics[i] |= {DiagnosticKind::method_error, !(errors[i] <= reported_method_error)};
    }
}

Report Conversion::report(const Reading& reading, DiagnosticSet diagnostics, const double* numbers) const noexcept {
    Report report{.error = reading.error(),
                  .diagnostics = {},
                  .defect = reading.defect(),
                  .sensitivity = {},
                  .method_error = 0.0};
    if (!reading) {
        return report;
    }
    if (in_codec_->exact_defect != nullptr && (settings_.sensitivity || settings_.tolerance < reading.defect())) {
        report.defect = in_codec_->exact_defect(numbers);
    }
    if (report.defect > settings_.tolerance) {
        report.error = Error::defect;
        return report;
    }
    report.diagnostics = diagnostics;
    report.diagnostics |= {DiagnosticKind::normalized, report.defect > reported_defect};
    if (settings_.sensitivity || !report.diagnostics.empty()) {
        report.sensitivity = out_codec_->sensitivity(to_, *reading);
    }
    return report;
}

} // namespace rotconv
