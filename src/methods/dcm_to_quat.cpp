#include "formulas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <Eigen/SVD>

#include "../core/numerics/davenport.hpp"
#include "../core/numerics/eigensystem.hpp"

namespace rotconv::formula::dcm_to_quat {
namespace {

using Quaternion = Eigen::Map<Eigen::Vector4d>;

/// The squares less 1: the diagonal of Davenport's K.
Eigen::Vector4d sums(const double* m) noexcept {
    return {m[0] + m[4] + m[8], m[0] - m[4] - m[8], m[4] - m[0] - m[8], m[8] - m[0] - m[4]};
}

/// The norms of the rows; for a symmetric matrix also those of the columns.
Eigen::Array4d norms_of_rows(const Eigen::Matrix4d& p) noexcept {
    const Eigen::Array44d squares = p.array().square();
    return ((squares.col(0) + squares.col(1)) + (squares.col(2) + squares.col(3))).sqrt();
}

/// Shepperd's choice: the component that belongs to the largest of the trace and the diagonal.
Eigen::Index pivot_of(const double* m) noexcept {
    const Eigen::Index entry = largest_on_diagonal(m);
    return m[0] + m[4] + m[8] >= m[4 * entry] ? 0 : entry + 1;
}

/// Not copysign: equal entries 0 and -0 differ by -0.
double with_sign_of(double difference, double size) noexcept { return difference < 0.0 ? -size : size; }

/// Sets components of these sizes: w positive, the others with the signs of the differences.
void set_sizes(const Eigen::Matrix4d& p, const Eigen::Array4d& sizes, double* q) noexcept {
    q[0] = sizes[0];
    for (int k = 1; k < 4; ++k) {
        q[k] = with_sign_of(p(0, k), sizes[k]);
    }
}

} // namespace

Eigen::Matrix4d products(const double* m) noexcept {
    const double wx = m[7] - m[5];
    const double wy = m[2] - m[6];
    const double wz = m[3] - m[1];
    const double xy = m[3] + m[1];
    const double xz = m[2] + m[6];
    const double yz = m[7] + m[5];
    Eigen::Matrix4d p;
    p << 1.0 + m[0] + m[4] + m[8], wx, wy, wz, //
        wx, 1.0 + m[0] - m[4] - m[8], xy, xz,  //
        wy, xy, 1.0 - m[0] + m[4] - m[8], yz,  //
        wz, xz, yz, 1.0 - m[0] - m[4] + m[8];
    return p;
}

/// Baruh 1999, Eqs 1-4: w from the trace, the others by division by w.
void trace(const double* m, double* q) noexcept {
    const double w = 0.5 * std::sqrt(m[0] + m[4] + m[8] + 1.0);
    Quaternion{q} = products(m).col(0) / (4.0 * w);
    q[0] = w;
}

/// Baruh 1999: the largest from Eqs 5-8, the others from Eqs 2-4. These are differences and give w first, then all by
/// w, as in his Example 2 c): the largest does not help where w is small.
void baruh(const double* m, double* q) noexcept {
    const Eigen::Matrix4d p = products(m);
    int at = 0;
    const double largest = 0.5 * std::sqrt(p.diagonal().maxCoeff(&at));
    const double w = at == 0 ? largest : p(0, at) / (4.0 * largest);
    Quaternion{q} = p.col(0) / (4.0 * w);
    q[0] = w;
    q[at] = largest;
}

/// Chiaverini and Siciliano 1999: four square roots of sums of the diagonal, signs from the differences. Software also
/// cites Klumpp 1976 for it.
void four_roots(const double* m, double* q) noexcept {
    const Eigen::Matrix4d p = products(m);
    set_sizes(p, 0.5 * p.diagonal().array().sqrt(), q);
}

/// Klumpp 1976, by its abstract: roots protected against negative sums; the largest vector element's sign is that of
/// its difference, and the other two take theirs from it.
void klumpp(const double* m, double* q) noexcept {
    const Eigen::Matrix4d p = products(m);
    Quaternion{q}.array() = 0.5 * p.diagonal().array().max(0.0).sqrt();
    const int largest = q[1] >= q[2] && q[1] >= q[3] ? 1 : q[2] >= q[3] ? 2 : 3;
    const double leader = with_sign_of(p(0, largest), 1.0);
    for (int k = 1; k < 4; ++k) {
        q[k] = leader * (k == largest ? q[k] : with_sign_of(p(largest, k), q[k]));
    }
}

/// Shepperd 1978: the largest of trace and diagonal picks the square root, the rest by division by it.
void shepperd(const double* m, double* q) noexcept {
    const Eigen::Matrix4d p = products(m);
    const Eigen::Index pivot = pivot_of(m);
    const double root = std::sqrt(p(pivot, pivot));
    Quaternion{q} = 0.5 / root * p.col(pivot);
    q[pivot] = 0.5 * root;
}

/// Markley 2008: the column of 4 q q' with the largest diagonal element, over its norm.
void markley(const double* m, double* q) noexcept {
    const Eigen::Matrix4d p = products(m);
    const Eigen::Index pivot = pivot_of(m);
    Quaternion{q} = p.col(pivot) / norms_of_rows(p)[pivot];
}

/// One step of Bjorck and Bowie 1971 to the nearest rotation, X <- X (3 I - X'X)/2, then Markley 2008. A defect d
/// leaves an error of the order of d^2.
void first_order(const double* m, double* q) noexcept {
    const Eigen::Map<const RowMajor> x(m);
    const RowMajor nearer = 0.5 * x * (3.0 * RowMajor::Identity() - x.transpose() * x);
    markley(nearer.data(), q);
}

/// Cayley's factorisation, which the survey of Sarabandi and Thomas 2019 recommends: the norms of the four rows of
/// 4 q q', signs from the differences.
void cayley(const double* m, double* q) noexcept {
    const Eigen::Matrix4d p = products(m);
    set_sizes(p, 0.25 * norms_of_rows(p), q);
}

/// Sarabandi and Thomas 2018, with their threshold eta = 0: each component from the diagonal where that sum is large,
/// else from its row's other three entries; signs from the differences.
void sarabandi_thomas(const double* m, double* q) noexcept {
    const Eigen::Matrix4d p = products(m);
    Eigen::Array44d squares = p.array().square();
    squares.matrix().diagonal().setZero();
    const Eigen::Array4d others = (squares.col(0) + squares.col(1)) + squares.col(2) + squares.col(3);
    const Eigen::Array4d sum = sums(m);
    constexpr double eta = 0.0;
    set_sizes(p, 0.5 * (sum > eta).select(1.0 + sum, others / (3.0 - sum)).sqrt(), q);
}

/// Sarabandi, Shabani, Porta and Thomas 2020, the approximate method, checked against a port by A. Diaz, not the code
/// of the authors: the sum of the columns of 4 q q', each with the sign of its product with the longest.
void sarabandi_2020(const double* m, double* q) noexcept {
    const Eigen::Matrix4d p = products(m);
    int longest = 0;
    norms_of_rows(p).maxCoeff(&longest);
    Quaternion{q} = (p * (p * p.col(longest)).cwiseSign()).normalized();
}

/// Hanson and Hanson 2022, for a matrix without noise: K, of which a rotation's quaternion is the eigenvector to 3, and
/// of the adjugate of K - 3 I, which is -64 q q', the longest column.
void adjugate(const double* m, double* q) noexcept {
    constexpr std::array<std::array<int, 3>, 4> others{{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};
    Eigen::Matrix4d k = products(m);
    k.diagonal() = sums(m).array() - 3.0;
    Eigen::Matrix4d cofactors;
    for (unsigned at = 0; at < 16; ++at) {
        const double minor = k(others[at / 4], others[at % 4]).determinant();
        cofactors(at / 4, at % 4) = (at / 4 + at) % 2 == 0 ? minor : -minor;
    }
    int longest = 0;
    norms_of_rows(cofactors).maxCoeff(&longest);
    Quaternion{q} = cofactors.col(longest).normalized();
}

/// Bar-Itzhack 2000, version 3: the eigenvector of his K3 to its largest eigenvalue. The paper's factor 1/3 changes no
/// eigenvector.
void bar_itzhack(const double* m, double* q) noexcept {
    Eigen::Matrix4d k = products(m);
    k.diagonal() = sums(m);
    Quaternion{q} = Eigensystem<4>(k).vectors.col(3); // in increasing order of eigenvalues
}

/// Markley 1988: the nearest rotation U diag(1, 1, det U det V) V' of M = U S V', then Shepperd 1978.
void svd(const double* m, double* q) noexcept {
    const Eigen::Matrix3d matrix = Eigen::Map<const RowMajor>(m);
    const Eigen::JacobiSVD<Eigen::Matrix3d> decomposition(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
    if (decomposition.info() != Eigen::Success) { // not finite: U and V were never written
        std::fill_n(q, 4, std::numeric_limits<double>::quiet_NaN());
        return;
    }
    Eigen::Matrix3d u = decomposition.matrixU();
    const Eigen::Matrix3d& v = decomposition.matrixV();
    if (u.determinant() * v.determinant() < 0.0) {
        u.col(2) = -u.col(2);
    }
    const RowMajor rotation = u * v.transpose();
    shepperd(rotation.data(), q);
}

/// Higham 1986, without his scaling: X <- (X + X^-T)/2 tends to the polar factor, quadratically; then Shepperd 1978.
void polar(const double* m, double* q) noexcept {
    constexpr int most_steps = 30;
    constexpr double last_change = 1e-8; // the step after it would change less than rounding
    RowMajor x = Eigen::Map<const RowMajor>(m);
    for (int step = 0; step < most_steps; ++step) {
        RowMajor cofactors;
        cofactors.row(0) = x.row(1).cross(x.row(2));
        cofactors.row(1) = x.row(2).cross(x.row(0));
        cofactors.row(2) = x.row(0).cross(x.row(1));
        const double determinant = x.row(0).dot(cofactors.row(0));
        const RowMajor next = 0.5 * (x + cofactors / determinant);
        const double change = (next - x).norm();
        x = next;
        if (!(change > last_change)) {
            break;
        }
    }
    shepperd(x.data(), q);
}

/// Davenport 1968 (the matrix K), products after Dekker 1971: the largest column of K + I and two power steps, the
/// second with exact products. Without more steps a defect d leaves an error of the order of d^3.
void compensated(const double* m, double* q) noexcept {
    double own[9];
    double near[4];
    std::copy_n(m, 9, own);
    const Davenport<double> k(own);
    k.take_pivot_column(near);
    k.take_power_step(near);
    DoubleDouble exact[4] = {near[0], near[1], near[2], near[3]};
    Davenport<DoubleDouble>(own).take_power_step(exact);
    Quaternion{q} = Eigen::Vector4d(exact[0].hi, exact[1].hi, exact[2].hi, exact[3].hi).normalized();
}

} // namespace rotconv::formula::dcm_to_quat
