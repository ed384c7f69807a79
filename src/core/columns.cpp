#include <rotconv/columns.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include <rotconv/dcm.hpp>

#include "blocks.hpp"
#include "davenport.hpp"
#include "double_double.hpp"
#include "nearest_velocity.hpp"
#include "scaling.hpp"

namespace rotconv {
namespace {

using std::numbers::sqrt2;

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

/// Two columns of each row, the first above the second.
using ColumnLanes = std::array<Lane, 6>;

/// Gram-Schmidt on columns that are orthonormal but for `square`, the sum of the squares of what is missing. It leaves
/// an orthogonal matrix, and one power step its polar factor, where that is at most clean_square.
ROTCONV_FOR_EACH_PROCESSOR
void read_clean(const ColumnLanes& m, std::size_t rows, Readings& readings, Lane& square) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        const double a0 = m[0][i];
        const double a1 = m[1][i];
        const double a2 = m[2][i];
        const double along = (a0 * m[3][i] + a1 * m[4][i]) + a2 * m[5][i];
        const double a_excess = ((a0 * a0 + a1 * a1) + a2 * a2) - 1.0;
        const double share = along - along * a_excess; // along/|a|^2
        const double b0 = m[3][i] - share * a0;
        const double b1 = m[4][i] - share * a1;
        const double b2 = m[5][i] - share * a2;
        const double b_excess = ((b0 * b0 + b1 * b1) + b2 * b2) - 1.0;
        const std::array matrix{a0, b0, a1 * b2 - a2 * b1, a1, b1, a2 * b0 - a0 * b2, a2, b2, a0 * b1 - a1 * b0};
        const Davenport k(matrix.data());
        const Quaternion q = k.power_step(k.pivot_column());
        readings.w[i] = q.w;
        readings.x[i] = q.x;
        readings.y[i] = q.y;
        readings.z[i] = q.z;
        readings.defect[i] = clean_defect;
        square[i] = (a_excess * a_excess + b_excess * b_excess) + along * along;
    }
}

/// Reads the rows that are not clean by `read_any`.
template <class ReadAny>
void read_others(const Lane& square, std::size_t rows, Readings& readings, const ReadAny& read_any) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        readings.fault[i] = Fault::none;
        if (!(square[i] <= clean_square)) [[unlikely]] {
            readings.set(i, read_any(i));
        }
    }
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
namespace {

Reading read_any(const Columns& m) noexcept {
    if (!m.allFinite()) {
        return Reading::failed(Fault::not_finite);
    }
    Reading reading = gram_schmidt(m.col(0), m.col(1));
    if (reading.ok()) {
        reading.defect = defect(m);
    }
    return reading;
}

} // namespace

Reading to_rotation(const Columns& m) noexcept {
    Readings one; // NOLINT(*-member-init): written before it is read
    read(m.data(), 1, one);
    return one.reading(0);
}

void read(const double* numbers, std::size_t rows, Readings& readings) noexcept {
    Lane square; // NOLINT(*-member-init): written before it is read
    read_clean(to_lanes<6>(numbers, rows), rows, readings, square);
    read_others(square, rows, readings,
                [numbers](std::size_t i) { return read_any(Eigen::Map<const Columns>(numbers + 6 * i)); });
}

// From the eigenvalues of M'M - I.
double defect(const Columns& m) noexcept {
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

Figures figures(const Rotation& /*rotation*/) noexcept { return {.condition = sqrt2}; }

Columns rate(const Columns& m, const Eigen::Vector3d& w, Frame frame) noexcept { return turned(m, w, frame); }

Eigen::Vector3d angular_velocity(const Columns& m, const Columns& rates, Frame frame) noexcept {
    return nearest_velocity([&](const Eigen::Vector3d& w) { return rate(m, w, frame); }, rates);
}

} // namespace columns

namespace hopf {
namespace {

/// The columns of Hopf's numbers.
ROTCONV_FOR_EACH_PROCESSOR
ColumnLanes columns_of(const double* numbers, std::size_t rows) noexcept {
    ColumnLanes m; // NOLINT(*-member-init): as many rows as there are
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
    return m;
}

/// y times a power of two f, so that y'y cannot overflow: (f^2 y'y - f^2, 2 f fy) is parallel to the two columns.
struct Scaled {
    explicit Scaled(const Vector5& number) noexcept {
        const auto scale = PowerOfTwo::to_unit(std::max(1.0, number.cwiseAbs().maxCoeff()));
        f = scale(1.0);
        y = number.unaryExpr(scale);
        square = y.squaredNorm();
    }

    [[nodiscard]] Eigen::Vector3d first() const noexcept { return {square - f * f, 2.0 * f * y[0], 2.0 * f * y[1]}; }
    [[nodiscard]] Columns columns() const noexcept {
        Columns m;
        m << first(), (2.0 * f) * y.tail<3>();
        return m * (sqrt2 / (square + f * f));
    }

    Vector5 y;
    double f, square;
};

Reading read_any(const Vector5& y) noexcept {
    if (!y.allFinite()) {
        return Reading::failed(Fault::not_finite);
    }
    const Scaled scaled(y);
    Reading reading =
        gram_schmidt(scaled.first(), scaled.y.tail<3>()); // of the second column only the direction counts
    if (reading.ok()) {
        reading.defect = columns::defect(scaled.columns());
    }
    return reading;
}

} // namespace

Reading to_rotation(const Vector5& y) noexcept {
    Readings one; // NOLINT(*-member-init): written before it is read
    read(y.data(), 1, one);
    return one.reading(0);
}

void read(const double* numbers, std::size_t rows, Readings& readings) noexcept {
    Lane square; // NOLINT(*-member-init): written before it is read
    read_clean(columns_of(numbers, rows), rows, readings, square);
    read_others(square, rows, readings,
                [numbers](std::size_t i) { return read_any(Eigen::Map<const Vector5>(numbers + 5 * i)); });
}

double defect(const Vector5& y) noexcept { return columns::defect(Scaled(y).columns()); }

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
