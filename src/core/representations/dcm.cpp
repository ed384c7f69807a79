#include <rotconv/dcm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "../numerics/davenport.hpp"
#include "../numerics/least_squares_angular_velocity.hpp"
#include "../numerics/scaling.hpp"
#include "codec.hpp"

namespace rotconv::dcm {
namespace {

/// A defect up to which power steps alone are the quickest: each gains a factor of at least 20.
constexpr double near_rotation = 0.05;

/// M'M - I.
Eigen::Matrix3d gram_excess(const Dcm& m) noexcept { return m.transpose() * m - Eigen::Matrix3d::Identity(); }

struct Extremes {
    double least, greatest;
};

/// The largest root of x^3 - 3 x = 2 c for c in [-1, 1], 2 cos(acos(c)/3) to 4e-12: in the cosine of half the angle it
/// has no singularity near, and this polynomial meets it in the Chebyshev points of [0, 1].
double largest_root(double c) noexcept {
    constexpr std::array coefficients{-0.00014717953787685018, 0.001134197404638232,  -0.00412384290426036,
                                      0.0096281607649311,      -0.016817242070370317, 0.02465678662997338,
                                      -0.033499987945140405,   0.04560020089465416,   -0.06582459024308872,
                                      0.10691511081910582,     -0.22222215094074232,  1.1547005371224666,
                                      1.0000000000037088};
    const double u = std::sqrt(0.5 + 0.5 * c);
    double sum = 0.0;
    for (const double coefficient : coefficients) {
        sum = sum * u + coefficient;
    }
    return sum;
}

/// Of the eigenvalues of a symmetric matrix, by the roots of its cubic as cosines of a third of an angle (Smith 1961).
Extremes extreme_eigenvalues(const Eigen::Matrix3d& m) noexcept {
    const double mean = m.trace() / 3.0;
    const Eigen::Matrix3d rest = m - mean * Eigen::Matrix3d::Identity();
    const double size = std::sqrt(rest.squaredNorm() / 6.0);
    if (size == 0.0) {
        return {mean, mean};
    }
    const double cosine = std::clamp(0.5 * (rest * (1.0 / size)).determinant(), -1.0, 1.0);
    return {mean - size * largest_root(-cosine), mean + size * largest_root(cosine)};
}

/// The square of how far rows 1 and 2 are from orthonormal and row 3 from their cross product. With d its root, the
/// defect is below 3 d where that is small, and the determinant positive; nan where a number is not finite.
double squared_distance(const std::array<double, 9>& m) noexcept {
    const double cross_0 = (m[1] * m[5] - m[2] * m[4]) - m[6];
    const double cross_1 = (m[2] * m[3] - m[0] * m[5]) - m[7];
    const double cross_2 = (m[0] * m[4] - m[1] * m[3]) - m[8];
    const double first = ((m[0] * m[0] + m[1] * m[1]) + m[2] * m[2]) - 1.0;
    const double second = ((m[3] * m[3] + m[4] * m[4]) + m[5] * m[5]) - 1.0;
    const double both = (m[0] * m[3] + m[1] * m[4]) + m[2] * m[5];
    return ((cross_0 * cross_0 + cross_1 * cross_1) + cross_2 * cross_2) +
           ((first * first + second * second) + both * both);
}

/// All that a clean matrix needs; see clean_square.
struct PowerStep {
    explicit PowerStep(const std::array<double, 9>& m) noexcept : square(squared_distance(m)) {
        const Davenport k(m.data());
        q = k.power_step(k.pivot_column());
    }

    double square;
    std::array<double, 4> q;
};

/// Any proper matrix: the singular value decomposition M = U S V' gives the polar factor U V'. One Newton step
/// on trace(R(q)' M) against M itself then removes the rounding of the decomposition.
Reading far_from_rotation(const Dcm& matrix) noexcept {
    const auto scale = PowerOfTwo::to_unit(matrix.cwiseAbs().maxCoeff());
    const Dcm m = matrix.unaryExpr(scale);
    if (!(m.determinant() > 0.0)) {
        return Error::not_proper;
    }
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Dcm factor = svd.matrixU() * svd.matrixV().transpose();
    if (factor.determinant() < 0.0) {
        // rounding has turned the sign of the smallest singular value
        factor -= 2.0 * svd.matrixU().col(2) * svd.matrixV().col(2).transpose();
    }
    const auto q = quaternion_of_rotation(RowMajor(factor).data());
    const Rotation decomposed = Rotation::from_components(q[0], q[1], q[2], q[3]);

    // With S = R(q)' M, the remaining small rotation d satisfies (tr(S) I - S) d = (S32 - S23, S13 - S31, S21 - S12).
    const Eigen::Matrix3d s = from_rotation(decomposed).transpose() * m;
    const Eigen::Matrix3d symmetric = 0.5 * (s + s.transpose());
    const Eigen::Vector3d skew{s(2, 1) - s(1, 2), s(0, 2) - s(2, 0), s(1, 0) - s(0, 1)};
    const Eigen::Matrix3d hessian = symmetric.trace() * Eigen::Matrix3d::Identity() - symmetric;
    Eigen::Vector3d half = 0.5 * hessian.fullPivLu().solve(skew);
    if (!(half.norm() < 1e-8)) {
        half.setZero(); // the matrix is nearly singular, and this its noise
    }
    const Eigen::Vector3d v{q[1], q[2], q[3]};
    const Eigen::Vector3d corrected = v + q[0] * half + v.cross(half);

    const Eigen::Vector3d& singular = svd.singularValues();
    return {Rotation::from_components(q[0] - v.dot(half), corrected.x(), corrected.y(), corrected.z()),
            std::max(std::fabs(scale.undone(singular[0]) - 1.0), std::fabs(scale.undone(singular[2]) - 1.0))};
}

/// Where one power step is not known to serve.
Reading read_unclean(const double* numbers, double square) noexcept {
    const Eigen::Map<const RowMajor> matrix(numbers);
    if (!matrix.allFinite()) {
        return Error::not_finite;
    }
    const double bound = 3.0 * std::sqrt(square);
    if (!(bound <= near_rotation)) {
        return far_from_rotation(matrix);
    }
    const Davenport k(numbers);
    auto q = k.power_step(k.pivot_column());
    double remaining = bound * bound;
    while (remaining > 0x1p-56) {
        q = k.power_step(q);
        remaining *= bound;
    }
    return {Rotation::from_components(q[0], q[1], q[2], q[3]), bound <= reported_defect ? bound : defect(matrix)};
}

ROTCONV_TARGET_CLONES
void read(const Spec& /*spec*/, const double* numbers, std::size_t rows, Readings& readings) noexcept {
    double m[9][batch_rows];
    to_columns(numbers, rows, m);
    BatchColumn square; // written before it is read
    for (std::size_t i = 0; i < rows; ++i) {
        const PowerStep step({m[0][i], m[1][i], m[2][i], m[3][i], m[4][i], m[5][i], m[6][i], m[7][i], m[8][i]});
        square[i] = step.square;
        readings.w[i] = step.q[0];
        readings.x[i] = step.q[1];
        readings.y[i] = step.q[2];
        readings.z[i] = step.q[3];
        readings.defect[i] = clean_defect;
    }
    for (std::size_t i = 0; i < rows; ++i) {
        readings.error[i] = Error::none;
        if (!(square[i] <= clean_square)) [[unlikely]] {
            readings.set(i, read_unclean(numbers + 9 * i, square[i]));
        }
    }
}

} // namespace

Reading to_rotation(const Dcm& matrix) noexcept {
    std::array<double, 9> numbers;
    Eigen::Map<RowMajor>{numbers.data()} = matrix;
    const PowerStep step(numbers);
    if (step.square <= clean_square) [[likely]] {
        return {Rotation::near_unit(step.q[0], step.q[1], step.q[2], step.q[3]), clean_defect};
    }
    return read_unclean(numbers.data(), step.square);
}

double defect(const Dcm& matrix) noexcept {
    const Eigen::Matrix3d excess = gram_excess(matrix);
    if (!(0.5 * excess.norm() <= near_rotation)) {
        return far_from_rotation(matrix).defect();
    }
    // s^2 - 1 for the singular values s, without cancellation
    const Extremes extremes = extreme_eigenvalues(excess);
    const auto from_one = [](double square_excess) {
        return std::fabs(square_excess) / (1.0 + std::sqrt(1.0 + square_excess));
    };
    return std::max(from_one(extremes.least), from_one(extremes.greatest));
}

Sensitivity sensitivity(const Rotation& /*rotation*/) noexcept { return {.condition = std::numbers::sqrt2}; }

Dcm rate(const Dcm& matrix, const Eigen::Vector3d& w, Frame frame) noexcept {
    Dcm rates;
    for (Eigen::Index i = 0; i < 3; ++i) {
        if (frame == Frame::body) {
            rates.row(i) = matrix.row(i).cross(w);
        } else {
            rates.col(i) = w.cross(matrix.col(i));
        }
    }
    return rates;
}

Eigen::Vector3d angular_velocity(const Dcm& matrix, const Dcm& rates, Frame frame) noexcept {
    return least_squares_angular_velocity([&](const Eigen::Vector3d& w) { return rate(matrix, w, frame); }, rates);
}

} // namespace rotconv::dcm

namespace rotconv {

constinit const Codec codecs::dcm{
    .representation = {.name = RepresentationId::dcm,
                       .text = "dcm",
                       .aliases = {"matrix"},
                       .size = 9,
                       .columns = {"r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"},
                       .modifiers = {Modifier::passive, Modifier::col},
                       .presets = presets_of_matrices,
                       .other_order = {0, 3, 6, 1, 4, 7, 2, 5, 8},
                       .range = "orthogonal, det 1",
                       .formula = "v_ref = R v_body; R = [e1 e2 e3], the body axes in reference coordinates"},
    .read = dcm::read,
    .exact_defect = defect_of<RowMajor, dcm::defect>,
    .sensitivity = sensitivity_of<dcm::sensitivity>,
    .rate = rate_of<RowMajor, dcm::rate>,
    .angular_velocity = angular_velocity_of<RowMajor, dcm::angular_velocity>};

} // namespace rotconv
