#include <rotconv/comparison.hpp>

#include <algorithm>
#include <array>
#include <limits>

#include "checks.hpp"
#include "input_batch.hpp"
#include "kernels.hpp"

namespace rotconv {
Comparison::Comparison(const Spec& from, const Spec& reference, const ComparisonSettings& settings)
    : from_(checked(from)), reference_(checked(reference)), settings_(settings) {}

void Comparison::run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports) const {
    reports.clear();
    const std::size_t rows = checked_rows(in.size(), inputs(), out.size(), outputs());
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
    relate(input.attitudes, reference.attitudes, rows, relative, angles.data());

    const std::size_t width = outputs();
    for (std::size_t i = 0; i < rows; ++i) {
        out[i * width] = settings_.per_radian * angles[i];
        if (settings_.attitudes) {
            std::ranges::copy(input.attitudes.at(i).components(), out + (i + 1) * width - 8);
            std::ranges::copy(reference.attitudes.at(i).components(), out + (i + 1) * width - 4);
        }
    }
    for (std::size_t i = 0; i < rows; ++i) {
        const double angle = out[i * width];
        const DiagnosticSet beyond{DiagnosticKind::beyond, angle > settings_.within};
        if (beyond.empty() && !input.is_remarkable(i, settings_.reading) &&
            !reference.is_remarkable(i, settings_.reading)) {
            continue;
        }
        RowReport found = report_of_pair(input, reference, i, settings_.reading);
        if (found.error != Error::none) {
            std::fill_n(out + i * width, width, std::numeric_limits<double>::quiet_NaN());
        } else {
            found.deviation = angle;
            found.diagnostics |= beyond;
            if (!settings_.reading.sensitivity && found.diagnostics.empty()) {
                continue;
            }
        }
        found.row = first + i;
        reports.push_back(found);
    }
}

} // namespace rotconv
