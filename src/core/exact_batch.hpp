#pragma once

#include <cstddef>

#include <rotconv/spec.hpp>

#include "representations/rotation_batch.hpp"

namespace rotconv {

/// A quaternion of 106 bits: w, x, y, z in two parts each, as those of Rotation.
struct ExactQuaternion {
    // NOLINTBEGIN(*-avoid-c-arrays): as in the sources that are compiled for newer processors
    double hi[4];
    double lo[4];
    // NOLINTEND(*-avoid-c-arrays)
};

/// What a batch of an exact conversion needs to know beside its rows.
struct ExactBatch {
    const Spec* from;
    const Spec* to;
    double lock_margin;
    const ExactQuaternion* left;  ///< turns the attitudes, as they are written, from the left; or null
    const ExactQuaternion* right; ///< or from the right
};

/// The functions of one kind of processor.
struct ExactFunctions {
    /// Converts rows, at most `batch_rows`, from one representation's own order to the other's, each number rounded
    /// once. `readings` become the attitudes that are written, rounded, with the defects and errors of the rows;
    /// `diagnostics` are empty at first.
    void (*convert)(const ExactBatch& batch, const double* in, std::size_t rows, Readings& readings, double* out,
                    DiagnosticSet* diagnostics) noexcept;
    /// Reads one row of a SPEC, not yet inverted where that is passive.
    void (*read)(const Spec& spec, const double* numbers, ExactQuaternion& attitude) noexcept;
};

/// Those that this processor is best at. All give the same numbers.
[[nodiscard]] const ExactFunctions& exact_functions() noexcept;

} // namespace rotconv
