#include "formulas.hpp"

#include <Eigen/LU>

namespace rotconv::formula {
namespace dcm_to_cayley {

/// Stuelpnagel 1964, section 6: (I - X)(I + X)^-1 with X = R' is [c]_x, c = tan(theta/2) n. The factors commute.
void lu(const double* m, double* c) noexcept {
    const Eigen::Matrix3d x = Eigen::Map<const RowMajor>(m).transpose();
    const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d cross = (identity + x).partialPivLu().solve(identity - x);
    c[0] = cross(2, 1);
    c[1] = cross(0, 2);
    c[2] = cross(1, 0);
}

/// The Rodrigues vector of a matrix, common property (in Shuster's survey of 1993 among others): (r32 - r23, r13 - r31,
/// r21 - r12)/(1 + tr).
void polynomial(const double* m, double* c) noexcept { Vector{c} = differences(m) / (1.0 + (m[0] + m[4] + m[8])); }

/// Shepperd 1978, then c = v/w.
void quaternion(const double* m, double* c) noexcept {
    double q[4];
    dcm_to_quat::shepperd(m, q);
    Vector{c} = Vector(q + 1) / q[0];
}

} // namespace dcm_to_cayley

namespace cayley_to_dcm {

/// Stuelpnagel 1964, section 6 with S = -[c]_x and X = R': (I + [c]_x)(I - [c]_x)^-1. The factors commute.
void inverse(const double* c, double* m) noexcept {
    const Eigen::Matrix3d cross = cross_matrix(c);
    const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
    Eigen::Map<RowMajor>{m} = (identity - cross).partialPivLu().solve(identity + cross);
}

/// The matrix of a Rodrigues vector, common property (in Shuster's survey of 1993 among others): ((1 - c'c) I + 2 c c'
/// + 2 [c]_x)/(1 + c'c).
void closed(const double* c, double* m) noexcept {
    const Eigen::Map<const Eigen::Vector3d> vector(c);
    const double square = vector.squaredNorm();
    Eigen::Map<RowMajor>{m} =
        ((1.0 - square) * RowMajor::Identity() + 2.0 * vector * vector.transpose() + 2.0 * cross_matrix(c)) /
        (1.0 + square);
}

} // namespace cayley_to_dcm
} // namespace rotconv::formula
