#include "formulas.hpp"

#include <algorithm>
#include <numbers>

namespace rotconv::formula::dcm_to_rotvec {
namespace {

double cosine(const double* m) noexcept { return 0.5 * (m[0] + m[4] + m[8] - 1.0); }

} // namespace

/// Euler's axis and angle, common property (in Shuster's survey of 1993 among others): angle = acos((tr - 1)/2), axis =
/// differences/(2 sin angle).
void acos(const double* m, double* r) noexcept {
    const double angle = std::acos(cosine(m));
    Vector{r} = differences(m) / (2.0 * std::sin(angle)) * angle;
}

/// The same with angle = atan2(|d|/2, (tr - 1)/2), axis = d/|d| of the differences d.
void atan2(const double* m, double* r) noexcept {
    const Eigen::Vector3d d = differences(m);
    const double length = d.norm();
    Vector{r} = d / length * std::atan2(0.5 * length, cosine(m));
}

/// Stuelpnagel 1964, section 6, logarithm, its exchanged denominators put right:
/// S = -s(1 + 2 cos s)/(2 sin s) I + s(1 + cos s)/sin s X - s/(2 sin s) X^2, where X = R' and S = -[r]_x.
void polynomial(const double* m, double* r) noexcept {
    const RowMajor x = Eigen::Map<const RowMajor>(m).transpose();
    const double cos = cosine(m);
    const double angle = std::acos(cos);
    const double sin = std::sin(angle);
    const RowMajor s = -angle * (1.0 + 2.0 * cos) / (2.0 * sin) * RowMajor::Identity() + angle * (1.0 + cos) / sin * x -
                       angle / (2.0 * sin) * (x * x);
    r[0] = s(1, 2);
    r[1] = s(2, 0);
    r[2] = s(0, 1);
}

/// Nurlanov 2021, Eqs 8, 9b, 12 and 13: the axis from S = R + R' + (1 - tr) I = (3 - tr) n n', its lengths from the
/// diagonal, its signs from the row of the longest and from the differences.
void nurlanov(const double* m, double* r) noexcept {
    const double trace = m[0] + m[4] + m[8];
    const double angle = std::atan2(0.5 * std::sqrt(std::max(0.0, (3.0 - trace) * (1.0 + trace))), cosine(m));
    const Eigen::Vector3d d = differences(m);
    if (std::fabs(3.0 - trace) < 1e-8) {
        const double square = angle * angle;
        Vector{r} = 0.5 * (1.0 + square / 6.0 + 7.0 / 360.0 * (square * square)) * d;
        return;
    }
    const Eigen::Matrix3d s = dcm_to_quat::products(m).bottomRightCorner<3, 3>();
    Eigen::Vector3d axis = (s.diagonal().array() / (3.0 - trace)).max(0.0).sqrt();
    int longest = 0;
    axis.maxCoeff(&longest);
    axis = (s.col(longest).array() < 0.0).select(-axis, axis);
    Vector{r} = axis.dot(d) < 0.0 ? -angle * axis : angle * axis;
}

/// GTSAM 4.2, SO3::Logmap: by acos, and for tr < -0.999 by the column of 4 q q' with 2 + 2 r_ii in its diagonal place
/// and pi - 2 |w|/|q|. Both are right at pi alone, and were put right in 2026, see `hertzberg`.
void gtsam(const double* m, double* r) noexcept {
    const double trace = m[0] + m[4] + m[8];
    if (trace + 1.0 < 1e-3) {
        const Eigen::Index pivot = largest_on_diagonal(m);
        Eigen::Vector4d column = dcm_to_quat::products(m).col(pivot + 1);
        column[pivot + 1] = 2.0 + 2.0 * m[4 * pivot];
        const double angle = std::numbers::pi - 2.0 * std::fabs(column[0]) / column.norm();
        const double scale = 0.5 * angle / std::sqrt(column[pivot + 1]);
        Vector{r} = (column[0] < 0.0 ? -scale : scale) * column.tail<3>();
        return;
    }
    const double angle = std::acos(cosine(m));
    const double beyond = trace - 3.0;
    Vector{r} = (beyond < -1e-6 ? angle / (2.0 * std::sin(angle)) : 0.5 - beyond / 12.0 + beyond * beyond / 60.0) *
                differences(m);
}

/// GTSAM since August 2026, after Hertzberg et al. 2013: the column of 4 q q' of w where tr > 0, else of the largest on
/// the diagonal, not normalised, with w >= 0; then 2 atan2(|v|, w) v/|v|.
void hertzberg(const double* m, double* r) noexcept {
    const Eigen::Index column = m[0] + m[4] + m[8] > 0.0 ? 0 : 1 + largest_on_diagonal(m);
    Eigen::Vector4d q = dcm_to_quat::products(m).col(column);
    q *= q[0] < 0.0 ? -1.0 : 1.0;
    const double length = q.tail<3>().norm();
    Vector{r} = (length > 0.0 ? 2.0 * std::atan2(length, q[0]) / length : 2.0 / q[0]) * q.tail<3>();
}

/// Shepperd 1978, then the logarithm of Sola 2017 of the quaternion with w >= 0.
void quaternion(const double* m, double* r) noexcept {
    double q[4];
    dcm_to_quat::shepperd(m, q);
    Eigen::Map<Eigen::Vector4d>{q} *= q[0] < 0.0 ? -1.0 : 1.0;
    quat_to_rotvec::atan2(q, r);
}

} // namespace rotconv::formula::dcm_to_rotvec
