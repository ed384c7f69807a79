#include <rotconv/product.hpp>

#include <algorithm>
#include <array>
#include <memory>

#include "../numerics/power_of_two.hpp"
#include "input_batch.hpp"
#include "kernels.hpp"

namespace rotconv {
namespace {

/// The sensitivity of numbers of the SPEC that mean the attitude.
Sensitivity sensitivity_of(const Spec& spec, const Rotation& attitude) noexcept {
    return codec_of(spec.name).sensitivity(spec, spec.passive ? attitude.inverse() : attitude);
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
        other.at_fault = 1;
        return other;
    }
    report.diagnostics |= other.diagnostics;
    report.references[0] = {other.defect, other.unusual};
    return report;
}

// NOLINTNEXTLINE(modernize-pass-by-value): the other arguments are references, too
Composition::Composition(const Spec& first, const Spec& second, const Spec& to, const ConversionSettings& settings)
    : first_(checked(first)), second_(checked(second)), to_(checked(to)), settings_(settings),
      zeros_(std::make_shared<ZeroTable>()) {}

Composition Composition::interpolating() const {
    Composition other = *this;
    other.interpolates_ = true;
    other.zeros_ = std::make_shared<ZeroTable>();
    return other;
}

void Composition::run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports,
                      std::span<double> rest) const {
    run(in, out, reports, rest, 1);
}

void Composition::again(std::span<const double> row, std::span<double> numbers, std::span<double> rest) const {
    std::vector<RowReport> reports;
    run(row, numbers, reports, rest, rest.size() / to_.size());
}

void Composition::run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports,
                      std::span<double> rest, std::size_t rest_size) const {
    reports.clear();
    const std::size_t to_later = first_.size() + second_.size();
    const std::size_t width = to_later + (interpolates_ ? second_.size() + 6 : 0);
    check_size(rest.empty() ? out.size() : rest.size(),
               in.size() / width * to_.size() * (rest.empty() ? 1 : rest_size));
    const FixedRotations fixed = fixed_rotations(settings_.left, settings_.right);
    ProductBatch batch{&first_, &fixed, &second_, &to_, settings_.lock_margin, zeros_.get(), rest_size};
    const auto run_batch = [&](const double* numbers, std::size_t rows, double* written, std::size_t begin) {
        InputBatch first(first_, numbers, rows, width);
        InputBatch second(second_, numbers + first_.size(), rows, width);
        std::unique_ptr<InputBatch> later; // large, and seldom there: an optional one would be cleared
        if (interpolates_) {
            later = std::make_unique<InputBatch>(second_, numbers + to_later, rows, width);
            batch.later = later->own();
            batch.fractions = numbers + to_later + second_.size();
            batch.row_size = width;
        }
        AttitudeBatch<double> product;
        std::array<DiagnosticSet, batch_rows> diagnostics{};
        std::array<double, batch_rows * most_numbers> own;
        kernel_table().multiply(batch, first.own(), second.own(), rows, {&first.attitudes, &second.attitudes, &product},
                                own.data(), rest.empty() ? nullptr : rest.data() + begin * to_.size() * rest_size,
                                diagnostics.data());
        to_written_order(to_, own.data(), rows, written);
        report_rows(
            begin, rows, written, to_.size(), settings_.sensitivity, reports,
            [&](std::size_t i) {
                return !diagnostics[i].empty() || first.is_remarkable(i, settings_) ||
                       (!interpolates_ && second.is_remarkable(i, settings_));
            },
            [&](std::size_t i) {
                return interpolates_ ? first.report(i, settings_) : report_of_pair(first, second, i, settings_);
            },
            [&](std::size_t i, RowReport& found) {
                found.diagnostics |= diagnostics[i];
                found.sensitivity = sensitivity_of(to_, product.at(i));
            });
    };
    for_each_batch(in, width, out, to_.size(), run_batch);
}

// NOLINTNEXTLINE(modernize-pass-by-value): the other arguments are references, too
VectorRotation::VectorRotation(const Spec& from, const ConversionSettings& settings)
    : from_(checked(from)), settings_(settings), zeros_(std::make_shared<ZeroTable>()) {}

void VectorRotation::run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports) const {
    reports.clear();
    const std::size_t width = from_.size() + 3;
    const auto run_batch = [&](const double* numbers, std::size_t rows, double* written, std::size_t begin) {
        InputBatch input(from_, numbers, rows, width);
        std::array<double, 3 * batch_rows> vectors;
        for (std::size_t i = 0; i < rows; ++i) {
            std::copy_n(numbers + i * width + from_.size(), 3, vectors.data() + 3 * i);
        }
        kernel_table().rotate(from_, zeros_.get(), input.own(), vectors.data(), rows, input.attitudes, written);
        std::for_each_n(written, 3 * rows, [](double& number) { number += 0.0; }); // -0 becomes 0
        const auto is_finite = [written](std::size_t i) { return all_finite(written + 3 * i, 3); };
        report_rows(
            begin, rows, written, 3, settings_.sensitivity, reports,
            [&](std::size_t i) { return !is_finite(i) || input.is_remarkable(i, settings_); },
            [&](std::size_t i) {
                RowReport found = input.report(i, settings_);
                if (found.error == Error::none && !is_finite(i)) {
                    found = {.error = all_finite(&vectors[3 * i], 3) ? Error::overflow : Error::not_finite};
                }
                return found;
            },
            [&](std::size_t i, RowReport& found) {
                if (settings_.sensitivity) {
                    found.sensitivity = sensitivity_of(from_, input.attitudes.at(i));
                }
            });
    };
    for_each_batch(in, width, out, 3, run_batch);
}

} // namespace rotconv
