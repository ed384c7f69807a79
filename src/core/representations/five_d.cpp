#include <rotconv/two_column.hpp>

#include <algorithm>
#include <numbers>

#include <Eigen/Geometry>

#include "../numerics/least_squares_angular_velocity.hpp"
#include "../numerics/scaling.hpp"
#include "codec.hpp"
#include "gram_schmidt.hpp"

namespace rotconv::five_d {
namespace {

using std::numbers::sqrt2;

/// The columns of Hopf's numbers.
ROTCONV_TARGET_CLONES
void columns_of(const double* numbers, std::size_t rows, TwoColumns& m) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        const double* const y = numbers + 5 * i;
        const double square = ((y[0] * y[0] + y[1] * y[1]) + (y[2] * y[2] + y[3] * y[3])) + y[4] * y[4];
        const double factor = 2.0 * sqrt2 / (square + 1.0);
        m[0][i] = (0.5 * factor) * (square - 1.0);
        m[1][i] = factor * y[0];
        m[2][i] = factor * y[1];
        m[3][i] = factor * y[2];
        m[4][i] = factor * y[3];
        m[5][i] = factor * y[4];
    }
}

/// y times a power of two f, so that y'y cannot overflow: (f^2 y'y - f^2, 2 f fy) is parallel to the two columns.
struct Scaled {
    explicit Scaled(const Vector5& number) noexcept
        : scale(PowerOfTwo::to_unit(std::max(1.0, number.cwiseAbs().maxCoeff()))), f(scale(1.0)),
          y(number.unaryExpr(scale)), square(y.squaredNorm()) {}

    [[nodiscard]] Eigen::Vector3d first() const noexcept { return {square - f * f, 2.0 * f * y[0], 2.0 * f * y[1]}; }
    [[nodiscard]] Columns columns() const noexcept {
        Columns m;
        m << first(), (2.0 * f) * y.tail<3>();
        return m * (sqrt2 / (square + f * f));
    }

    PowerOfTwo scale;
    double f;
    Vector5 y;
    double square;
};

Reading read_any(const Vector5& y) noexcept {
    if (!y.allFinite()) {
        return Error::not_finite;
    }
    const Scaled scaled(y);
    const Reading reading =
        gram_schmidt(scaled.first(), scaled.y.tail<3>()); // of the second column only the direction counts
    return reading ? Reading(*reading, two_column::defect(scaled.columns())) : reading;
}

void read(const Spec& /*spec*/, const double* numbers, std::size_t rows, Readings& readings) noexcept {
    TwoColumns m; // as many rows as there are
    columns_of(numbers, rows, m);
    read_columns(m, rows, readings,
                 [numbers](std::size_t i) { return read_any(Eigen::Map<const Vector5>(numbers + 5 * i)); });
}

} // namespace

Reading to_rotation(const Vector5& y) noexcept { return read_row({.name = RepresentationId::five_d}, y.data()); }

double defect(const Vector5& y) noexcept { return two_column::defect(Scaled(y).columns()); }

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
    Columns h;
    h << 0.5 * (square - 1.0), y[2], y[0], y[3], y[1], y[4];
    const auto rates = two_column::rate(h, w, frame).reshaped().eval();
    return rates.tail<5>() + y * rates[0];
}

Eigen::Vector3d angular_velocity(const Vector5& y, const Vector5& rates, Frame frame) noexcept {
    return least_squares_angular_velocity([&](const Eigen::Vector3d& w) { return rate(y, w, frame); }, rates);
}

} // namespace rotconv::five_d

namespace rotconv {

constinit const Codec codecs::five_d{
    .representation = {.name = RepresentationId::five_d,
                       .text = "5d",
                       .aliases = {"hopf"},
                       .size = 5,
                       .columns = {"y1", "y2", "y3", "y4", "y5"},
                       .modifiers = {Modifier::passive},
                       .presets = presets_of_matrices,
                       .range = "norm between 0.41 and 2.41",
                       .formula = "(r21, r31, r12, r22, r32)/(sqrt 2 - r11): stereographic, Hopf 1940"},
    .read = five_d::read,
    .exact_defect = defect_of<five_d::Vector5, five_d::defect>,
    .sensitivity = sensitivity_of<five_d::sensitivity>,
    .rate = rate_of<five_d::Vector5, five_d::rate>,
    .angular_velocity = angular_velocity_of<five_d::Vector5, five_d::angular_velocity>};

} // namespace rotconv
