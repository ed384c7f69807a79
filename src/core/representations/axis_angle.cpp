#include <rotconv/axis_angle.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "../numerics/angles.hpp"
#include "../numerics/exact_number.hpp"
#include "codec.hpp"
#include "rotation_angle.hpp"

namespace rotconv::axis_angle {

Reading to_rotation(const AxisAngle& value) noexcept {
    const std::array<double, 4> numbers{value.axis.x(), value.axis.y(), value.axis.z(), value.angle};
    return read_row({.name = RepresentationId::axis_angle, .unit = value.unit}, numbers.data());
}

AxisAngle from_rotation(const Rotation& rotation, AngleUnit unit) noexcept {
    std::array<double, 4> numbers{};
    write_row({.name = RepresentationId::axis_angle, .unit = unit}, rotation, numbers.data());
    return {{numbers[0], numbers[1], numbers[2]}, numbers[3], unit};
}

Sensitivity sensitivity(const Rotation& rotation) noexcept {
    const double sine = rotation.vector_length() / std::sqrt(rotation.squared_norm());
    return {.margin = std::min(angle_of(rotation), angle_to_half_turn(rotation)),
            .condition = std::max(1.0, 0.5 / sine)};
}

} // namespace rotconv::axis_angle

namespace rotconv {
namespace {

/// (n, a) or (-n, -a), and whole turns; without an angle any axis.
template <class T> bool choose(const Spec& spec, const double* last, std::span<const double> rest, double* v) noexcept {
    const auto rest_of_angle = rest.last(rest.size() / 4);
    const T angle = exact_number<T>(v[3], rest_of_angle);
    if (v[3] == 0.0) {
        std::copy_n(last, 3, v);
    }
    const double turn = 2.0 * half_turn_in(spec.unit).hi;
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
    if (turns == 0.0) {
        v[3] = chosen * v[3] + 0.0;
        return true;
    }
    const bool is_exact = spec.unit == AngleUnit::degrees && is_exactly_none(rest_of_angle[0]);
    return round_to(plus_half_turns(scaled(angle, chosen), 2.0 * turns, spec.unit), is_exact,
                    0x1p-69 * (1.0 + std::fabs(turns)) * turn, v[3]);
}

bool choose_nearest(const Spec& spec, const double* last, DiagnosticSet /*diagnostics*/, std::span<const double> rest,
                    double* v) noexcept {
    return in_scalar_of(rest, 4, [&]<class T>(T /*scalar*/) { return choose<T>(spec, last, rest, v); });
}

} // namespace

// Without a kinematic equation: the axis has no rate at the identity.
constinit const Codec codecs::axis_angle{.representation = {.name = RepresentationId::axis_angle,
                                                            .text = "axis-angle",
                                                            .aliases = {"axang", "aa"},
                                                            .size = 4,
                                                            .columns = {"ax", "ay", "az", "angle"},
                                                            .modifiers = {Modifier::passive, Modifier::deg},
                                                            .presets = presets_of_vectors,
                                                            .first_angle = 3},
                                         .range = "unit axis, angle in [0, pi]; axis (1, 0, 0) for the identity",
                                         .singular = "identity, half-turn",
                                         .singular_attitude = "a half-turn",
                                         .formula = "R = I + sin(theta) [n] + (1 - cos(theta)) [n]^2",
                                         .listed_order = {1, 2, 3, 0}, // the angle first
                                         .sensitivity = sensitivity_of<axis_angle::sensitivity>,
                                         .choose_nearest = choose_nearest};

} // namespace rotconv
