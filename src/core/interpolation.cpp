#include "interpolation.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "numerics/elementary.hpp"

namespace rotconv {
namespace {

using Quaternion = std::array<double, 4>;

Quaternion unit(const Rotation& rotation) noexcept {
    const double norm = std::sqrt(rotation.squared_norm());
    return {rotation.w() / norm, rotation.x() / norm, rotation.y() / norm, rotation.z() / norm};
}

/// p + factor q.
Quaternion sum(const Quaternion& p, double factor, const Quaternion& q) noexcept {
    return {p[0] + factor * q[0], p[1] + factor * q[1], p[2] + factor * q[2], p[3] + factor * q[3]};
}

double product(const Quaternion& p, const Quaternion& q) noexcept {
    return (p[0] * q[0] + p[1] * q[1]) + (p[2] * q[2] + p[3] * q[3]);
}

double sine(double angle) noexcept { return sine_cosine<double>(DoubleDouble(angle), AngleUnit::radians).sine; }

} // namespace

std::optional<Rotation> interpolated(const Rotation& a, const Rotation& b, double fraction) noexcept {
    const Quaternion p = unit(a);
    const Quaternion q = unit(b);
    const double cosine = product(p, q); // of half the turn
    if (std::abs(cosine) <= 4.0 * std::numeric_limits<double>::epsilon()) {
        return std::nullopt;
    }
    const double sign = cosine < 0.0 ? -1.0 : 1.0;
    const Quaternion chord = sum(p, -sign, q);
    if (chord == Quaternion{}) {
        return a;
    }
    const Quaternion other = sum(p, sign, q);
    const double half =
        2.0 * angle_of(std::sqrt(product(other, other)), std::sqrt(product(chord, chord)), AngleUnit::radians).hi;
    const double whole = sine(half);
    // A turn whose square is too small for a double is as straight as its chord.
    const double of_a = whole > 0.0 ? sine((1.0 - fraction) * half) / whole : 1.0 - fraction;
    const double of_b = whole > 0.0 ? sine(fraction * half) / whole : fraction;
    const Quaternion r = sum({of_a * p[0], of_a * p[1], of_a * p[2], of_a * p[3]}, sign * of_b, q);
    return Rotation::near_unit(r[0], r[1], r[2], r[3]);
}

} // namespace rotconv
