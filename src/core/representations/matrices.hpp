#pragma once

#include <rotconv/reading.hpp>

#include "../numerics/approximate.hpp"
#include "../numerics/davenport.hpp"
#include "../numerics/power_of_two.hpp"
#include "../numerics/quaternion_algebra.hpp"

namespace rotconv {

/// The square of how far a matrix or two columns are from orthonormal, up to which the defect is not worked out.
inline constexpr double clean_square = 0x1p-58;
/// A bound on that defect.
inline constexpr double clean_defect = 0x1p-27;

/// The polar factor of a finite matrix of any size, both nine numbers row by row, and the matrix's defect. Errors:
/// not_proper, where the determinant as computed is not above 0; rank_deficient, where the two smaller singular values
/// are together below 1e-12 of the largest, so that nothing tells how far the matrix turns.
[[nodiscard]] Error polar_factor(const double* matrix, double* factor, double& defect) noexcept;

/// Largest singular value of M - (polar factor of M); see dcm::defect().
[[nodiscard]] double defect_of_matrix(const double* matrix) noexcept;
/// The same of two columns, one behind the other; see two_column::defect().
[[nodiscard]] double defect_of_columns(const double* columns) noexcept;

/// |s - 1| of s^2 - 1, both times a unit, without cancellation.
ROTCONV_INLINE double distance_from_one(double square_excess, double unit = 1.0) noexcept {
    return __builtin_fabs(square_excess) / (unit + root(larger_of(0.0, unit * unit + square_excess)));
}

inline namespace ROTCONV_TARGET {

/// The square of how far rows 1 and 2 are from orthonormal and row 3 from their cross product. With d its root, the
/// defect is below 3 d where that is small, and the determinant positive; nan where a number is not finite.
ROTCONV_INLINE double squared_distance(const double (&m)[9]) noexcept {
    const double cross_0 = (m[1] * m[5] - m[2] * m[4]) - m[6];
    const double cross_1 = (m[2] * m[3] - m[0] * m[5]) - m[7];
    const double cross_2 = (m[0] * m[4] - m[1] * m[3]) - m[8];
    const double first = ((m[0] * m[0] + m[1] * m[1]) + m[2] * m[2]) - 1.0;
    const double second = ((m[3] * m[3] + m[4] * m[4]) + m[5] * m[5]) - 1.0;
    const double both = (m[0] * m[3] + m[1] * m[4]) + m[2] * m[5];
    return ((cross_0 * cross_0 + cross_1 * cross_1) + cross_2 * cross_2) +
           ((first * first + second * second) + both * both);
}

/// A bound on the error of entries of the matrix of q: 2 (q_i q_j +- q_k q_l)/|q|^2 is off by 8 off, and by as much
/// from its divisor; what is rounded in them is 2^-96 of the products, which are below 1.
ROTCONV_INLINE ErrorBound error_of_entries(double off) noexcept { return {16.0 * off + 0x1p-95, 0x1p-96}; }
/// The same in Fixed, whose products are rounded at 2^-101 of 1, and |q|^2, at least 1/4, at 2^-98.
ROTCONV_INLINE double first_error_of_entries(double off) noexcept { return 16.0 * off + 0x1p-91; }

/// A bound on the error of unit_quaternion_of(). With c = 9 d, d the root of the squared distance, entries of K are off
/// by at most c from those of a rotation, as a matrix: so are its eigenvalues from 4, 0, 0, 0, and the pivot column, to
/// half of c, from its direction. What the power step leaves of that, and what the series for the length leaves out,
/// are products of two such numbers, of c^2 or, with what the column is rounded by, of 2^-96.
ROTCONV_INLINE double first_error_of_quaternion(double square) noexcept { return 256.0 * square + 0x1p-91; }

/// With q the quaternion of the pivot column over its length, and p = (K + I) q/4 - q, which is small, the next
/// power step is q + p, and unit q + p - ((|q|^2 - 1)/2 + q p) q.
ROTCONV_INLINE void unit_quaternion_of(const double (&m)[9], Fixed (&unit)[4]) noexcept {
    Fixed parts[9];
    for (std::size_t i = 0; i < 9; ++i) {
        const double high = fixed_part(m[i], 1.0);
        parts[i] = {high, m[i] - high};
    }
    const Davenport<Fixed> k(parts);
    Fixed column[4];
    k.take_pivot_column(column);
    double q[4] = {column[0].hi, column[1].hi, column[2].hi, column[3].hi};
    const double inverse = 1.0 / root(squared_norm(q));
    for (double& component : q) {
        component *= inverse;
    }
    const auto times_q = [&q](Fixed w, Fixed x, Fixed y, Fixed z) {
        return (w * q[0] + x * q[1]) + (y * q[2] + z * q[3]);
    };
    const Fixed next[4] = {times_q(k.ww, k.wx, k.wy, k.wz), times_q(k.wx, k.xx, k.xy, k.xz),
                           times_q(k.wy, k.xy, k.yy, k.yz), times_q(k.wz, k.xz, k.yz, k.zz)};
    const Fixed square = times_q(q[0], q[1], q[2], q[3]);
    double excess = 0.5 * ((square.hi - 1.0) + square.lo);
    double p[4];
    for (std::size_t i = 0; i < 4; ++i) {
        p[i] = 0.25 * ((next[i].hi - 4.0 * q[i]) + next[i].lo);
        excess = __builtin_fma(q[i], p[i], excess);
    }
    for (std::size_t i = 0; i < 4; ++i) {
        unit[i] = {q[i], __builtin_fma(-excess, q[i], p[i])};
    }
}

/// One power step, which serves if the squared distance that it returns is at most clean_square.
ROTCONV_INLINE double read_clean(const double (&m)[9], double (&q)[4]) noexcept {
    const Davenport<double> k(m);
    k.take_pivot_column(q);
    k.take_power_step(q);
    return squared_distance(m);
}

} // namespace ROTCONV_TARGET
} // namespace rotconv
