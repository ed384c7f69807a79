#pragma once

#include "../numerics/elementary.hpp"
#include "kernel.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// A vector along the axis and its length. Both are times a power of two that brings the largest component to a size of
/// 1/2 to 1, but for the zero vector and for a Careful one. The length counts in every number: it is precise.
template <class T> struct AxisVector {
    ROTCONV_INLINE AxisVector() noexcept = default;
    ROTCONV_INLINE explicit AxisVector(const double* v) noexcept {
        double scale = 1.0;
        if constexpr (!std::is_same_v<T, Careful>) {
            const double size = largest_magnitude(v[0], v[1], v[2]);
            scale = unit_scale(is_plain_number(size, 0x1p-300) && size > 0.0 ? size : 0.5);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            along[k] = v[k] * scale;
        }
        length = root(sum_of_squares(along[0], along[1], along[2]));
        back = 1.0 / scale;
    }

    Given<T> along[3];
    Precise<T> length;
    double back; ///< times this, it is the vector
};

/// The length of a vector of doubles and what the exact one has beside it, to 2^-100: not normalised.
ROTCONV_INLINE DoubleDouble length_of(double x, double y, double z) noexcept {
    const DoubleDouble xx = two_prod(x, x);
    const DoubleDouble yy = two_prod(y, y);
    const DoubleDouble zz = two_prod(z, z);
    const DoubleDouble two = two_sum(xx.hi, yy.hi);
    const DoubleDouble three = two_sum(two.hi, zz.hi);
    const double length = __builtin_sqrt(three.hi);
    const DoubleDouble back = two_prod(length, length);
    const double rest = ((three.hi - back.hi) - back.lo) + ((two.lo + three.lo) + ((xx.lo + yy.lo) + zz.lo));
    return {length, rest * (0.5 / length)};
}

/// (|v| cos, v sin) of the half angle; of no axis the identity.
template <class T>
ROTCONV_INLINE void quaternion_of(const AxisVector<T>& v, const SineCosine<T>& half, T (&q)[4]) noexcept {
    q[0] = select(sign_of(v.length) == 0.0, T(1.0), rounded_to<T>(v.length * half.cosine));
    for (std::size_t k = 0; k < 3; ++k) {
        q[k + 1] = half.sine * v.along[k];
    }
}

/// A quaternion with the sign that is printed, and the length of its vector part. It and the angle count in every
/// number, the angle twice: they are precise.
template <class T> struct AxisHalfAngle {
    ROTCONV_INLINE explicit AxisHalfAngle(const T (&given)[4]) noexcept {
        const double sign = canonical_sign(given);
        for (std::size_t k = 0; k < 4; ++k) {
            q[k] = scaled(given[k], sign);
        }
        length = root(sum_of_squares(q[1], q[2], q[3]));
    }

    T q[4];
    Precise<T> length;
};

/// Writes what result_of(row, DoubleDouble (&result)[size]) gives: numbers, and what they leave. doubt_of(row, result)
/// is called for each.
template <std::size_t size, class ResultOf, class DoubtOf>
ROTCONV_INLINE void write_results(std::size_t rows, const ResultOf& result_of, const DoubtOf& doubt_of, double* numbers,
                                  double* rest) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        DoubleDouble result[size];
        result_of(i, result);
        doubt_of(i, result);
        for (std::size_t k = 0; k < size; ++k) {
            numbers[size * i + k] = result[k].hi;
        }
    }
    for (std::size_t i = 0; i < rows && rest != nullptr; ++i) {
        DoubleDouble result[size];
        result_of(i, result);
        for (std::size_t k = 0; k < size; ++k) {
            rest[size * i + k] = result[k].lo;
        }
    }
}

/// Whether the sign that is printed is in doubt: what stands before the component that decides it must be 0, and that
/// must be more than its error.
inline std::uint64_t doubt_of_sign(const double (&q)[4], double off) noexcept {
    std::uint64_t doubts = 0;
    for (unsigned k = 0; k < 4; ++k) {
        if (__builtin_fabs(q[k]) > off) {
            return doubts;
        }
        if (q[k] != 0.0 || off >= 0x1p-66) {
            return other_doubt;
        }
        doubts |= off == 0.0 ? 0U : std::uint64_t{1} << (16U + k);
    }
    return doubts;
}

/// Kernels that read an axis and an angle, of a class Formula whose numbers begin with a vector along the axis, with
///     error_of(const double* numbers, AngleUnit unit)
///     half_angle(const AxisVector<T>& v, const double* numbers)
///     is_exact          whether that is a double, of which sine and cosine are off by 2^-100 of themselves
template <class Formula, std::size_t size> struct ReadByAxis {
    template <class T>
    static void read(const Spec& spec, const double* numbers, std::size_t rows, AttitudeBatch<T>& attitudes) noexcept {
        Columns<double, size> columns;
        Columns<double, 3> along;
        Column<DoubleDouble> length;
        Column<DoubleDouble> half;
        Column<T> cosine;
        Column<T> sine;
        for (std::size_t i = 0; i < rows; ++i) {
            attitudes.error[i] = Formula::error_of(numbers + size * i, spec.unit);
            attitudes.defect[i] = 0.0;
        }
        to_columns(numbers, rows, columns);
        for (std::size_t i = 0; i < rows; ++i) {
            double own[size];
            columns.get(i, own);
            const AxisVector<T> v(own);
            along.set(i, v.along);
            length.set(i, v.length);
            half.set(i, Formula::half_angle(v, own));
        }
        // An angle to 2^-103 of itself; up to 3/4 its sine and cosine are not off by more of themselves either.
        const double unit_size = spec.unit == AngleUnit::degrees ? 0x1p-5 : 1.0;
        for (std::size_t i = 0; i < rows; ++i) {
            const double in_radians = unit_size * __builtin_fabs(half.hi[i]);
            attitudes.off[i] = Formula::is_exact || in_radians < 0.75 ? 0.0 : 0x1p-101 * in_radians;
        }
        sine_cosine(half, rows, spec.unit, cosine, sine);
        for (std::size_t i = 0; i < rows; ++i) {
            AxisVector<T> v;
            along.get(i, v.along);
            v.length = length[i];
            T q[4];
            quaternion_of(v, SineCosine<T>{sine[i], cosine[i]}, q);
            attitudes.set(i, q);
        }
    }
    static Error read_one(const Spec& spec, const double* numbers, double (&q)[4], double& defect) noexcept {
        defect = 0.0;
        const Error error = Formula::error_of(numbers, spec.unit);
        if (error == Error::none) {
            const AxisVector<double> v(numbers);
            quaternion_of(v, sine_cosine<double>(Formula::half_angle(v, numbers), spec.unit), q);
        }
        return error;
    }
    static void read_carefully(const Spec& spec, const double* numbers, Careful (&q)[4]) noexcept {
        const AxisVector<Careful> v(numbers);
        quaternion_of(v, sine_cosine(Formula::half_angle(v, numbers), spec.unit), q);
    }
};

/// Those that write, of a class Formula with
///     numbers_of(const T (&q)[4], const Precise<T>& length, const Precise<T>& angle, Precise<T> (&numbers)[size])
///     error_of(std::size_t k, double length, AngleUnit unit, double off)   ErrorBound, see AttitudeBatch::off
/// where q and length are those of AxisHalfAngle.
template <class Formula, std::size_t count> struct WrittenByAxis {
    static constexpr std::size_t size = count;
    static constexpr bool needs_angle = true; ///< otherwise it is 0

    template <class T> ROTCONV_INLINE static DiagnosticSet diagnostics_of(const T (&q)[4]) noexcept {
        return half_turn_of(q);
    }

    template <class T> static void write(const Spec& spec, double /*lock_margin*/, const AttitudeBatch<T>& attitudes,
                                         std::size_t rows, double* numbers, double* rest, DiagnosticSet* diagnostics,
                                         std::uint64_t* doubts) noexcept {
        Columns<T, 4> parts;
        Column<T> sides;
        Column<DoubleDouble> length;
        Column<DoubleDouble> half;
        for (std::size_t i = 0; i < rows; ++i) {
            T q[4];
            attitudes.get(i, q);
            const AxisHalfAngle<T> part(q);
            parts.set(i, part.q);
            length.set(i, part.length);
            sides.set(i, rounded_to<T>(part.length));
        }
        if constexpr (Formula::needs_angle) {
            angles_of(parts[0], sides, rows, spec.unit, half);
        }
        const auto result_of = [&](std::size_t i, DoubleDouble(&result)[size]) {
            T q[4];
            DoubleDouble angle;
            parts.get(i, q);
            if constexpr (Formula::needs_angle) {
                angle = scaled(half[i], 2.0);
            }
            Formula::numbers_of(q, length[i], angle, result);
        };
        const auto find_doubts = [&](std::size_t i, const DoubleDouble(&result)[size]) {
            for (unsigned k = 0; k < size && !std::is_same_v<T, double>; ++k) {
                const ErrorBound error = Formula::error_of(k, length.hi[i], spec.unit, attitudes.off[i]);
                doubts[i] |= doubt_of(result[k], error.absolute + error.relative * __builtin_fabs(result[k].hi), k);
            }
        };
        write_results<size>(rows, result_of, find_doubts, numbers, rest);
        for (std::size_t i = 0; i < rows; ++i) {
            T q[4];
            parts.get(i, q);
            diagnostics[i] = Formula::diagnostics_of(q);
            if (!std::is_same_v<T, double> && !(to_double(q[0]) > attitudes.off[i])) [[unlikely]] {
                doubts[i] |= doubt_of_sign({to_double(q[0]), to_double(q[1]), to_double(q[2]), to_double(q[3])},
                                           attitudes.off[i]);
            }
        }
    }
    template <class T>
    static DiagnosticSet write_one(const Spec& spec, double /*lock_margin*/, const T (&q)[4], T* numbers) noexcept {
        const auto component = [&](std::size_t k) { return Formula::needs_angle ? alone(q[k]) : q[k]; };
        const AxisHalfAngle<T> part({component(0), component(1), component(2), component(3)});
        Precise<T> angle = 0.0;
        if constexpr (Formula::needs_angle) {
            angle = scaled(angle_of(part.q[0], rounded_to<T>(part.length), spec.unit), 2.0);
        }
        Precise<T> result[size];
        Formula::numbers_of(part.q, part.length, angle, result);
        store(result, numbers);
        return Formula::diagnostics_of(part.q);
    }
};

} // namespace ROTCONV_TARGET
} // namespace rotconv
