#include <rotconv/rotation.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "numerics/elementary.hpp"
#include "representations/rotation_angle.hpp"

namespace rotconv {

double angle_between(const Rotation& a, const Rotation& b) noexcept { return angle_of(a * b.inverse()); }

std::optional<Rotation> interpolate(const Rotation& a, const Rotation& b, double fraction) {
    if (!(fraction >= 0.0 && fraction <= 1.0)) {
        throw std::invalid_argument("rotconv: a fraction is not in [0, 1]");
    }
    const Eigen::Vector4d p = unit(a);
    const Eigen::Vector4d q = unit(b);
    const double cosine = p.dot(q); // of the angle h between them, half that of the rotation
    if (std::abs(cosine) <= 4.0 * std::numeric_limits<double>::epsilon()) {
        return std::nullopt;
    }
    const double sign = cosine < 0.0 ? -1.0 : 1.0;
    if (p == sign * q) {
        return a;
    }
    const double h = 2.0 * angle_of((p + sign * q).norm(), (p - sign * q).norm(), AngleUnit::radians).hi;
    const double sine_of_h = sine_of(h);
    // If it underflows, the weights are linear.
    const double of_a = sine_of_h > 0.0 ? sine_of((1.0 - fraction) * h) / sine_of_h : 1.0 - fraction;
    const double of_b = sine_of_h > 0.0 ? sine_of(fraction * h) / sine_of_h : fraction;
    const Eigen::Vector4d r = of_a * p + (sign * of_b) * q;
    return rotation_at(r.data());
}

} // namespace rotconv
