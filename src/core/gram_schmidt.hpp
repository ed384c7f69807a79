#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

#include "davenport.hpp"
#include "lanes.hpp"

namespace rotconv {

/// The rotation of two nonzero directions, or a fault; columns of any finite length.
[[nodiscard]] Reading gram_schmidt(Eigen::Vector3d first, Eigen::Vector3d second) noexcept;

/// Two columns of each row, the first above the second.
using ColumnLanes = std::array<Lane, 6>;

/// Gram-Schmidt on columns that are orthonormal but for `square`, the sum of the squares of what is missing. It leaves
/// an orthogonal matrix, and one power step its polar factor, where that is at most clean_square.
void gram_schmidt(const ColumnLanes& m, std::size_t rows, Readings& readings, Lane& square) noexcept;

/// Reads a block of columns, and by `read_any(row)` those that are not clean.
template <class ReadAny>
void read_columns(const ColumnLanes& m, std::size_t rows, Readings& readings, const ReadAny& read_any) noexcept {
    Lane square; // NOLINT(*-member-init): written before it is read
    gram_schmidt(m, rows, readings, square);
    for (std::size_t i = 0; i < rows; ++i) {
        readings.fault[i] = Fault::none;
        if (!(square[i] <= clean_square)) [[unlikely]] {
            readings.set(i, read_any(i));
        }
    }
}

} // namespace rotconv
