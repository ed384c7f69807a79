#pragma once

#include <Eigen/Core>

#include <rotconv/reading.hpp>

/// The Gibbs vector, Rodrigues parameters: tan(theta/2) n, with R = (I + [c]_x)(I - [c]_x)^-1 (Stuelpnagel 1964,
/// section 6, whose s is -c). A half-turn has no Gibbs vector.
namespace rotconv::cayley {

/// q ~ (1, c): nothing is rounded. Error: not_finite.
[[nodiscard]] inline Reading to_rotation(const Eigen::Vector3d& c) noexcept {
    if (!(has_finite_bits(c.x()) && has_finite_bits(c.y()) && has_finite_bits(c.z()))) [[unlikely]] {
        return Error::not_finite;
    }
    return Rotation::from_components(1.0, c.x(), c.y(), c.z());
}
[[nodiscard]] Reading to_rotation(const DynamicMatrix auto& numbers) {
    return to_rotation(sized<Eigen::Vector3d>(numbers));
}

/// c = v/w. If w is 0 or a quotient overflows, each component of v that is not 0 becomes infinite with its sign,
/// and the others become 0. Each quotient is rounded once.
[[nodiscard]] Eigen::Vector3d from_rotation(const Rotation& rotation) noexcept;

/// Margin pi - theta, condition (1 + |c|^2)/2.
[[nodiscard]] Sensitivity sensitivity(const Rotation& rotation) noexcept;

/// The rate (w + c x w + c (c.w))/2, the cross product negative in reference axes: Stuelpnagel's Riccati equation of
/// section 6 (of the inverse).
[[nodiscard]] Eigen::Vector3d rate(const Eigen::Vector3d& c, const Eigen::Vector3d& w,
                                   Frame frame = Frame::body) noexcept;

/// 2 (c' - c x c')/(1 + |c|^2), the cross product positive in reference axes.
[[nodiscard]] Eigen::Vector3d angular_velocity(const Eigen::Vector3d& c, const Eigen::Vector3d& rates,
                                               Frame frame = Frame::body) noexcept;

} // namespace rotconv::cayley
