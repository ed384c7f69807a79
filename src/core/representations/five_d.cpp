#include <rotconv/two_column.hpp>

#include <algorithm>
#include <numbers>

#include "../numerics/least_squares_angular_velocity.hpp"
#include "../numerics/power_of_two.hpp"
#include "codec.hpp"

namespace rotconv::five_d {

using std::numbers::sqrt2;

Reading to_rotation(const Vector5& y, double tolerance) noexcept {
    return read_within({.name = RepresentationId::five_d}, y.data(), tolerance);
}

// With a power of two f, so that y'y cannot overflow: (f^2 y'y - f^2, 2 f fy) is parallel to the two columns.
double defect(const Vector5& y) noexcept {
    const auto scale = PowerOfTwo::to_unit(std::max(1.0, y.cwiseAbs().maxCoeff()));
    const double f = scale(1.0);
    const Vector5 fy = y.unaryExpr(scale);
    const double square = fy.squaredNorm();
    TwoColumns m;
    m << square - f * f, 2.0 * f * fy[2], 2.0 * f * fy[0], 2.0 * f * fy[3], 2.0 * f * fy[1], 2.0 * f * fy[4];
    return two_column::defect(m * (sqrt2 / (square + f * f)));
}

Vector5 from_rotation(const Rotation& rotation) noexcept {
    Vector5 y;
    write_row({.name = RepresentationId::five_d}, rotation, y.data());
    return y;
}

Sensitivity sensitivity(const Rotation& rotation) noexcept {
    const double turning = rotation.w() * rotation.w() + rotation.x() * rotation.x();
    const double tilting = rotation.y() * rotation.y() + rotation.z() * rotation.z();
    return {.condition = sqrt2 * (turning + tilting) / ((sqrt2 - 1.0) * turning + (sqrt2 + 1.0) * tilting)};
}

Vector5 rate(const Vector5& y, const Eigen::Vector3d& w, Frame frame) noexcept {
    const double square = y.squaredNorm();
    TwoColumns h;
    h << 0.5 * (square - 1.0), y[2], y[0], y[3], y[1], y[4];
    const auto rates = two_column::rate(h, w, frame).reshaped().eval();
    return rates.tail<5>() + y * rates[0];
}

Eigen::Vector3d angular_velocity(const Vector5& y, const Vector5& rates, Frame frame) noexcept {
    return least_squares_angular_velocity([&](const Eigen::Vector3d& w) { return rate(y, w, frame); }, rates);
}

} // namespace rotconv::five_d

namespace rotconv {

// NOLINTNEXTLINE(cert-err58-cpp): a constant, nothing runs
constinit const Codec codecs::five_d{
    .representation = {.name = RepresentationId::five_d,
                       .text = "5d",
                       .aliases = {"hopf"},
                       .size = 5,
                       .columns = {"y1", "y2", "y3", "y4", "y5"},
                       .modifiers = {Modifier::passive},
                       .presets = presets_of_matrices},
    .range = "norm between 0.41 and 2.41",
    .formula = "(r21, r31, r12, r22, r32)/(sqrt 2 - r11): stereographic, Hopf 1940",
    .exact_defect = [](const double* y) noexcept { return five_d::defect(Eigen::Map<const five_d::Vector5>(y)); },
    .sensitivity = sensitivity_of<five_d::sensitivity>,
    .rate = rate_of<five_d::Vector5, five_d::rate>,
    .angular_velocity = angular_velocity_of<five_d::Vector5, five_d::angular_velocity>};

} // namespace rotconv
