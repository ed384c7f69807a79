#pragma once

#include <cstddef>

#include "../numerics/elementary.hpp"
#include "../representations/rotation_batch.hpp"
#include "rows.hpp"
#include "scaling.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// A batch of quaternions with the sign that is printed, their vector parts as a direction and a length. The length and
/// the angle count in every number, the angle twice: they have 106 bits, or what T has left of them.
template <class T> struct AxisHalfAngles {
    Column<T> x, y, z;       ///< the vector part times a power of two, its largest component of size 1/2 to 1
    double back[batch_rows]; ///< what the power was
    Column<Real> length;     ///< of (x, y, z)
    Column<T> w;
    Column<Real> angle; ///< of the turn, times the same power where the vector part is below 2^-200; by find_angles()
    double angle_back[batch_rows];

    void take_apart(const BasicRotations<T>& rotations, std::size_t rows) noexcept {
        for (std::size_t i = 0; i < rows; ++i) {
            const double sign =
                printed_sign(rotations.w.hi[i], rotations.x.hi[i], rotations.y.hi[i], rotations.z.hi[i]);
            const Scale scale =
                scale_to_unit(largest_magnitude(rotations.x.hi[i], rotations.y.hi[i], rotations.z.hi[i]));
            const T own_x = scaled(rotations.x[i], sign * scale.there);
            const T own_y = scaled(rotations.y[i], sign * scale.there);
            const T own_z = scaled(rotations.z[i], sign * scale.there);
            x.set(i, own_x);
            y.set(i, own_y);
            z.set(i, own_z);
            w.set(i, scaled(rotations.w[i], sign));
            length.set(i, root(sum_of_squares(own_x, own_y, own_z)));
            back[i] = scale.back;
        }
    }

    /// After take_apart().
    void find_angles(std::size_t rows, AngleUnit unit) noexcept {
        Column<T> unscaled;
        for (std::size_t i = 0; i < rows; ++i) {
            unscaled.set(i, rounded_to<T>(scaled(length[i], back[i])));
        }
        angles_of(w, unscaled, rows, unit, angle);
        const Real unit_factor = scaled(unit == AngleUnit::degrees ? exact_degrees_per_radian : Real(1.0), 2.0);
        for (std::size_t i = 0; i < rows; ++i) {
            // there tan(x) = x, and what the length lost below the smallest double is not needed
            const bool tiny = back[i] < 0x1p-200;
            const Real linear = length[i] / choose(tiny, Real(w[i]), Real(1.0)) * unit_factor;
            angle.set(i, choose(tiny, linear, scaled(angle[i], 2.0)));
            angle_back[i] = tiny ? back[i] : 1.0;
        }
    }
};

/// pi - theta <= half_turn_margin.
[[nodiscard]] ROTCONV_INLINE bool is_half_turn(double w, double length, double back) noexcept {
    return w <= 0.5 * half_turn_margin * (length * back);
}

} // namespace ROTCONV_TARGET
} // namespace rotconv
