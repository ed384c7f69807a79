#include <rotconv/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <Eigen/Geometry>

#include "../numerics/power_of_two.hpp"
#include "codec.hpp"

namespace rotconv::quaternion {

Reading to_rotation_of_any_size(const Eigen::Quaterniond& q, double tolerance) noexcept {
    const std::array<double, 4> numbers{q.w(), q.x(), q.y(), q.z()};
    return read_within({.name = RepresentationId::quat}, numbers.data(), tolerance);
}

double defect(const Eigen::Quaterniond& q) noexcept {
    const auto scale = PowerOfTwo::to_unit(largest_magnitude(q.w(), q.x(), q.y(), q.z()));
    const double scaled = squared_norm(scale(q.w()), scale(q.x()), scale(q.y()), scale(q.z()));
    return std::fabs(scale.undone(std::sqrt(scaled)) - 1.0);
}

Sensitivity sensitivity(const Rotation& /*rotation*/) noexcept { return {.condition = 0.5}; }

Eigen::Quaterniond rate(const Eigen::Quaterniond& q, const Eigen::Vector3d& w, Frame frame) noexcept {
    const Eigen::Vector3d v{q.x(), q.y(), q.z()};
    const Eigen::Vector3d across = frame == Frame::body ? v.cross(w) : w.cross(v);
    const Eigen::Vector3d rates = 0.5 * (q.w() * w + across);
    return {-0.5 * v.dot(w), rates.x(), rates.y(), rates.z()};
}

Eigen::Vector3d angular_velocity(const Eigen::Quaterniond& q, const Eigen::Quaterniond& rates, Frame frame) noexcept {
    // Both times one power of two, so that |q|^2 is near 1.
    const auto scale = PowerOfTwo::to_unit(largest_magnitude(q.w(), q.x(), q.y(), q.z()));
    const Eigen::Vector3d v{scale(q.x()), scale(q.y()), scale(q.z())};
    const Eigen::Vector3d v_rate{scale(rates.x()), scale(rates.y()), scale(rates.z())};
    const double w = scale(q.w());
    const Eigen::Vector3d across = frame == Frame::body ? v_rate.cross(v) : v.cross(v_rate);
    return (2.0 / (w * w + v.squaredNorm())) * (w * v_rate - scale(rates.w()) * v + across);
}

} // namespace rotconv::quaternion

namespace rotconv {
namespace {

constexpr ModifierSet xyzw{Modifier::xyzw};
constexpr auto own_presets = std::to_array<PresetMeaning>({{"scipy", xyzw},
                                                           {"ros", xyzw},
                                                           {"tum", xyzw},
                                                           {"spice", passive},
                                                           {"bunge", passive},
                                                           {"baruh", xyzw},
                                                           {"trawny", xyzw},
                                                           {"jpl", xyzw},
                                                           {"stuelpnagel", passive},
                                                           {"colmap", passive}});

Eigen::Quaterniond value_of(const Spec& /*spec*/, const double* v) noexcept { return {v[0], v[1], v[2], v[3]}; }

/// q or -q.
bool choose_nearest(const Spec& /*spec*/, const double* last, DiagnosticSet /*diagnostics*/,
                    std::span<const double> /*rest*/, double* q) noexcept {
    if (last[0] * q[0] + last[1] * q[1] + last[2] * q[2] + last[3] * q[3] < 0.0) {
        std::transform(q, q + 4, q, [](double component) { return 0.0 - component; });
    }
    return true;
}

} // namespace

// NOLINTNEXTLINE(cert-err58-cpp): a constant, nothing runs
constinit const Codec codecs::quat{
    .representation = {.name = RepresentationId::quat,
                       .text = "quat",
                       .aliases = {"quaternion", "q"},
                       .size = 4,
                       .columns = {"qw", "qx", "qy", "qz"},
                       .modifiers = {Modifier::passive, Modifier::xyzw, Modifier::wxyz},
                       .presets = own_presets,
                       .other_order = {1, 2, 3, 0}},
    .range = "unit; w > 0, or w = 0 and the first nonzero of x, y, z positive",
    .formula = "w = cos(theta/2), (x, y, z) = sin(theta/2) n",
    .has_any_length = true,
    .exact_defect = [](const double* v) noexcept { return quaternion::defect(value_of({}, v)); },
    .sensitivity = sensitivity_of<quaternion::sensitivity>,
    .choose_nearest = choose_nearest,
    .rate =
        [](const Spec& spec, const double* v, const Eigen::Vector3d& w, Frame frame, double* rates) noexcept {
            const Eigen::Quaterniond q = quaternion::rate(value_of(spec, v), w, frame);
            Eigen::Map<Eigen::Vector4d>(rates) << q.w(), q.vec();
        },
    .angular_velocity =
        [](const Spec& spec, const double* v, const double* rates, Frame frame) noexcept {
            return quaternion::angular_velocity(value_of(spec, v), value_of(spec, rates), frame);
        }};

} // namespace rotconv
