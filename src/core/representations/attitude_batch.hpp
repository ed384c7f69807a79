#pragma once

#include <cstddef>

#include <rotconv/reading.hpp>

#include "../numerics/row_batch.hpp"

namespace rotconv {

// NOLINTBEGIN(*-avoid-c-arrays): nothing inline of the standard library goes into sources of several targets

/// The attitudes that the rows of a batch describe; not set at first. As in Rotation the quaternions are not
/// normalised, |q|^2 is in [1/4, 4), and both signs of q are the same attitude. T is the scalar, double or
/// DoubleDouble.
template <class T> struct AttitudeBatch {
    Column<T> w, x, y, z;
    double defect[batch_rows]; ///< up to `reported_defect` a bound on it
    Error error[batch_rows];   ///< where there is one, the quaternion means nothing
    /// They were given as quaternions, and these rows were not scaled: they keep their bits where they are unit to 4
    /// eps.
    bool is_as_given[batch_rows];
    bool are_quaternions = false;

    ROTCONV_INLINE void set(std::size_t row, T w_, T x_, T y_, T z_) noexcept {
        w.set(row, w_);
        x.set(row, x_);
        y.set(row, y_);
        z.set(row, z_);
    }
    ROTCONV_INLINE void set(std::size_t row, const T (&q)[4]) noexcept { set(row, q[0], q[1], q[2], q[3]); }
    ROTCONV_INLINE void get(std::size_t row, T (&q)[4]) const noexcept {
        q[0] = w[row];
        q[1] = x[row];
        q[2] = y[row];
        q[3] = z[row];
    }

    /// Rounded.
    [[nodiscard]] ROTCONV_INLINE Rotation at(std::size_t row) const noexcept {
        return Rotation::near_unit(w.hi[row], x.hi[row], y.hi[row], z.hi[row]);
    }
};

// NOLINTEND(*-avoid-c-arrays)

} // namespace rotconv
