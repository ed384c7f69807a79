#pragma once

#include <Eigen/Core>

#include <rotconv/reading.hpp>

/// Modified Rodrigues parameters, tan(theta/4) n: the stereographic projection of the quaternion (Wiener 1962; Schaub
/// and Junkins 1996). At a half-turn the chart changes to the shadow set -m/|m|^2, so that the norm stays at most 1.
namespace rotconv::mrp {

/// q ~ (1 - |m|^2, 2m), for m of any length. Error: not_finite. Worst error found: 1.31 eps.
[[nodiscard]] Reading to_rotation(const Eigen::Vector3d& m) noexcept;
[[nodiscard]] Reading to_rotation(const DynamicMatrix auto& numbers) {
    return to_rotation(sized<Eigen::Vector3d>(numbers));
}

/// m = v/(|q| + w) with w >= 0; the norm is at most 1. Worst error found: 0.99 eps.
[[nodiscard]] Eigen::Vector3d from_rotation(const Rotation& rotation) noexcept;

/// Margin pi - theta, condition (1 + |m|^2)/4.
[[nodiscard]] Sensitivity sensitivity(const Rotation& rotation) noexcept;

/// The rate B w/4 with B w = (1 - |m|^2) w + 2 m x w + 2 m (m.w), the cross product negative in reference axes (Schaub
/// and Junkins 1996). B is (1 + |m|^2) times an orthogonal matrix. The same equation holds for the shadow.
[[nodiscard]] Eigen::Vector3d rate(const Eigen::Vector3d& m, const Eigen::Vector3d& w,
                                   Frame frame = Frame::body) noexcept;

/// 4 B' m'/(1 + |m|^2)^2.
[[nodiscard]] Eigen::Vector3d angular_velocity(const Eigen::Vector3d& m, const Eigen::Vector3d& rates,
                                               Frame frame = Frame::body) noexcept;

} // namespace rotconv::mrp
