#pragma once

#include <cmath>

#include <Eigen/Core>

#include <rotconv/euler.hpp>

// Published formulas, each for one row of numbers in the representations' own order: `m` row by row, active; `q` as
// w x y z; angles in radians. They add no guards of their own, so that a comparison shows what was published; those
// named `compensated` are nobody's: the same with products of twice the precision.

namespace rotconv::formula {

/// A matrix as nine numbers, row by row.
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

using Vector = Eigen::Map<Eigen::Vector3d>;

/// (m32 - m23, m13 - m31, m21 - m12) = 2 sin(theta) n.
inline Eigen::Vector3d differences(const double* m) noexcept { return {m[7] - m[5], m[2] - m[6], m[3] - m[1]}; }

/// 0, 1 or 2.
inline Eigen::Index largest_on_diagonal(const double* m) noexcept {
    Eigen::Index entry = 0;
    Eigen::Vector3d(m[0], m[4], m[8]).maxCoeff(&entry);
    return entry;
}

inline double length(const double* v) noexcept { return std::sqrt((v[0] * v[0] + v[1] * v[1]) + v[2] * v[2]); }

/// [v]_x, so that [v]_x u = v x u.
inline RowMajor cross_matrix(const double* v) noexcept {
    RowMajor cross;
    cross << 0.0, -v[2], v[1], v[2], 0.0, -v[0], -v[1], v[0], 0.0;
    return cross;
}

/// Euler angles in the order of rotations about moving axes.
struct MovingAngles {
    double first, middle, third;
};

// Types of functions: `Formula a, b;` declares two.
using Formula = void(const double* in, double* out) noexcept;
using EulerFormula = void(EulerSequence sequence, const double* in, double* out) noexcept;

namespace dcm_to_quat {
Formula trace, baruh, four_roots, klumpp, shepperd, markley, first_order, cayley, sarabandi_thomas, sarabandi_2020,
    adjugate, bar_itzhack, svd, polar, compensated;

/// 4 q q': the squares are Baruh's Eqs 5-8 (1999); the others are the entries of R - R' and R + R' off the diagonal.
Eigen::Matrix4d products(const double* m) noexcept;
} // namespace dcm_to_quat
namespace dcm_to_rotvec {
Formula acos, atan2, polynomial, nurlanov, gtsam, hertzberg, quaternion;
}
namespace dcm_to_euler {
EulerFormula asin, slabaugh, shoemake, shuster_markley, eigen;

/// Writes the angles in the order of the sequence, each in (-pi, pi]. Valid range: angles in (-3 pi, 3 pi].
void set(EulerSequence sequence, const MovingAngles& moving, double* angles) noexcept;
} // namespace dcm_to_euler
namespace dcm_to_cayley {
Formula lu, polynomial, quaternion;
}
namespace quat_to_dcm {
Formula unit, two_over_norm, homogeneous, normalise_first;
}
namespace quat_to_rotvec {
Formula acos, atan2, compensated;
}
namespace quat_to_euler {
EulerFormula bernardes_arccos, bernardes_atan2;
}
namespace rotvec_to_quat {
Formula half_angle, taylor, branchless;
}
namespace rotvec_to_dcm {
Formula rodrigues, half_angle, compensated;
}
namespace cayley_to_dcm {
Formula inverse, closed;
}
namespace two_column_to_dcm {
Formula gram_schmidt, symmetric;
}

} // namespace rotconv::formula
