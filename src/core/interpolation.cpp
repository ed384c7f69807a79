#include <rotconv/rotation.hpp>

#include <cmath>
#include <limits>

#include "numerics/elementary.hpp"
#include "representations/half_turn.hpp"

namespace rotconv {
namespace {

using Eigen::Vector4d;

double sine(double angle) noexcept { return sine_cosine<double>(DoubleDouble(angle), AngleUnit::radians).sine; }

} // namespace

double angle_between(const Rotation& a, const Rotation& b) noexcept { return angle_of(a * b.inverse()); }

std::optional<Rotation> interpolate(const Rotation& a, const Rotation& b, double fraction) noexcept {
    const Vector4d p = unit(a);
    const Vector4d q = unit(b);
    const double cosine = p.dot(q); // of half the turn
    if (std::abs(cosine) <= 4.0 * std::numeric_limits<double>::epsilon()) {
        return std::nullopt;
    }
    const double sign = cosine < 0.0 ? -1.0 : 1.0;
    if (p == sign * q) {
        return a;
    }
    const double half = 2.0 * angle_of((p + sign * q).norm(), (p - sign * q).norm(), AngleUnit::radians).hi;
    const double whole = sine(half);
    // A turn whose square is too small for a double is as straight as its chord.
    const double of_a = whole > 0.0 ? sine((1.0 - fraction) * half) / whole : 1.0 - fraction;
    const double of_b = whole > 0.0 ? sine(fraction * half) / whole : fraction;
    const Vector4d r = of_a * p + (sign * of_b) * q;
    return Rotation::near_unit(r[0], r[1], r[2], r[3]);
}

} // namespace rotconv
