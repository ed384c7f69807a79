#include <rotconv/columns.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include <rotconv/dcm.hpp>

#include "davenport.hpp"
#include "double_double.hpp"
#include "nearest_velocity.hpp"
#include "scaling.hpp"

namespace rotconv {
namespace {

using std::numbers::sqrt2;

/// Largest |s - 1| over the singular values s of a 3x2 matrix, from the eigenvalues of M'M - I.
double columns_defect(const Columns& m) noexcept {
    const auto scale = PowerOfTwo::to_unit(std::max(1.0, m.cwiseAbs().maxCoeff()));
    const Columns scaled = m.unaryExpr(scale);
    const double unit = scale(1.0);
    const double a = scaled.col(0).squaredNorm() - unit * unit;
    const double b = scaled.col(1).squaredNorm() - unit * unit;
    const double c = scaled.col(0).dot(scaled.col(1));
    const double mean = 0.5 * (a + b);
    const double radius = std::hypot(0.5 * (a - b), c);
    const auto from_one = [unit](double square_excess) {
        return std::fabs(square_excess) / (unit + std::sqrt(std::max(0.0, unit * unit + square_excess)));
    };
    return scale.undone(std::max(from_one(mean + radius), from_one(mean - radius)));
}

/// The rotation of two nonzero directions, or a fault; columns of any finite length.
Reading gram_schmidt(Eigen::Vector3d first, Eigen::Vector3d second) noexcept {
    const double first_size = first.cwiseAbs().maxCoeff();
    const double second_size = second.cwiseAbs().maxCoeff();
    if (first_size == 0.0 || second_size == 0.0) {
        return Reading::failed(Fault::rank_deficient);
    }
    first = first.unaryExpr(PowerOfTwo::to_unit(first_size)).eval();
    second = second.unaryExpr(PowerOfTwo::to_unit(second_size)).eval();
    // The normal of the plane, with the digits that nearly parallel columns have; the second column follows from it.
    Eigen::Vector3d normal{difference_of_products(first[1], second[2], first[2], second[1]),
                           difference_of_products(first[2], second[0], first[0], second[2]),
                           difference_of_products(first[0], second[1], first[1], second[0])};
    const double normal_size = normal.cwiseAbs().maxCoeff();
    if (normal_size == 0.0) {
        return Reading::failed(Fault::rank_deficient);
    }
    normal = normal.unaryExpr(PowerOfTwo::to_unit(normal_size)).eval();
    Eigen::Matrix<double, 3, 3, Eigen::RowMajor> m;
    m.col(0) = first.normalized();
    m.col(2) = normal.normalized();
    m.col(1) = m.col(2).cross(m.col(0));
    const Quaternion q = quaternion_of_rotation(m.data());
    return {.rotation = Rotation::from_components(q.w, q.x, q.y, q.z)};
}

/// The rates of two columns that turn as a rigid pair.
Columns turned(const Columns& m, const Eigen::Vector3d& w, Frame frame) noexcept {
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

} // namespace

namespace columns {

Reading to_rotation(const Columns& m) noexcept {
    if (!m.allFinite()) {
        return Reading::failed(Fault::not_finite);
    }
    Reading reading = gram_schmidt(m.col(0), m.col(1));
    if (reading.ok()) {
        reading.defect = columns_defect(m);
    }
    return reading;
}

Figures figures(const Rotation& /*rotation*/) noexcept { return {.condition = sqrt2}; }

Columns rate(const Columns& m, const Eigen::Vector3d& w, Frame frame) noexcept { return turned(m, w, frame); }

Eigen::Vector3d angular_velocity(const Columns& m, const Columns& rates, Frame frame) noexcept {
    return nearest_velocity([&](const Eigen::Vector3d& w) { return rate(m, w, frame); }, rates);
}

} // namespace columns

namespace hopf {

Reading to_rotation(const Vector5& y) noexcept {
    if (!y.allFinite()) {
        return Reading::failed(Fault::not_finite);
    }
    // Times a power of two f, so that y'y cannot overflow: (f^2 y'y - f^2, 2 f fy) is parallel to the two columns.
    const auto scale = PowerOfTwo::to_unit(std::max(1.0, y.cwiseAbs().maxCoeff()));
    const double f = scale(1.0);
    const Vector5 fy = y.unaryExpr(scale);
    const double square = fy.squaredNorm();
    const Eigen::Vector3d first{square - f * f, 2.0 * f * fy[0], 2.0 * f * fy[1]};
    Reading reading = gram_schmidt(first, fy.tail<3>()); // of the second column only the direction counts
    if (reading.ok()) {
        Columns m;
        m << first, (2.0 * f) * fy.tail<3>();
        reading.defect = columns_defect(m * (sqrt2 / (square + f * f)));
    }
    return reading;
}

Vector5 from_rotation(const Rotation& rotation) noexcept {
    const double w = rotation.w();
    const double x = rotation.x();
    const double y = rotation.y();
    const double z = rotation.z();
    Vector5 numerator;
    numerator << 2.0 * (x * y + w * z), 2.0 * (x * z - w * y), 2.0 * (x * y - w * z), (w * w + y * y) - (x * x + z * z),
        2.0 * (y * z + w * x);
    return numerator / ((sqrt2 - 1.0) * (w * w + x * x) + (sqrt2 + 1.0) * (y * y + z * z));
}

Figures figures(const Rotation& rotation) noexcept {
    const double turning = rotation.w() * rotation.w() + rotation.x() * rotation.x();
    const double tilting = rotation.y() * rotation.y() + rotation.z() * rotation.z();
    return {.condition = sqrt2 * (turning + tilting) / ((sqrt2 - 1.0) * turning + (sqrt2 + 1.0) * tilting)};
}

Vector5 rate(const Vector5& y, const Eigen::Vector3d& w, Frame frame) noexcept {
    const double square = y.squaredNorm();
    Columns h;
    h << 0.5 * (square - 1.0), y[2], y[0], y[3], y[1], y[4];
    const auto rates = turned(h, w, frame).reshaped().eval();
    return rates.tail<5>() + y * rates[0];
}

Eigen::Vector3d angular_velocity(const Vector5& y, const Vector5& rates, Frame frame) noexcept {
    return nearest_velocity([&](const Eigen::Vector3d& w) { return rate(y, w, frame); }, rates);
}

} // namespace hopf
} // namespace rotconv
