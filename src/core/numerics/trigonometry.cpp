#include "trigonometry.hpp"

#include <cmath>
#include <numbers>

namespace rotconv {
namespace {

/// (1, tan(hi + lo)), with the sum's denominator moved to the cosine: large tangents keep their digits.
HalfAngle tangent_of(double hi, double lo) noexcept {
    const double tangent = std::tan(hi);
    if (lo == 0.0) {
        return {1.0, tangent};
    }
    const double tangent_lo = std::tan(lo);
    return {1.0 - tangent * tangent_lo, tangent + tangent_lo};
}

/// Turns by `quadrants` times 90 degrees.
HalfAngle turned(HalfAngle h, unsigned quadrants) noexcept {
    switch (quadrants & 3U) {
    case 1: return {-h.sine, h.cosine};
    case 2: return {-h.cosine, -h.sine};
    case 3: return {h.sine, -h.cosine};
    default: return h;
    }
}

/// An angle less the multiple of a period that is nearest to it, and how many that are, modulo 4.
struct Reduced {
    double rest;
    unsigned quotient;
};

Reduced reduced(double angle, double period) noexcept {
    int quotient = 0; // of its size three bits are sure, and what a library puts above them would not bear to be added
    const double rest = std::remquo(angle, period, &quotient);
    return {rest, static_cast<unsigned>(quotient) & 3U};
}

/// Half of hi + lo degrees: each part is reduced exactly to a multiple of 180, half of which are quadrants, and a rest.
/// The rest's product with pi/180 is off by at most 0.65 ulp, less than a correction would round away.
HalfAngle half_of_degrees(DoubleDouble angle) noexcept {
    const Reduced hi = reduced(angle.hi, 180.0);
    const Reduced lo = reduced(angle.lo, 180.0);
    const DoubleDouble rest = exact_sum(hi.rest, lo.rest);
    const unsigned quadrants = hi.quotient + lo.quotient;
    if (std::fabs(rest.hi) == 90.0 && rest.lo == 0.0) {
        return turned({1.0, std::copysign(1.0, rest.hi)}, quadrants);
    }
    constexpr double half_radians_per_degree = 0.5 * radians_per_degree;
    return turned(tangent_of(rest.hi * half_radians_per_degree, rest.lo * half_radians_per_degree), quadrants);
}

} // namespace

HalfAngle half_of(double angle, AngleUnit unit) noexcept {
    if (unit == AngleUnit::degrees) {
        return half_of_degrees({angle, 0.0});
    }
    return {1.0, std::tan(0.5 * angle)};
}

HalfAngle half_of(DoubleDouble angle, AngleUnit unit) noexcept {
    if (unit == AngleUnit::degrees) {
        return half_of_degrees(angle);
    }
    return tangent_of(0.5 * angle.hi, 0.5 * angle.lo);
}

double angle_of(double y, double x, AngleUnit unit) noexcept {
    if (unit == AngleUnit::radians) {
        const double angle = std::atan2(y, x);
        return angle <= -std::numbers::pi ? std::numbers::pi : angle;
    }
    // The quadrant is added in degrees, where it is exact, in one rounding.
    const double abs_y = std::fabs(y);
    const double abs_x = std::fabs(x);
    double angle = 0.0;
    if (abs_y > abs_x) {
        angle = 90.0 - std::atan2(x, abs_y) * degrees_per_radian;
    } else {
        const double acute =
            abs_y == abs_x ? (abs_x == 0.0 ? 0.0 : 45.0) : std::atan2(abs_y, abs_x) * degrees_per_radian;
        angle = x < 0.0 ? 180.0 - acute : acute;
    }
    return y < 0.0 && angle < 180.0 ? -angle : angle;
}

Direction direction_of(double angle, AngleUnit unit) noexcept {
    if (unit == AngleUnit::radians) {
        return {std::cos(angle), std::sin(angle)};
    }
    const Reduced turn = reduced(angle, 90.0);
    const double rest = turn.rest / degrees_per_radian;
    const HalfAngle whole = turned({std::cos(rest), std::sin(rest)}, turn.quotient);
    return {whole.cosine, whole.sine};
}

double without_turns(double angle) noexcept {
    constexpr double turn_high = 2.0 * std::numbers::pi;
    constexpr double turn_low = 2.4492935982947064e-16; // what that double lacks of 2 pi
    const double turns = std::round(angle / turn_high);
    return (angle - turns * turn_high) - turns * turn_low;
}

double units_per_radian(AngleUnit unit) noexcept { return unit == AngleUnit::degrees ? degrees_per_radian : 1.0; }

} // namespace rotconv
