#pragma once

namespace rotconv {

/// 1, 0 or -1: the exact sign of the determinant of nine finite numbers, row by row.
[[nodiscard]] int determinant_sign(const double* m) noexcept;

} // namespace rotconv
