#include <rotconv/axis_angle.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "../numerics/angles.hpp"
#include "../numerics/double_double.hpp"
#include "../numerics/scaling.hpp"
#include "../numerics/trigonometry.hpp"
#include "axis_half_angle.hpp"
#include "codec.hpp"
#include "half_turn.hpp"

namespace rotconv::axis_angle {

namespace {

ROTCONV_TARGET_CLONES void write(const Spec& spec, double /*lock_margin*/, const Rotations& rotations, std::size_t rows,
                                 double* numbers, DiagnosticSet* diagnostics) noexcept {
    const AngleUnit unit = spec.unit;
    AxisHalfAngles parts; // NOLINT(*-member-init): written before it is read
    take_apart(rotations, rows, parts);
    Angles angles; // NOLINT(*-member-init)
    angles_of(parts.half, rows, unit, angles);
    for (std::size_t i = 0; i < rows; ++i) {
        const DoubleDouble inverse = quotient(1.0, 0.0, parts.length(i));
        numbers[4 * i] = product(split(parts.x[i]), inverse);
        numbers[4 * i + 1] = product(split(parts.y[i]), inverse);
        numbers[4 * i + 2] = product(split(parts.z[i]), inverse);
        numbers[4 * i + 3] = 2.0 * (angles.hi[i] + angles.lo[i]);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        diagnostics[i] = note_half_turn(parts.half.x[i], parts.half.y[i]);
        if (parts.half.y[i] > least_known_length) {
            continue;
        }
        const double length = rotations.at(i).vector_length();
        diagnostics[i] |= {DiagnosticKind::identity_axis, length == 0.0};
        Eigen::Map<Eigen::Vector3d>{numbers + 4 * i} =
            length == 0.0 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d(parts.vector(i) / length);
        numbers[4 * i + 3] = length / parts.half.x[i] * (2.0 * units_per_radian(unit));
    }
}

} // namespace

Reading to_rotation(const AxisAngle& value) noexcept {
    if (!value.axis.allFinite() || !std::isfinite(value.angle)) {
        return Error::not_finite;
    }
    const HalfAngle half = half_of(value.angle, value.unit);
    const double size = value.axis.cwiseAbs().maxCoeff();
    if (size == 0.0) {
        const bool no_turn = value.unit == AngleUnit::degrees ? half.sine == 0.0 : value.angle == 0.0;
        return no_turn ? Reading(Rotation()) : Reading(Error::zero_axis);
    }
    const Eigen::Vector3d axis = value.axis.unaryExpr(PowerOfTwo::to_unit(size));
    const Eigen::Vector3d v = axis * half.sine;
    return Rotation::from_components(axis.norm() * half.cosine, v.x(), v.y(), v.z());
}

AxisAngle from_rotation(const Rotation& rotation, AngleUnit unit) noexcept {
    std::array<double, 4> numbers{};
    codecs::axis_angle.write_row({.unit = unit}, rotation, numbers.data());
    return {.axis = {numbers[0], numbers[1], numbers[2]}, .angle = numbers[3], .unit = unit};
}

Sensitivity sensitivity(const Rotation& rotation) noexcept {
    const double sine = rotation.vector_length() / std::sqrt(rotation.squared_norm());
    return {.margin = std::min(angle_of(rotation), angle_to_half_turn(rotation)),
            .condition = std::max(1.0, 0.5 / sine)};
}

} // namespace rotconv::axis_angle

namespace rotconv {
namespace {

AxisAngle value_of(const Spec& spec, const double* v) noexcept { return {{v[0], v[1], v[2]}, v[3], spec.unit}; }

/// (n, a) or (-n, -a), and whole turns; without an angle any axis.
void nearest(const Spec& spec, const double* last, DiagnosticSet /*diagnostics*/, double* v) noexcept {
    if (v[3] == 0.0) {
        std::copy_n(last, 3, v);
    }
    const double turn = 2.0 * pi_in(spec.unit).hi;
    double least = std::numeric_limits<double>::infinity();
    double chosen = 1.0;
    double turns = 0.0;
    for (const double sign : {1.0, -1.0}) {
        const double own_turns = nearest_turns(last[3] - sign * v[3], spec.unit);
        const double step = (sign * v[3] - last[3]) + own_turns * turn;
        double square = step * step / (units_per_radian(spec.unit) * units_per_radian(spec.unit));
        for (std::size_t i = 0; i < 3; ++i) {
            square += (sign * v[i] - last[i]) * (sign * v[i] - last[i]);
        }
        if (square < least) {
            least = square;
            chosen = sign;
            turns = own_turns;
        }
    }
    std::transform(v, v + 3, v, [chosen](double component) { return chosen * component + 0.0; });
    v[3] = plus_half_turns({chosen * v[3], 0.0}, 2.0 * turns, spec.unit).hi;
}

} // namespace

// Without a kinematic equation: the axis has no rate at the identity.
constinit const Codec codecs::axis_angle{
    .representation = {.name = RepresentationId::axis_angle,
                       .text = "axis-angle",
                       .aliases = {"axang"},
                       .size = 4,
                       .columns = {"ax", "ay", "az", "angle"},
                       .modifiers = {Modifier::passive, Modifier::deg},
                       .presets = presets_of_vectors,
                       .range = "unit axis, angle in [0, pi]; axis (1, 0, 0) for the identity",
                       .singular = "identity, half-turn",
                       .singular_attitude = "a half-turn",
                       .formula = "R = I + sin(theta) [n] + (1 - cos(theta)) [n]^2"},
    .read = read_each<Eigen::Vector4d, axis_angle::to_rotation, value_of>,
    .write = axis_angle::write,
    .sensitivity = sensitivity_of<axis_angle::sensitivity>,
    .nearest = nearest};

} // namespace rotconv
