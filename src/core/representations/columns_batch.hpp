#pragma once

#include <cstddef>

#include "../numerics/gram_schmidt.hpp"
#include "../numerics/power_of_two.hpp"
#include "../numerics/quaternion_algebra.hpp"
#include "kernel.hpp"
#include "matrices.hpp"
#include "write_rows.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// The sum of the squares of what columns lack of being orthonormal, up to which their defect is not worked out.
inline constexpr double clean_square = 0x1p-58;
/// A bound on that defect.
inline constexpr double clean_defect = 0x1p-27;

/// Kernels that read two columns, by Gram-Schmidt. Formula::directions(const T (&numbers)[Formula::size], T
/// (&first)[3], T (&second)[3]) finds vectors along them, Formula::columns(const double* numbers, double (&columns)[6])
/// the columns themselves.
template <class Formula> struct ColumnsKernel {
    static constexpr std::size_t size = Formula::size;

    template <class T> ROTCONV_INLINE static void quaternion_of(const T (&numbers)[size], T (&q)[4]) noexcept {
        T first[3];
        T second[3];
        Formula::directions(numbers, first, second);
        gram_schmidt(first, second, q);
    }
    template <class T> ROTCONV_INLINE static void quaternion_of(const double* numbers, T (&q)[4]) noexcept {
        T own[size];
        for (std::size_t k = 0; k < size; ++k) {
            own[k] = numbers[k];
        }
        quaternion_of(own, q);
    }

    /// Of finite numbers: whether the columns span no plane.
    static bool is_deficient(const double* numbers) noexcept {
        ScaledDoubleDouble own[size];
        for (std::size_t k = 0; k < size; ++k) {
            own[k] = numbers[k];
        }
        ScaledDoubleDouble first[3];
        ScaledDoubleDouble second[3];
        ScaledDoubleDouble normal[3];
        Formula::directions(own, first, second);
        cross(first, second, normal);
        return normal[0].is_zero() && normal[1].is_zero() && normal[2].is_zero();
    }

    /// See clean_square.
    ROTCONV_INLINE static double lacking(const double (&numbers)[size]) noexcept {
        double m[6];
        Formula::columns(numbers, m);
        const double a = ((m[0] * m[0] + m[1] * m[1]) + m[2] * m[2]) - 1.0;
        const double b = ((m[3] * m[3] + m[4] * m[4]) + m[5] * m[5]) - 1.0;
        const double c = (m[0] * m[3] + m[1] * m[4]) + m[2] * m[5];
        return (a * a + b * b) + c * c;
    }
    /// The error and the defect of a row that is not.
    static Error check(const double* numbers, const DoubleDouble (&q)[4], double& defect) noexcept {
        if (!all_finite(numbers, size)) {
            return Error::not_finite;
        }
        const double length = squared_norm(q).hi;
        if (!(length >= 0.2 && length <= 2.0) && is_deficient(numbers)) {
            return Error::rank_deficient;
        }
        double m[6];
        double own[size];
        for (std::size_t k = 0; k < size; ++k) {
            own[k] = numbers[k];
        }
        Formula::columns(own, m);
        defect = defect_of_columns(m);
        return Error::none;
    }

    template <class T> static void read(const Spec& /*spec*/, const double* numbers, std::size_t rows,
                                        AttitudeBatch<T>& attitudes) noexcept {
        double columns[size][batch_rows];
        to_columns(numbers, rows, columns);
        double square[batch_rows];
        for (std::size_t i = 0; i < rows; ++i) {
            double own[size];
            T exact[size];
            T q[4];
            for (std::size_t k = 0; k < size; ++k) {
                own[k] = columns[k][i];
                exact[k] = own[k];
            }
            quaternion_of(exact, q);
            attitudes.set(i, q);
            attitudes.defect[i] = clean_defect;
            square[i] = lacking(own);
        }
        for (std::size_t i = 0; i < rows; ++i) {
            attitudes.error[i] = Error::none;
            if (!(square[i] <= clean_square)) {
                DoubleDouble q[4]; // nearly parallel columns lose digits in double
                quaternion_of(numbers + size * i, q);
                attitudes.error[i] = check(numbers + size * i, q, attitudes.defect[i]);
                attitudes.set(i, rounded_to<T>(q[0]), rounded_to<T>(q[1]), rounded_to<T>(q[2]), rounded_to<T>(q[3]));
            }
        }
    }

    static Error read_one(const Spec& /*spec*/, const double* numbers, double* q, double& defect) noexcept {
        double own[size];
        for (std::size_t k = 0; k < size; ++k) {
            own[k] = numbers[k];
        }
        if (lacking(own) <= clean_square) {
            double near[4];
            quaternion_of(own, near);
            for (std::size_t k = 0; k < 4; ++k) {
                q[k] = near[k];
            }
            defect = clean_defect;
            return Error::none;
        }
        DoubleDouble exact[4];
        quaternion_of(numbers, exact);
        for (std::size_t k = 0; k < 4; ++k) {
            q[k] = exact[k].hi;
        }
        return check(numbers, exact, defect);
    }

    static void read_carefully(const Spec& /*spec*/, const double* numbers, ScaledDoubleDouble* q) noexcept {
        ScaledDoubleDouble own[4];
        quaternion_of(numbers, own);
        for (std::size_t k = 0; k < 4; ++k) {
            q[k] = own[k];
        }
    }
};

template <class Formula> constexpr Kernel kernel_of_columns() noexcept {
    using Reading = ColumnsKernel<Formula>;
    return {.fast = {.read = Reading::template read<double>, .write = write_rows_by<Formula, double>},
            .exact = {.read = Reading::template read<DoubleDouble>, .write = write_rows_by<Formula, DoubleDouble>},
            .one = {.read = Reading::read_one, .write = write_row_by<Formula, double>},
            .careful = {.read = Reading::read_carefully, .write = write_row_by<Formula, ScaledDoubleDouble>}};
}

} // namespace ROTCONV_TARGET
} // namespace rotconv
