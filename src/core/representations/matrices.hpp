#pragma once

#include <rotconv/reading.hpp>

namespace rotconv {

/// A quaternion near that of the polar factor of a finite matrix of any size, nine numbers row by row, and the matrix's
/// defect. Errors: not_proper, where the determinant, whose sign is exact, is not above 0; rank_deficient, where the
/// two smaller singular values are together below 1e-12 of the largest, so that nothing tells how far the matrix turns.
[[nodiscard]] Error read_far_matrix(const double* matrix, double* q, double& defect) noexcept;

/// Largest singular value of M - (polar factor of M); see dcm::defect().
[[nodiscard]] double defect_of_matrix(const double* matrix) noexcept;
/// The same of two columns, one behind the other; see two_column::defect().
[[nodiscard]] double defect_of_columns(const double* columns) noexcept;

} // namespace rotconv
