#pragma once

#include <cstddef>

#include <rotconv/angle.hpp>

#include "rotations.hpp"

namespace rotconv::ROTCONV_EXACT {

/// A batch of quaternions with the sign that is printed, their vector parts as a direction and a length.
struct AxisHalfAngles {
    Column x, y, z;          ///< the vector part times a power of two, its largest component of size 1/2 to 1
    double back[batch_rows]; ///< what the power was
    Column length;           ///< of (x, y, z)
    Column w;
    Column angle; ///< of the turn, times the same power where the vector part is below 2^-200; only with find_angles()
    double angle_back[batch_rows];

    void take_apart(const Rotations& rotations, std::size_t rows) noexcept;
    /// After take_apart().
    void find_angles(std::size_t rows, AngleUnit unit) noexcept;
};

/// pi - theta <= half_turn_margin.
[[nodiscard]] ROTCONV_INLINE bool is_half_turn(double w, double length, double back) noexcept {
    return w <= 0.5 * half_turn_margin * (length * back);
}

} // namespace rotconv::ROTCONV_EXACT
