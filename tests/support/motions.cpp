#include "motions.hpp"

#include <cmath>

namespace motions {
namespace {

enum Axis { x, y, z };

} // namespace

oracle::Quaternion Motion::attitude(const oracle::Real& time) const {
    oracle::Quaternion q = oracle::Quaternion::Identity();
    for (const Turn& turn : turns) {
        const oracle::Real angle = turn.offset + turn.slope * time + turn.amplitude * sin(turn.frequency * time);
        q = q * oracle::about(oracle::Vector3::Unit(turn.axis), angle);
    }
    q.normalize();
    return q;
}

Eigen::Vector3d Motion::omega(double time) const {
    Eigen::Vector3d w = Eigen::Vector3d::Zero();
    for (const Turn& turn : turns) {
        const double angle = turn.offset + turn.slope * time + turn.amplitude * std::sin(turn.frequency * time);
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const int second = (turn.axis + 1) % 3;
        const int third = (turn.axis + 2) % 3;
        const double along = w[second];
        w[second] = c * along + s * w[third];
        w[third] = c * w[third] - s * along;
        w[turn.axis] += turn.slope + turn.amplitude * turn.frequency * std::cos(turn.frequency * time);
    }
    return w;
}

Motion spin() {
    const double azimuth = std::atan2(2.0, 1.0);
    const double elevation = std::acos(2.0 / 3.0);
    return {"spin", {{z, azimuth}, {y, elevation}, {z, 0.0, 1.5}, {y, -elevation}, {z, -azimuth}}};
}

Motion coning() { return {"coning", {{z, 0.0, 5.0}, {x, 0.1}, {z, 0.0, -5.0}}}; }

Motion symmetric_body() { return {"symmetric body", {{z, 0.0, 1.1}, {x, 0.7}, {z, 0.0, 0.9}}}; }

Motion gentle() { return {"gentle", {{z, 0.2, 0.0, 0.5, 0.7}, {y, 0.1, 0.0, 0.3, 1.1}, {x, 0.0, 0.0, 0.6, 1.6}}}; }

Motion through_lock() { return {"through lock", {{z, 0.0, 0.3}, {y, 0.0, 1.0}, {x, 0.0, 0.0, 0.5, 1.3}}}; }

Motion tumbling() {
    return {"tumbling", {{x, -0.9, 1.5, 0.2, 1.1}, {y, -0.5, 0.4, 0.1, 1.0}, {z, -0.5, 1.3, 0.1, 1.8}}};
}

std::vector<Motion> all() { return {spin(), coning(), symmetric_body(), gentle(), through_lock(), tumbling()}; }

} // namespace motions
