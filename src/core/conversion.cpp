#include <rotconv/conversion.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "representations/codec.hpp"

namespace rotconv {
namespace {

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

/// Sets -0 to 0.
ROTCONV_TARGET_CLONES
void drop_minus_zero(double* numbers, std::size_t count) noexcept {
    for (std::size_t i = 0; i < count; ++i) {
        numbers[i] += 0.0;
    }
}

/// Whether there may be something to tell of any row: one look at each column, for most batches have no such row.
ROTCONV_TARGET_CLONES
bool any_remarkable(const Readings& readings, const DiagnosticSet* diagnostics, std::size_t rows,
                    double largest_defect) noexcept {
    // Sums of bits, since compilers vectorise those.
    std::uint64_t defects = 0;
    std::uint8_t errors = 0;
    DiagnosticSet kinds;
    for (std::size_t i = 0; i < rows; ++i) {
        defects |= readings.defect[i] <= largest_defect ? 0U : 1U;
    }
    for (std::size_t i = 0; i < rows; ++i) {
        errors = static_cast<std::uint8_t>(errors | static_cast<std::uint8_t>(readings.error[i]));
        kinds |= diagnostics[i];
    }
    return defects != 0 || errors != 0 || !kinds.empty();
}

} // namespace

Conversion::Conversion(const Spec& from, const Spec& to, const Settings& settings)
    : from_(from), to_(to), settings_(settings), in_codec_(&codec_of(from.name)), out_codec_(&codec_of(to.name)) {}

void Conversion::run(std::span<const double> in, std::span<double> out, std::vector<Report>& reports) const {
    reports.clear();
    const std::size_t rows = in.size() / from_.size();
    for (std::size_t first = 0; first < rows; first += batch_rows) {
        run_batch(in.data() + first * from_.size(), first, std::min(batch_rows, rows - first),
                  out.data() + first * to_.size(), reports);
    }
}

void Conversion::run_batch(const double* in, std::size_t first, std::size_t rows, double* out,
                           std::vector<Report>& reports) const {
    std::array<double, batch_rows * most_numbers> own_order; // NOLINT(*-member-init): written before it is read
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
    const std::size_t width = to_.size();
    drop_minus_zero(out, rows * width);
    if (reordered(to_)) {
        (to_.size() == 4 ? to_written_order<4> : to_written_order<9>)(to_, out, rows); // a quaternion or a matrix
    }
    const double largest_defect = settings_.sensitivity ? -1.0 : std::min(settings_.tolerance, reported_defect);
    if (!any_remarkable(readings, diagnostics.data(), rows, largest_defect)) {
        return;
    }
    for (std::size_t i = 0; i < rows; ++i) {
        if (readings.defect[i] <= largest_defect && readings.error[i] == Error::none && diagnostics[i].empty()) {
            continue;
        }
        Report found = report(readings.reading(i), diagnostics[i], in + i * from_.size());
        if (found.error != Error::none) {
            std::fill_n(out + i * width, width, std::numeric_limits<double>::quiet_NaN());
        }
        if (settings_.sensitivity || found.error != Error::none || !found.diagnostics.empty()) {
            found.row = first + i;
            reports.push_back(found);
        }
    }
}

Report Conversion::report(const Reading& reading, DiagnosticSet diagnostics, const double* numbers) const noexcept {
    Report report;
    report.error = reading.error();
    report.defect = reading.defect();
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
