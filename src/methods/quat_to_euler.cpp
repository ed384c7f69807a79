#include "formulas.hpp"

#include <numbers>

#include "../core/representations/euler_formulas.hpp"

namespace rotconv::formula::quat_to_euler {
namespace {

constexpr double pi = std::numbers::pi;

/// Bernardes and Viollet 2022: a + ib and c + id of the sequence, read as rotations about fixed axes i, j, k.
struct Halves {
    Halves(EulerSequence sequence, const double* q) noexcept : Halves(FixedAxes(sequence), q) {}
    Halves(const FixedAxes& axes, const double* q) noexcept : sign(axes.sign) {
        const double qi = q[1 + axes.i];
        const double qj = q[1 + axes.j];
        const double qk = q[1 + axes.k] * axes.sign;
        a = axes.proper ? q[0] : q[0] - qj;
        b = axes.proper ? qi : qi + qk;
        c = axes.proper ? qj : qj + q[0];
        d = axes.proper ? qk : qk - qi;
        half_sum = std::atan2(b, a);
        half_difference = std::atan2(d, c);
    }

    double sign;
    double a, b, c, d;
    double half_sum, half_difference; ///< halves of the outer angles' sum and difference
};

/// The end of their procedure: Tait-Bryan angles from those of a proper sequence.
void set_halves(EulerSequence sequence, const Halves& h, MovingAngles moving, double* angles) noexcept {
    if (!sequence.proper()) {
        moving.first *= h.sign;
        moving.middle -= 0.5 * pi;
    }
    dcm_to_euler::set(sequence, moving, angles);
}

} // namespace

/// Bernardes and Viollet 2022: middle angle by arccos; within 1e-7 of lock, SciPy's threshold, one outer angle is free,
/// and the third of the sequence set to 0.
void bernardes_arccos(EulerSequence sequence, const double* q, double* angles) noexcept {
    constexpr double lock = 1e-7;
    const Halves h(sequence, q);
    const double cosine_square = h.a * h.a + h.b * h.b;
    const double sine_square = h.c * h.c + h.d * h.d;
    const double middle = std::acos(2.0 * cosine_square / (cosine_square + sine_square) - 1.0);
    MovingAngles moving{h.half_sum + h.half_difference, middle, h.half_sum - h.half_difference};
    const bool sum_only = std::fabs(middle) < lock;
    const bool difference_only = std::fabs(middle - pi) < lock;
    if (sum_only || difference_only) {
        const double free = sum_only ? 2.0 * h.half_sum : 2.0 * h.half_difference;
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
    set_halves(sequence, h, {h.half_sum + h.half_difference, middle, h.half_sum - h.half_difference}, angles);
}

} // namespace rotconv::formula::quat_to_euler
