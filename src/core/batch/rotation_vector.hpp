#pragma once

#include "../numerics/elementary.hpp"
#include "scaling.hpp"

// The formulas of rotation vectors for one row, over a scalar, double or Real.

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// A rotation vector times a power of two, its largest component of size 1/2 to 1, and its length, to 106 bits since it
/// counts twice.
struct ScaledRotationVector {
    ROTCONV_INLINE ScaledRotationVector() noexcept = default;
    ROTCONV_INLINE ScaledRotationVector(double x_, double y_, double z_) noexcept {
        const Scale scale = scale_to_unit(largest_magnitude(x_, y_, z_));
        x = x_ * scale.there;
        y = y_ * scale.there;
        z = z_ * scale.there;
        back = scale.back;
        length = root(sum_of_squares(x, y, z));
    }

    /// Of the turn, in the vector's unit.
    [[nodiscard]] ROTCONV_INLINE Real half_angle() const noexcept { return scaled(length, 0.5 * back); }

    double x, y, z;
    double back; ///< what the power was
    Real length; ///< of (x, y, z)
};

/// 1 in the unit, in radians, halved.
[[nodiscard]] ROTCONV_INLINE Real half_unit_in_radians(AngleUnit unit) noexcept {
    return unit == AngleUnit::degrees ? scaled(exact_radians_per_degree, 0.5) : Real(0.5);
}

/// (|v| cos, sin v) of the half angle, where v is the scaled vector: of length 1/2 to sqrt 3. Of very small vectors
/// (1, v/2).
template <class T> ROTCONV_INLINE void quaternion_of(const ScaledRotationVector& v, const SineCosine<T>& half,
                                                     Real half_unit, T (&q)[4]) noexcept {
    // there sin(x) = x; the products are kept away from underflow
    const bool tiny = v.back < 0x1p-200;
    const T sine = choose(tiny, rounded_to<T>(half_unit), half.sine);
    const double factor = tiny ? v.back : 1.0;
    q[0] = choose(tiny, T(1.0), rounded_to<T>(v.length * half.cosine));
    q[1] = scaled(sine * v.x, factor);
    q[2] = scaled(sine * v.y, factor);
    q[3] = scaled(sine * v.z, factor);
}

} // namespace ROTCONV_TARGET
} // namespace rotconv
