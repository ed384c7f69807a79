#pragma once

#include <cstddef>
#include <type_traits>

#include "../numerics/wide.hpp"
#include "../representations/rotation_batch.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// Divides all numbers by one: a division costs a Real more than a product, and a double nothing.
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

/// The same of the entries of a rotation matrix, by one division: 1 and -1 are met exactly.
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

inline bool is_ordinary_row(const BasicRotations<Real>& q, std::size_t row) noexcept {
    return is_ordinary(q.w.hi[row]) && is_ordinary(q.x.hi[row]) && is_ordinary(q.y.hi[row]) && is_ordinary(q.z.hi[row]);
}

/// Writes rows by a formula over a scalar: Formula::apply(const S (&q)[4], S (&numbers)[Formula::size]), where S is T,
/// or Wide for rows of which that would lose digits.
template <class Formula, class T>
void write_rows(const BasicRotations<T>& q, std::size_t rows, double* numbers) noexcept {
    constexpr std::size_t size = Formula::size;
    double columns[size][batch_rows];
    for (std::size_t i = 0; i < rows; ++i) {
        T own[4];
        T result[size];
        q.get(i, own);
        Formula::apply(own, result);
        for (std::size_t k = 0; k < size; ++k) {
            columns[k][i] = nearly(result[k]);
        }
    }
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t k = 0; k < size; ++k) {
            numbers[size * i + k] = columns[k][i];
        }
    }
    if constexpr (std::is_same_v<T, Real>) {
        for (std::size_t i = 0; i < rows; ++i) {
            if (!is_ordinary_row(q, i)) [[unlikely]] {
                const Wide own[4] = {q.w[i], q.x[i], q.y[i], q.z[i]};
                Wide result[size];
                Formula::apply(own, result);
                for (std::size_t k = 0; k < size; ++k) {
                    numbers[size * i + k] = result[k].rounded();
                }
            }
        }
    }
}

/// 1 or -1: what gives a quaternion the sign that is printed; see Rotation::sign.
ROTCONV_INLINE double printed_sign(double w, double x, double y, double z) noexcept {
    const double leader_of_two = y != 0.0 ? y : z;
    const double leader_of_three = x != 0.0 ? x : leader_of_two;
    return (w != 0.0 ? w : leader_of_three) < 0.0 ? -1.0 : 1.0;
}

} // namespace ROTCONV_TARGET
} // namespace rotconv
