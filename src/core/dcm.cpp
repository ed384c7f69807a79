#include <rotconv/dcm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include "davenport.hpp"
#include "double_double.hpp"
#include "scaling.hpp"

namespace rotconv::dcm {
namespace {

/// A defect up to which power steps alone are the quickest: each gains a factor of at least 20.
constexpr double near_rotation = 0.05;

/// M'M - I.
Eigen::Matrix3d gram_excess(const Dcm& m) noexcept { return m.transpose() * m - Eigen::Matrix3d::Identity(); }

/// An upper bound on the defect: |s - 1| = |s^2 - 1|/(1 + s) for each singular value s, and rounding.
double defect_bound(const Dcm& m) noexcept {
    const double excess = gram_excess(m).norm();
    return 0.5 * excess * (1.0 + excess) + 8 * std::numeric_limits<double>::epsilon();
}

Rotation rotation_of(const Eigen::Vector4d& q) noexcept { return Rotation::from_components(q[0], q[1], q[2], q[3]); }

/// A sum of up to 24 numbers that is kept exactly, as parts that do not overlap (Shewchuk 1997, Grow-Expansion).
class ExactSum {
public:
    void add(double number) noexcept {
        for (std::size_t i = 0; i < count_; ++i) {
            const DoubleDouble both = exact_sum(number, parts_[i]);
            parts_[i] = both.lo;
            number = both.hi;
        }
        parts_[count_++] = number;
    }

    /// The sign of the largest part that is not 0, which is that of the sum.
    [[nodiscard]] int sign() const noexcept {
        for (std::size_t i = count_; i > 0; --i) {
            if (parts_[i - 1] != 0.0) {
                return parts_[i - 1] > 0.0 ? 1 : -1;
            }
        }
        return 0;
    }

private:
    std::array<double, 24> parts_{};
    std::size_t count_ = 0;
};

/// The sign of the determinant, exact but for parts below 2^-960 of the largest product: rows and columns are first
/// scaled by powers of two.
int sign_of_determinant(Dcm m) noexcept {
    for (int side = 0; side < 2; ++side) {
        for (Eigen::Index i = 0; i < 3; ++i) {
            const double largest = m.row(i).cwiseAbs().maxCoeff();
            if (largest == 0.0) {
                return 0;
            }
            m.row(i) = m.row(i).unaryExpr(PowerOfTwo::to_unit(largest)).eval();
        }
        m.transposeInPlace();
    }
    ExactSum sum;
    for (int first = 0; first < 3; ++first) {
        for (const int step : {1, 2}) {
            const int second = (first + step) % 3;
            const int third = (first + 3 - step) % 3;
            const double sign = step == 1 ? 1.0 : -1.0;
            const DoubleDouble two = exact_product(m(0, first), m(1, second));
            for (const double part : {two.hi, two.lo}) {
                const DoubleDouble three = exact_product(part, sign * m(2, third));
                sum.add(three.lo);
                sum.add(three.hi);
            }
        }
    }
    return sum.sign();
}

/// Any proper matrix: the singular value decomposition M = U S V' gives the polar factor U V'. One Newton step
/// on trace(R(q)' M) against M itself then removes the rounding of the decomposition.
Reading far_from_rotation(const Dcm& matrix) noexcept {
    if (sign_of_determinant(matrix) <= 0) {
        return Reading::failed(Fault::not_proper);
    }
    const auto scale = PowerOfTwo::to_unit(matrix.cwiseAbs().maxCoeff());
    const Dcm m = matrix.unaryExpr(scale);
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Dcm factor = svd.matrixU() * svd.matrixV().transpose();
    if (factor.determinant() < 0.0) {
        // det M > 0 is known exactly: rounding has turned the sign of the smallest singular value
        factor -= 2.0 * svd.matrixU().col(2) * svd.matrixV().col(2).transpose();
    }
    const Eigen::Vector4d q = quaternion_of_rotation(factor);

    // With S = R(q)' M, the remaining small rotation d satisfies (tr(S) I - S) d = (S32 - S23, S13 - S31, S21 - S12).
    const Eigen::Matrix3d s = from_rotation(rotation_of(q)).transpose() * m;
    const Eigen::Matrix3d symmetric = 0.5 * (s + s.transpose());
    const Eigen::Vector3d skew{s(2, 1) - s(1, 2), s(0, 2) - s(2, 0), s(1, 0) - s(0, 1)};
    const Eigen::Matrix3d hessian = symmetric.trace() * Eigen::Matrix3d::Identity() - symmetric;
    Eigen::Vector3d half = 0.5 * hessian.fullPivLu().solve(skew);
    if (!(half.norm() < 1e-8)) {
        half.setZero(); // the matrix is nearly singular, and this its noise
    }
    const Eigen::Vector3d v = q.tail<3>();
    Eigen::Vector4d corrected;
    corrected << q[0] - v.dot(half), v + q[0] * half + v.cross(half);

    Reading reading;
    reading.rotation = rotation_of(corrected);
    const Eigen::Vector3d& singular = svd.singularValues();
    reading.defect = std::max(std::fabs(scale.undone(singular[0]) - 1.0), std::fabs(scale.undone(singular[2]) - 1.0));
    return reading;
}

} // namespace

Reading to_rotation(const Dcm& matrix) noexcept {
    if (!matrix.allFinite()) {
        return Reading::failed(Fault::not_finite);
    }
    const double bound = defect_bound(matrix);
    if (!(bound <= near_rotation) || matrix.determinant() <= 0.0) {
        return far_from_rotation(matrix);
    }
    const Eigen::Matrix4d k = davenport_matrix(matrix);
    Eigen::Vector4d q = pivot_column(k);
    double remaining = bound;
    while (remaining * bound > 0x1p-58) {
        q = power_step(k, q);
        remaining *= bound;
    }
    q = exact_power_step(k, q);

    Reading reading;
    reading.rotation = rotation_of(q);
    reading.defect = bound <= reported_defect ? bound : defect(matrix);
    return reading;
}

double defect(const Dcm& matrix) noexcept {
    const Eigen::Matrix3d excess = gram_excess(matrix);
    if (!(0.5 * excess.norm() <= near_rotation)) {
        return far_from_rotation(matrix).defect;
    }
    // s^2 - 1 for the singular values s, without cancellation
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(excess, Eigen::EigenvaluesOnly);
    const auto from_one = [](double square_excess) {
        return std::fabs(square_excess) / (1.0 + std::sqrt(1.0 + square_excess));
    };
    return std::max(from_one(solver.eigenvalues()[0]), from_one(solver.eigenvalues()[2]));
}

Dcm from_rotation(const Rotation& rotation) noexcept {
    const double w = rotation.w();
    const double x = rotation.x();
    const double y = rotation.y();
    const double z = rotation.z();
    const double ww = w * w;
    const double xx = x * x;
    const double yy = y * y;
    const double zz = z * z;
    const double squared_norm = (ww + xx) + (yy + zz);
    Dcm m;
    m << (ww - yy) + (xx - zz), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y), //
        2.0 * (x * y + w * z), (ww - xx) + (yy - zz), 2.0 * (y * z - w * x),  //
        2.0 * (x * z - w * y), 2.0 * (y * z + w * x), (ww - xx) + (zz - yy);
    return m / squared_norm;
}

Figures figures(const Rotation& /*rotation*/) noexcept { return {.condition = std::numbers::sqrt2}; }

} // namespace rotconv::dcm
