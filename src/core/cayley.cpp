#include <rotconv/cayley.hpp>

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "finite.hpp"
#include "half_turn.hpp"

namespace rotconv::cayley {

Reading to_rotation(const Eigen::Vector3d& c) noexcept {
    if (!all_finite(c.x(), c.y(), c.z())) {
        return Reading::failed(Fault::not_finite);
    }
    return {.rotation = Rotation::from_components(1.0, c.x(), c.y(), c.z())};
}

Eigen::Vector3d from_rotation(const Rotation& rotation) noexcept {
    const Rotation q = rotation.canonical();
    const Eigen::Vector3d v{q.x(), q.y(), q.z()};
    Eigen::Vector3d c = v / q.w();
    if (c.allFinite()) {
        return c;
    }
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return v.unaryExpr([](double component) { return component == 0.0 ? 0.0 : std::copysign(infinity, component); });
}

Notes notes(const Rotation& rotation) noexcept {
    const double length_bound = (std::fabs(rotation.x()) + std::fabs(rotation.y())) + std::fabs(rotation.z());
    // Only a quotient above the largest double is infinite; the cheap bound decides nearly always.
    const bool suspect = length_bound >= std::fabs(rotation.w()) * 0x1p1023;
    return {Kind::infinite, suspect && !from_rotation(rotation).allFinite()};
}

Figures figures(const Rotation& rotation) noexcept {
    const double length = rotation.vector_length() / rotation.w();
    return {.margin = angle_to_half_turn(rotation), .condition = 0.5 * (1.0 + length * length)};
}

Eigen::Vector3d rate(const Eigen::Vector3d& c, const Eigen::Vector3d& w, Frame frame) noexcept {
    const Eigen::Vector3d turn = frame == Frame::body ? c.cross(w) : w.cross(c);
    return 0.5 * (w + turn + c.dot(w) * c);
}

Eigen::Vector3d angular_velocity(const Eigen::Vector3d& c, const Eigen::Vector3d& rates, Frame frame) noexcept {
    const Eigen::Vector3d turn = frame == Frame::body ? rates.cross(c) : c.cross(rates);
    return (2.0 / (1.0 + c.squaredNorm())) * (rates + turn);
}

} // namespace rotconv::cayley
