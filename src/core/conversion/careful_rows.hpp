#pragma once

#include "../numerics/elementary.hpp"
#include "../numerics/quaternion_algebra.hpp"
#include "../representations/kernel.hpp"
#include "kernels.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

inline const Kernel& kernel_of(RepresentationId name) noexcept {
#define ROTCONV_LINE(id) &kernels::id,
    static constexpr const Kernel* table[] = {ROTCONV_REPRESENTATIONS(ROTCONV_LINE)};
#undef ROTCONV_LINE
    return *table[static_cast<std::size_t>(name)];
}

template <class T> const BatchKernel<T>& batch_kernel_of(RepresentationId name) noexcept {
    if constexpr (std::is_same_v<T, double>) {
        return kernel_of(name).fast;
    } else {
        return kernel_of(name).exact;
    }
}

// Functions of one attitude, in any scalar.

/// b q or q b.
template <class T> ROTCONV_INLINE void multiply_from_side(const T (&by)[4], bool from_the_left, T (&q)[4]) noexcept {
    const T own[4] = {q[0], q[1], q[2], q[3]};
    multiply(from_the_left ? by : own, from_the_left ? own : by, q);
}
template <class T>
ROTCONV_INLINE void multiply_from_side(const ExactQuaternion& by, bool from_the_left, T (&q)[4]) noexcept {
    T constant[4];
    for (std::size_t k = 0; k < 4; ++k) {
        constant[k] = rounded_to<T>(DoubleDouble(by.hi[k], by.lo[k]));
    }
    multiply_from_side(constant, from_the_left, q);
}
/// By what there may be.
template <class T> ROTCONV_INLINE void multiply_by(const FixedRotations& by, T (&q)[4]) noexcept {
    if (by.left.count > 0 && !by.right_first) {
        multiply_from_side(by.left.rotation, true, q);
    }
    if (by.right.count > 0) {
        multiply_from_side(by.right.rotation, false, q);
    }
    if (by.left.count > 0 && by.right_first) {
        multiply_from_side(by.left.rotation, true, q);
    }
}
/// R_REF' R.
template <class T> ROTCONV_INLINE void make_relative(const T (&reference)[4], T (&q)[4]) noexcept {
    multiply_from_side({-reference[0], reference[1], reference[2], reference[3]}, true, q);
}

ROTCONV_INLINE SineCosine<DoubleDouble> sine_cosine_of(DoubleDouble angle) noexcept {
    return sine_cosine<DoubleDouble>(angle, AngleUnit::radians);
}
inline SineCosine<Wide> sine_cosine_of(const Wide& angle) noexcept { return sine_cosine(angle, AngleUnit::radians); }
/// a / b, from 0 to 1, of which b may be 0.
ROTCONV_INLINE DoubleDouble ratio_below_1(DoubleDouble a, DoubleDouble b) noexcept {
    return a / select(b.hi == 0.0, DoubleDouble(1.0), b);
}
inline Wide ratio_below_1(const Wide& a, const Wide& b) noexcept {
    Wide unknown = 0.5;
    unknown.widen(0.5);
    return b.may_be_zero() || b.exponent() < -100'000 ? unknown : a / b;
}

template <class T>
ROTCONV_INLINE void rotate_vector(const T (&q)[4], const Given<T> (&vector)[3], T (&rotated)[3]) noexcept {
    T m[9];
    scaled_matrix_of(q, m);
    for (std::size_t k = 0; k < 3; ++k) {
        rotated[k] = (m[3 * k] * vector[0] + m[3 * k + 1] * vector[1]) + m[3 * k + 2] * vector[2];
    }
    divide(rotated, squared_norm(q));
}

/// A part of a whole, each a sum of three doubles.
template <class T> ROTCONV_INLINE T part_of_way(const double* fractions) noexcept {
    const auto sum_of = [](const double* parts) { return (T(parts[0]) + T(parts[1])) + T(parts[2]); };
    return sum_of(fractions) / sum_of(fractions + 3);
}
/// p becomes the attitude on the shortest turn from p to q, neither of a given length, at that part of the way: p times
/// the part of the rotation p' q. In unit quaternions it moves by no more than p and q together.
/// @param fractions see part_of_way()
template <class T> ROTCONV_INLINE void interpolate(const double* fractions, const T (&q)[4], T (&p)[4]) noexcept {
    T turn[4] = {q[0], q[1], q[2], q[3]};
    make_relative(p, turn);
    const double sign = sign_of(turn[0]) < 0.0 ? -1.0 : 1.0;
    const T length = root(sum_of_squares(turn[1], turn[2], turn[3]));
    const T half = angle_of(scaled(turn[0], sign), length, AngleUnit::radians);
    const SineCosine<T> part = sine_cosine_of(part_of_way<T>(fractions) * half);
    const T factor = scaled(ratio_below_1(part.sine, length), sign);
    multiply_from_side({part.cosine, turn[1] * factor, turn[2] * factor, turn[3] * factor}, false, p);
}

/// Applies a rotation that only permutes and negates axes exactly, to matrices, and leaves none.
inline void move_axes(const Spec& spec, FixedSide& side, bool from_the_left, bool inverse, const double*& in,
                      std::size_t rows, double* out) noexcept {
    if (side.count == 0 || kernel_of(spec.name).column != 9) {
        return;
    }
    const auto& [w, x, y, z] = side.rotation.hi;
    const auto& lo = side.rotation.lo;
    double m[9];
    scaled_matrix_of({inverse ? -w : w, x, y, z}, m);
    const double norm = squared_norm(side.rotation.hi);
    bool moves = largest_magnitude(lo[0], lo[1], lo[2], lo[3]) == 0.0;
    for (double& entry : m) {
        moves = moves && (entry == 0.0 || __builtin_fabs(entry) == norm);
        entry /= norm;
    }
    if (!moves) {
        return;
    }
    for (std::size_t k = 0; k < 9 * rows; ++k) {
        const double* const a = in + k / 9 * 9;
        const std::size_t i = k % 9 / 3 * 3;
        const std::size_t j = k % 3;
        out[k] = from_the_left != inverse ? (m[i] * a[j] + m[i + 1] * a[3 + j]) + m[i + 2] * a[6 + j]
                                          : (a[i] * m[j] + a[i + 1] * m[3 + j]) + a[i + 2] * m[6 + j];
    }
    in = out;
    side.count = 0;
}
/// What is left of them when matrices have taken those that they take without a sum, which would cost small
/// numbers digits.
inline FixedRotations move_axes(const Spec& spec, bool inverse, FixedRotations fixed, const double*& in,
                                std::size_t rows, double (&moved)[2][9 * batch_rows]) noexcept {
    move_axes(spec, fixed.left, true, inverse, in, rows, moved[0]);
    move_axes(spec, fixed.right, false, inverse, in, rows, moved[1]);
    return fixed;
}

// Rows that the batch kernels do not serve, because a number or the attitude that came of them is not plain.

/// For exact.read, or else for fast.read.
inline bool all_plain_numbers(const Spec& spec, const double* numbers, std::size_t rows, bool exactly) noexcept {
    const Kernel& kernel = kernel_of(spec.name);
    const double least = exactly ? kernel.least_plain_number : 0x1p-112;
    return kernel.is_quaternion ||
           all(numbers, rows * spec.size(), [least](double number) { return is_plain_number(number, least); });
}

template <class T> bool all_plain(const AttitudeBatch<T>& attitudes, std::size_t first, std::size_t rows) noexcept {
    const auto is_plain = [&](std::size_t k) { return all(attitudes[k].hi + first, rows, is_plain_component); };
    return is_plain(0) && is_plain(1) && is_plain(2) && is_plain(3);
}

/// Calls careful(i) for each row without error that is one of them.
template <class T, class Function> void for_each_careful_row(const Spec& spec, const double* numbers,
                                                             const AttitudeBatch<T>& attitudes, std::size_t rows,
                                                             const Function& careful, bool exactly = true) noexcept {
    if (all_plain(attitudes, 0, rows) && all_plain_numbers(spec, numbers, rows, exactly)) {
        return;
    }
    for (std::size_t i = 0; i < rows; ++i) {
        if (attitudes.error[i] == Error::none &&
            !(all_plain(attitudes, i, 1) && all_plain_numbers(spec, numbers + i * spec.size(), 1, exactly))) {
            careful(i);
        }
    }
}

// Rows that 106 bits do not decide, one at a time, in Wide.

inline void scale_to_unit(Careful (&q)[4]) noexcept {
    int largest = q[0].exponent();
    for (const Careful& component : q) {
        largest = component.exponent() > largest ? component.exponent() : largest;
    }
    for (Careful& component : q) {
        component = component.shifted(-1 - largest);
    }
}

inline void multiply_by(const FixedSide& side, bool from_the_left, Careful (&q)[4]) noexcept {
    for (std::size_t k = 0; k < side.count; ++k) {
        const FixedFactor& factor = side.factors[from_the_left ? side.count - 1 - k : k];
        Careful by[4];
        kernel_of(factor.spec.name).careful.read(factor.spec, factor.numbers, by);
        for (std::size_t i = 0; i < 4; ++i) {
            by[i] = by[i] + Careful(factor.rest[i]);
        }
        scale_to_unit(by);
        by[0] = factor.spec.passive != factor.is_inverse ? -by[0] : by[0];
        multiply_from_side(by, from_the_left, q);
    }
}

/// The attitude of a row between the fixed rotations; its largest component was of size 1/2 to 1.
inline void read_carefully(const Spec& spec, const double* numbers, const FixedRotations& all,
                           Careful (&q)[4]) noexcept {
    double moved[2][9 * batch_rows];
    const FixedRotations fixed = move_axes(spec, spec.passive, all, numbers, 1, moved);
    kernel_of(spec.name).careful.read(spec, numbers, q);
    scale_to_unit(q);
    q[0] = spec.passive ? -q[0] : q[0];
    multiply_by(fixed.left, true, q);
    multiply_by(fixed.right, false, q);
}

/// The attitude that is written.
inline void read_carefully(const Task& task, const TaskNumbers& row, Careful (&q)[4]) noexcept {
    read_carefully(*task.first, row.first, *task.fixed, q);
    if (task.second != nullptr) {
        Careful other[4];
        read_carefully(*task.second, row.second, no_rotations, other);
        if (row.later != nullptr && row.fractions != nullptr) {
            Careful later[4];
            read_carefully(*task.second, row.later, no_rotations, later);
            interpolate(row.fractions, later, other);
        }
        multiply_from_side(other, false, q);
    }
    q[0] = task.inverts() ? -q[0] : q[0];
}
inline DiagnosticSet write_carefully(const Task& task, const TaskNumbers& row, const Careful (&q)[4],
                                     Careful* results) noexcept {
    if (task.to != nullptr) {
        return kernel_of(task.to->name).careful.write(*task.to, task.lock_margin, q, results);
    }
    Careful vector[3];
    Careful rotated[3];
    load(row.second, vector);
    rotate_vector(q, vector, rotated);
    store(rotated, results);
    return {};
}

inline void set_rounded(const Careful (&q)[4], std::size_t row, AttitudeBatch<double>& attitudes) noexcept {
    attitudes.set(row, {q[0].rounded(), q[1].rounded(), q[2].rounded(), q[3].rounded()});
}

} // namespace ROTCONV_TARGET
} // namespace rotconv
