#pragma once

#include <array>

#include <Eigen/Core>

#include "products.hpp"

namespace rotconv {

/// A matrix as nine numbers, row by row.
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// The sum of the squares of what a matrix lacks of being orthonormal, up to which it counts as clean: one power step
/// serves. And a bound on its defect.
inline constexpr double clean_square = 0x1p-58;
inline constexpr double clean_defect = 0x1p-27;

/// Davenport's symmetric 4x4 matrix K of a 3x3 matrix M, plus the identity. The unit quaternion q that maximises
/// trace(R(q)' M) is its eigenvector to the largest eigenvalue, and R(q) the polar factor of M where det M > 0. For a
/// rotation K + I = 4 q q'.
class Davenport {
public:
    using Four = std::array<double, 4>; ///< w, x, y, z

    /// @param m nine numbers, row by row
    explicit Davenport(const double* m) noexcept
        : ww((1.0 + m[0]) + (m[4] + m[8])), xx((1.0 + m[0]) - (m[4] + m[8])), yy((1.0 - m[0]) + (m[4] - m[8])),
          zz((1.0 - m[0]) - (m[4] - m[8])), wx(m[7] - m[5]), wy(m[2] - m[6]), wz(m[3] - m[1]), xy(m[1] + m[3]),
          xz(m[2] + m[6]), yz(m[5] + m[7]) {}

    /// A quarter of the column with the largest diagonal element: parallel to q for a rotation, near it for a matrix
    /// near one. Its length is then between 1/2 and 1.
    [[nodiscard]] Four pivot_column() const noexcept {
        const bool w_first = ww >= xx;
        const bool y_first = yy >= zz;
        const double wx_pivot = w_first ? ww : xx;
        const double yz_pivot = y_first ? yy : zz;
        const bool wx_first = wx_pivot >= yz_pivot;
        return {0.25 * (wx_first ? (w_first ? ww : wx) : (y_first ? wy : wz)),
                0.25 * (wx_first ? (w_first ? wx : xx) : (y_first ? xy : xz)),
                0.25 * (wx_first ? (w_first ? wy : xy) : (y_first ? yy : yz)),
                0.25 * (wx_first ? (w_first ? wz : xz) : (y_first ? yz : zz))};
    }

    /// (K + I) q / 4: keeps the eigenvector, reduces all else by about the matrix's defect.
    [[nodiscard]] Four power_step(const Four& q) const noexcept {
        return {0.25 * ((ww * q[0] + wx * q[1]) + (wy * q[2] + wz * q[3])),
                0.25 * ((wx * q[0] + xx * q[1]) + (xy * q[2] + xz * q[3])),
                0.25 * ((wy * q[0] + xy * q[1]) + (yy * q[2] + yz * q[3])),
                0.25 * ((wz * q[0] + xz * q[1]) + (yz * q[2] + zz * q[3]))};
    }

    /// The same with exact products, each component rounded once: for the last step, whose rounding remains.
    [[nodiscard]] Four exact_power_step(const Four& q) const noexcept {
        const auto row = [&](double kw, double kx, double ky, double kz) {
            return 0.25 * sum_of_products(kw, q[0], kx, q[1], ky, q[2], kz, q[3]);
        };
        return {row(ww, wx, wy, wz), row(wx, xx, xy, xz), row(wy, xy, yy, yz), row(wz, xz, yz, zz)};
    }

private:
    double ww, xx, yy, zz, wx, wy, wz, xy, xz, yz; // of K + I
};

/// The quaternion of nine numbers, row by row, that are a rotation to rounding: the polar factor to a few tenths of an
/// eps.
inline Davenport::Four quaternion_of_rotation(const double* m) noexcept {
    const Davenport k(m);
    return k.exact_power_step(k.pivot_column());
}

} // namespace rotconv
