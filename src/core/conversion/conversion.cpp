#include <rotconv/conversion.hpp>
#include <rotconv/product.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "../checks.hpp"
#include "../numerics/power_of_two.hpp"
#include "../numerics/quaternion_algebra.hpp"
#include "input_batch.hpp"
#include "kernels.hpp"

namespace rotconv {
namespace {

ExactQuaternion exact(const FixedRotation& fixed) noexcept {
    const Rotation& q = fixed.rotation;
    return {{q.w(), q.x(), q.y(), q.z()}, {fixed.rest[0], fixed.rest[1], fixed.rest[2], fixed.rest[3]}, fixed.off};
}

} // namespace

Reading read_attitude(const Spec& spec, std::span<const double> numbers) {
    check_size(numbers.size(), checked(spec).size());
    std::array<double, most_numbers> own{};
    to_own_order(spec, numbers.data(), 1, own.data());
    const Reading reading = read_row(spec, own.data());
    return reading && spec.passive ? Reading(reading->inverse(), reading.defect()) : reading;
}

UnusualNumbers unusual_numbers(const Spec& spec, std::span<const double> numbers, double defect) {
    check_size(numbers.size(), spec.size());
    UnusualNumbers found;
    if (defect > reported_defect) {
        found.defect = defect;
    }
    const Representation& read = representation(spec.name);
    if (!read.has_angles()) {
        return found;
    }
    const bool has_axis = read.first_angle > 0;
    const double largest = largest_magnitude(numbers[0], numbers[1], numbers[2]);
    const double length = norm_of(numbers[0], numbers[1], numbers[2]);
    const double angle = has_axis ? std::abs(numbers[read.first_angle]) : read.angle_is_length ? length : largest;
    if (has_axis && length > 0.0 && std::abs(length - 1.0) > reported_axis_defect) {
        found.defect = std::abs(length - 1.0);
        found.of_axis = true;
    }
    if (spec.unit == AngleUnit::radians && angle > reported_angle) {
        found.angle = angle;
    }
    return found;
}

RowReport report_of(const Spec& spec, const double* numbers, Error error, double defect, double tolerance,
                    bool is_exact) noexcept {
    RowReport report{.error = error};
    if (error != Error::none) {
        return report;
    }
    const auto exact_defect = codec_of(spec.name).exact_defect;
    report.defect = exact_defect != nullptr && (is_exact || tolerance < defect) ? exact_defect(numbers) : defect;
    if (report.defect > tolerance) {
        report.error = Error::defect;
    } else {
        report.unusual = unusual_numbers(spec, {numbers, spec.size()}, report.defect);
        report.report_numbers();
    }
    return report;
}

FixedRotation::FixedRotation(const Rotation& rounded, const std::array<double, 4>& more)
    : rotation(rounded), rest(more) {
    if (!is_identity()) {
        FixedFactor factor;
        std::ranges::copy(rounded.components(), std::begin(factor.numbers));
        std::ranges::copy(more, std::begin(factor.rest));
        factors.push_back(factor);
    }
}

FixedRotation FixedRotation::inverse() const {
    FixedRotation inverse(rotation.inverse(), {rest[0], -rest[1], -rest[2], -rest[3]});
    inverse.off = off;
    inverse.factors.assign(factors.rbegin(), factors.rend());
    for (FixedFactor& factor : inverse.factors) {
        factor.is_inverse = !factor.is_inverse;
    }
    return inverse;
}

FixedRotation FixedRotation::of_numbers(const Spec& spec, std::span<const double> numbers) {
    check_size(numbers.size(), checked(spec).size());
    std::array<double, most_numbers> own{};
    to_own_order(spec, numbers.data(), 1, own.data());
    ExactQuaternion q{};
    kernel_table().read_exactly(spec, own.data(), q);
    FixedRotation fixed(Rotation::near_unit(q.hi[0], q.hi[1], q.hi[2], q.hi[3]), {q.lo[0], q.lo[1], q.lo[2], q.lo[3]});
    FixedFactor factor{.spec = spec};
    std::copy_n(own.begin(), spec.size(), std::begin(factor.numbers));
    fixed.off = q.off;
    fixed.factors = {factor};
    return fixed;
}

FixedRotation operator*(const FixedRotation& a, const FixedRotation& b) {
    DoubleDouble q[3][4];
    for (std::size_t k = 0; k < 4; ++k) {
        q[0][k] = {a.rotation.components().at(k), a.rest.at(k)};
        q[1][k] = {b.rotation.components().at(k), b.rest.at(k)};
    }
    multiply(q[0], q[1], q[2]);
    FixedRotation product(Rotation::near_unit(q[2][0].hi, q[2][1].hi, q[2][2].hi, q[2][3].hi),
                          {q[2][0].lo, q[2][1].lo, q[2][2].lo, q[2][3].lo});
    product.off = off_of_product(a.off, b.off);
    product.factors = a.factors;
    product.factors.insert(product.factors.end(), b.factors.begin(), b.factors.end());
    return product;
}

FixedRotations fixed_rotations(const FixedRotation& left, const FixedRotation& right) noexcept {
    return {{exact(left), left.factors.data(), left.factors.size()},
            {exact(right), right.factors.data(), right.factors.size()}};
}

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

namespace {

/// Reports the rows of a batch of which there is something to tell.
/// @param second of a product, null where its attitudes are between two
void report_task(const Task& task, const ConversionSettings& settings, std::size_t begin, std::size_t rows,
                 double* written, const InputBatch& first, const InputBatch* second,
                 const AttitudeBatch<double>& attitudes, const std::array<DiagnosticSet, batch_rows>& diagnostics,
                 std::vector<RowReport>& reports) {
    const bool turns_vectors = task.to == nullptr;
    const std::size_t size = task.out_size();
    const auto overflows = [&](std::size_t i) { return turns_vectors && !all_finite(written + i * size, size); };
    DiagnosticSet all;
    std::for_each_n(diagnostics.begin(), rows, [&all](DiagnosticSet each) { all |= each; });
    if (all.empty() && !turns_vectors && !first.any_remarkable(rows, settings) &&
        (second == nullptr || !second->any_remarkable(rows, settings))) {
        return; // as most batches
    }
    report_rows(
        begin, rows, written, size, settings.sensitivity, reports,
        [&](std::size_t i) {
            return !diagnostics[i].empty() || first.is_remarkable(i, settings) || overflows(i) ||
                   (second != nullptr && second->is_remarkable(i, settings));
        },
        [&](std::size_t i) {
            RowReport found =
                second != nullptr ? report_of_pair(first, *second, i, settings) : first.report(i, settings);
            found.error = found.error == Error::none && overflows(i) ? Error::overflow : found.error;
            return found;
        },
        [&](std::size_t i, RowReport& found) {
            if (settings.sensitivity || !diagnostics[i].empty()) { // a row that is only normalized needs none
                const Spec& spec = turns_vectors ? *task.first : *task.to;
                const Rotation attitude = attitudes.at(i);
                found.sensitivity = codec_of(spec.name).sensitivity(
                    spec, turns_vectors && spec.passive ? attitude.inverse() : attitude);
            }
            found.diagnostics |= diagnostics[i];
        });
}

} // namespace

void run_task(Task task, const ConversionSettings& settings, bool interpolates, std::span<const double> in,
              std::span<double> out, std::vector<RowReport>& reports, std::span<double> rest) {
    reports.clear();
    const bool turns_vectors = task.to == nullptr;
    const bool is_product = task.second != nullptr;
    const bool is_fast = settings.fast && !turns_vectors && !is_product && task.rest_size == 1;
    FixedRotations fixed = turns_vectors ? no_rotations : fixed_rotations(settings.left, settings.right);
    fixed.right_first = task.inverts(); // as S' R' L' is worked out, to the last bit of a double
    task.lock_margin = settings.lock_margin;
    task.fixed = &fixed;
    const std::size_t to_second = task.first->size();
    const std::size_t to_later = to_second + (turns_vectors || is_product ? task.second_size() : 0);
    const std::size_t to_fractions = to_later + task.second_size();
    const std::size_t width = interpolates ? to_fractions + 6 : to_later;
    const std::size_t size = task.out_size();
    if (!rest.empty()) {
        check_size(rest.size(), in.size() / width * size * task.rest_size);
    }
    const auto run_batch = [&](const double* numbers, std::size_t rows, double* written, std::size_t begin) {
        InputBatch first(*task.first, numbers, rows, width);
        AttitudeBatch<double> product;
        std::unique_ptr<InputBatch> second; // large, and seldom there: optional ones would be cleared
        std::unique_ptr<InputBatch> later;
        std::vector<double> others;
        const auto take_others = [&](std::size_t at, std::size_t count) { // the vectors, or the fractions
            for (std::size_t i = 0; i < rows; ++i) {
                const double* const row = numbers + i * width + at;
                others.insert(others.end(), row, row + count);
            }
            return others.data();
        };
        TaskNumbers own{.first = first.own()};
        if (turns_vectors) {
            own.second = take_others(to_second, 3);
        } else if (is_product) {
            second = std::make_unique<InputBatch>(*task.second, numbers + to_second, rows, width);
            own.second = second->own();
        }
        if (interpolates) {
            later = std::make_unique<InputBatch>(*task.second, numbers + to_later, rows, width);
            own.later = later->own();
            own.fractions = take_others(to_fractions, 6);
        }
        const TaskAttitudes attitudes{is_product ? product : first.attitudes, &first.attitudes,
                                      is_product ? &second->attitudes : nullptr};
        std::array<DiagnosticSet, batch_rows> diagnostics{};
        const auto run = is_fast ? kernel_table().run_fast : kernel_table().run;
        if (task.to != nullptr && task.to->is_reordered()) { // no such representation needs `rest` to be continuous
            std::array<double, batch_rows * most_numbers> results;
            run(task, own, rows, attitudes, results.data(), nullptr, diagnostics.data());
            to_written_order(*task.to, results.data(), rows, written);
        } else {
            run(task, own, rows, attitudes, written, rest.empty() ? nullptr : &rest[begin * size * task.rest_size],
                diagnostics.data());
        }
        report_task(task, settings, begin, rows, written, first, interpolates ? nullptr : second.get(),
                    attitudes.written, diagnostics, reports);
    };
    for_each_batch(in, width, out, size, run_batch);
}

// NOLINTNEXTLINE(modernize-pass-by-value): the other arguments are references, too
Conversion::Conversion(const Spec& from, const Spec& to, const ConversionSettings& settings)
    : from_(checked(from)), to_(checked(to)), settings_(settings), zeros_(std::make_shared<ZeroTable>()) {}

void Conversion::run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports,
                     std::span<double> rest) const {
    run_task({.first = &from_, .to = &to_, .zeros = zeros_.get()}, settings_, false, in, out, reports, rest);
}

void Conversion::again(std::span<const double> row, std::span<double> numbers, std::span<double> rest) const {
    std::vector<RowReport> reports;
    const std::size_t rest_size = rest.size() / to_.size();
    run_task({.first = &from_, .to = &to_, .zeros = zeros_.get(), .rest_size = rest_size}, settings_, false, row,
             numbers, reports, rest);
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
    run_task({.first = &first_, .to = &to_, .zeros = zeros_.get(), .second = &second_}, settings_, interpolates_, in,
             out, reports, rest);
}

void Composition::again(std::span<const double> row, std::span<double> numbers, std::span<double> rest) const {
    std::vector<RowReport> reports;
    const std::size_t rest_size = rest.size() / to_.size();
    run_task({.first = &first_, .to = &to_, .zeros = zeros_.get(), .rest_size = rest_size, .second = &second_},
             settings_, interpolates_, row, numbers, reports, rest);
}

// NOLINTNEXTLINE(modernize-pass-by-value): the other arguments are references, too
VectorRotation::VectorRotation(const Spec& from, const ConversionSettings& settings)
    : from_(checked(from)), settings_(settings), zeros_(std::make_shared<ZeroTable>()) {}

void VectorRotation::run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports) const {
    run_task({.first = &from_, .zeros = zeros_.get()}, settings_, false, in, out, reports, {});
}

} // namespace rotconv
