#include <rotconv/comparison.hpp>

#include <algorithm>
#include <array>
#include <utility>

#include "conversion/input_batch.hpp"
#include "conversion/kernels.hpp"

namespace rotconv {

Comparison::Comparison(const Spec& from, const Spec& reference, ComparisonSettings settings)
    : from_(checked(from)), reference_(checked(reference)), settings_(std::move(settings)) {}

void Comparison::run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports) const {
    reports.clear();
    const KernelTable& kernels = kernel_table();
    const ConversionSettings& reading = settings_.reading;
    const FixedRotations fixed = fixed_rotations(reading.left, reading.right);
    const std::size_t width = outputs();
    const auto run_batch = [&](const double* numbers, std::size_t rows, double* written, std::size_t first) {
        InputBatch input(from_, numbers, rows, inputs());
        InputBatch reference(reference_, numbers + from_.size(), rows, inputs());
        kernels.read(from_, fixed, input.own(), rows, input.attitudes);
        kernels.read(reference_, no_rotations, reference.own(), rows, reference.attitudes);
        std::array<double, batch_rows> angles;
        kernels.relate(input.attitudes, reference.attitudes, rows, angles.data());
        for (std::size_t i = 0; i < rows; ++i) {
            written[i * width] = settings_.per_radian * angles[i];
            if (settings_.attitudes) {
                std::ranges::copy(input.attitudes.at(i).components(), written + (i + 1) * width - 8);
                std::ranges::copy(reference.attitudes.at(i).components(), written + (i + 1) * width - 4);
            }
        }
        const auto is_beyond = [&](std::size_t i) { return written[i * width] > settings_.within; };
        report_rows(
            first, rows, written, width, reading.sensitivity, reports,
            [&](std::size_t i) {
                return is_beyond(i) || input.is_remarkable(i, reading) || reference.is_remarkable(i, reading);
            },
            [&](std::size_t i) { return report_of_pair(input, reference, i, reading); },
            [&](std::size_t i, RowReport& found) {
                found.deviation = written[i * width];
                found.diagnostics |= {DiagnosticKind::beyond, is_beyond(i)};
            });
    };
    for_each_batch(in, inputs(), out, width, run_batch);
}

} // namespace rotconv
