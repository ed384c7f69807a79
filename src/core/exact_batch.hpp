#pragma once

#include <cstddef>

#include <rotconv/spec.hpp>

#include "representations/rotation_batch.hpp"

namespace rotconv {

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

/// Converts rows, at most `batch_rows`, from one representation's own order to the other's, each number rounded once.
/// @param readings become the attitudes that are written, rounded, with the defects and errors of the rows
/// @param diagnostics empty at first
using ConvertExactly = void(const ExactBatch& batch, const double* in, std::size_t rows, Readings& readings,
                            double* out, DiagnosticSet* diagnostics) noexcept;

/// The function of the kind that this processor is best at. All give the same numbers.
[[nodiscard]] ConvertExactly* exact_conversion() noexcept;

} // namespace rotconv
