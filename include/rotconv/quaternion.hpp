#pragma once

#include <rotconv/reading.hpp>

namespace rotconv {

/// A Hamilton quaternion w + xi + yj + zk of any norm but 0.
struct Quaternion {
    double w = 1.0;
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
};

/// Euler-Rodrigues parameters, the unit quaternion (Stuelpnagel 1964, section 5; Baruh 1999). Two-to-one (q and -q are
/// the same attitude), linear kinematics, no singular attitude.
namespace quaternion {

/// The attitude q/|q|. Exact: nothing is rounded. Faults: not_finite, zero_quaternion. Defect: | |q| - 1 |.
[[nodiscard]] Reading to_rotation(const Quaternion& q) noexcept;

/// q/|q| with w > 0, or w = 0 and the first nonzero of x, y, z positive. Within 1 eps of the attitude: each component
/// is rounded once; a quaternion that is unit to 4 eps keeps its bits.
[[nodiscard]] Quaternion from_rotation(const Rotation& rotation) noexcept;

/// Margin infinite, condition 1/2.
[[nodiscard]] Figures figures(const Rotation& rotation) noexcept;

} // namespace quaternion
} // namespace rotconv
