#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

#include "../numerics/davenport.hpp"
#include "rotation_batch.hpp"

namespace rotconv {

/// The rotation of two nonzero directions, or an error; columns of any finite length.
[[nodiscard]] Reading gram_schmidt(Eigen::Vector3d first, Eigen::Vector3d second) noexcept;

/// Two columns of each row, the first above the second.
using TwoColumns = double[6][batch_rows];

/// Gram-Schmidt on columns that are orthonormal but for `square`, the sum of the squares of what is missing. It leaves
/// an orthogonal matrix, and one power step its polar factor, where that is at most clean_square.
void gram_schmidt(const TwoColumns& m, std::size_t rows, Readings& readings, BatchColumn& square) noexcept;

/// Reads a batch of columns, and by `read_any(row)` those that are not clean.
template <class ReadAny>
void read_columns(const TwoColumns& m, std::size_t rows, Readings& readings, const ReadAny& read_any) noexcept {
    BatchColumn square; // written before it is read
    gram_schmidt(m, rows, readings, square);
    for (std::size_t i = 0; i < rows; ++i) {
        readings.error[i] = Error::none;
        if (!(square[i] <= clean_square)) [[unlikely]] {
            readings.set(i, read_any(i));
        }
    }
}

} // namespace rotconv
