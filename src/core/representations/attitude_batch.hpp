#pragma once

#include <cstddef>

#include <rotconv/reading.hpp>

#include "../numerics/row_batch.hpp"

namespace rotconv {

// NOLINTBEGIN(*-avoid-c-arrays, *-member-init): nothing inline of the standard library goes into sources of several
// targets, and a batch is not written twice

/// The attitudes that the rows of a batch describe, w, x, y, z; not set at first. As in Rotation the quaternions are
/// not normalised, |q|^2 is in [1/4, 4), and both signs of q are the same attitude. T is the scalar, double or
/// DoubleDouble.
template <class T> struct AttitudeBatch : Columns<T, 4> {
    double defect[batch_rows]; ///< up to `reported_defect` a bound on it
    /// Of DoubleDouble: each component is off by at most 2^-99 of itself and this; the quaternion may be of any length
    /// near that which is here. 0 where no sum has cancelled, so that what is 0 is 0.
    double off[batch_rows];
    Error error[batch_rows]; ///< where there is one, the quaternion means nothing
    /// They were given as quaternions, and these rows were not scaled: they keep their bits where they are unit to 4
    /// eps.
    bool is_as_given[batch_rows];
    bool are_quaternions = false;

    /// Rounded.
    [[nodiscard]] ROTCONV_INLINE Rotation at(std::size_t row) const noexcept {
        const auto& q = this->columns;
        return Rotation::near_unit(q[0].hi[row], q[1].hi[row], q[2].hi[row], q[3].hi[row]);
    }
};

// NOLINTEND(*-avoid-c-arrays, *-member-init)

} // namespace rotconv
