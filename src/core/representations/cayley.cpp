#include <rotconv/cayley.hpp>

#include <numbers>

#include <Eigen/Geometry>

#include "codec.hpp"
#include "rotation_angle.hpp"

namespace rotconv::cayley {

Eigen::Vector3d from_rotation(const Rotation& rotation) noexcept {
    Eigen::Vector3d c;
    write_row({.name = RepresentationId::cayley}, rotation, c.data());
    return c;
}

Sensitivity sensitivity(const Rotation& rotation) noexcept {
    const double length = rotation.vector_length() / rotation.w();
    return {.margin = angle_to_half_turn(rotation), .condition = 0.5 * (1.0 + length * length)};
}

Eigen::Vector3d rate(const Eigen::Vector3d& c, const Eigen::Vector3d& w, Frame frame) noexcept {
    const Eigen::Vector3d across = frame == Frame::body ? c.cross(w) : w.cross(c);
    return 0.5 * (w + across + c.dot(w) * c);
}

Eigen::Vector3d angular_velocity(const Eigen::Vector3d& c, const Eigen::Vector3d& rates, Frame frame) noexcept {
    const Eigen::Vector3d across = frame == Frame::body ? rates.cross(c) : c.cross(rates);
    return (2.0 / (1.0 + c.squaredNorm())) * (rates + across);
}

} // namespace rotconv::cayley

namespace rotconv {
namespace {

using Eigen::Vector3d;

constexpr auto own_presets = presets_that_mean(passive, "spice", "bunge", "stuelpnagel", "colmap");

double distance_to_half_turn(const Spec& /*spec*/, const double* c) noexcept {
    return 2.0 * angle_of(Eigen::Map<const Vector3d>(c).norm(), 1.0, AngleUnit::radians).hi;
}

} // namespace

constinit const Codec codecs::cayley{.representation = {.name = RepresentationId::cayley,
                                                        .text = "cayley",
                                                        .aliases = {"gibbs", "crp"},
                                                        .size = 3,
                                                        .columns = {"cx", "cy", "cz"},
                                                        .modifiers = {Modifier::passive},
                                                        .presets = own_presets,
                                                        .has_half_turns = false},
                                     .range = "infinite at a half-turn",
                                     .singular = "half-turn",
                                     .singular_attitude = "a half-turn",
                                     .formula = "tan(theta/2) n; R = (I + [c])(I - [c])^-1",
                                     .sensitivity = sensitivity_of<cayley::sensitivity>,
                                     .rate = rate_of<Vector3d, cayley::rate>,
                                     .angular_velocity = angular_velocity_of<Vector3d, cayley::angular_velocity>,
                                     .greatest_distance = std::numbers::pi,
                                     .distance_to_singularity = distance_to_half_turn};

} // namespace rotconv
