#include "formulas.hpp"

#include <cmath>

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

/// Shepperd 1978, then the logarithm of Sola 2017 of the quaternion with w >= 0.
void quaternion(const double* m, double* r) noexcept {
    double q[4];
    dcm_to_quat::shepperd(m, q);
    if (q[0] < 0.0) {
        Eigen::Map<Eigen::Vector4d>{q} *= -1.0;
    }
    quat_to_rotvec::atan2(q, r);
}

/// Davenport 1968 to the quaternion, then its logarithm, both with products after Dekker 1971.
void compensated(const double* m, double* r) noexcept {
    double q[4];
    dcm_to_quat::compensated(m, q);
    quat_to_rotvec::compensated(q, r);
}

} // namespace rotconv::formula::dcm_to_rotvec
