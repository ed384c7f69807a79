#include "constant_turns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <rotconv/dcm.hpp>

#include "representations/half_turn.hpp"

namespace rotconv {

Eigen::Vector3d relative_vector(const Rotation& a, const Rotation& b) noexcept {
    const Rotation turn = a.inverse() * b;
    return Eigen::Vector3d(turn.x(), turn.y(), turn.z()) * (turn.w() / turn.squared_norm());
}

std::vector<std::size_t> spread_rows(std::span<const Rotation> attitudes, std::size_t count) {
    std::vector<std::size_t> rows{0};
    std::vector<double> nearest(attitudes.size(), std::numeric_limits<double>::infinity());
    while (rows.size() < std::min(count, attitudes.size())) {
        for (std::size_t i = 0; i < attitudes.size(); ++i) {
            nearest[i] = std::min(nearest[i], angle_of(attitudes[i] * attitudes[rows.back()].inverse()));
        }
        const auto farthest = std::ranges::max_element(nearest);
        rows.push_back(static_cast<std::size_t>(farthest - nearest.begin()));
    }
    return rows;
}

ConstantTurns constant_turns(AlignedSide side, std::span<const Rotation> unknown, std::span<const Rotation> known) {
    Alignment alignment(side);
    for (std::size_t i = 0; i < known.size(); ++i) {
        alignment.add(unknown[i], known[i]);
    }
    return alignment.some_turns();
}

LargestAngle largest_angle(const ConstantTurns& turns, std::span<const Rotation> unknown,
                           std::span<const Rotation> known) noexcept {
    LargestAngle largest;
    for (std::size_t i = 0; i < known.size(); ++i) {
        const double angle = angle_of(turns.left * unknown[i] * turns.right * known[i].inverse());
        if (angle > largest.angle) {
            largest = {angle, i};
        }
    }
    return largest;
}

ConstantTurns with_named_axes(const ConstantTurns& turns, AlignedSide first, std::span<const Rotation> unknown,
                              std::span<const Rotation> known) {
    const auto named = [](const Rotation& rotation) {
        const Dcm rounded = dcm::from_rotation(rotation).array().round();
        const Reading reading = dcm::to_rotation(rounded, 0.0);
        return reading ? *reading : rotation;
    };
    const bool left_first = first == AlignedSide::reference;
    ConstantTurns found{left_first ? named(turns.left) : Rotation(), left_first ? Rotation() : named(turns.right)};
    Alignment other(left_first ? AlignedSide::body : AlignedSide::reference);
    for (std::size_t i = 0; i < known.size(); ++i) {
        other.add(found.left * unknown[i] * found.right, known[i]);
    }
    (left_first ? found.right : found.left) = named(left_first ? other.some_turns().right : other.some_turns().left);
    return found;
}

} // namespace rotconv
