#pragma once

#include "davenport.hpp"
#include "wide.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// With the digits that nearly parallel vectors have.
template <class T> ROTCONV_INLINE void cross(const T (&a)[3], const T (&b)[3], T (&product)[3]) noexcept {
    product[0] = a[1] * b[2] - a[2] * b[1];
    product[1] = a[2] * b[0] - a[0] * b[2];
    product[2] = a[0] * b[1] - a[1] * b[0];
}

template <class T> ROTCONV_INLINE void normalize(T (&a)[3]) noexcept {
    const T inverse = T(1.0) / root(sloppy_sum(sloppy_sum(square(a[0]), square(a[1])), square(a[2])));
    for (T& component : a) {
        component = component * inverse;
    }
}

/// The quaternion of the attitude whose first column has the direction of `first` and whose second is in the half-plane
/// of `second`. Of parallel vectors its length is not between 1/2 and 1.
template <class T> ROTCONV_INLINE void gram_schmidt(const T (&first)[3], const T (&second)[3], T (&q)[4]) noexcept {
    T x[3] = {first[0], first[1], first[2]};
    T y[3];
    T z[3];
    cross(first, second, z);
    normalize(x);
    normalize(z);
    y[0] = sloppy_sum(z[1] * x[2], -(z[2] * x[1]));
    y[1] = sloppy_sum(z[2] * x[0], -(z[0] * x[2]));
    y[2] = sloppy_sum(z[0] * x[1], -(z[1] * x[0]));
    const T m[9] = {x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]};
    Davenport<T> k(m);
    // What is left of two entries below their own error is 0: a half-turn stays one. Wide knows its own errors.
    const auto clean = [&](T& sum, int i, int j) {
        if constexpr (std::is_same_v<T, Wide>) {
            return;
        }
        const double size = __builtin_fabs(to_double(m[i])) + __builtin_fabs(to_double(m[j]));
        sum = select(__builtin_fabs(to_double(sum)) <= 0x1p-100 * size, T(0.0), sum);
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
