#pragma once

#include <rotconv/reading.hpp>

#include "../numerics/power_of_two.hpp"

namespace rotconv {

/// The square of how far a matrix or two columns are from orthonormal, up to which the defect is not worked out.
inline constexpr double clean_square = 0x1p-58;
/// A bound on that defect.
inline constexpr double clean_defect = 0x1p-27;

/// A quaternion near that of the polar factor of a finite matrix of any size, nine numbers row by row, and the matrix's
/// defect. Errors: not_proper, where the determinant, whose sign is exact, is not above 0; rank_deficient, where the
/// two smaller singular values are together below 1e-12 of the largest, so that nothing tells how far the matrix turns.
[[nodiscard]] Error read_far_matrix(const double* matrix, double* q, double& defect) noexcept;

/// Largest singular value of M - (polar factor of M); see dcm::defect().
[[nodiscard]] double defect_of_matrix(const double* matrix) noexcept;
/// The same of two columns, one behind the other; see two_column::defect().
[[nodiscard]] double defect_of_columns(const double* columns) noexcept;

/// |s - 1| of s^2 - 1, both times a unit, without cancellation.
ROTCONV_INLINE double distance_from_one(double square_excess, double unit = 1.0) noexcept {
    return __builtin_fabs(square_excess) / (unit + root(larger_of(0.0, unit * unit + square_excess)));
}

} // namespace rotconv
