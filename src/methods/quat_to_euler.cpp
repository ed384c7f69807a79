#include "formulas.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "../core/representations/euler_formulas.hpp"

namespace rotconv::formula::quat_to_euler {
namespace {

constexpr double pi = std::numbers::pi;

/// Into (-pi, pi]; sums of two arguments need no more than one turn.
double wrapped(double angle) noexcept {
    if (angle <= -pi) {
        return angle + 2.0 * pi;
    }
    return angle > pi ? angle - 2.0 * pi : angle;
}

/// The entries of the rotation matrix by the axes of the sequence read as turns about moving axes, i first: fixed axes
/// are the same turns in reverse order. For a proper sequence k is the axis that does not occur.
struct MovingAxes {
    MovingAxes(EulerSequence sequence, const double* q, Formula* to_matrix) noexcept
        : i(sequence.axis(sequence.intrinsic() ? 0 : 2)), j(sequence.axis(1)), k(3 - i - j),
          sign((j - i + 3) % 3 == 1 ? 1.0 : -1.0) {
        to_matrix(q, m);
    }

    [[nodiscard]] double operator()(int row, int column) const noexcept {
        return m[static_cast<std::size_t>(3 * row + column)];
    }

    int i, j, k;
    double sign;
    double m[9];
};

/// In the order of turns about moving axes.
struct Angles {
    double first, middle, third;
};

/// R = R_i(first) R_j(middle) R_k(third), or with R_i at the end: outer angles by atan2.
Angles outer_angles(const MovingAxes& r, bool proper) noexcept {
    const int i = r.i;
    const int j = r.j;
    const int k = r.k;
    if (proper) {
        return {std::atan2(r(j, i), -r.sign * r(k, i)), 0.0, std::atan2(r(i, j), r.sign * r(i, k))};
    }
    return {std::atan2(-r.sign * r(j, k), r(k, k)), 0.0, std::atan2(-r.sign * r(i, j), r(i, i))};
}

void set(EulerSequence sequence, const Angles& moving, double* angles) noexcept {
    angles[0] = wrapped(sequence.intrinsic() ? moving.first : moving.third);
    angles[1] = moving.middle;
    angles[2] = wrapped(sequence.intrinsic() ? moving.third : moving.first);
}

/// Bernardes and Viollet 2022: a + ib and c + id of the sequence read as turns about fixed axes i, j, k.
struct Halves {
    Halves(EulerSequence sequence, const double* q) noexcept {
        const FixedAxes axes(sequence);
        const double qi = q[1 + axes.i];
        const double qj = q[1 + axes.j];
        const double qk = q[1 + axes.k] * axes.sign;
        sign = axes.sign;
        if (sequence.proper()) {
            a = q[0];
            b = qi;
            c = qj;
            d = qk;
        } else {
            a = q[0] - qj;
            b = qi + qk;
            c = qj + q[0];
            d = qk - qi;
        }
    }

    double a, b, c, d;
    double sign;
};

/// The end of their procedure: Tait-Bryan angles from those of a proper sequence.
void set_halves(EulerSequence sequence, const Halves& h, Angles moving, double* angles) noexcept {
    if (!sequence.proper()) {
        moving.first *= h.sign;
        moving.middle -= 0.5 * pi;
    }
    set(sequence, moving, angles);
}

} // namespace

/// Diebel 2006, the twelve sequences: atan2 for the outer angles, asin or acos of one entry for the middle one.
void classic(EulerSequence sequence, const double* q, double* angles) noexcept {
    const MovingAxes r(sequence, q, quat_to_dcm::unit);
    Angles moving = outer_angles(r, sequence.proper());
    moving.middle = sequence.proper() ? std::acos(r(r.i, r.i)) : std::asin(r.sign * r(r.i, r.k));
    set(sequence, moving, angles);
}

/// Shoemake 1994, Graphics Gems IV, Eul_FromQuat: through the matrix, the middle angle by atan2 with the hypotenuse of
/// two entries; where this is small an outer angle is 0, here the third of the sequence.
void matrix_threshold(EulerSequence sequence, const double* q, double* angles) noexcept {
    constexpr double lock = 16.0 * std::numeric_limits<float>::epsilon(); // 1.9e-6, as in his program
    const MovingAxes r(sequence, q, quat_to_dcm::two_over_norm);
    const int i = r.i;
    const int j = r.j;
    const int k = r.k;
    const bool proper = sequence.proper();
    const double hypotenuse =
        proper ? std::sqrt(r(i, j) * r(i, j) + r(i, k) * r(i, k)) : std::sqrt(r(i, i) * r(i, i) + r(i, j) * r(i, j));
    Angles moving{};
    if (hypotenuse > lock) {
        moving = outer_angles(r, proper);
    } else if (sequence.intrinsic()) { // R = R_i R_j
        moving.first = std::atan2(r.sign * r(k, j), r(j, j));
    } else { // the third of the sequence is the first of the moving axes: R = R_j R_k, or R_j R_i
        moving.third = proper ? std::atan2(-r.sign * r(j, k), r(j, j)) : std::atan2(r.sign * r(j, i), r(j, j));
    }
    moving.middle = proper ? std::atan2(hypotenuse, r(i, i)) : std::atan2(r.sign * r(i, k), hypotenuse);
    set(sequence, moving, angles);
}

/// Bernardes and Viollet 2022: middle angle by arccos; within 1e-7 of lock, SciPy's threshold, one outer angle is free,
/// and the third of the sequence set to 0.
void bernardes_arccos(EulerSequence sequence, const double* q, double* angles) noexcept {
    constexpr double lock = 1e-7;
    const Halves h(sequence, q);
    const double cosine_square = h.a * h.a + h.b * h.b;
    const double sine_square = h.c * h.c + h.d * h.d;
    const double middle = std::acos(2.0 * cosine_square / (cosine_square + sine_square) - 1.0);
    const double half_sum = std::atan2(h.b, h.a);
    const double half_difference = std::atan2(h.d, h.c);
    Angles moving{half_sum + half_difference, middle, half_sum - half_difference};
    const bool sum_only = std::fabs(middle) < lock;
    const bool difference_only = std::fabs(middle - pi) < lock;
    if (sum_only || difference_only) {
        const double free = sum_only ? 2.0 * half_sum : 2.0 * half_difference;
        if (sequence.intrinsic()) {
            moving = {free, middle, 0.0};
        } else { // the first of the sequence is the third about moving axes
            moving = {0.0, middle, sum_only ? free : -free};
        }
    }
    set_halves(sequence, h, moving, angles);
}

/// The same half angles, with the middle angle by atan2 of hypotenuses and without a threshold.
void bernardes_atan2(EulerSequence sequence, const double* q, double* angles) noexcept {
    const Halves h(sequence, q);
    const double middle = 2.0 * std::atan2(std::hypot(h.c, h.d), std::hypot(h.a, h.b));
    const double half_sum = std::atan2(h.b, h.a);
    const double half_difference = std::atan2(h.d, h.c);
    set_halves(sequence, h, {half_sum + half_difference, middle, half_sum - half_difference}, angles);
}

} // namespace rotconv::formula::quat_to_euler
