#pragma once

#include "../numerics/real.hpp"
#include "../numerics/wide.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

// Matrices are nine numbers, row by row.

template <class T> ROTCONV_INLINE T squared_norm(const T (&q)[4]) noexcept {
    return quick_sum(quick_sum(square(q[0]), square(q[1])), quick_sum(square(q[2]), square(q[3])));
}

/// The matrix of q/|q|, times |q|^2.
template <class T> ROTCONV_INLINE void scaled_matrix_of(const T (&q)[4], T (&m)[9]) noexcept {
    const T ww = square(q[0]);
    const T xx = square(q[1]);
    const T yy = square(q[2]);
    const T zz = square(q[3]);
    const T xy = q[1] * q[2];
    const T xz = q[1] * q[3];
    const T yz = q[2] * q[3];
    const T wx = q[0] * q[1];
    const T wy = q[0] * q[2];
    const T wz = q[0] * q[3];
    m[0] = (ww - yy) + (xx - zz);
    m[1] = scaled(xy - wz, 2.0);
    m[2] = scaled(xz + wy, 2.0);
    m[3] = scaled(xy + wz, 2.0);
    m[4] = (ww - xx) + (yy - zz);
    m[5] = scaled(yz - wx, 2.0);
    m[6] = scaled(xz - wy, 2.0);
    m[7] = scaled(yz + wx, 2.0);
    m[8] = (ww - xx) + (zz - yy);
}

/// a + b to 2^-104 of the larger; of doubles without a rounding.
ROTCONV_INLINE Real total(double a, double b) noexcept { return exact_sum(a, b); }
template <class T> ROTCONV_INLINE T total(const T& a, const T& b) noexcept { return quick_sum(a, b); }

/// Davenport's K of a matrix, plus the identity; see numerics/davenport.hpp.
template <class T> struct Davenport {
    template <class Entry> ROTCONV_INLINE explicit Davenport(const Entry (&m)[9]) noexcept {
        const Entry one(1.0);
        const T first = total(one, m[0]);
        const T second = total(one, Entry(-m[0]));
        const T sum = total(m[4], m[8]);
        const T difference = total(m[4], Entry(-m[8]));
        ww = quick_sum(first, sum);
        xx = quick_sum(first, -sum);
        yy = quick_sum(second, difference);
        zz = quick_sum(second, -difference);
        wx = total(m[7], Entry(-m[5]));
        wy = total(m[2], Entry(-m[6]));
        wz = total(m[3], Entry(-m[1]));
        xy = total(m[1], m[3]);
        xz = total(m[2], m[6]);
        yz = total(m[5], m[7]);
    }

    /// A quarter of the column with the largest diagonal element: the quaternion of a rotation, of length 1/2 to 1.
    ROTCONV_INLINE void take_pivot_column(T (&q)[4]) const noexcept {
        const bool w_first = nearly(ww) >= nearly(xx);
        const bool y_first = nearly(yy) >= nearly(zz);
        const bool wx_first = nearly(choose(w_first, ww, xx)) >= nearly(choose(y_first, yy, zz));
        q[0] = scaled(choose(wx_first, choose(w_first, ww, wx), choose(y_first, wy, wz)), 0.25);
        q[1] = scaled(choose(wx_first, choose(w_first, wx, xx), choose(y_first, xy, xz)), 0.25);
        q[2] = scaled(choose(wx_first, choose(w_first, wy, xy), choose(y_first, yy, yz)), 0.25);
        q[3] = scaled(choose(wx_first, choose(w_first, wz, xz), choose(y_first, yz, zz)), 0.25);
    }

    T ww, xx, yy, zz, wx, wy, wz, xy, xz, yz;
};

/// To 2^-104 of the larger product.
template <class T> ROTCONV_INLINE void quick_cross(const T (&a)[3], const T (&b)[3], T (&product)[3]) noexcept {
    product[0] = quick_sum(a[1] * b[2], -(a[2] * b[1]));
    product[1] = quick_sum(a[2] * b[0], -(a[0] * b[2]));
    product[2] = quick_sum(a[0] * b[1], -(a[1] * b[0]));
}

/// With the digits that nearly parallel vectors have.
template <class T> ROTCONV_INLINE void cross(const T (&a)[3], const T (&b)[3], T (&product)[3]) noexcept {
    product[0] = a[1] * b[2] - a[2] * b[1];
    product[1] = a[2] * b[0] - a[0] * b[2];
    product[2] = a[0] * b[1] - a[1] * b[0];
}

template <class T> ROTCONV_INLINE void normalize(T (&a)[3]) noexcept {
    const T inverse = T(1.0) / root(quick_sum(quick_sum(square(a[0]), square(a[1])), square(a[2])));
    for (T& component : a) {
        component = component * inverse;
    }
}

/// The attitude whose first column has the direction of `first` and whose second is in the half-plane of `second`.
template <class T> ROTCONV_INLINE void gram_schmidt(const T (&first)[3], const T (&second)[3], T (&q)[4]) noexcept {
    T x[3] = {first[0], first[1], first[2]};
    T y[3];
    T z[3];
    cross(first, second, z);
    normalize(x);
    normalize(z);
    quick_cross(z, x, y);
    const T m[9] = {x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]};
    Davenport<T> k(m);
    // What is left of two entries below their own error is 0: a half-turn stays one.
    const auto clean = [&](T& sum, int i, int j) {
        const double size = __builtin_fabs(nearly(m[i])) + __builtin_fabs(nearly(m[j]));
        sum = choose(__builtin_fabs(nearly(sum)) <= 0x1p-100 * size, T(0.0), sum);
    };
    clean(k.wx, 7, 5);
    clean(k.wy, 2, 6);
    clean(k.wz, 3, 1);
    clean(k.xy, 1, 3);
    clean(k.xz, 2, 6);
    clean(k.yz, 5, 7);
    k.take_pivot_column(q);
}

} // namespace ROTCONV_TARGET
} // namespace rotconv
