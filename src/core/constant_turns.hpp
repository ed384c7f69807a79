#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <rotconv/alignment.hpp>

namespace rotconv {

struct LargestAngle {
    double angle = 0.0;  ///< radians
    std::size_t row = 0; ///< the first with it
};

/// See Alignment.
[[nodiscard]] ConstantTurns constant_turns(AlignedSide side, std::span<const Rotation> unknown,
                                           std::span<const Rotation> known);

/// What is left of the angles between them.
[[nodiscard]] LargestAngle largest_angle(const ConstantTurns& turns, std::span<const Rotation> unknown,
                                         std::span<const Rotation> known) noexcept;

/// The turns of the axes' names that are nearest, where they are near: that of the first side, and that of the other as
/// it fits the first.
[[nodiscard]] ConstantTurns with_named_axes(const ConstantTurns& turns, AlignedSide first,
                                            std::span<const Rotation> unknown, std::span<const Rotation> known);

/// sin(theta/2) cos(theta/2) n of the turn from a to b in body axes: whatever the signs of the quaternions.
[[nodiscard]] Eigen::Vector3d relative_vector(const Rotation& a, const Rotation& b) noexcept;

/// At most `count` rows that are as far from each other as may be: each the farthest from those before it.
[[nodiscard]] std::vector<std::size_t> spread_rows(std::span<const Rotation> attitudes, std::size_t count);

} // namespace rotconv
