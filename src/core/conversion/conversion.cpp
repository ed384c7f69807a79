#include <rotconv/conversion.hpp>

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

/// Whether there may be something to report: one look at each column, because most batches have no such row.
bool any_remarkable(const InputBatch& input, const DiagnosticSet* diagnostics, std::size_t rows,
                    double largest_defect) noexcept {
    const AttitudeBatch<double>& attitudes = input.attitudes;
    // Sums of bits, because compilers vectorise those.
    std::uint64_t defects = 0;
    for (std::size_t i = 0; i < rows; ++i) {
        defects |= attitudes.defect[i] <= largest_defect ? 0U : 1U;
    }
    std::uint8_t errors = 0;
    DiagnosticSet kinds;
    for (std::size_t i = 0; i < rows; ++i) {
        errors = static_cast<std::uint8_t>(errors | static_cast<std::uint8_t>(attitudes.error[i]));
        kinds |= diagnostics[i];
    }
    return defects != 0 || errors != 0 || !kinds.empty() || input.any_unusual(rows);
}

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
    const double angle = has_axis                                ? std::abs(numbers[read.first_angle])
                         : spec.name == RepresentationId::rotvec ? length
                                                                 : largest;
    if (has_axis && length > 0.0 && std::abs(length - 1.0) > reported_axis_defect) {
        found.defect = std::abs(length - 1.0);
        found.of_axis = true;
    }
    if (spec.unit == AngleUnit::radians && angle > reported_angle) {
        found.angle = angle;
    }
    return found;
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
    const ExactQuaternion factors[] = {exact(a), exact(b)};
    DoubleDouble q[3][4];
    for (std::size_t k = 0; k < 4; ++k) {
        q[0][k] = {factors[0].hi[k], factors[0].lo[k]};
        q[1][k] = {factors[1].hi[k], factors[1].lo[k]};
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
    return {!left.factors.empty(), !right.factors.empty(), exact(left),          exact(right),
            left.factors.data(),   left.factors.size(),    right.factors.data(), right.factors.size()};
}

// NOLINTNEXTLINE(modernize-pass-by-value): the other arguments are references, too
Conversion::Conversion(const Spec& from, const Spec& to, const ConversionSettings& settings)
    : from_(checked(from)), to_(checked(to)), settings_(settings), out_codec_(&codec_of(to.name)),
      zeros_(std::make_shared<ZeroTable>()) {}

void Conversion::run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports,
                     std::span<double> rest) const {
    run(in, out, reports, rest, 1);
}

void Conversion::again(std::span<const double> row, std::span<double> numbers, std::span<double> rest) const {
    std::vector<RowReport> reports;
    run(row, numbers, reports, rest, rest.size() / to_.size());
}

void Conversion::run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports,
                     std::span<double> rest, std::size_t rest_size) const {
    reports.clear();
    // Passive output writes the inverse, (L R S)' = S' R' L': left and right change places and are inverted.
    const FixedRotation left = to_.passive ? settings_.right.inverse() : settings_.left;
    const FixedRotation right = to_.passive ? settings_.left.inverse() : settings_.right;
    const FixedRotations fixed = fixed_rotations(left, right);
    const auto convert = settings_.fast && rest_size == 1 ? kernel_table().convert_fast : kernel_table().convert;
    const std::size_t width = to_.size();
    check_size(rest.empty() ? out.size() : rest.size(),
               in.size() / from_.size() * width * (rest.empty() ? 1 : rest_size));
    const ConversionBatch batch{&from_, &to_, settings_.lock_margin, &fixed, zeros_.get(), rest_size};
    const auto run_batch = [&](const double* numbers, std::size_t rows, double* written, std::size_t first) {
        InputBatch input(from_, numbers, rows, from_.size());
        std::array<DiagnosticSet, batch_rows> diagnostics;
        if (to_.is_reordered()) { // such a representation has no Codec::choose_nearest, which alone wants `rest`
            std::array<double, batch_rows * most_numbers> own;
            convert(batch, input.own(), rows, input.attitudes, own.data(), nullptr, diagnostics.data());
            to_written_order(to_, own.data(), rows, written);
        } else {
            convert(batch, input.own(), rows, input.attitudes, written,
                    rest.empty() ? nullptr : &rest[first * width * rest_size], diagnostics.data());
        }
        if (!any_remarkable(input, diagnostics.data(), rows, InputBatch::largest_unreported(settings_))) {
            return;
        }
        report_rows(
            first, rows, written, width, settings_.sensitivity, reports,
            [&](std::size_t i) { return !diagnostics[i].empty() || input.is_remarkable(i, settings_); },
            [&](std::size_t i) { return input.report(i, settings_); },
            [&](std::size_t i, RowReport& found) {
                if (settings_.sensitivity || !diagnostics[i].empty()) { // a row that is only normalized needs none
                    found.sensitivity = out_codec_->sensitivity(to_, input.attitudes.at(i));
                }
                found.diagnostics |= diagnostics[i];
            });
    };
    for_each_batch(in, from_.size(), out, width, run_batch);
}

} // namespace rotconv
