#pragma once

#include <cstddef>

#include <rotconv/frame.hpp>
#include <rotconv/spec.hpp>

#include "representations/rotation_batch.hpp"

namespace rotconv {

// NOLINTBEGIN(*-avoid-c-arrays): nothing inline of the standard library goes into sources of several targets

/// A quaternion of 106 bits: w, x, y, z in two parts each, as those of Rotation.
struct ExactQuaternion {
    double hi[4];
    double lo[4];
};

/// What a batch of an exact conversion needs to know beside its rows.
struct ExactBatch {
    const Spec* from;
    const Spec* to;
    double lock_margin;
    const ExactQuaternion* left;  ///< turns the attitudes, as they are written, from the left; or null
    const ExactQuaternion* right; ///< or from the right
};

/// What a batch of relative attitudes, R_REF' R or R R_REF', needs to know beside its rows.
struct RelativeBatch {
    const Spec* from;
    const Spec* reference;
    const Spec* to;
    Frame frame;
    double lock_margin;
};

/// How batches of rows, at most `batch_rows`, are read and written by the functions of one kind of processor. Numbers
/// are in the representation's own order, attitudes not yet inverted: of a Spec's conventions the sequence and the unit
/// are left to them. Diagnostics are what there is to remark on each row; the sets are empty at first.
struct BatchFunctions {
    /// In double.
    void (*read)(const Spec& spec, const double* numbers, std::size_t rows, Readings& readings) noexcept;
    void (*write)(const Spec& spec, double lock_margin, const Rotations& rotations, std::size_t rows, double* numbers,
                  DiagnosticSet* diagnostics) noexcept;
    /// The same of one row, q as w, x, y, z.
    Error (*read_one)(const Spec& spec, const double* numbers, double* q, double& defect) noexcept;
    DiagnosticSet (*write_one)(const Spec& spec, double lock_margin, const double* q, double* numbers) noexcept;
    /// From one representation to the other, each number rounded once. `readings` become the attitudes that are
    /// written, rounded, with the defects and errors of the rows.
    void (*convert)(const ExactBatch& batch, const double* in, std::size_t rows, Readings& readings, double* out,
                    DiagnosticSet* diagnostics) noexcept;
    /// The relative attitudes of rows and those of a reference, each number rounded once.
    void (*relate)(const RelativeBatch& batch, const double* in, const double* reference, std::size_t rows, double* out,
                   DiagnosticSet* diagnostics) noexcept;
    /// Reads one row to the last bit.
    void (*read_exactly)(const Spec& spec, const double* numbers, ExactQuaternion& attitude) noexcept;
};

/// Those that this processor is best at. All give the same numbers.
[[nodiscard]] const BatchFunctions& batch_functions() noexcept;

/// One row.
[[nodiscard]] Reading read_row(const Spec& spec, const double* numbers) noexcept;

/// One row; with a lock margin of 0 nothing is given up to lock. Returns what there is to remark on it.
DiagnosticSet write_row(const Spec& spec, const Rotation& rotation, double* numbers, double lock_margin = 0.0) noexcept;

// NOLINTEND(*-avoid-c-arrays)

} // namespace rotconv
