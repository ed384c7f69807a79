#pragma once

#include <cstddef>

#include <rotconv/reading.hpp>

#include "../numerics/row_batch.hpp"
#include "double_double.hpp"

namespace rotconv::ROTCONV_EXACT {

/// One number of each row of a batch.
struct Column {
    double hi[batch_rows];
    double lo[batch_rows];

    ROTCONV_INLINE Real operator[](std::size_t row) const noexcept { return {hi[row], lo[row]}; }
    ROTCONV_INLINE void set(std::size_t row, Real value) noexcept {
        hi[row] = value.hi;
        lo[row] = value.lo;
    }
};

/// The attitudes of a batch; not set at first. As in Rotation the quaternions are not normalised, |q|^2 is in [1/4, 4),
/// and both signs of q are the same attitude.
struct Rotations {
    Column w, x, y, z;
    /// They come from quaternions, which keep their bits where they are doubles and unit to 4 eps.
    bool as_given = false;

    void set(std::size_t row, Real w_, Real x_, Real y_, Real z_) noexcept {
        w.set(row, w_);
        x.set(row, x_);
        y.set(row, y_);
        z.set(row, z_);
    }
};

/// A batch of what numbers describe; defect and error as those of Reading. Rows with an error have some finite attitude
/// all the same.
struct Readings : Rotations {
    double defect[batch_rows];
    Error error[batch_rows];
};

} // namespace rotconv::ROTCONV_EXACT
