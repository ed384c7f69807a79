#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "../numerics/angles.hpp"
#include "../numerics/double_double.hpp"
#include "rotation_batch.hpp"

namespace rotconv {

/// A batch of quaternions with the sign that is printed: the vector parts, their lengths, and (w, length), whose angle
/// is half the angle of the turn.
struct AxisHalfAngles {
    BatchColumn x, y, z;
    PlaneVectors half;
    BatchColumn length_low; ///< what the length was rounded by
    BatchColumn inverse;    ///< 1/length, rounded

    [[nodiscard]] Eigen::Vector3d vector(std::size_t row) const noexcept { return {x[row], y[row], z[row]}; }
    [[nodiscard]] Root length(std::size_t row) const noexcept { return {half.y[row], length_low[row], inverse[row]}; }
};

/// Lengths below this are not known: the squares have lost digits.
inline constexpr double least_known_length = 1e-130;

/// |(x, y, z)| and its inverse to twice the precision, for a size between 1e-130 and 2.
inline Root length_of(Split x, Split y, Split z) noexcept {
    return root_of((x.high * x.high + y.high * y.high) + z.high * z.high,
                   (rest_of_square(x) + rest_of_square(y)) + rest_of_square(z));
}

void take_apart(const Rotations& rotations, std::size_t rows, AxisHalfAngles& parts) noexcept;

} // namespace rotconv
