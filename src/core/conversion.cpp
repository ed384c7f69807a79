#include <rotconv/conversion.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "checks.hpp"
#include "input_batch.hpp"
#include "kernels.hpp"
#include "numerics/power_of_two.hpp"
#include "numerics/quaternion_algebra.hpp"

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

std::optional<FixedRotation> inverse_of(const std::optional<FixedRotation>& turn) noexcept {
    return turn ? std::optional(turn->inverse()) : std::nullopt;
}

/// Whether the result is the given numbers, but for their order, signs, unit and quarter turns (from ZXZ to ZYZ): then
/// a singularity leaves nothing open.
bool passes_numbers(const Spec& from, const Spec& to) noexcept {
    const bool reversed = (from.sequence.intrinsic() != to.sequence.intrinsic()) != (from.passive != to.passive);
    const auto same = [&](std::size_t i) { return from.sequence.axis(i) == to.sequence.axis(reversed ? 2 - i : i); };
    const bool are_angles = representation(from.name).has_gimbal_lock && representation(to.name).has_gimbal_lock;
    return are_angles ? same(0) && same(2) : from.name == to.name;
}

/// Whether numbers of the result are a convention, and another kind says so.
bool is_convention(DiagnosticSet found) noexcept {
    return found.has(DiagnosticKind::gimbal_lock) || found.has(DiagnosticKind::infinite) ||
           found.has(DiagnosticKind::identity_axis);
}

ExactQuaternion exact(const FixedRotation& turn) noexcept {
    const Rotation& q = turn.rotation;
    return {{q.w(), q.x(), q.y(), q.z()}, {turn.rest[0], turn.rest[1], turn.rest[2], turn.rest[3]}};
}

} // namespace

Reading read_attitude(const Spec& spec, std::span<const double> numbers) {
    check_size(numbers.size(), checked(spec).size());
    std::array<double, most_numbers> own{};
    to_own_order(spec, numbers.data(), 1, own.data());
    const Reading reading = read_row(spec, own.data());
    return reading && spec.passive ? Reading(reading->inverse(), reading.defect()) : reading;
}

FixedRotation FixedRotation::of_numbers(const Spec& spec, std::span<const double> numbers) {
    check_size(numbers.size(), checked(spec).size());
    std::array<double, most_numbers> own{};
    to_own_order(spec, numbers.data(), 1, own.data());
    ExactQuaternion q{};
    kernel_table().read_exactly(spec, own.data(), q);
    return {Rotation::near_unit(q.hi[0], q.hi[1], q.hi[2], q.hi[3]), {q.lo[0], q.lo[1], q.lo[2], q.lo[3]}};
}

FixedRotation operator*(const FixedRotation& a, const FixedRotation& b) noexcept {
    const ExactQuaternion factors[] = {exact(a), exact(b)}; // NOLINT(*-avoid-c-arrays): as multiply() takes them
    DoubleDouble q[3][4];                                   // NOLINT(*-avoid-c-arrays)
    for (std::size_t k = 0; k < 4; ++k) {
        q[0][k] = {factors[0].hi[k], factors[0].lo[k]};
        q[1][k] = {factors[1].hi[k], factors[1].lo[k]};
    }
    multiply(q[0], q[1], q[2]);
    return {Rotation::near_unit(q[2][0].hi, q[2][1].hi, q[2][2].hi, q[2][3].hi),
            {q[2][0].lo, q[2][1].lo, q[2][2].lo, q[2][3].lo}};
}

Turns turns_of(const std::optional<FixedRotation>& left, const std::optional<FixedRotation>& right) noexcept {
    const FixedRotation none{Rotation{}};
    return {left.has_value(), right.has_value(), exact(left.value_or(none)), exact(right.value_or(none))};
}

Conversion::Conversion(const Spec& from, const Spec& to, const ConversionSettings& settings)
    : from_(checked(from)), to_(checked(to)), settings_(settings), out_codec_(&codec_of(to.name)),
      looks_at_digits_(settings.decimal && out_codec_->well_conditioned != nullptr &&
                       (settings.left || settings.right || !passes_numbers(from, to))) {}

void Conversion::run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports,
                     std::span<double> rest) const {
    reports.clear();
    // Passive output writes the inverse, (L R S)' = S' R' L': left and right change places and are inverted.
    const Turns turns = to_.passive ? turns_of(inverse_of(settings_.right), inverse_of(settings_.left))
                                    : turns_of(settings_.left, settings_.right);
    const ConversionBatch batch{&from_, &to_, settings_.lock_margin, &turns};
    const std::size_t rows = checked_rows(in.size(), from_.size(), out.size(), to_.size());
    check_size(rest.empty() ? out.size() : rest.size(), rows * to_.size());
    for (std::size_t first = 0; first < rows; first += batch_rows) {
        run_batch(batch, in.data() + first * from_.size(), first, std::min(batch_rows, rows - first),
                  out.data() + first * to_.size(), rest.empty() ? nullptr : rest.data() + first * to_.size(), reports);
    }
}

void Conversion::run_batch(const ConversionBatch& batch, const double* in, std::size_t first, std::size_t rows,
                           double* out, double* rest, std::vector<RowReport>& reports) const {
    InputBatch input(from_, in, rows, from_.size());
    std::array<DiagnosticSet, batch_rows> diagnostics;
    const auto convert = settings_.fast ? kernel_table().convert_fast : kernel_table().convert;
    if (to_.is_reordered()) { // such a representation has no Codec::nearest, which alone wants `rest`
        std::array<double, batch_rows * most_numbers> own;
        convert(batch, input.own(), rows, input.attitudes, own.data(), nullptr, diagnostics.data());
        to_written_order(to_, own.data(), rows, out);
    } else {
        convert(batch, input.own(), rows, input.attitudes, out, rest, diagnostics.data());
        std::for_each_n(out, rows * to_.size(), [](double& number) { number += 0.0; }); // -0 becomes 0
    }
    if (looks_at_digits_) {
        const NumberRange range = out_codec_->well_conditioned(to_);
        const auto is_outside = [&range](double number) { return number < range.least || number > range.greatest; };
        for (std::size_t i = 0; i < rows; ++i) {
            const std::span numbers(out + i * to_.size() + range.first, range.count);
            if (std::ranges::any_of(numbers, is_outside) && !is_convention(diagnostics[i])) {
                diagnostics[i] |= {DiagnosticKind::few_digits, openness(input, i) > reported_openness};
            }
        }
    }
    report(input, diagnostics.data(), first, rows, out, reports);
}

void Conversion::report(const InputBatch& input, const DiagnosticSet* diagnostics, std::size_t first, std::size_t rows,
                        double* out, std::vector<RowReport>& reports) const {
    const AttitudeBatch<double>& attitudes = input.attitudes;
    if (!any_remarkable(input, diagnostics, rows, InputBatch::largest_unreported(settings_))) {
        return;
    }
    const std::size_t width = to_.size();
    for (std::size_t i = 0; i < rows; ++i) {
        if (diagnostics[i].empty() && !input.is_remarkable(i, settings_)) {
            continue;
        }
        RowReport found = input.report(i, settings_);
        if (found.error != Error::none) {
            std::fill_n(out + i * width, width, std::numeric_limits<double>::quiet_NaN());
        } else {
            if (settings_.sensitivity || !diagnostics[i].empty()) { // a row that is only normalized needs none
                found.sensitivity = out_codec_->sensitivity(to_, attitudes.at(i));
            }
            found.diagnostics |= diagnostics[i];
            if (found.diagnostics.has(DiagnosticKind::few_digits)) {
                found.openness = openness(input, i);
            }
            if (!settings_.sensitivity && found.diagnostics.empty()) {
                continue;
            }
        }
        found.row = first + i;
        reports.push_back(found);
    }
}

double Conversion::openness(const InputBatch& input, std::size_t row) const noexcept {
    if (input.attitudes.error[row] != Error::none) {
        return 0.0;
    }
    const std::span numbers(input.own() + row * from_.size(), from_.size());
    const double condition = out_codec_->sensitivity(to_, input.attitudes.at(row)).condition;
    return condition > few_digits_condition ? condition * attitude_error(from_, numbers, 0.5 * last_place(numbers))
                                            : 0.0;
}

} // namespace rotconv
