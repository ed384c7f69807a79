#include <rotconv/conversion.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "batch.hpp"
#include "read_batch.hpp"
#include "representations/constant_turns.hpp"

namespace rotconv {
namespace {

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

Reading read_attitude(const Spec& spec, std::span<const double> numbers) noexcept {
    std::array<double, most_numbers> own{};
    to_own_order(spec, numbers.data(), 1, own.data());
    const Reading reading = read_row(spec, own.data());
    return reading && spec.passive ? Reading(reading->inverse(), reading.defect()) : reading;
}

ConstantTurn ConstantTurn::of_numbers(const Spec& spec, std::span<const double> numbers) noexcept {
    std::array<double, most_numbers> own{};
    to_own_order(spec, numbers.data(), 1, own.data());
    ExactQuaternion q{};
    batch_functions().read_exactly(spec, own.data(), q);
    const ConstantTurn turn(Rotation::near_unit(q.hi[0], q.hi[1], q.hi[2], q.hi[3]),
                            {q.lo[0], q.lo[1], q.lo[2], q.lo[3]});
    return spec.passive ? turn.inverse() : turn;
}

Conversion::Conversion(const Spec& from, const Spec& to, const Settings& settings)
    : from_(from), to_(to), settings_(settings), out_codec_(&codec_of(to.name)) {}

void Conversion::run(std::span<const double> in, std::span<double> out, std::vector<Report>& reports) const {
    reports.clear();
    const std::size_t rows = in.size() / from_.size();
    for (std::size_t first = 0; first < rows; first += batch_rows) {
        run_batch(in.data() + first * from_.size(), first, std::min(batch_rows, rows - first),
                  out.data() + first * to_.size(), reports);
    }
}

void Conversion::convert(ReadBatch& readings, std::size_t rows, double* numbers, DiagnosticSet* diagnostics) const {
    const ConstantTurns turns(settings_, to_.passive);
    if (!settings_.fast) {
        const ExactBatch batch{&from_, &to_, settings_.lock_margin, turns.left(), turns.right()};
        batch_functions().convert(batch, readings.own(), rows, readings, numbers, diagnostics);
        return;
    }
    readings.read(from_, rows);
    if (from_.passive != to_.passive) {
        readings.invert(rows);
    }
    if (turns.any()) {
        turns.turn(readings, rows);
    }
    batch_functions().write(to_, settings_.lock_margin, readings, rows, numbers, diagnostics);
}

void Conversion::run_batch(const double* in, std::size_t first, std::size_t rows, double* out,
                           std::vector<Report>& reports) const {
    ReadBatch readings(from_, in, rows);
    std::array<DiagnosticSet, batch_rows> diagnostics;
    const std::size_t width = to_.size();
    if (to_.is_reordered()) {
        std::array<double, batch_rows * most_numbers> numbers;
        convert(readings, rows, numbers.data(), diagnostics.data());
        to_written_order(to_, numbers.data(), rows, out);
    } else {
        convert(readings, rows, out, diagnostics.data());
        drop_minus_zero(out, rows * width);
    }
    const double largest_defect = settings_.sensitivity ? -1.0 : std::min(settings_.tolerance, reported_defect);
    if (!any_remarkable(readings, diagnostics.data(), rows, largest_defect)) {
        return;
    }
    for (std::size_t i = 0; i < rows; ++i) {
        if (readings.defect[i] <= largest_defect && readings.error[i] == Error::none && diagnostics[i].empty()) {
            continue;
        }
        Report found = readings.report(i, settings_);
        if (found.error != Error::none) {
            std::fill_n(out + i * width, width, std::numeric_limits<double>::quiet_NaN());
        } else {
            found.diagnostics |= diagnostics[i];
            if (!settings_.sensitivity && found.diagnostics.empty()) {
                continue;
            }
            if (settings_.sensitivity || !diagnostics[i].empty()) { // inexact input alone asks for none
                found.sensitivity = out_codec_->sensitivity(to_, readings.at(i));
            }
        }
        found.row = first + i;
        reports.push_back(found);
    }
}

} // namespace rotconv
