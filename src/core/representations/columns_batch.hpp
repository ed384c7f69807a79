#pragma once

#include <cstddef>

#include "kernel.hpp"
#include "matrices.hpp"

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

/// Kernels that read two columns, by Gram-Schmidt, of a class Formula with
///     directions(const T (&numbers)[size], T (&first)[3], T (&second)[3])   vectors along the columns
///     columns(const double (&numbers)[size], double (&columns)[6])          the columns themselves
///     lost_by_directions(const double (&numbers)[size])   how many times 2^-102 the first is off, of itself
template <class Formula, std::size_t size> struct ReadByColumns {
    template <class T> ROTCONV_INLINE static void quaternion_of(const double* numbers, T (&q)[4]) noexcept {
        T first[3];
        T second[3];
        find_directions(numbers, first, second);
        gram_schmidt(first, second, q);
    }
    template <class T>
    ROTCONV_INLINE static void find_directions(const double* numbers, T (&first)[3], T (&second)[3]) noexcept {
        T own[size];
        load(numbers, own);
        Formula::directions(own, first, second);
    }

    /// Whether the columns, of finite numbers, span no plane.
    static bool is_deficient(const double* numbers) noexcept {
        bool is_deficient = false;
        with_enough_bits([&] {
            Careful first[3];
            Careful second[3];
            Careful normal[3];
            find_directions(numbers, first, second);
            cross(first, second, normal);
            is_deficient = normal[0].sign() == 0 && normal[1].sign() == 0 && normal[2].sign() == 0;
            return !is_deficient || !Wide::Bits::doubted();
        });
        return is_deficient;
    }

    /// See AttitudeBatch::off. Directions are off by 2^-102 of their terms. Of the normal, the cross product, that is
    /// as much more as its length, the sine of the angle between them, is less.
    static double off_of(const double (&numbers)[size]) noexcept {
        double first[3];
        double second[3];
        double normal[3];
        find_directions(numbers, first, second);
        const double lost = Formula::lost_by_directions(numbers);
        normalize(first);
        normalize(second);
        cross(first, second, normal);
        const double sine = root((normal[0] * normal[0] + normal[1] * normal[1]) + normal[2] * normal[2]);
        const double off = 0x1p-97 * lost / sine;
        return sine > 0x1p-30 && lost < 0x1p30 ? off : 1.0; // also where they are too large for doubles
    }

    /// The sum of the squares of what the columns lack of being orthonormal.
    ROTCONV_INLINE static double lacking(const double (&numbers)[size]) noexcept {
        double m[6];
        Formula::columns(numbers, m);
        const double a = ((m[0] * m[0] + m[1] * m[1]) + m[2] * m[2]) - 1.0;
        const double b = ((m[3] * m[3] + m[4] * m[4]) + m[5] * m[5]) - 1.0;
        const double c = (m[0] * m[3] + m[1] * m[4]) + m[2] * m[5];
        return (a * a + b * b) + c * c;
    }
    /// A row that is not clean: nearly parallel columns lose digits in double.
    static Error read_unclean(const double (&numbers)[size], DoubleDouble (&q)[4], double& defect) noexcept {
        if (!all_finite(numbers, size)) {
            return Error::not_finite;
        }
        quaternion_of(numbers, q);
        const double square = squared_norm(q).hi;
        if (!(square >= 0.2 && square <= 2.0) && is_deficient(numbers)) {
            return Error::rank_deficient;
        }
        double m[6];
        Formula::columns(numbers, m);
        defect = defect_of_columns(m);
        return Error::none;
    }

    template <class T> static void read(const Spec& /*spec*/, const double* numbers, std::size_t rows,
                                        AttitudeBatch<T>& attitudes) noexcept {
        Columns<double, size> columns;
        to_columns(numbers, rows, columns);
        double square[batch_rows];
        for (std::size_t i = 0; i < rows; ++i) {
            double own[size];
            T q[4];
            columns.get(i, own);
            quaternion_of(own, q);
            attitudes.set(i, q);
            attitudes.defect[i] = clean_defect;
            attitudes.off[i] = 0x1p-95;
            square[i] = lacking(own);
        }
        for (std::size_t i = 0; i < rows; ++i) {
            attitudes.error[i] = Error::none;
            if (!(square[i] <= clean_square)) {
                double own[size];
                DoubleDouble q[4];
                columns.get(i, own);
                attitudes.error[i] = read_unclean(own, q, attitudes.defect[i]);
                attitudes.off[i] = off_of(own);
                attitudes.set(i, {rounded_to<T>(q[0]), rounded_to<T>(q[1]), rounded_to<T>(q[2]), rounded_to<T>(q[3])});
            }
        }
    }
    static Error read_one(const Spec& /*spec*/, const double* numbers, double (&q)[4], double& defect) noexcept {
        double own[size];
        load(numbers, own);
        if (lacking(own) <= clean_square) {
            quaternion_of(own, q);
            defect = clean_defect;
            return Error::none;
        }
        DoubleDouble exact[4];
        const Error error = read_unclean(own, exact, defect);
        load(exact, q);
        return error;
    }
    static void read_carefully(const Spec& /*spec*/, const double* numbers, Careful (&q)[4]) noexcept {
        quaternion_of(numbers, q);
    }
};

} // namespace ROTCONV_TARGET
} // namespace rotconv
