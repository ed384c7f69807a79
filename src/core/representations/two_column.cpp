#include <rotconv/two_column.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "../numerics/least_squares_angular_velocity.hpp"
#include "../numerics/power_of_two.hpp"
#include "codec.hpp"
#include "matrices.hpp"

namespace rotconv {

// From the eigenvalues of M'M - I.
double defect_of_columns(const double* columns) noexcept {
    const Eigen::Map<const TwoColumns> m(columns);
    const auto scale = PowerOfTwo::to_unit(std::max(1.0, m.cwiseAbs().maxCoeff()));
    const TwoColumns scaled = m.unaryExpr(scale);
    const double unit = scale(1.0);
    const double a = scaled.col(0).squaredNorm() - unit * unit;
    const double b = scaled.col(1).squaredNorm() - unit * unit;
    const double c = scaled.col(0).dot(scaled.col(1));
    const double mean = 0.5 * (a + b);
    const double radius = std::sqrt(0.25 * (a - b) * (a - b) + c * c);
    return scale.undone(std::max(distance_from_one(mean + radius, unit), distance_from_one(mean - radius, unit)));
}

namespace two_column {

Reading to_rotation(const TwoColumns& m, double tolerance) noexcept {
    return read_within({.name = RepresentationId::two_column}, m.data(), tolerance);
}

double defect(const TwoColumns& m) noexcept { return defect_of_columns(m.data()); }

Sensitivity sensitivity(const Rotation& /*rotation*/) noexcept { return {.condition = std::numbers::sqrt2}; }

TwoColumns rate(const TwoColumns& m, const Eigen::Vector3d& w, Frame frame) noexcept {
    Eigen::Vector3d axis = w;
    if (frame == Frame::body) {
        const Eigen::Vector3d normal = m.col(0).cross(m.col(1));
        const Eigen::Vector3d first = m.col(0) / m.col(0).norm();
        const Eigen::Vector3d third = normal / normal.norm();
        axis = w.x() * first + w.y() * third.cross(first) + w.z() * third;
    }
    TwoColumns rates;
    rates << axis.cross(m.col(0)), axis.cross(m.col(1));
    return rates;
}

Eigen::Vector3d angular_velocity(const TwoColumns& m, const TwoColumns& rates, Frame frame) noexcept {
    return least_squares_angular_velocity([&](const Eigen::Vector3d& w) { return rate(m, w, frame); }, rates);
}

} // namespace two_column

constinit const Codec codecs::two_column{.representation = {.name = RepresentationId::two_column,
                                                            .text = "6d",
                                                            .aliases = {"two-column"},
                                                            .size = 6,
                                                            .columns = {"r11", "r21", "r31", "r12", "r22", "r32"},
                                                            .modifiers = {Modifier::passive},
                                                            .presets = presets_of_matrices},
                                         .range = "two orthonormal columns",
                                         .formula = "columns 1 and 2 of R; the third is their cross product",
                                         .listed_order = {0, 2, 4, 1, 3, 5}, // row by row of the two
                                         .exact_defect = defect_of_columns,
                                         .sensitivity = sensitivity_of<two_column::sensitivity>,
                                         .rate = rate_of<TwoColumns, two_column::rate>,
                                         .angular_velocity =
                                             angular_velocity_of<TwoColumns, two_column::angular_velocity>};

} // namespace rotconv
