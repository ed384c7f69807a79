#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <rotconv/identification.hpp>

namespace rotconv {

/// known = left unknown right, in all rows.
struct ConstantTurns {
    Rotation left;
    Rotation right;
};

struct LargestAngle {
    double angle = 0.0;  ///< radians
    std::size_t row = 0; ///< the first with it
};

/// The turns with the least sum of squared sines of the half angles that are left: on one side the eigenvector of the
/// sum of q q' (Markley, Cheng, Crassidis and Oshman, "Averaging Quaternions", 2007); on both by turns, from the
/// rotation that aligns the vectors of relative turns.
/// @pre as many rows of either, at least one
[[nodiscard]] ConstantTurns constant_turns(TurnedSide side, std::span<const Rotation> unknown,
                                           std::span<const Rotation> known);

/// What is left of the angles between them.
[[nodiscard]] LargestAngle largest_angle(const ConstantTurns& turns, std::span<const Rotation> unknown,
                                         std::span<const Rotation> known) noexcept;

/// The turns of the axes' names that are nearest, where they are near: that of the first side, and that of the other as
/// it fits the first.
[[nodiscard]] ConstantTurns with_named_axes(const ConstantTurns& turns, TurnedSide first,
                                            std::span<const Rotation> unknown, std::span<const Rotation> known);

/// sin(theta/2) cos(theta/2) n of the turn from a to b in body axes: whatever the signs of the quaternions.
[[nodiscard]] Eigen::Vector3d relative_vector(const Rotation& a, const Rotation& b) noexcept;

/// At most `count` rows that are as far from each other as may be: each the farthest from those before it.
[[nodiscard]] std::vector<std::size_t> spread_rows(std::span<const Rotation> attitudes, std::size_t count);

} // namespace rotconv
