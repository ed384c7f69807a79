#pragma once

#include <cstddef>
#include <type_traits>

#include "double_double.hpp"

// Quaternions are w, x, y, z, matrices nine numbers row by row. T is double, DoubleDouble or Wide.

namespace rotconv {
inline namespace ROTCONV_TARGET {

template <class T> ROTCONV_INLINE T squared_norm(const T (&q)[4]) noexcept {
    return sloppy_sum(sloppy_sum(square(q[0]), square(q[1])), sloppy_sum(square(q[2]), square(q[3])));
}

/// x^2 + y^2 + z^2 to 2^-104.
template <class T> [[nodiscard]] ROTCONV_INLINE Precise<T> sum_of_squares(const T& x, const T& y, const T& z) noexcept {
    return sloppy_sum(sloppy_sum(precise_product(x, x), precise_product(y, y)), precise_product(z, z));
}

/// 1 or -1: the factor that gives a quaternion the sign that is printed, w > 0, or w = 0 and the first nonzero of x, y,
/// z positive.
template <class T> ROTCONV_INLINE double canonical_sign(const T (&q)[4]) noexcept {
    const double leader_of_two = sign_of(q[2]) != 0.0 ? sign_of(q[2]) : sign_of(q[3]);
    const double leader_of_three = sign_of(q[1]) != 0.0 ? sign_of(q[1]) : leader_of_two;
    return (sign_of(q[0]) != 0.0 ? sign_of(q[0]) : leader_of_three) < 0.0 ? -1.0 : 1.0;
}

/// a b, its length kept in [1/2, 2) by a power of two where those of a and b are: to 2^-100 of its length, or of
/// doubles with each component rounded once. Where a is the inverse of b the vector part is exactly 0.
template <class T> ROTCONV_INLINE void multiply(const T (&a)[4], const T (&b)[4], T (&product)[4]) noexcept {
    const auto sum = [](const Precise<T>& first, const Precise<T>& second) {
        if constexpr (std::is_same_v<T, double>) {
            return sloppy_sum(first, second);
        } else {
            return first + second;
        }
    };
    const auto two = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l, double sign) {
        return sum(precise_product(a[i], b[j]), precise_product(scaled(a[k], sign), b[l]));
    };
    const Precise<T> parts[4] = {
        sum(two(0, 0, 1, 1, -1.0), -two(2, 2, 3, 3, 1.0)), sum(two(0, 1, 1, 0, 1.0), two(2, 3, 3, 2, -1.0)),
        sum(two(0, 2, 2, 0, 1.0), two(3, 1, 1, 3, -1.0)), sum(two(0, 3, 3, 0, 1.0), two(1, 2, 2, 1, -1.0))};
    const double w = to_double(parts[0]);
    const double x = to_double(parts[1]);
    const double y = to_double(parts[2]);
    const double z = to_double(parts[3]);
    const double square = (w * w + x * x) + (y * y + z * z);
    const double factor = square < 0.25 ? 2.0 : (square >= 4.0 ? 0.5 : 1.0);
    for (std::size_t k = 0; k < 4; ++k) {
        product[k] = scaled(rounded_to<T>(parts[k]), factor);
    }
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

/// Each number over the divisor, by one division: for a DoubleDouble a division costs more than a product.
template <class T, std::size_t N> ROTCONV_INLINE void divide(T (&numbers)[N], const T& divisor) noexcept {
    const T inverse = T(1.0) / divisor;
    for (T& number : numbers) {
        number = number * inverse;
    }
}
template <std::size_t N> ROTCONV_INLINE void divide(double (&numbers)[N], double divisor) noexcept {
    for (double& number : numbers) {
        number /= divisor;
    }
}

/// The same of the entries of a rotation matrix, doubles too by one division: 1 and -1 are exact.
template <class T, std::size_t N> ROTCONV_INLINE void divide_entries(T (&numbers)[N], const T& divisor) noexcept {
    divide(numbers, divisor);
}
template <std::size_t N> ROTCONV_INLINE void divide_entries(double (&numbers)[N], double divisor) noexcept {
    const double inverse = 1.0 / divisor;
    for (double& number : numbers) {
        const double one = number == divisor ? 1.0 : -1.0;
        number = __builtin_fabs(number) == divisor ? one : number * inverse;
    }
}

} // namespace ROTCONV_TARGET
} // namespace rotconv
