#include <rotconv/comparison.hpp>

#include <algorithm>
#include <array>
#include <limits>

#include "input_batch.hpp"
#include "kernels.hpp"

namespace rotconv {
namespace {

/// The report on both attitudes of a row.
RowReport report_of(const InputBatch& input, const InputBatch& reference, std::size_t row,
                    const ConversionSettings& settings) {
    RowReport report = input.report(row, settings);
    if (report.error != Error::none) {
        return report;
    }
    RowReport other = reference.report(row, settings);
    if (other.error != Error::none) {
        other.of_reference = true;
        return other;
    }
    report.diagnostics |= other.diagnostics;
    report.reference_defect = other.defect;
    report.reference_unusual = other.unusual;
    return report;
}

} // namespace

Comparison::Comparison(const Spec& from, const Spec& reference, const ComparisonSettings& settings)
    : from_(from), reference_(reference), settings_(settings) {}

std::size_t Comparison::outputs() const noexcept {
    return 1 + (settings_.relative ? settings_.relative->size() : 0) + (settings_.attitudes ? 8 : 0);
}

void Comparison::run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports) const {
    reports.clear();
    const std::size_t rows = in.size() / inputs();
    for (std::size_t first = 0; first < rows; first += batch_rows) {
        run_batch(in.data() + first * inputs(), first, std::min(batch_rows, rows - first),
                  out.data() + first * outputs(), reports);
    }
}

void Comparison::run_batch(const double* in, std::size_t first, std::size_t rows, double* out,
                           std::vector<RowReport>& reports) const {
    InputBatch input(from_, in, rows, inputs());
    InputBatch reference(reference_, in + from_.size(), rows, inputs());
    const KernelTable& kernels = kernel_table();
    const Turns turns = turns_of(settings_.reading.left, settings_.reading.right);
    kernels.read(from_, turns, input.own(), rows, input.attitudes);
    kernels.read(reference_, no_turns, reference.own(), rows, reference.attitudes);
    AttitudeBatch<double> relative;
    std::array<double, batch_rows> angles;
    relate(input.attitudes, reference.attitudes, settings_.frame, rows, relative, angles.data());

    const double unit = settings_.unit == AngleUnit::degrees ? degrees_per_radian : 1.0;
    const std::size_t width = outputs();
    std::array<DiagnosticSet, batch_rows> diagnostics{};
    for (std::size_t i = 0; i < rows; ++i) {
        out[i * width] = unit * angles[i];
        if (settings_.attitudes) {
            const Rotation own = input.attitudes.at(i);
            const Rotation other = reference.attitudes.at(i);
            std::ranges::copy(
                std::array{own.w(), own.x(), own.y(), own.z(), other.w(), other.x(), other.y(), other.z()},
                out + (i + 1) * width - 8);
        }
    }
    if (settings_.relative) {
        const Spec& to = *settings_.relative;
        std::array<double, batch_rows * most_numbers> own;
        std::array<double, batch_rows * most_numbers> written;
        kernels.write_relative({&from_, &turns, &reference_, &to, settings_.frame, settings_.reading.lock_margin},
                               input.own(), reference.own(), rows, own.data(), diagnostics.data());
        to_written_order(to, own.data(), rows, written.data());
        for (std::size_t i = 0; i < rows; ++i) {
            std::copy_n(written.data() + i * to.size(), to.size(), out + i * width + 1);
        }
    }
    for (std::size_t i = 0; i < rows; ++i) {
        const double angle = out[i * width];
        diagnostics[i] |= {DiagnosticKind::beyond, angle > settings_.within};
        if (diagnostics[i].empty() && !input.is_remarkable(i, settings_.reading) &&
            !reference.is_remarkable(i, settings_.reading)) {
            continue;
        }
        RowReport found = report_of(input, reference, i, settings_.reading);
        if (found.error != Error::none) {
            std::fill_n(out + i * width, width, std::numeric_limits<double>::quiet_NaN());
        } else {
            found.deviation = angle;
            found.diagnostics |= diagnostics[i];
            if (!settings_.reading.sensitivity && found.diagnostics.empty()) {
                continue;
            }
            if (settings_.relative) {
                const Spec& to = *settings_.relative;
                found.sensitivity =
                    codec_of(to.name).sensitivity(to, to.passive ? relative.at(i).inverse() : relative.at(i));
            }
        }
        found.row = first + i;
        reports.push_back(found);
    }
}

} // namespace rotconv
