#include <rotconv/two_column.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "../batch/scaling.hpp"
#include "../numerics/least_squares_angular_velocity.hpp"
#include "../numerics/scaling.hpp"
#include "codec.hpp"
#include "gram_schmidt.hpp"

namespace rotconv::two_column {
namespace {

Reading read_any(const Columns& m) noexcept {
    if (!m.allFinite()) {
        return Error::not_finite;
    }
    const Reading reading = gram_schmidt(m.col(0), m.col(1));
    return reading ? Reading(*reading, defect(m)) : reading;
}

void read(const Spec& /*spec*/, const double* numbers, std::size_t rows, Readings& readings) noexcept {
    TwoColumns m; // as many rows as there are
    to_columns(numbers, rows, m);
    read_columns(m, rows, readings,
                 [numbers](std::size_t i) { return read_any(Eigen::Map<const Columns>(numbers + 6 * i)); });
}

} // namespace

Reading to_rotation(const Columns& m) noexcept { return read_row({.name = RepresentationId::two_column}, m.data()); }

// From the eigenvalues of M'M - I.
double defect(const Columns& m) noexcept {
    const auto scale = PowerOfTwo::to_unit(std::max(1.0, m.cwiseAbs().maxCoeff()));
    const Columns scaled = m.unaryExpr(scale);
    const double unit = scale(1.0);
    const double a = scaled.col(0).squaredNorm() - unit * unit;
    const double b = scaled.col(1).squaredNorm() - unit * unit;
    const double c = scaled.col(0).dot(scaled.col(1));
    const double mean = 0.5 * (a + b);
    const double radius = ScaledVector(0.5 * (a - b), c).length;
    const auto from_one = [unit](double square_excess) {
        return std::fabs(square_excess) / (unit + std::sqrt(std::max(0.0, unit * unit + square_excess)));
    };
    return scale.undone(std::max(from_one(mean + radius), from_one(mean - radius)));
}

Sensitivity sensitivity(const Rotation& /*rotation*/) noexcept { return {.condition = std::numbers::sqrt2}; }

Columns rate(const Columns& m, const Eigen::Vector3d& w, Frame frame) noexcept {
    Eigen::Vector3d axis = w;
    if (frame == Frame::body) {
        const Eigen::Vector3d normal = m.col(0).cross(m.col(1));
        const Eigen::Vector3d first = m.col(0) / m.col(0).norm();
        const Eigen::Vector3d third = normal / normal.norm();
        axis = w.x() * first + w.y() * third.cross(first) + w.z() * third;
    }
    Columns rates;
    rates << axis.cross(m.col(0)), axis.cross(m.col(1));
    return rates;
}

Eigen::Vector3d angular_velocity(const Columns& m, const Columns& rates, Frame frame) noexcept {
    return least_squares_angular_velocity([&](const Eigen::Vector3d& w) { return rate(m, w, frame); }, rates);
}

} // namespace rotconv::two_column

namespace rotconv {

constinit const Codec codecs::two_column{
    .representation = {.name = RepresentationId::two_column,
                       .text = "6d",
                       .aliases = {"two-column"},
                       .size = 6,
                       .columns = {"r11", "r21", "r31", "r12", "r22", "r32"},
                       .modifiers = {Modifier::passive},
                       .presets = presets_of_matrices,
                       .range = "two orthonormal columns",
                       .formula = "columns 1 and 2 of R; the third is their cross product"},
    .read = two_column::read,
    .exact_defect = defect_of<Columns, two_column::defect>,
    .sensitivity = sensitivity_of<two_column::sensitivity>,
    .rate = rate_of<Columns, two_column::rate>,
    .angular_velocity = angular_velocity_of<Columns, two_column::angular_velocity>};

} // namespace rotconv
