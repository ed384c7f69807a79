#include "formulas.hpp"

#include <Eigen/Geometry>

namespace rotconv::formula::two_column_to_dcm {
namespace {

using Column = Eigen::Map<const Eigen::Vector3d>;

void set(const Eigen::Vector3d& first, const Eigen::Vector3d& second, double* m) noexcept {
    Eigen::Map<RowMajor>{m} << first, second, first.cross(second);
}

} // namespace

/// Zhou et al. 2019: the first column keeps its direction, the second loses its part along it.
void gram_schmidt(const double* columns, double* m) noexcept {
    const Column a(columns);
    const Column b(columns + 3);
    const Eigen::Vector3d first = a / a.norm();
    const Eigen::Vector3d across = b - first.dot(b) * first;
    set(first, across / across.norm(), m);
}

/// Symmetric orthogonalisation of Loewdin 1950, which gives up as little of one column as of the other: A (A'A)^(-1/2),
/// for two columns (b'b + s) a - (a'b) b and (a'a + s) b - (a'b) a, s = |a x b|, over their common length.
void symmetric(const double* columns, double* m) noexcept {
    const Column a(columns);
    const Column b(columns + 3);
    const double s = a.cross(b).norm();
    const double dot = a.dot(b);
    const double length = s * std::sqrt(a.squaredNorm() + b.squaredNorm() + 2.0 * s);
    set(((b.squaredNorm() + s) * a - dot * b) / length, ((a.squaredNorm() + s) * b - dot * a) / length, m);
}

} // namespace rotconv::formula::two_column_to_dcm
