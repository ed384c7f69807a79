#include <rotconv/euler.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "finite.hpp"
#include "scaling.hpp"
#include "trigonometry.hpp"

namespace rotconv {

std::array<EulerSequence, 24> EulerSequence::all() noexcept {
    std::array<EulerSequence, 24> sequences;
    std::size_t count = 0;
    for (const char base : {'X', 'x'}) {
        for (int code = 0; code < 27; ++code) {
            const std::array<char, 3> letters{static_cast<char>(base + code / 9),
                                              static_cast<char>(base + code / 3 % 3),
                                              static_cast<char>(base + code % 3)};
            if (const auto sequence = parse({letters.data(), letters.size()})) {
                sequences[count++] = *sequence;
            }
        }
    }
    return sequences;
}

std::array<char, 3> EulerSequence::letters() const noexcept {
    const char base = intrinsic_ ? 'X' : 'x';
    return {static_cast<char>(base + axes_[0]), static_cast<char>(base + axes_[1]), static_cast<char>(base + axes_[2])};
}

namespace euler {
namespace {

/// The axes i, j, k of a sequence read as turns about fixed axes, the first turn about i. Intrinsic turns are the same
/// turns about fixed axes in reverse order. For a proper sequence k is the axis that does not occur.
struct FixedAxes {
    explicit FixedAxes(EulerSequence sequence) noexcept
        : i(sequence.axis(sequence.intrinsic() ? 2 : 0)), j(sequence.axis(1)),
          k(sequence.proper() ? 3 - i - j : sequence.axis(sequence.intrinsic() ? 0 : 2)),
          sign((j - i + 3) % 3 == 1 ? 1.0 : -1.0) {}

    int i, j, k;
    double sign; ///< +1 where (i, j, k) is an even permutation of (x, y, z)
};

/// a + ib = C e^(is), c + id = S e^(it), where s + t and s - t are the outer angles, and C, S are cosine and sine of
/// half the middle angle (of half the middle angle plus pi/4 for Tait-Bryan angles), times a common factor.
struct Halves {
    Halves(const Rotation& q, const FixedAxes& axes, bool proper) noexcept {
        const double qi = q.along(axes.i);
        const double qj = q.along(axes.j);
        const double qk = q.along(axes.k) * axes.sign;
        if (proper) {
            a = q.w();
            b = qi;
            c = qj;
            d = qk;
        } else {
            a = q.w() - qj;
            b = qi + qk;
            c = qj + q.w();
            d = qk - qi;
        }
        cosine = magnitude(a, b);
        sine = magnitude(c, d);
    }

    /// The smaller of C and S over their hypotenuse: sin(margin/2).
    [[nodiscard]] double sine_of_half_margin() const noexcept {
        return std::min(cosine, sine) / std::sqrt(cosine * cosine + sine * sine);
    }

    /// Margin at most `lock_margin`, which is compared through the tangent of its half.
    [[nodiscard]] bool locked(double lock_margin) const noexcept {
        const double smaller = std::min(cosine, sine);
        return smaller == 0.0 || lock_margin >= 0.5 * std::numbers::pi ||
               smaller <= tangent_of_half(lock_margin) * std::max(cosine, sine);
    }

    double a, b, c, d;
    double cosine, sine;

private:
    static double tangent_of_half(double angle) noexcept {
        return angle < 1e-8 ? 0.5 * angle : std::tan(0.5 * angle); // the same to an ulp, and quicker
    }

    /// hypot(u, v), where u and v are brought to a size that can be multiplied: only their ratio matters to the angles,
    /// and the length keeps its accuracy.
    static double magnitude(double& u, double& v) noexcept {
        const double square = u * u + v * v;
        if (square > 1e-280 || (u == 0.0 && v == 0.0)) {
            return std::sqrt(square);
        }
        const double length = std::hypot(u, v);
        const auto scale = PowerOfTwo::to_unit(largest_magnitude(u, v));
        u = scale(u);
        v = scale(v);
        return length;
    }
};

} // namespace

Reading to_rotation(const EulerAngles& value) noexcept {
    const auto& angles = value.angles;
    if (!all_finite(angles[0], angles[1], angles[2])) {
        return Reading::failed(Fault::not_finite);
    }
    const EulerSequence sequence = value.sequence;
    const FixedAxes axes(sequence);
    const HalfAngle first = half_of(angles[sequence.intrinsic() ? 2 : 0], value.unit);
    const HalfAngle second = half_of(angles[1], value.unit);
    const HalfAngle third = half_of(angles[sequence.intrinsic() ? 0 : 2], value.unit);

    const double cc = third.cosine * first.cosine;
    const double ss = third.sine * first.sine;
    const double sc = third.sine * first.cosine;
    const double cs = third.cosine * first.sine;
    double w = 0.0;
    std::array<double, 3> v{};
    const auto i = static_cast<std::size_t>(axes.i);
    const auto j = static_cast<std::size_t>(axes.j);
    const auto k = static_cast<std::size_t>(axes.k);
    if (sequence.proper()) {
        w = second.cosine * (cc - ss);
        v[i] = second.cosine * (sc + cs);
        v[j] = second.sine * (cc + ss);
        v[k] = axes.sign * (second.sine * (sc - cs));
    } else {
        w = second.cosine * cc + axes.sign * (second.sine * ss);
        v[i] = second.cosine * cs - axes.sign * (second.sine * sc);
        v[j] = second.sine * cc + axes.sign * (second.cosine * ss);
        v[k] = second.cosine * sc - axes.sign * (second.sine * cs);
    }
    return {.rotation = Rotation::from_components(w, v[0], v[1], v[2])};
}

EulerAngles from_rotation(const Rotation& rotation, EulerSequence sequence, AngleUnit unit,
                          double lock_margin) noexcept {
    const FixedAxes axes(sequence);
    const bool proper = sequence.proper();
    const Halves h(rotation, axes, proper);
    const double third_sign = proper ? 1.0 : axes.sign;
    double turned_first = 0.0; // about the fixed axis i
    double turned_second = 0.0;
    double turned_third = 0.0;
    if (h.locked(lock_margin)) {
        // Only s (where S = 0) or t (where C = 0) is defined; the angle that is not set to 0 is twice that.
        const bool sum = h.sine < h.cosine;
        const double real = sum ? h.a : h.c;
        const double imaginary = sum ? h.b : h.d;
        const double sine_of_double = 2.0 * (real * imaginary);
        const double cosine_of_double = (real - imaginary) * (real + imaginary);
        if (sequence.intrinsic()) {
            turned_third = angle_of(third_sign * sine_of_double, cosine_of_double, unit);
        } else {
            turned_first = angle_of(sum ? sine_of_double : -sine_of_double, cosine_of_double, unit);
        }
        const double limit = proper ? half_turn(unit) : 0.5 * half_turn(unit);
        turned_second = sum ? (proper ? 0.0 : -limit) : limit;
    } else {
        const double sine_of_double = 2.0 * h.cosine * h.sine;
        const double cosine_of_double = (h.cosine - h.sine) * (h.cosine + h.sine);
        turned_first = angle_of(h.b * h.c - h.a * h.d, h.a * h.c + h.b * h.d, unit);
        turned_second = proper ? angle_of(sine_of_double, cosine_of_double, unit)
                               : angle_of(-cosine_of_double, sine_of_double, unit);
        turned_third = angle_of(third_sign * (h.a * h.d + h.b * h.c), h.a * h.c - h.b * h.d, unit);
    }
    if (sequence.intrinsic()) {
        std::swap(turned_first, turned_third);
    }
    return {.angles = {turned_first, turned_second, turned_third}, .sequence = sequence, .unit = unit};
}

Notes notes(const Rotation& rotation, EulerSequence sequence, double lock_margin) noexcept {
    const Halves h(rotation, FixedAxes(sequence), sequence.proper());
    if (h.locked(lock_margin)) {
        return {Kind::gimbal_lock, true};
    }
    return {Kind::near_gimbal_lock, near_lock_condition * std::numbers::sqrt2 * h.sine_of_half_margin() < 1.0};
}

Figures figures(const Rotation& rotation, EulerSequence sequence) noexcept {
    const Halves h(rotation, FixedAxes(sequence), sequence.proper());
    return {.margin = 2.0 * std::atan2(std::min(h.cosine, h.sine), std::max(h.cosine, h.sine)),
            .condition = 1.0 / (std::numbers::sqrt2 * h.sine_of_half_margin())};
}

} // namespace euler
} // namespace rotconv
