#include <rotconv/dcm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "../numerics/davenport.hpp"
#include "../numerics/eigensystem.hpp"
#include "../numerics/least_squares_angular_velocity.hpp"
#include "../numerics/power_of_two.hpp"
#include "codec.hpp"
#include "matrices.hpp"

namespace rotconv {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

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

/// The singular values of a matrix, the largest first, with their vectors: plane rotations of two columns at a time,
/// until all are orthogonal (Hestenes 1958). The columns are then the left vectors times the values.
struct SingularValues {
    explicit SingularValues(Matrix3d matrix) noexcept : left(std::move(matrix)) {
        constexpr int most_sweeps = 60;
        bool orthogonal = false;
        for (int sweep = 0; sweep < most_sweeps && !orthogonal; ++sweep) {
            orthogonal = true;
            for (const auto& [i, k] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
                orthogonal = !rotate(i, k) && orthogonal;
            }
        }
        values = left.colwise().norm();
        for (const auto& [i, k] : {std::pair{0, 1}, {1, 2}, {0, 1}}) {
            if (values[i] < values[k]) {
                std::swap(values[i], values[k]);
                left.col(i).swap(left.col(k));
                right.col(i).swap(right.col(k));
            }
        }
    }

    Matrix3d left;
    Matrix3d right = Matrix3d::Identity();
    Vector3d values;

private:
    /// Makes two columns orthogonal; false where they are.
    bool rotate(Eigen::Index i, Eigen::Index k) noexcept {
        const double a = left.col(i).squaredNorm();
        const double b = left.col(k).squaredNorm();
        const double c = left.col(i).dot(left.col(k));
        if (!(std::fabs(c) > std::numeric_limits<double>::epsilon() * std::sqrt(a * b))) {
            return false;
        }
        const PlaneRotation turned(a, b, c);
        for (Matrix3d* const m : {&left, &right}) {
            turned(m->col(i).data(), m->col(k).data(), 3);
        }
        return true;
    }
};

/// max |s - 1| over the singular values of a scaled matrix.
double defect_of(const SingularValues& scaled, const PowerOfTwo& scale) noexcept {
    return std::max(std::fabs(scale.undone(scaled.values[0]) - 1.0), std::fabs(scale.undone(scaled.values[2]) - 1.0));
}

} // namespace

Error polar_factor(const double* matrix, double* factor, double& defect) noexcept {
    const Eigen::Map<const RowMajor> given(matrix);
    const auto scale = PowerOfTwo::to_unit(given.cwiseAbs().maxCoeff());
    const Matrix3d scaled = given.unaryExpr(scale);
    if (scaled.determinant() <= 0.0) {
        return Error::not_proper;
    }
    const SingularValues singular(scaled);
    const Vector3d& values = singular.values;
    constexpr double least_turning = 1e-12;
    if (values[1] + values[2] < least_turning * values[0]) {
        return Error::rank_deficient;
    }
    defect = defect_of(singular, scale);
    // U V' of M = U S V'; the third vectors follow from the others, since the determinant is positive
    const Vector3d u1 = singular.left.col(0) / values[0];
    const Vector3d u2 = singular.left.col(1) / values[1];
    const Vector3d v1 = singular.right.col(0);
    const Vector3d v2 = singular.right.col(1);
    const Vector3d u3 = u1.cross(u2);
    const Vector3d v3 = v1.cross(v2);
    for (Eigen::Index i = 0; i < 9; ++i) { // an expression of Eigen's would leave a symbol that users could replace
        factor[i] = u1[i / 3] * v1[i % 3] + u2[i / 3] * v2[i % 3] + u3[i / 3] * v3[i % 3];
    }
    return Error::none;
}

double defect_of_matrix(const double* matrix) noexcept {
    const Eigen::Map<const RowMajor> m(matrix);
    const Matrix3d excess = m.transpose() * m - Matrix3d::Identity();
    constexpr double small_excess = 0.05;
    if (!(0.5 * excess.norm() <= small_excess)) {
        const auto scale = PowerOfTwo::to_unit(m.cwiseAbs().maxCoeff());
        return defect_of(SingularValues(m.unaryExpr(scale)), scale);
    }
    // The eigenvalues are s^2 - 1 for the singular values s, without cancellation: the roots of a cubic, as cosines of
    // a third of an angle (Smith 1961).
    const double mean = excess.trace() / 3.0;
    const Matrix3d deviator = excess - mean * Matrix3d::Identity();
    const double size = std::sqrt(deviator.squaredNorm() / 6.0);
    const double cosine = size == 0.0 ? 0.0 : std::clamp(0.5 * (deviator * (1.0 / size)).determinant(), -1.0, 1.0);
    return std::max(distance_from_one(mean - size * largest_root(-cosine)),
                    distance_from_one(mean + size * largest_root(cosine)));
}

namespace dcm {

Reading to_rotation(const Dcm& matrix, double tolerance) noexcept {
    const double* const m = matrix.data(); // column by column
    const double numbers[9] = {alone(m[0]), alone(m[3]), alone(m[6]), alone(m[1]), alone(m[4]),
                               alone(m[7]), alone(m[2]), alone(m[5]), alone(m[8])};
    // Most are clean, and need no table of kernels.
    if (squared_distance(numbers) <= clean_square && clean_defect <= tolerance) [[likely]] {
        const Davenport<double> k(numbers);
        double q[4];
        k.take_first_power_step(q);
        return {Rotation::near_unit(q[0], q[1], q[2], q[3]), clean_defect};
    }
    return read_within({.name = RepresentationId::dcm}, numbers, tolerance);
}

double defect(const Dcm& matrix) noexcept { return defect_of_matrix(RowMajor(matrix).data()); }

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

} // namespace dcm

constinit const Codec codecs::dcm{
    .representation = {.name = RepresentationId::dcm,
                       .text = "dcm",
                       .aliases = {"matrix", "rotmat"},
                       .size = 9,
                       .columns = {"r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"},
                       .modifiers = {Modifier::passive, Modifier::col},
                       .presets = presets_of_matrices,
                       .other_order = {0, 3, 6, 1, 4, 7, 2, 5, 8}},
    .range = "orthogonal, det 1",
    .formula = "v_ref = R v_body; R = [e1 e2 e3], the body axes in reference coordinates",
    .exact_defect = defect_of_matrix,
    .sensitivity = sensitivity_of<dcm::sensitivity>,
    .rate = rate_of<RowMajor, dcm::rate>,
    .angular_velocity = angular_velocity_of<RowMajor, dcm::angular_velocity>};

} // namespace rotconv
