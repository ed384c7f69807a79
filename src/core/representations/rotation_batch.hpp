#pragma once

#include <cstddef>

#include <rotconv/reading.hpp>

#include "../numerics/row_batch.hpp"

namespace rotconv {

// NOLINTBEGIN(*-avoid-c-arrays): nothing inline of the standard library goes into sources of several targets

/// The attitudes of a batch; not set at first. As in Rotation the quaternions are not normalised, |q|^2 is in [1/4, 4),
/// and both signs of q are the same attitude. T is the scalar, double or Real.
template <class T> struct BasicRotations {
    Column<T> w, x, y, z;
    /// They come from quaternions, which keep their bits where they are doubles and unit to 4 eps.
    bool as_given = false;

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
    ROTCONV_INLINE void set(std::size_t row, const Rotation& rotation) noexcept {
        set(row, rotation.w(), rotation.x(), rotation.y(), rotation.z());
    }
};

/// A batch of what numbers describe; see Reading.
template <class T> struct BasicReadings : BasicRotations<T> {
    double defect[batch_rows];
    Error error[batch_rows];

    using BasicRotations<T>::set;
    ROTCONV_INLINE void set(std::size_t row, const Reading& reading) noexcept {
        set(row, reading ? *reading : Rotation()); // something finite in any case
        defect[row] = reading.defect();
        error[row] = reading.error();
    }

    [[nodiscard]] ROTCONV_INLINE Reading reading(std::size_t row) const noexcept {
        return error[row] == Error::none ? Reading(this->at(row), defect[row]) : Reading(error[row]);
    }
};

using Rotations = BasicRotations<double>;
using Readings = BasicReadings<double>;

// NOLINTEND(*-avoid-c-arrays)

} // namespace rotconv
