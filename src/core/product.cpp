#include <rotconv/product.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "checks.hpp"
#include "input_batch.hpp"
#include "kernels.hpp"
#include "numerics/power_of_two.hpp"

namespace rotconv {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Calls run(in, rows, out, first) for batches of rows of so many numbers.
template <class Run> void for_each_batch(std::span<const double> in, std::size_t inputs, std::span<double> out,
                                         std::size_t outputs, const Run& run) {
    const std::size_t rows = checked_rows(in.size(), inputs, out.size(), outputs);
    for (std::size_t first = 0; first < rows; first += batch_rows) {
        run(in.data() + first * inputs, std::min(batch_rows, rows - first), out.data() + first * outputs, first);
    }
}

} // namespace

RowReport report_of_pair(const InputBatch& first, const InputBatch& second, std::size_t row,
                         const ConversionSettings& settings) noexcept {
    RowReport report = first.report(row, settings);
    if (report.error != Error::none) {
        return report;
    }
    RowReport other = second.report(row, settings);
    if (other.error != Error::none) {
        other.of_reference = true;
        return other;
    }
    report.diagnostics |= other.diagnostics;
    report.reference_defect = other.defect;
    report.reference_unusual = other.unusual;
    return report;
}

Composition::Composition(const Spec& first, const Spec& second, const Spec& to, const ConversionSettings& settings)
    : first_(checked(first)), second_(checked(second)), to_(checked(to)), settings_(settings) {}

void Composition::run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports,
                      std::span<double> rest) const {
    reports.clear();
    const std::size_t width = first_.size() + second_.size();
    check_size(rest.empty() ? out.size() : rest.size(), in.size() / width * to_.size());
    const Turns turns = turns_of(settings_.left, settings_.right);
    const ProductBatch batch{&first_, &turns, &second_, &to_, settings_.lock_margin};
    const auto run_batch = [&](const double* numbers, std::size_t rows, double* written, std::size_t begin) {
        InputBatch first(first_, numbers, rows, width);
        InputBatch second(second_, numbers + first_.size(), rows, width);
        AttitudeBatch<double> product;
        std::array<DiagnosticSet, batch_rows> diagnostics{};
        std::array<double, batch_rows * most_numbers> own;
        kernel_table().multiply(batch, first.own(), second.own(), rows, {&first.attitudes, &second.attitudes, &product},
                                own.data(), rest.empty() ? nullptr : rest.data() + begin * to_.size(),
                                diagnostics.data());
        to_written_order(to_, own.data(), rows, written);
        for (std::size_t i = 0; i < rows; ++i) {
            if (diagnostics[i].empty() && !first.is_remarkable(i, settings_) && !second.is_remarkable(i, settings_)) {
                continue;
            }
            RowReport found = report_of_pair(first, second, i, settings_);
            if (found.error != Error::none) {
                std::fill_n(written + i * to_.size(), to_.size(), nan);
            } else {
                found.diagnostics |= diagnostics[i];
                if (!settings_.sensitivity && found.diagnostics.empty()) {
                    continue;
                }
                found.sensitivity =
                    codec_of(to_.name).sensitivity(to_, to_.passive ? product.at(i).inverse() : product.at(i));
            }
            found.row = begin + i;
            reports.push_back(found);
        }
    };
    for_each_batch(in, width, out, to_.size(), run_batch);
}

VectorRotation::VectorRotation(const Spec& from, const ConversionSettings& settings)
    : from_(checked(from)), settings_(settings) {}

void VectorRotation::run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports) const {
    reports.clear();
    const std::size_t width = from_.size() + 3;
    const auto run_batch = [&](const double* numbers, std::size_t rows, double* written, std::size_t begin) {
        InputBatch input(from_, numbers, rows, width);
        std::array<double, 3 * batch_rows> vectors;
        for (std::size_t i = 0; i < rows; ++i) {
            std::copy_n(numbers + i * width + from_.size(), 3, vectors.data() + 3 * i);
        }
        kernel_table().rotate(from_, input.own(), vectors.data(), rows, input.attitudes, written);
        for (std::size_t i = 0; i < rows; ++i) {
            const std::span vector(vectors.data() + 3 * i, 3);
            const std::span rotated(written + 3 * i, 3);
            std::ranges::for_each(rotated, [](double& number) { number += 0.0; }); // -0 becomes 0
            const bool is_finite = all_finite(rotated.data(), 3);
            if (is_finite && !input.is_remarkable(i, settings_)) {
                continue;
            }
            RowReport found = input.report(i, settings_);
            if (found.error == Error::none && !is_finite) {
                found = {.error = all_finite(vector.data(), 3) ? Error::overflow : Error::not_finite};
            }
            if (found.error != Error::none) {
                std::ranges::fill(rotated, nan);
            } else if (settings_.sensitivity) {
                const Rotation attitude = input.attitudes.at(i);
                found.sensitivity =
                    codec_of(from_.name).sensitivity(from_, from_.passive ? attitude.inverse() : attitude);
            } else if (found.diagnostics.empty()) {
                continue;
            }
            found.row = begin + i;
            reports.push_back(found);
        }
    };
    for_each_batch(in, width, out, 3, run_batch);
}

} // namespace rotconv
