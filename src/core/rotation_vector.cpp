#include <rotconv/rotation_vector.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "finite.hpp"
#include "half_turn.hpp"
#include "scaling.hpp"
#include "trigonometry.hpp"

namespace rotconv::rotation_vector {
namespace {

/// Below this half angle sin(x) = x, cos(x) = 1 and atan(x) = x to less than half an ulp.
constexpr double linear_half_angle = 1e-9;

/// Half of the angle theta 2^exponent, which may be above the largest double: then its quarter is squared.
HalfAngle half_of_scaled(DoubleDouble theta, int exponent, AngleUnit unit) noexcept {
    const auto scaled = [&theta](int power) {
        return DoubleDouble{std::ldexp(theta.hi, power), std::ldexp(theta.lo, power)};
    };
    if (exponent < std::numeric_limits<double>::max_exponent) {
        return half_of(scaled(exponent), unit);
    }
    const HalfAngle quarter = half_of(scaled(exponent - 1), unit);
    return {quarter.cosine * quarter.cosine - quarter.sine * quarter.sine, 2.0 * quarter.cosine * quarter.sine};
}

} // namespace

Reading to_rotation(const RotationVector& value) noexcept {
    const Eigen::Vector3d& r = value.vector;
    if (!all_finite(r.x(), r.y(), r.z())) {
        return Reading::failed(Fault::not_finite);
    }
    const double size = r.cwiseAbs().maxCoeff();
    const double per_radian = radian(value.unit);
    if (size <= linear_half_angle * per_radian) {
        return {.rotation = Rotation::from_components(2.0 * per_radian, r.x(), r.y(), r.z())};
    }
    const auto scale = PowerOfTwo::to_unit(size);
    const Eigen::Vector3d direction = r.unaryExpr(scale);
    const DoubleDouble scaled_length = length(direction.x(), direction.y(), direction.z());
    const HalfAngle half = half_of_scaled(scaled_length, -scale.exponent(), value.unit);
    const Eigen::Vector3d v = direction * half.sine;
    const double w = scaled_length.hi * half.cosine + scaled_length.lo * half.cosine;
    return {.rotation = Rotation::from_components(w, v.x(), v.y(), v.z())};
}

RotationVector from_rotation(const Rotation& rotation, AngleUnit unit) noexcept {
    double ratio = 0.0;
    if (rotation.vector_length() <= linear_half_angle * rotation.w()) {
        ratio = 2.0 * radian(unit) / rotation.w();
    } else {
        // The length counts twice, in the angle and in the direction: near pi its rounding is the largest part of the
        // error.
        const double rounded_once = length(rotation.x(), rotation.y(), rotation.z()).hi;
        ratio = 2.0 * angle_of(rounded_once, rotation.w(), unit) / rounded_once;
    }
    return {.vector = {rotation.x() * ratio, rotation.y() * ratio, rotation.z() * ratio}, .unit = unit};
}

Notes notes(const Rotation& rotation) noexcept { return note_half_turn(rotation); }

Figures figures(const Rotation& rotation) noexcept {
    const double length = rotation.vector_length();
    const double sine = length / std::sqrt(rotation.squared_norm());
    const double condition = length <= linear_half_angle * rotation.w() ? 1.0 : 0.5 * angle_of(rotation) / sine;
    return {.margin = angle_to_half_turn(rotation), .condition = std::max(1.0, condition)};
}

} // namespace rotconv::rotation_vector
