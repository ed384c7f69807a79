#include <rotconv/rotation_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "../numerics/angles.hpp"
#include "../numerics/exact_number.hpp"
#include "../numerics/power_of_two.hpp"
#include "../numerics/quaternion_algebra.hpp"
#include "codec.hpp"
#include "rotation_angle.hpp"

namespace rotconv::rotation_vector {
namespace {

/// Below this half angle sin(x) = x, cos(x) = 1 and atan(x) = x to less than half an ulp.
constexpr double linear_half_angle = 1e-9;

/// Half of a vector's angle, in radians and as sine and cosine; 0 where its square does not count.
struct HalfLength {
    double radians = 0.0;
    SineCosine<double> sides{0.0, 1.0};
};

/// |r| to twice the working precision.
DoubleDouble length_of(const Eigen::Vector3d& r) noexcept {
    const auto scale = PowerOfTwo::to_unit(largest_magnitude(r.x(), r.y(), r.z()));
    const DoubleDouble length = root(sum_of_squares(scale(r.x()), scale(r.y()), scale(r.z())));
    return {scale.undone(length.hi), scale.undone(length.lo)};
}

HalfLength half_length(const RotationVector& value) noexcept {
    const double size = value.vector.cwiseAbs().maxCoeff();
    const double per_radian = units_per_radian(value.unit);
    if (size <= linear_half_angle * per_radian) {
        return {};
    }
    const DoubleDouble half = scaled(length_of(value.vector), 0.5);
    return {half.hi / per_radian, sine_cosine<double>(half, value.unit)};
}

/// factor v + (1 - factor) n (n.v) with n = r/|r|. Where |r|^2 underflows the factor is 1.
Eigen::Vector3d stretched(const Eigen::Vector3d& r, double factor, const Eigen::Vector3d& v) noexcept {
    const double square = r.squaredNorm();
    const double along = square > 0.0 ? (1.0 - factor) / square : 0.0;
    return factor * v + (along * r.dot(v)) * r;
}

RotationVector value_of(const Spec& spec, const double* v) noexcept {
    return {Eigen::Vector3d(v[0], v[1], v[2]), spec.unit};
}

/// Past a half-turn the numbers are singular at the full turns: there the margin is the distance to the nearest one, 0
/// where a length in radians does not tell it from one.
Sensitivity sensitivity_of_numbers(const Spec& spec, const double* v, const Rotation& rotation) noexcept {
    Sensitivity result = sensitivity(rotation);
    const double half = half_length(value_of(spec, v)).radians;
    if (2.0 * half - std::numbers::pi > half_turn_margin) {
        const double angle = angle_of(rotation);
        result.margin = angle > 2.0 * half * std::numeric_limits<double>::epsilon() ? angle : 0.0;
        result.condition = std::max(1.0, half * std::sqrt(rotation.squared_norm()) / rotation.vector_length());
    }
    return result;
}

} // namespace

Reading to_rotation(const RotationVector& value) noexcept {
    return read_row({.name = RepresentationId::rotvec, .unit = value.unit}, value.vector.data());
}

RotationVector from_rotation(const Rotation& rotation, AngleUnit unit) noexcept {
    RotationVector result(Eigen::Vector3d::Zero(), unit);
    write_row({.name = RepresentationId::rotvec, .unit = unit}, rotation, result.vector.data());
    return result;
}

Sensitivity sensitivity(const Rotation& rotation) noexcept {
    const double length = rotation.vector_length();
    const double sine = length / std::sqrt(rotation.squared_norm());
    const double condition = sine <= linear_half_angle ? 1.0 : 0.5 * angle_of(rotation) / sine;
    return {.margin = angle_to_half_turn(rotation), .condition = std::max(1.0, condition)};
}

Eigen::Vector3d rate(const RotationVector& value, const Eigen::Vector3d& w, Frame frame) noexcept {
    const double per_radian = units_per_radian(value.unit);
    const Eigen::Vector3d r = value.vector / per_radian;
    const HalfLength half = half_length(value);
    const double cotangent = half.radians == 0.0 ? 1.0 : half.radians * half.sides.cosine / half.sides.sine;
    const Eigen::Vector3d across = frame == Frame::body ? r.cross(w) : w.cross(r);
    return (stretched(r, cotangent, w) + 0.5 * across) * per_radian;
}

Eigen::Vector3d angular_velocity(const RotationVector& value, const Eigen::Vector3d& rates, Frame frame) noexcept {
    const double per_radian = units_per_radian(value.unit);
    const Eigen::Vector3d r = value.vector / per_radian;
    const Eigen::Vector3d v = rates / per_radian;
    const HalfLength half = half_length(value);
    const double ratio = half.radians == 0.0 ? 1.0 : half.sides.sine / half.radians;
    const Eigen::Vector3d across = frame == Frame::body ? v.cross(r) : r.cross(v);
    return stretched(r, ratio * half.sides.cosine, v) + (0.5 * ratio * ratio) * across;
}

} // namespace rotconv::rotation_vector

namespace rotconv {
namespace {

using Eigen::Map;
using Eigen::Vector3d;

/// n (theta + 2 pi k); without an angle any axis.
template <class T> bool choose(const Spec& spec, const double* last, std::span<const double> rest, double* r) noexcept {
    const double pi = half_turn_in(spec.unit).hi;
    if ((Map<const Vector3d>(r) - Map<const Vector3d>(last)).squaredNorm() < 0.99 * (pi * pi)) {
        return true; // the others are a whole turn and more from these
    }
    const bool is_identity = largest_magnitude(r[0], r[1], r[2]) == 0.0;
    const double* const along = is_identity ? last : r;
    const double size = largest_magnitude(along[0], along[1], along[2]);
    if (size == 0.0) {
        return true;
    }
    // the vector times a power of two, and its length
    const int exponent = PowerOfTwo::exponent_of_unit(size);
    const auto exact = is_identity ? std::array{T(last[0]), T(last[1]), T(last[2])} : exact_vector<T>(r, rest);
    const std::array vector{shifted(exact[0], -exponent), shifted(exact[1], -exponent), shifted(exact[2], -exponent)};
    const T length = root(sum_of_squares(vector[0], vector[1], vector[2]));
    const T theta = is_identity ? T(0.0) : shifted(length, exponent);
    const double last_along =
        (to_double(vector[0]) * last[0] + (to_double(vector[1]) * last[1] + to_double(vector[2]) * last[2])) /
        to_double(length);
    const double turns = nearest_turns(last_along - to_double(theta), spec.unit);
    if (turns == 0.0) {
        return true;
    }
    const T ratio = plus_half_turns(theta, 2.0 * turns, spec.unit) / length;
    bool decided = true;
    for (std::size_t i = 0; i < 3; ++i) {
        decided = round_product(ratio, -exponent, exact[i], size, r[i]) && decided;
    }
    return decided;
}

bool choose_nearest(const Spec& spec, const double* last, DiagnosticSet /*diagnostics*/, std::span<const double> rest,
                    double* r) noexcept {
    return in_scalar_of(rest, 3, [&]<class T>(T /*scalar*/) { return choose<T>(spec, last, rest, r); });
}

/// By whole turns, past a half-turn.
void wrap(double* numbers) noexcept {
    Map<Vector3d> r(numbers);
    if (const double length = r.norm(); length > std::numbers::pi) {
        r *= without_turns(length) / length;
    }
}

} // namespace

constinit const Codec codecs::rotvec{
    .representation = {.name = RepresentationId::rotvec,
                       .text = "rotvec",
                       .aliases = {"exp", "rotationvector", "prv"},
                       .size = 3,
                       .columns = {"rx", "ry", "rz"},
                       .modifiers = {Modifier::passive, Modifier::deg},
                       .presets = presets_of_vectors,
                       .angle_is_length = true},
    .range = "norm at most pi",
    .singular = "half-turn",
    .singular_attitude = "a full turn",
    .formula = "theta n; R = exp [theta n]",
    .sensitivity = sensitivity_of<rotation_vector::sensitivity>,
    .choose_nearest = choose_nearest,
    .rate = rate_of<Vector3d, rotation_vector::rate, rotation_vector::value_of>,
    .angular_velocity = angular_velocity_of<Vector3d, rotation_vector::angular_velocity, rotation_vector::value_of>,
    .sensitivity_of_numbers = rotation_vector::sensitivity_of_numbers,
    .greatest_distance = std::numbers::pi,
    .switch_chart = wrap};

} // namespace rotconv
