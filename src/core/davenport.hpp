#pragma once

#include <Eigen/Core>

namespace rotconv {

/// Davenport's symmetric 4x4 matrix K of a 3x3 matrix M, plus the identity, in the order (w, x, y, z). The unit
/// quaternion q that maximises trace(R(q)' M) is its eigenvector to the largest eigenvalue, and R(q) the polar factor
/// of M where det M > 0. For a rotation K + I = 4 q q'.
[[nodiscard]] Eigen::Matrix4d davenport_matrix(const Eigen::Matrix3d& m) noexcept;

/// The column with the largest diagonal element: parallel to q for a rotation, near it for a matrix near one.
[[nodiscard]] Eigen::Vector4d pivot_column(const Eigen::Matrix4d& k) noexcept;

/// K q / 4: keeps the eigenvector, reduces all else by about the matrix's defect.
[[nodiscard]] Eigen::Vector4d power_step(const Eigen::Matrix4d& k, const Eigen::Vector4d& q) noexcept;

/// The same with the products exact, each component rounded once: for the last step, whose rounding remains.
[[nodiscard]] Eigen::Vector4d exact_power_step(const Eigen::Matrix4d& k, const Eigen::Vector4d& q) noexcept;

/// The quaternion of a matrix that is orthogonal to rounding.
[[nodiscard]] Eigen::Vector4d quaternion_of_rotation(const Eigen::Matrix3d& m) noexcept;

} // namespace rotconv
