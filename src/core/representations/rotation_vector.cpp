#include <rotconv/rotation_vector.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "../numerics/angles.hpp"
#include "../numerics/double_double.hpp"
#include "../numerics/scaling.hpp"
#include "../numerics/trigonometry.hpp"
#include "axis_half_angle.hpp"
#include "codec.hpp"
#include "half_turn.hpp"

namespace rotconv::rotation_vector {
namespace {

/// Below this half angle sin(x) = x, cos(x) = 1 and atan(x) = x to less than half an ulp.
constexpr double linear_half_angle = 1e-9;

/// A vector scaled to a size near 1, its length to 2^-102, since whole turns are taken off it, and half of its angle.
struct Scaled {
    Scaled(const Eigen::Vector3d& r, AngleUnit unit) noexcept
        : scale(PowerOfTwo::to_unit(r.cwiseAbs().maxCoeff())), vector(r.unaryExpr(scale)),
          length(rotconv::length(vector.x(), vector.y(), vector.z())),
          half(half_of({scale.undone(length.hi), scale.undone(length.lo)}, unit)) {}

    PowerOfTwo scale;
    Eigen::Vector3d vector;
    DoubleDouble length;
    HalfAngle half;
};

bool is_linear(const Eigen::Vector3d& r, AngleUnit unit) noexcept {
    return r.cwiseAbs().maxCoeff() <= linear_half_angle * units_per_radian(unit);
}

/// A vector of any size, in any unit.
Rotation rotation_of_any(const Eigen::Vector3d& r, AngleUnit unit) noexcept {
    if (is_linear(r, unit)) {
        return Rotation::from_components(2.0 * units_per_radian(unit), r.x(), r.y(), r.z());
    }
    if (r.cwiseAbs().maxCoeff() > 0x1p1022) { // the length may be too large for a double
        const Rotation half = rotation_of_any(0.5 * r, unit);
        return half * half;
    }
    const Scaled s(r, unit);
    const Eigen::Vector3d v = s.vector * s.half.sine;
    return Rotation::from_components(s.length.hi * s.half.cosine + s.length.lo * s.half.cosine, v.x(), v.y(), v.z());
}

/// Half of a vector's angle, in radians and as sine and cosine.
struct HalfLength {
    double radians = 0.0;
    HalfAngle sides{1.0, 0.0};
};

HalfLength half_length(const RotationVector& value) noexcept {
    if (is_linear(value.vector, value.unit)) {
        return {};
    }
    const Scaled s(value.vector, value.unit);
    return {s.scale.undone(0.5 * s.length.hi / units_per_radian(value.unit)), s.half};
}

/// Lengths, in radians, that the grid knows to full accuracy; nan is none.
bool is_plain(double length) noexcept { return length < 3.2 && length > least_known_length; }

/// factor v + (1 - factor) n (n.v) with n = r/|r|. Where |r|^2 underflows the factor is 1.
Eigen::Vector3d stretched(const Eigen::Vector3d& r, double factor, const Eigen::Vector3d& v) noexcept {
    const double square = r.squaredNorm();
    const double along = square > 0.0 ? (1.0 - factor) / square : 0.0;
    return factor * v + (along * r.dot(v)) * r;
}

ROTCONV_TARGET_CLONES void read(const Spec& spec, const double* numbers, std::size_t rows,
                                Readings& readings) noexcept {
    const AngleUnit unit = spec.unit;
    BatchColumn length, length_low, inverse, cosine, sine; // NOLINT(*-member-init): written before they are read
    for (std::size_t i = 0; i < rows; ++i) {
        const Root root = length_of(split(numbers[3 * i]), split(numbers[3 * i + 1]), split(numbers[3 * i + 2]));
        length[i] = root.hi;
        length_low[i] = root.lo;
        inverse[i] = root.inverse;
    }
    for (std::size_t i = 0; i < rows; ++i) {
        cosine[i] = std::cos(0.5 * length[i]);
        sine[i] = std::sin(0.5 * length[i]);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        const double half_low = 0.5 * length_low[i];
        const DoubleDouble ratio = quotient(sine[i], cosine[i] * half_low, {length[i], length_low[i], inverse[i]});
        readings.w[i] = cosine[i] - sine[i] * half_low;
        readings.x[i] = product(split(numbers[3 * i]), ratio);
        readings.y[i] = product(split(numbers[3 * i + 1]), ratio);
        readings.z[i] = product(split(numbers[3 * i + 2]), ratio);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        readings.defect[i] = 0.0;
        readings.error[i] = Error::none;
        if (unit != AngleUnit::radians || !is_plain(length[i])) {
            const Eigen::Vector3d r(numbers + 3 * i);
            readings.set(i, r.allFinite() ? Reading(rotation_of_any(r, unit)) : Reading(Error::not_finite));
        }
    }
}

ROTCONV_TARGET_CLONES void write(const Spec& spec, double /*lock_margin*/, const Rotations& rotations, std::size_t rows,
                                 double* numbers, DiagnosticSet* diagnostics) noexcept {
    const AngleUnit unit = spec.unit;
    // The length counts twice, in the angle and in the direction: near pi its rounding would be the largest part of the
    // error.
    AxisHalfAngles parts; // NOLINT(*-member-init): written before it is read
    take_apart(rotations, rows, parts);
    Angles angles; // NOLINT(*-member-init)
    angles_of(parts.half, rows, unit, angles);
    // Degrees are brought to the size of radians by a power of two.
    const double scale = unit == AngleUnit::degrees ? 64.0 : 1.0;
    const double doubling = 2.0 / scale;
    for (std::size_t i = 0; i < rows; ++i) {
        const DoubleDouble ratio = quotient(doubling * angles.hi[i], doubling * angles.lo[i], parts.length(i));
        numbers[3 * i] = scale * product(split(parts.x[i]), ratio);
        numbers[3 * i + 1] = scale * product(split(parts.y[i]), ratio);
        numbers[3 * i + 2] = scale * product(split(parts.z[i]), ratio);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        diagnostics[i] = note_half_turn(parts.half.x[i], parts.half.y[i]);
        if (!(parts.half.y[i] > least_known_length)) { // there the set is linear
            const double ratio = 2.0 * units_per_radian(unit) / parts.half.x[i];
            Eigen::Map<Eigen::Vector3d>{numbers + 3 * i} = parts.vector(i) * ratio;
        }
    }
}

RotationVector value_of(const Spec& spec, const double* v) noexcept { return {{v[0], v[1], v[2]}, spec.unit}; }

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
    return codecs::rotvec.read_row({.unit = value.unit}, value.vector.data());
}

RotationVector from_rotation(const Rotation& rotation, AngleUnit unit) noexcept {
    RotationVector result{.unit = unit};
    codecs::rotvec.write_row({.unit = unit}, rotation, result.vector.data());
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
    const Eigen::Vector3d turn = frame == Frame::body ? r.cross(w) : w.cross(r);
    return (stretched(r, cotangent, w) + 0.5 * turn) * per_radian;
}

Eigen::Vector3d angular_velocity(const RotationVector& value, const Eigen::Vector3d& rates, Frame frame) noexcept {
    const double per_radian = units_per_radian(value.unit);
    const Eigen::Vector3d r = value.vector / per_radian;
    const Eigen::Vector3d v = rates / per_radian;
    const HalfLength half = half_length(value);
    const double ratio = half.radians == 0.0 ? 1.0 : half.sides.sine / half.radians;
    const double square = half.sides.cosine * half.sides.cosine + half.sides.sine * half.sides.sine;
    const Eigen::Vector3d turn = frame == Frame::body ? v.cross(r) : r.cross(v);
    return stretched(r, ratio * half.sides.cosine / square, v) + (0.5 * ratio * ratio / square) * turn;
}

} // namespace rotconv::rotation_vector

namespace rotconv {
namespace {

using Eigen::Map;
using Eigen::Vector3d;

/// n (theta + 2 pi k); without an angle any axis.
void nearest(const Spec& spec, const double* last, DiagnosticSet /*diagnostics*/, double* r) noexcept {
    const double pi = pi_in(spec.unit).hi;
    if ((Map<const Vector3d>(r) - Map<const Vector3d>(last)).squaredNorm() < 0.99 * (pi * pi)) {
        return; // the others are a whole turn and more from these
    }
    const bool is_identity = largest_magnitude(r[0], r[1], r[2]) == 0.0;
    const double* const along = is_identity ? last : r;
    const double size = largest_magnitude(along[0], along[1], along[2]);
    if (size == 0.0) {
        return;
    }
    const auto scale = PowerOfTwo::to_unit(size);
    const Vector3d scaled{scale(along[0]), scale(along[1]), scale(along[2])};
    const DoubleDouble scaled_length = length(scaled[0], scaled[1], scaled[2]);
    const DoubleDouble theta =
        is_identity ? DoubleDouble{} : DoubleDouble{scale.undone(scaled_length.hi), scale.undone(scaled_length.lo)};
    const double last_along = scaled.dot(Map<const Vector3d>(last)) / scaled_length.hi;
    const double turns = nearest_turns(last_along - theta.hi, spec.unit);
    if (turns != 0.0) {
        const DoubleDouble ratio = quotient(plus_half_turns(theta, 2.0 * turns, spec.unit), scaled_length);
        for (std::size_t i = 0; i < 3; ++i) {
            r[i] = product(scaled[static_cast<Eigen::Index>(i)], ratio) + 0.0;
        }
    }
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
                       .aliases = {"exp"},
                       .size = 3,
                       .columns = {"rx", "ry", "rz"},
                       .modifiers = {Modifier::passive, Modifier::deg},
                       .presets = presets_of_vectors,
                       .range = "norm at most pi",
                       .singular = "half-turn",
                       .singular_attitude = "a full turn",
                       .formula = "theta n; R = exp [theta n]"},
    .read = rotation_vector::read,
    .write = rotation_vector::write,
    .sensitivity = sensitivity_of<rotation_vector::sensitivity>,
    .nearest = nearest,
    .rate = rate_of<Vector3d, rotation_vector::rate, rotation_vector::value_of>,
    .angular_velocity = angular_velocity_of<Vector3d, rotation_vector::angular_velocity, rotation_vector::value_of>,
    .sensitivity_of_numbers = rotation_vector::sensitivity_of_numbers,
    .greatest_distance = std::numbers::pi,
    .switch_chart = wrap};

} // namespace rotconv
