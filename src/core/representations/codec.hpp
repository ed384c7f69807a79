#pragma once

#include <cstddef>

#include <rotconv/reading.hpp>
#include <rotconv/spec.hpp>

#include "../numerics/row_batch.hpp"

namespace rotconv {

/// How batches of rows are read and written, at most `batch_rows` of them, numbers in the representation's own order
/// and the attitude not yet inverted: what is left of the conventions is the sequence and the unit.
struct Codec {
    void (*read)(const Spec& spec, const double* numbers, std::size_t rows, Readings& readings) noexcept;
    /// The defect in full, where `read` returns a bound only; null elsewhere.
    double (*exact_defect)(const double* numbers) noexcept;
    /// Also diagnostics what there is to note of each row.
    void (*write)(const Spec& spec, double lock_margin, const Rotations& rotations, std::size_t rows, double* numbers,
                  DiagnosticSet* diagnostics) noexcept;
    Sensitivity (*sensitivity)(const Spec& spec, const Rotation& rotation) noexcept;

    /// One row.
    [[nodiscard]] Reading read_row(const Spec& spec, const double* numbers) const noexcept {
        Readings one; // NOLINT(*-member-init)
        read(spec, numbers, 1, one);
        return one.reading(0);
    }

    /// One row, with nothing given up to lock.
    void write_row(const Spec& spec, const Rotation& rotation, double* numbers) const noexcept {
        DiagnosticSet diagnostics;
        write(spec, 0.0, OneRotation(rotation), 1, numbers, &diagnostics);
    }
};

[[nodiscard]] const Codec& codec_of(RepresentationId name) noexcept;

} // namespace rotconv
