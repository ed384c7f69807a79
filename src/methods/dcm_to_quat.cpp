#include "formulas.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "../core/numerics/davenport.hpp"

namespace rotconv::formula::dcm_to_quat {
namespace {

/// 4 q q': the squares are Baruh's Eqs 5-8 (1999); the others are the entries of R - R' and R + R' off the diagonal.
struct Products {
    explicit Products(const double* m) noexcept
        : ww(1.0 + m[0] + m[4] + m[8]), xx(1.0 + m[0] - m[4] - m[8]), yy(1.0 - m[0] + m[4] - m[8]),
          zz(1.0 - m[0] - m[4] + m[8]), wx(m[7] - m[5]), wy(m[2] - m[6]), wz(m[3] - m[1]), yz(m[7] + m[5]),
          zx(m[2] + m[6]), xy(m[3] + m[1]) {}

    double ww, xx, yy, zz, wx, wy, wz, yz, zx, xy;
};

/// Not copysign: equal entries 0 and -0 differ by -0.
double with_sign_of(double difference, double size) noexcept { return difference < 0.0 ? -size : size; }

void set(double* q, double w, double x, double y, double z) noexcept {
    q[0] = w;
    q[1] = x;
    q[2] = y;
    q[3] = z;
}

} // namespace

/// Baruh 1999, Eqs 1-4: w from the trace, the rest by division by it.
void trace(const double* m, double* q) noexcept {
    const Products p(m);
    const double w = 0.5 * std::sqrt(m[0] + m[4] + m[8] + 1.0);
    const double scale = 4.0 * w;
    set(q, w, p.wx / scale, p.wy / scale, p.wz / scale);
}

/// Baruh 1999: the largest from Eqs 5-8, the others from Eqs 2-4. These are differences and give w first, then all by
/// w, as in his Example 2 c): the largest does not help where w is small.
void baruh(const double* m, double* q) noexcept {
    const Products p(m);
    const double largest = std::max(std::max(p.ww, p.xx), std::max(p.yy, p.zz));
    const double pivot = 0.5 * std::sqrt(largest);
    if (largest == p.ww) {
        set(q, pivot, p.wx / (4.0 * pivot), p.wy / (4.0 * pivot), p.wz / (4.0 * pivot));
    } else if (largest == p.xx) {
        const double w = p.wx / (4.0 * pivot);
        set(q, w, pivot, p.wy / (4.0 * w), p.wz / (4.0 * w));
    } else if (largest == p.yy) {
        const double w = p.wy / (4.0 * pivot);
        set(q, w, p.wx / (4.0 * w), pivot, p.wz / (4.0 * w));
    } else {
        const double w = p.wz / (4.0 * pivot);
        set(q, w, p.wx / (4.0 * w), p.wy / (4.0 * w), pivot);
    }
}

/// Chiaverini and Siciliano 1999: four square roots of sums of the diagonal, signs from the differences. Software also
/// cites Klumpp 1976 for it.
void four_roots(const double* m, double* q) noexcept {
    const Products p(m);
    set(q, 0.5 * std::sqrt(p.ww), with_sign_of(p.wx, 0.5 * std::sqrt(p.xx)), with_sign_of(p.wy, 0.5 * std::sqrt(p.yy)),
        with_sign_of(p.wz, 0.5 * std::sqrt(p.zz)));
}

/// Klumpp 1976, by its abstract: roots protected against negative sums; the largest vector element's sign is that of
/// its difference, and the other two take theirs from it.
void klumpp(const double* m, double* q) noexcept {
    const Products p(m);
    const auto root = [](double square) { return 0.5 * std::sqrt(std::max(square, 0.0)); };
    const double x = root(p.xx);
    const double y = root(p.yy);
    const double z = root(p.zz);
    if (x >= y && x >= z) {
        const double leader = with_sign_of(p.wx, 1.0);
        set(q, root(p.ww), leader * x, leader * with_sign_of(p.xy, y), leader * with_sign_of(p.zx, z));
    } else if (y >= z) {
        const double leader = with_sign_of(p.wy, 1.0);
        set(q, root(p.ww), leader * with_sign_of(p.xy, x), leader * y, leader * with_sign_of(p.yz, z));
    } else {
        const double leader = with_sign_of(p.wz, 1.0);
        set(q, root(p.ww), leader * with_sign_of(p.zx, x), leader * with_sign_of(p.yz, y), leader * z);
    }
}

/// Shepperd 1978: the largest of trace and diagonal picks the square root, the rest by division by it.
void shepperd(const double* m, double* q) noexcept {
    const Products p(m);
    const double sum = m[0] + m[4] + m[8];
    if (sum >= m[0] && sum >= m[4] && sum >= m[8]) {
        const double root = std::sqrt(p.ww);
        const double scale = 0.5 / root;
        set(q, 0.5 * root, scale * p.wx, scale * p.wy, scale * p.wz);
    } else if (m[0] >= m[4] && m[0] >= m[8]) {
        const double root = std::sqrt(p.xx);
        const double scale = 0.5 / root;
        set(q, scale * p.wx, 0.5 * root, scale * p.xy, scale * p.zx);
    } else if (m[4] >= m[8]) {
        const double root = std::sqrt(p.yy);
        const double scale = 0.5 / root;
        set(q, scale * p.wy, scale * p.xy, 0.5 * root, scale * p.yz);
    } else {
        const double root = std::sqrt(p.zz);
        const double scale = 0.5 / root;
        set(q, scale * p.wz, scale * p.zx, scale * p.yz, 0.5 * root);
    }
}

/// Markley 2008: the column of 4 q q' with the largest diagonal element, over its norm.
void markley(const double* m, double* q) noexcept {
    const Products p(m);
    const double sum = m[0] + m[4] + m[8];
    if (sum >= m[0] && sum >= m[4] && sum >= m[8]) {
        set(q, p.ww, p.wx, p.wy, p.wz);
    } else if (m[0] >= m[4] && m[0] >= m[8]) {
        set(q, p.wx, p.xx, p.xy, p.zx);
    } else if (m[4] >= m[8]) {
        set(q, p.wy, p.xy, p.yy, p.yz);
    } else {
        set(q, p.wz, p.zx, p.yz, p.zz);
    }
    const double norm = std::sqrt((q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]));
    set(q, q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm);
}

/// Cayley's factorisation, which the survey of Sarabandi and Thomas 2019 recommends: the norms of the four rows of
/// 4 q q', signs from the differences.
void cayley(const double* m, double* q) noexcept {
    const Products p(m);
    const auto quarter_norm = [](double a, double b, double c, double d) {
        return 0.25 * std::sqrt((a * a + b * b) + (c * c + d * d));
    };
    set(q, quarter_norm(p.ww, p.wx, p.wy, p.wz), with_sign_of(p.wx, quarter_norm(p.wx, p.xx, p.xy, p.zx)),
        with_sign_of(p.wy, quarter_norm(p.wy, p.xy, p.yy, p.yz)),
        with_sign_of(p.wz, quarter_norm(p.wz, p.zx, p.yz, p.zz)));
}

/// Sarabandi and Thomas 2018, with their threshold eta = 0: each component from the diagonal where that sum is large,
/// else from its row's other three entries; signs from the differences.
void sarabandi_thomas(const double* m, double* q) noexcept {
    const Products p(m);
    const auto component = [](double sum, double a, double b, double c) {
        constexpr double eta = 0.0;
        return 0.5 * std::sqrt(sum > eta ? 1.0 + sum : (a * a + b * b + c * c) / (3.0 - sum));
    };
    set(q, component(m[0] + m[4] + m[8], p.wx, p.wy, p.wz),
        with_sign_of(p.wx, component(m[0] - m[4] - m[8], p.wx, p.xy, p.zx)),
        with_sign_of(p.wy, component(m[4] - m[0] - m[8], p.wy, p.xy, p.yz)),
        with_sign_of(p.wz, component(m[8] - m[0] - m[4], p.wz, p.zx, p.yz)));
}

/// Bar-Itzhack 2000, version 3: the eigenvector of his K3 to its largest eigenvalue. The paper's factor 1/3 changes no
/// eigenvector.
void bar_itzhack(const double* m, double* q) noexcept {
    const Products p(m);
    Eigen::Matrix4d k;
    k << m[0] + m[4] + m[8], p.wx, p.wy, p.wz, //
        p.wx, m[0] - m[4] - m[8], p.xy, p.zx,  //
        p.wy, p.xy, m[4] - m[0] - m[8], p.yz,  //
        p.wz, p.zx, p.yz, m[8] - m[0] - m[4];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(k);
    const Eigen::Vector4d vector = solver.eigenvectors().col(3); // in increasing order of eigenvalues
    set(q, vector[0], vector[1], vector[2], vector[3]);
}

/// Markley 1988: the nearest rotation U diag(1, 1, det U det V) V' of M = U S V', then Shepperd 1978.
void svd(const double* m, double* q) noexcept {
    const Eigen::Matrix3d matrix = Eigen::Map<const RowMajor>(m);
    const Eigen::JacobiSVD<Eigen::Matrix3d> decomposition(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
    if (decomposition.info() != Eigen::Success) { // not finite: U and V were never written
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        set(q, nan, nan, nan, nan);
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
    // NOLINTBEGIN(*-avoid-c-arrays, *-array-to-pointer-decay)
    double own[9];
    double near[4];
    std::copy_n(m, 9, own);
    const Davenport<double> k(own);
    k.take_pivot_column(near);
    k.take_power_step(near);
    DoubleDouble exact[4] = {near[0], near[1], near[2], near[3]};
    // NOLINTEND(*-avoid-c-arrays, *-array-to-pointer-decay)
    Davenport<DoubleDouble>(own).take_power_step(exact);
    const Eigen::Vector4d p = Eigen::Vector4d(exact[0].hi, exact[1].hi, exact[2].hi, exact[3].hi).normalized();
    set(q, p[0], p[1], p[2], p[3]);
}

} // namespace rotconv::formula::dcm_to_quat
