#pragma once

#include <cstddef>
#include <type_traits>

#include "double_double.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// Davenport's symmetric 4x4 matrix K of a 3x3 matrix M (1968), plus the identity. The unit quaternion q that maximises
/// trace(R(q)' M) is its eigenvector to the largest eigenvalue, and R(q) the polar factor of M where det M > 0. For a
/// rotation K + I = 4 q q'. The entries of M, nine numbers row by row, are doubles or have as many digits as T.
template <class T> struct Davenport {
    template <class Entry> ROTCONV_INLINE explicit Davenport(const Entry (&m)[9]) noexcept {
        const auto total = [](const Entry& a, const Entry& b) -> T {
            if constexpr (std::is_same_v<Entry, T>) {
                return sloppy_sum(a, b);
            } else {
                return two_sum(a, b); // of doubles, exact
            }
        };
        const Entry one(1.0);
        const T first = total(one, m[0]);
        const T second = total(one, -m[0]);
        const T sum = total(m[4], m[8]);
        const T difference = total(m[4], -m[8]);
        ww = sloppy_sum(first, sum);
        xx = sloppy_sum(first, -sum);
        yy = sloppy_sum(second, difference);
        zz = sloppy_sum(second, -difference);
        wx = total(m[7], -m[5]);
        wy = total(m[2], -m[6]);
        wz = total(m[3], -m[1]);
        xy = total(m[1], m[3]);
        xz = total(m[2], m[6]);
        yz = total(m[5], m[7]);
    }

    /// A quarter of the column with the largest diagonal element: parallel to q for a rotation, near it for a matrix
    /// near one. Its length is then between 1/2 and 1.
    ROTCONV_INLINE void take_pivot_column(T (&q)[4]) const noexcept {
        const bool w_first = to_double(ww) >= to_double(xx);
        const bool y_first = to_double(yy) >= to_double(zz);
        const bool wx_first = to_double(select(w_first, ww, xx)) >= to_double(select(y_first, yy, zz));
        q[0] = scaled(select(wx_first, select(w_first, ww, wx), select(y_first, wy, wz)), 0.25);
        q[1] = scaled(select(wx_first, select(w_first, wx, xx), select(y_first, xy, xz)), 0.25);
        q[2] = scaled(select(wx_first, select(w_first, wy, xy), select(y_first, yy, yz)), 0.25);
        q[3] = scaled(select(wx_first, select(w_first, wz, xz), select(y_first, yz, zz)), 0.25);
    }

    /// (K + I) q / 4: keeps the eigenvector, reduces all else by about the defect of M.
    ROTCONV_INLINE void take_power_step(T (&q)[4]) const noexcept {
        const T next[4] = {scaled((ww * q[0] + wx * q[1]) + (wy * q[2] + wz * q[3]), 0.25),
                           scaled((wx * q[0] + xx * q[1]) + (xy * q[2] + xz * q[3]), 0.25),
                           scaled((wy * q[0] + xy * q[1]) + (yy * q[2] + yz * q[3]), 0.25),
                           scaled((wz * q[0] + xz * q[1]) + (yz * q[2] + zz * q[3]), 0.25)};
        for (int k = 0; k < 4; ++k) {
            q[k] = next[k];
        }
    }

    /// Both in one, for a single row of doubles: the pivot is found by places, for branches would be mispredicted.
    ROTCONV_INLINE void take_first_power_step(double (&q)[4]) const noexcept {
        const double columns[4][4] = {{ww, wx, wy, wz}, {wx, xx, xy, xz}, {wy, xy, yy, yz}, {wz, xz, yz, zz}};
        const auto w_or_x = static_cast<std::size_t>(ww < xx);
        const std::size_t y_or_z = 2 + static_cast<std::size_t>(yy < zz);
        const bool later = columns[w_or_x][w_or_x] < columns[y_or_z][y_or_z];
        const auto& pivot = columns[w_or_x + (y_or_z - w_or_x) * static_cast<std::size_t>(later)];
        for (std::size_t i = 0; i < 4; ++i) {
            q[i] = 0.25 * ((columns[0][i] * (0.25 * pivot[0]) + columns[1][i] * (0.25 * pivot[1])) +
                           (columns[2][i] * (0.25 * pivot[2]) + columns[3][i] * (0.25 * pivot[3])));
        }
    }

    /// Whether nothing couples q's component i to the others.
    [[nodiscard]] ROTCONV_INLINE bool stands_alone(unsigned i) const noexcept {
        const auto are_zero = [](const T& a, const T& b, const T& c) {
            return sign_of(a) == 0.0 && sign_of(b) == 0.0 && sign_of(c) == 0.0;
        };
        return i == 0   ? are_zero(wx, wy, wz)
               : i == 1 ? are_zero(wx, xy, xz)
               : i == 2 ? are_zero(wy, xy, yz)
                        : are_zero(wz, xz, yz);
    }

    T ww, xx, yy, zz, wx, wy, wz, xy, xz, yz;
};

} // namespace ROTCONV_TARGET
} // namespace rotconv
