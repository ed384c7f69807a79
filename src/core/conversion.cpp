#include <rotconv/conversion.hpp>

#include <algorithm>
#include <array>
#include <limits>

#include "door.hpp"

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

/// The way back, in place.
void to_written_order(const Spec& spec, double* numbers, std::size_t rows) noexcept {
    const auto order = spec.order();
    const std::size_t size = spec.size();
    for (std::size_t row = 0; row < rows; ++row, numbers += size) {
        std::array<double, widest> own{};
        std::copy_n(numbers, size, own.begin());
        for (std::size_t i = 0; i < size; ++i) {
            numbers[i] = own[order[i]];
        }
    }
}

} // namespace

Conversion::Conversion(const Spec& from, const Spec& to, const Settings& settings)
    : from_(from), to_(to), settings_(settings), in_door_(&door_of(from.name)), out_door_(&door_of(to.name)) {}

void Conversion::run(std::span<const double> in, std::span<double> out, std::span<Report> reports) const noexcept {
    const double* from = in.data();
    double* to = out.data();
    while (!reports.empty()) {
        const std::size_t rows = std::min(block, reports.size());
        run_block(from, to, reports.first(rows));
        from += rows * from_.size();
        to += rows * to_.size();
        reports = reports.subspan(rows);
    }
}

void Conversion::run_block(const double* in, double* out, std::span<Report> reports) const noexcept {
    const std::size_t rows = reports.size();
    std::array<double, block * widest> own_order; // NOLINT(*-member-init): written before it is read
    if (reordered(from_)) {
        to_own_order(from_, in, rows, own_order.data());
        in = own_order.data();
    }
    std::array<Reading, block> readings;
    in_door_->read(from_, in, rows, readings.data());
    if (from_.passive != to_.passive) {
        for (std::size_t i = 0; i < rows; ++i) {
            readings[i].rotation = readings[i].rotation.inverse();
        }
    }
    out_door_->write(to_, settings_.lock_margin, readings.data(), rows, out);
    for (std::size_t i = 0; i < rows * to_.size(); ++i) {
        out[i] += 0.0; // -0 becomes 0
    }
    if (reordered(to_)) {
        to_written_order(to_, out, rows);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        reports[i] = report(readings[i], in + i * from_.size());
        if (reports[i].fault != Fault::none) {
            std::fill_n(out + i * to_.size(), to_.size(), std::numeric_limits<double>::quiet_NaN());
        }
    }
}

Report Conversion::report(const Reading& reading, const double* numbers) const noexcept {
    Report report{.fault = reading.fault, .notes = {}, .defect = reading.defect, .figures = {}};
    if (!reading.ok()) {
        return report;
    }
    if (in_door_->exact_defect != nullptr && (settings_.figures || settings_.tolerance < reading.defect)) {
        report.defect = in_door_->exact_defect(numbers);
    }
    if (report.defect > settings_.tolerance) {
        report.fault = Fault::defect;
        return report;
    }
    report.notes = {Kind::normalized, report.defect > reported_defect};
    if (out_door_->notes != nullptr) {
        report.notes |= out_door_->notes(to_, settings_.lock_margin, reading.rotation);
    }
    if (settings_.figures || !report.notes.empty()) {
        report.figures = out_door_->figures(to_, reading.rotation);
    }
    return report;
}

} // namespace rotconv
