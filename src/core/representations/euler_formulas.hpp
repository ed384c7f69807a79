#pragma once

#include <cstddef>
#include <type_traits>

#include <rotconv/spec.hpp>

#include "../numerics/elementary.hpp"
#include "../numerics/power_of_two.hpp"

// The formulas of Euler angles for one row, over a scalar: double, DoubleDouble, Wide or, in a first phase,
// Approximate.

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// The axes i, j, k of a sequence read as turns about fixed axes, the first turn about i. Intrinsic turns are the same
/// turns about fixed axes in reverse order. For a proper sequence k is the axis that does not occur.
struct FixedAxes {
    ROTCONV_INLINE explicit FixedAxes(EulerSequence sequence) noexcept
        : proper(sequence.proper()),
          intrinsic(sequence.intrinsic()), places{intrinsic ? 2U : 0U, 1, intrinsic ? 0U : 2U},
          i(sequence.axis(places[0])), j(sequence.axis(1)), k(proper ? 3 - i - j : sequence.axis(places[2])),
          sign((j - i + 3) % 3 == 1 ? 1.0 : -1.0) {}

    bool proper, intrinsic;
    std::size_t places[3]; ///< where the angles of the three turns stand among the numbers
    int i, j, k;
    double sign; ///< +1 where (i, j, k) is an even permutation of (x, y, z)
};

/// The same where the compiler knows the kind of the sequence, and leaves out the formula of the other.
template <bool is_proper> struct AxesOfKind : FixedAxes {
    using FixedAxes::FixedAxes;
    static constexpr bool proper = is_proper;
};

/// a - b, and 0 where so much cancels that the rest is the operands' own error: 0 and gimbal lock are exact.
template <class T> ROTCONV_INLINE T clean_difference(const T& a, const T& b) noexcept {
    const T difference = a - b;
    return select(__builtin_fabs(to_double(difference)) <= 0x1p-97 * __builtin_fabs(to_double(a)), T(0.0), difference);
}
ROTCONV_INLINE double clean_difference(double a, double b) noexcept { return a - b; }
template <class T> ROTCONV_INLINE T clean_sum(const T& a, const T& b) noexcept { return clean_difference(a, -b); }

/// Keeps a loop from working on several rows at once where that is no faster: on two, to 106 bits, without fused
/// multiply-add. Such loops over the formulas below took 8 s to compile.
template <class T> ROTCONV_INLINE void row_by_row() noexcept {
    if constexpr (!std::is_same_v<T, double> && !ROTCONV_HAS_FMA) {
        __asm__ volatile("");
    }
}

/// The quaternion w, i, j, k of the three turns about fixed axes, of which half angles are given: their product.
template <class Axes, class T>
ROTCONV_INLINE void product_of_turns(const Axes& axes, const SineCosine<T> (&turns)[3], T (&q)[4]) noexcept {
    row_by_row<T>();
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

/// a <= b, as far as it only counts where they are far from each other.
template <class T> ROTCONV_INLINE bool is_roughly_at_most(const T& a, const T& b) noexcept { return is_at_most(a, b); }
inline bool is_roughly_at_most(const Wide& a, const Wide& b) noexcept { return to_double(a) <= to_double(b); }

template <class T> struct Vector { T x, y; };

/// The vectors whose angles are those of the three turns. With a + ib = C e^(is), c + id = S e^(it) the outer angles
/// are s + t and s - t, and C, S are cosine and sine of m/2, m the middle angle (of m/2 + pi/4 for Tait-Bryan angles),
/// times a common factor.
template <class T> struct TurnVectors {
    /// @param q w, i, j, k
    template <class Axes> ROTCONV_INLINE TurnVectors(const Axes& axes, const T (&q)[4]) noexcept {
        row_by_row<T>();
        const T k = scaled(q[3], axes.sign);
        const Vector<T> ab{axes.proper ? q[0] : clean_difference(q[0], q[2]), axes.proper ? q[1] : clean_sum(q[1], k)};
        const Vector<T> cd{axes.proper ? q[2] : clean_sum(q[2], q[0]), axes.proper ? k : clean_difference(k, q[1])};
        cosine_length = root(sloppy_sum(square(ab.x), square(ab.y)));
        sine_length = root(sloppy_sum(square(cd.x), square(cd.y)));
        const T ac = ab.x * cd.x;
        const T bd = ab.y * cd.y;
        const T bc = ab.y * cd.x;
        const T ad = cd.y * ab.x; // where it equals bc, so do their factors, in this order
        first = {clean_sum(ac, bd), clean_difference(bc, ad)};
        last = {clean_difference(ac, bd), scaled(clean_sum(bc, ad), axes.proper ? 1.0 : axes.sign)};
        // a Tait-Bryan angle by its own tangent, (S^2 - C^2)/(2 S C): near 0 it keeps its digits
        middle = {axes.proper ? cosine_length : cosine_length * sine_length,
                  axes.proper ? sine_length : scaled(clean_difference(q[0] * q[2], q[1] * k), 2.0)};
    }

    /// Takes the other triple of a proper sequence, a + pi, -b, c + pi.
    ROTCONV_INLINE void take_other() noexcept {
        first = {-first.x, -first.y};
        last = {-last.x, -last.y};
    }

    /// At lock only s (where S = 0) or t (where C = 0) is defined: of the angles that are listed first and last the
    /// last is 0 and the first twice that.
    void give_up_one(const FixedAxes& axes, const T (&q)[4], bool upper) noexcept {
        const T k = scaled(q[3], axes.sign);
        const bool sum = !upper;
        const T x = sum ? (axes.proper ? q[0] : q[0] - q[2]) : (axes.proper ? q[2] : q[2] + q[0]);
        const T y = sum ? (axes.proper ? q[1] : q[1] + k) : (axes.proper ? k : k - q[1]);
        const double last_sign = axes.proper ? 1.0 : axes.sign;
        const double sign = axes.intrinsic ? last_sign : (sum ? 1.0 : -1.0);
        Vector<T>& listed_first = axes.intrinsic ? last : first;
        Vector<T>& listed_last = axes.intrinsic ? first : last;
        listed_first = {clean_difference(x, y) * clean_sum(x, y), scaled(x * y, 2.0 * sign)};
        listed_last = {T(1.0), T(0.0)};
    }

    /// In the order of the turns about fixed axes, for an intrinsic sequence the reverse of the angles as they are
    /// listed.
    Vector<T> first, middle, last;
    T cosine_length, sine_length; ///< C and S
};

/// From where on an attitude counts as locked: where its margin is at most the lock margin, that is where tan(margin/2)
/// = min(C, S)/max(C, S) is at most tan(lock margin/2).
struct LockLimit {
    /// Margins that lock all attitudes at one end, though the other may be nearer.
    static constexpr double at_lower = -0x1p1000, at_upper = -0x1p1001;

    explicit LockLimit(double lock_margin) noexcept
        : locks_all(lock_margin >= 0.5 * exact_pi.hi || lock_margin <= at_lower),
          end(lock_margin <= at_lower ? lock_margin : 0.0) {
        if (lock_margin < 1e-9) {
            tangent = 0.5 * lock_margin;
        } else if (!locks_all) {
            const auto half = sine_cosine<DoubleDouble>(0.5 * lock_margin, AngleUnit::radians);
            tangent = half.sine / half.cosine;
        }
    }

    /// Whether lengths that are off by so much do not tell which side of it they are on.
    [[nodiscard]] bool is_doubtful(double cosine_length, double sine_length, double off) const noexcept {
        const double larger = larger_of(cosine_length, sine_length);
        const double smaller = -larger_of(-cosine_length, -sine_length);
        const double distance = smaller - tangent.hi * larger;
        return !locks_all && !(__builtin_fabs(distance) > off + 0x1p-50 * smaller);
    }

    bool locks_all;
    double end; ///< one of those, or 0
    DoubleDouble tangent;
};

template <class T> struct Lock {
    ROTCONV_INLINE Lock(const T& cosine_length, const T& sine_length, const LockLimit& limit) noexcept
        : upper(limit.end == 0.0 ? is_roughly_at_most(cosine_length, sine_length) : limit.end == LockLimit::at_upper) {
        const T smaller = select(upper, cosine_length, sine_length);
        const T larger = select(upper, sine_length, cosine_length);
        locked = limit.locks_all || is_at_most(smaller, rounded_to<T>(limit.tangent) * larger);
        // condition = 1/(sqrt 2 sin(margin/2)), with sin(margin/2) = smaller/hypot
        constexpr double factor = 2.0 * near_lock_condition * near_lock_condition;
        const double a = to_double(smaller);
        const double b = to_double(larger);
        nearly_locked = !locked && factor * (a * a) < a * a + b * b;
    }

    [[nodiscard]] ROTCONV_INLINE DiagnosticSet diagnostics() const noexcept {
        DiagnosticSet found{DiagnosticKind::gimbal_lock, locked};
        found |= {DiagnosticKind::near_gimbal_lock, nearly_locked};
        return found;
    }

    bool upper, locked, nearly_locked; ///< upper: the middle angle is nearer to its upper limit
};

/// The ranges of the angles of a SPEC.
struct AngleRanges {
    AngleRanges(const FixedAxes& axes, const Spec& spec) noexcept
        : half_turn(half_turn_in(spec.unit)), is_other(axes.proper && spec.sequence.sign(1) < 0.0),
          middle_factor(axes.proper ? 2.0 : spec.sequence.sign(1)),
          upper(scaled(half_turn, axes.proper ? 1.0 : 0.5 * spec.sequence.sign(1))),
          lower(axes.proper ? DoubleDouble() : -upper) {}

    /// In (-pi, pi] or (-180, 180], as it is printed.
    template <class T> [[nodiscard]] ROTCONV_INLINE T outer(const T& angle) const noexcept {
        if constexpr (std::is_same_v<T, Wide>) { // with what it has beside the number that is printed
            return printed(angle) <= -half_turn.hi ? angle + whole_turn<T>() : angle;
        } else {
            return select(printed(angle) <= -half_turn.hi, T(half_turn.hi), angle);
        }
    }
    /// In [0, 2 pi) or [0, 360), as it is printed: what rounds to the end is 0.
    template <class T> [[nodiscard]] T positive(const T& angle) const noexcept {
        const T positive = printed(angle) < 0.0 ? angle + whole_turn<T>() : angle;
        return printed(positive) >= 2.0 * half_turn.hi ? T(0.0) : positive;
    }
    template <class T> [[nodiscard]] T whole_turn() const noexcept {
        if constexpr (std::is_same_v<T, Wide>) {
            return scaled(Wide::half_turn(half_turn.hi == 180.0), 2.0);
        } else {
            return rounded_to<T>(scaled(half_turn, 2.0));
        }
    }
    template <class T> [[nodiscard]] ROTCONV_INLINE static double printed(const T& angle) noexcept {
        return to_double(angle);
    }
    /// Near the ends of ranges a doubt where it does not round clearly; 0 where it may be.
    [[nodiscard]] static double printed(const Wide& angle) noexcept {
        double nearest = 0.0;
        if (!angle.round(nearest) && __builtin_fabs(nearest) > 3.0) {
            Wide::Bits::doubt();
        }
        return nearest;
    }
    /// What the angle, or the same whole turns further, has beside the number that is printed.
    [[nodiscard]] double rest_of(DoubleDouble angle, double printed) const noexcept {
        const double beyond = printed - angle.hi; // about -1, 0 or 1 full turn
        const double turns = beyond > half_turn.hi ? 2.0 : beyond < -half_turn.hi ? -2.0 : 0.0;
        return (angle + scaled(half_turn, turns) - printed).hi;
    }

    DoubleDouble half_turn;
    bool is_other;             ///< of the two triples the one whose middle angle, of a proper sequence, is negative
    double middle_factor;      ///< from the angle of its vector to the middle angle
    DoubleDouble upper, lower; ///< limits of that
};

} // namespace ROTCONV_TARGET
} // namespace rotconv
