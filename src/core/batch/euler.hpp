#pragma once

#include <cstddef>

#include <rotconv/reading.hpp>

#include "../numerics/elementary.hpp"
#include "../representations/fixed_axes.hpp"
#include "scaling.hpp"

// The formulas of Euler angles for one row, over a scalar, double or Real.

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// a - b, and 0 where so much cancels that the rest is the operands' own error: 0 and lock are met exactly.
ROTCONV_INLINE Real clean_difference(Real a, Real b) noexcept {
    const Real difference = a - b;
    return choose(__builtin_fabs(difference.hi) <= 0x1p-97 * __builtin_fabs(a.hi), 0.0, difference);
}
ROTCONV_INLINE double clean_difference(double a, double b) noexcept { return a - b; }
template <class T> ROTCONV_INLINE T clean_sum(T a, T b) noexcept { return clean_difference(a, -b); }

/// The quaternion w, i, j, k of the three turns about fixed axes, of which half angles are given: their product.
template <class T>
ROTCONV_INLINE void product_of_turns(const FixedAxes& axes, const SineCosine<T> (&turns)[3], T (&q)[4]) noexcept {
    const T cc = turns[2].cosine * turns[0].cosine;
    const T ss = turns[2].sine * turns[0].sine;
    const T sc = turns[2].sine * turns[0].cosine;
    const T cs = turns[2].cosine * turns[0].sine;
    const T c = turns[1].cosine;
    const T s = turns[1].sine;
    const T signed_s = scaled(s, axes.sign);
    if (axes.proper) {
        q[0] = c * clean_difference(cc, ss);
        q[1] = c * clean_sum(sc, cs);
        q[2] = s * clean_sum(cc, ss);
        q[3] = signed_s * clean_difference(sc, cs);
    } else {
        q[0] = clean_sum(c * cc, signed_s * ss);
        q[1] = clean_difference(c * cs, signed_s * sc);
        q[2] = clean_sum(s * cc, scaled(c, axes.sign) * ss);
        q[3] = clean_difference(c * sc, signed_s * cs);
    }
}

template <class T> struct Vector { T x, y; };

/// The vectors whose angles are those of the three turns. With a + ib = C e^(is), c + id = S e^(it) the outer angles
/// are s + t and s - t, and C, S are cosine and sine of m/2, m the middle angle (of m/2 + pi/4 for Tait-Bryan angles),
/// times a common factor.
template <class T> struct TurnVectors {
    /// @param q w, i, j, k
    ROTCONV_INLINE TurnVectors(const FixedAxes& axes, const T (&q)[4]) noexcept {
        const T k = scaled(q[3], axes.sign);
        const ScaledVector<T> ab(axes.proper ? q[0] : clean_difference(q[0], q[2]),
                                 axes.proper ? q[1] : clean_sum(q[1], k));
        const ScaledVector<T> cd(axes.proper ? q[2] : clean_sum(q[2], q[0]),
                                 axes.proper ? k : clean_difference(k, q[1]));
        const T ac = ab.x * cd.x;
        const T bd = ab.y * cd.y;
        const T bc = ab.y * cd.x;
        const T ad = ab.x * cd.y;
        first = {clean_sum(ac, bd), clean_difference(bc, ad)};
        third = {clean_difference(ac, bd), scaled(clean_sum(bc, ad), axes.proper ? 1.0 : axes.sign)};
        // a Tait-Bryan angle by its own tangent, (S^2 - C^2)/(2 S C): near 0 it keeps its digits
        middle = {axes.proper ? ab.length : ab.length * cd.length,
                  axes.proper ? cd.length : scaled(clean_difference(q[0] * q[2], q[1] * k), 2.0)};
        cosine_length = nearly(ab.length);
        sine_length = nearly(cd.length);
    }

    /// At lock only s (where S = 0) or t (where C = 0) is defined: of the angles that are listed first and last the
    /// last is 0 and the first twice that.
    void give_up_one(const FixedAxes& axes, bool intrinsic, const T (&q)[4]) noexcept {
        const T k = scaled(q[3], axes.sign);
        const bool sum = sine_length < cosine_length;
        const T x = sum ? (axes.proper ? q[0] : q[0] - q[2]) : (axes.proper ? q[2] : q[2] + q[0]);
        const T y = sum ? (axes.proper ? q[1] : q[1] + k) : (axes.proper ? k : k - q[1]);
        const double third_sign = axes.proper ? 1.0 : axes.sign;
        const double sign = intrinsic ? third_sign : (sum ? 1.0 : -1.0);
        // the first of the numbers is that of the last fixed turn where the turns are intrinsic
        Vector<T>& free = intrinsic ? third : first;
        Vector<T>& fixed = intrinsic ? first : third;
        free = {clean_difference(x, y) * clean_sum(x, y), scaled(x * y, 2.0 * sign)};
        fixed = {T(1.0), T(0.0)};
    }

    Vector<T> first, middle, third;    ///< in the order of the fixed turns
    double cosine_length, sine_length; ///< C and S
};

/// tan(lock margin/2); infinite from pi/2 on.
inline double tangent_of_half(double lock_margin) noexcept {
    if (lock_margin < 1e-9) {
        return 0.5 * lock_margin;
    }
    if (lock_margin >= 0.5 * exact_pi.hi) {
        return __builtin_inf();
    }
    const auto half = sine_cosine<Real>(0.5 * lock_margin, AngleUnit::radians);
    return (half.sine / half.cosine).hi;
}

/// Whether an attitude counts as locked: its margin is at most the lock margin where tan(margin/2) = min(C, S)/max(C,
/// S) is at most tan(lock margin/2).
struct Lock {
    ROTCONV_INLINE Lock(double cosine_length, double sine_length, double lock_tangent) noexcept {
        const bool upper = cosine_length <= sine_length;
        const double smaller = upper ? cosine_length : sine_length;
        const double larger = upper ? sine_length : cosine_length;
        constexpr double factor = 2.0 * near_lock_condition * near_lock_condition;
        locked = smaller == 0.0 || smaller <= lock_tangent * larger;
        // condition = 1/(sqrt 2 sin(margin/2)), with sin(margin/2) = smaller/hypot
        nearly_locked = !locked && factor * (smaller * smaller) < smaller * smaller + larger * larger;
    }

    [[nodiscard]] ROTCONV_INLINE DiagnosticSet diagnostics() const noexcept {
        DiagnosticSet found{DiagnosticKind::gimbal_lock, locked};
        found |= {DiagnosticKind::near_gimbal_lock, nearly_locked};
        return found;
    }

    bool locked, nearly_locked;
};

/// The ranges of the angles of a sequence, in a unit.
struct AngleRanges {
    ROTCONV_INLINE AngleRanges(const FixedAxes& axes, AngleUnit unit) noexcept
        : half_turn(half_turn_in(unit).hi), middle_factor(axes.proper ? 2.0 : 1.0),
          upper((axes.proper ? 1.0 : 0.5) * half_turn), lower(axes.proper ? 0.0 : -upper) {}

    /// In (-pi, pi] or (-180, 180].
    [[nodiscard]] ROTCONV_INLINE double outer(double angle) const noexcept {
        return angle <= -half_turn ? half_turn : angle;
    }
    [[nodiscard]] ROTCONV_INLINE double locked_middle(bool is_upper) const noexcept { return is_upper ? upper : lower; }

    double half_turn;
    double middle_factor; ///< from the angle of its vector to the middle angle
    double upper, lower;  ///< limits of that
};

} // namespace ROTCONV_TARGET
} // namespace rotconv
