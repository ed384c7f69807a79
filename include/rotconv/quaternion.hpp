#pragma once

#include <cmath>
#include <limits>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <rotconv/reading.hpp>

/// Euler-Rodrigues parameters, the unit quaternion (Stuelpnagel 1964, section 5; Baruh 1999). Two-to-one (q and -q are
/// the same attitude), linear kinematics, no singular attitude.
namespace rotconv::quaternion {

/// The attitude q/|q|. Exact: nothing is rounded. The defect is | |q| - 1 |; up to `reported_defect` it may be an upper
/// bound. Errors: not_finite, zero_quaternion, defect above the tolerance.
[[nodiscard]] Reading to_rotation(const Eigen::Quaterniond& q, double tolerance = default_tolerance) noexcept;

/// | |q| - 1 |.
/// @pre to_rotation(q) has a rotation
[[nodiscard]] double defect(const Eigen::Quaterniond& q) noexcept;

/// q/|q| with w > 0, or w = 0 and the first nonzero of x, y, z positive. Worst error found: 0.89 eps. A quaternion that
/// is unit to 4 eps keeps its bits.
[[nodiscard]] Eigen::Quaterniond from_rotation(const Rotation& rotation) noexcept;

/// Margin infinite, condition 1/2.
[[nodiscard]] Sensitivity sensitivity(const Rotation& rotation) noexcept;

/// The rates: q (0, w)/2, or (0, w) q/2 in reference axes (Stuelpnagel section 5, of the conjugate: udot = sigma u).
/// Linear in q; the norm of q, whatever it is, does not change.
[[nodiscard]] Eigen::Quaterniond rate(const Eigen::Quaterniond& q, const Eigen::Vector3d& w,
                                      Frame frame = Frame::body) noexcept;

/// Vector part of 2 q* qdot/|q|^2, or 2 qdot q*/|q|^2, for any norm. A rate of the norm itself is left out.
/// @pre q is not 0
[[nodiscard]] Eigen::Vector3d angular_velocity(const Eigen::Quaterniond& q, const Eigen::Quaterniond& rates,
                                               Frame frame = Frame::body) noexcept;

// The rest is inline because it is short and often called.

/// to_rotation() of a quaternion that is far from unit or does not describe an attitude.
[[nodiscard]] Reading to_rotation_of_any_size(const Eigen::Quaterniond& q, double tolerance) noexcept;

[[gnu::always_inline]] inline Reading to_rotation(const Eigen::Quaterniond& q, double tolerance) noexcept {
    const double excess = std::fabs(squared_norm(q.w(), q.x(), q.y(), q.z()) - 1.0);
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ // then the comparison is no check for nan
    const bool is_finite =
        has_finite_bits(q.w()) && has_finite_bits(q.x()) && has_finite_bits(q.y()) && has_finite_bits(q.z());
#else
    constexpr bool is_finite = true; // a number that is not fails the comparison
#endif
    // | |q| - 1 | = | |q|^2 - 1 |/(|q| + 1)
    if (is_finite && excess <= reported_defect && excess <= tolerance) [[likely]] {
        return {Rotation::near_unit(q.w(), q.x(), q.y(), q.z()), excess};
    }
    return to_rotation_of_any_size(q, tolerance);
}

inline Eigen::Quaterniond from_rotation(const Rotation& rotation) noexcept {
    const double squared_norm = rotation.squared_norm();
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    const bool is_unit = std::fabs(squared_norm - 1.0) <= rounding;
    const double factor = is_unit ? rotation.sign() : rotation.sign() / std::sqrt(squared_norm);
    return {rotation.w() * factor, rotation.x() * factor, rotation.y() * factor, rotation.z() * factor};
}

} // namespace rotconv::quaternion
