#pragma once

#include <Eigen/Core>

#include <rotconv/reading.hpp>

/// The Gibbs vector, Rodrigues parameters: tan(theta/2) n, with R = (I + [c]_x)(I - [c]_x)^-1 (Stuelpnagel 1964,
/// section 6, whose s is -c). Represents no half-turn.
namespace rotconv::cayley {

/// q ~ (1, c): nothing is rounded. Fault: not_finite.
[[nodiscard]] inline Reading to_rotation(const Eigen::Vector3d& c) noexcept {
    if (!c.allFinite()) [[unlikely]] {
        return Reading::failed(Fault::not_finite);
    }
    return {.rotation = Rotation::from_components(1.0, c.x(), c.y(), c.z())};
}

/// c = v/w. Where w is 0 or a quotient overflows, infinite with the sign of each component that is not 0, and 0
/// elsewhere.
[[nodiscard]] Eigen::Vector3d from_rotation(const Rotation& rotation) noexcept;

/// Margin pi - theta, condition (1 + |c|^2)/2.
[[nodiscard]] Figures figures(const Rotation& rotation) noexcept;

} // namespace rotconv::cayley
