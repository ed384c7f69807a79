#pragma once

#include <string>
#include <vector>

#include "oracle.hpp"

/// Motions whose attitude and angular velocity are known in closed form: products of turns about coordinate axes.
namespace motions {

/// A turn by offset + slope t + amplitude sin(frequency t).
struct Turn {
    int axis;
    double offset = 0.0;
    double slope = 0.0;
    double amplitude = 0.0;
    double frequency = 0.0;
};

/// Intrinsic turns, one after the other.
struct Motion {
    std::string name;
    std::vector<Turn> turns;

    [[nodiscard]] oracle::Quaternion attitude(const oracle::Real& time) const;
    /// The body's angular velocity in body axes.
    [[nodiscard]] Eigen::Vector3d omega(double time) const;
};

/// 1.5 rad/s about (1, 2, 2)/3, through a half-turn every 4.2 s.
Motion spin();
/// An axis 0.1 rad off the vertical goes round it at 5 rad/s, without spin.
Motion coning();
/// The torque-free motion of a symmetric body: precession 1.1, nutation 0.7 and spin 0.9.
Motion symmetric_body();
/// Yaw, pitch and roll that swing by less than 0.6 rad.
Motion gentle();
/// Pitch grows steadily: exactly through the lock of euler:ZYX, first at 1.57 s.
Motion through_lock();
/// Up to 3 rad/s about changing axes, through half-turns and, in 20 s, past the lock of euler:ZYX at 0.0370 rad (3.907
/// s).
Motion tumbling();
/// All six.
std::vector<Motion> all();

} // namespace motions
