#include "codec.hpp"
#include "elementary.hpp"
#include "scaling.hpp"

namespace rotconv::ROTCONV_EXACT {
namespace {

/// As in the plain codec: the axes i, j, k of the sequence read as turns about fixed axes, the first about i; k is the
/// axis that does not occur where first = third.
struct FixedAxes {
    explicit FixedAxes(const Spec& spec) noexcept {
        const int axes[] = {spec.sequence.axis(0), spec.sequence.axis(1), spec.sequence.axis(2)};
        proper = axes[0] == axes[2];
        first_place = spec.sequence.intrinsic() ? 2 : 0;
        i = axes[first_place];
        j = axes[1];
        k = proper ? 3 - i - j : axes[2 - first_place];
        sign = (j - i + 3) % 3 == 1 ? 1.0 : -1.0;
    }

    int i, j, k;
    double sign; ///< +1 where (i, j, k) is an even permutation of (x, y, z)
    bool proper;
    std::size_t first_place; ///< where the angle of the first turn stands among the numbers
};

/// a - b, and 0 where so much cancels that the rest is the operands' own error: 0 and lock are met exactly.
ROTCONV_INLINE Real clean_difference(Real a, Real b) noexcept {
    const Real difference = a - b;
    return choose(__builtin_fabs(difference.hi) <= 0x1p-97 * __builtin_fabs(a.hi), 0.0, difference);
}
ROTCONV_INLINE Real clean_sum(Real a, Real b) noexcept { return clean_difference(a, -b); }

void read(const Spec& spec, const double* numbers, std::size_t rows, Readings& readings) noexcept {
    const FixedAxes axes(spec);
    Column angles{};
    Column cosines[3];
    Column sines[3];
    for (std::size_t i = 0; i < rows; ++i) {
        const bool finite = all_finite(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
        readings.error[i] = finite ? Error::none : Error::not_finite;
        readings.defect[i] = 0.0;
    }
    for (std::size_t turn = 0; turn < 3; ++turn) {
        const std::size_t place = turn == 1 ? 1 : (turn == 0 ? axes.first_place : 2 - axes.first_place);
        for (std::size_t i = 0; i < rows; ++i) {
            angles.set(i, readings.error[i] == Error::none ? 0.5 * numbers[3 * i + place] : 0.0);
        }
        sine_cosine(angles, rows, spec.unit, cosines[turn], sines[turn]);
    }
    Column* const along[] = {&readings.x, &readings.y, &readings.z};
    Column& along_i = *along[axes.i];
    Column& along_j = *along[axes.j];
    Column& along_k = *along[axes.k];
    for (std::size_t i = 0; i < rows; ++i) {
        const Real cc = cosines[2][i] * cosines[0][i];
        const Real ss = sines[2][i] * sines[0][i];
        const Real sc = sines[2][i] * cosines[0][i];
        const Real cs = cosines[2][i] * sines[0][i];
        const Real c = cosines[1][i];
        const Real s = sines[1][i];
        const Real signed_s = scaled(s, axes.sign);
        if (axes.proper) {
            readings.w.set(i, c * clean_difference(cc, ss));
            along_i.set(i, c * clean_sum(sc, cs));
            along_j.set(i, s * clean_sum(cc, ss));
            along_k.set(i, signed_s * clean_difference(sc, cs));
        } else {
            readings.w.set(i, clean_sum(c * cc, signed_s * ss));
            along_i.set(i, clean_difference(c * cs, signed_s * sc));
            along_j.set(i, clean_sum(s * cc, scaled(c, axes.sign) * ss));
            along_k.set(i, clean_difference(c * sc, signed_s * cs));
        }
    }
}

/// tan(lock margin/2); infinite from pi/2 on.
double tangent_of_half(double lock_margin) noexcept {
    if (lock_margin >= 0.5 * pi.hi) {
        return __builtin_inf();
    }
    Column half{};
    Column cosine{};
    Column sine{};
    half.set(0, 0.5 * lock_margin);
    sine_cosine(half, 1, AngleUnit::radians, cosine, sine);
    return (sine[0] / cosine[0]).hi;
}

/// A vector times a power of two, the larger component of size 1/2 to 1, and its length without it.
struct ScaledVector {
    ROTCONV_INLINE ScaledVector(Real x_, Real y_) noexcept {
        const Scale scale = scale_to_unit(largest_magnitude(x_.hi, y_.hi, 0.0));
        x = scaled(x_, scale.there);
        y = scaled(y_, scale.there);
        length = scaled(root(quick_sum(square(x), square(y))), scale.back);
    }

    Real x, y, length;
};

/// The vectors whose angles are the middle one and the outer ones.
struct Vectors {
    Column x{}, y{};
};

void write(const Spec& spec, double lock_margin, const Rotations& rotations, std::size_t rows, double* numbers,
           DiagnosticSet* diagnostics) noexcept {
    const FixedAxes axes(spec);
    const bool proper = axes.proper;
    const double third_sign = proper ? 1.0 : axes.sign;
    const double lock_tangent = tangent_of_half(lock_margin);
    const Column* const along[] = {&rotations.x, &rotations.y, &rotations.z};
    const Column& along_i = *along[axes.i];
    const Column& along_j = *along[axes.j];
    const Column& along_k = *along[axes.k];
    Vectors first;
    Vectors middle;
    Vectors third;
    double sine_length[batch_rows];
    double cosine_length[batch_rows];
    // a + ib = C e^(is), c + id = S e^(it), where s + t and s - t are the outer angles, and C, S are cosine and sine of
    // m/2, m the middle angle (of m/2 + pi/4 for Tait-Bryan angles), times a common factor
    for (std::size_t i = 0; i < rows; ++i) {
        const Real w = rotations.w[i];
        const Real qi = along_i[i];
        const Real qj = along_j[i];
        const Real qk = scaled(along_k[i], axes.sign);
        const ScaledVector ab(proper ? w : clean_difference(w, qj), proper ? qi : clean_sum(qi, qk));
        const ScaledVector cd(proper ? qj : clean_sum(qj, w), proper ? qk : clean_difference(qk, qi));
        const Real ac = ab.x * cd.x;
        const Real bd = ab.y * cd.y;
        const Real bc = ab.y * cd.x;
        const Real ad = ab.x * cd.y;
        const Real difference = clean_difference(bc, ad);
        const Real sum = clean_sum(bc, ad);
        first.x.set(i, clean_sum(ac, bd));
        first.y.set(i, difference);
        third.x.set(i, clean_difference(ac, bd));
        third.y.set(i, scaled(sum, third_sign));
        // a Tait-Bryan angle by its own tangent, (S^2 - C^2)/(2 S C): near 0 it keeps its digits
        middle.x.set(i, proper ? ab.length : ab.length * cd.length);
        middle.y.set(i, proper ? cd.length : scaled(clean_difference(w * qj, qi * qk), 2.0));
        cosine_length[i] = ab.length.hi;
        sine_length[i] = cd.length.hi;
    }
    for (std::size_t i = 0; i < rows; ++i) {
        const bool upper = cosine_length[i] <= sine_length[i];
        const double smaller = upper ? cosine_length[i] : sine_length[i];
        const double larger = upper ? sine_length[i] : cosine_length[i];
        constexpr double factor = 2.0 * near_lock_condition * near_lock_condition;
        const bool locked = smaller == 0.0 || smaller <= lock_tangent * larger;
        const bool nearly = !locked && factor * (smaller * smaller) < smaller * smaller + larger * larger;
        diagnostics[i] = {DiagnosticKind::gimbal_lock, locked};
        diagnostics[i] |= {DiagnosticKind::near_gimbal_lock, nearly};
        if (locked) { // only s (where S = 0) or t (where C = 0) is defined; the angle that is not set to 0 is twice
                      // that
            const Real w = rotations.w[i];
            const Real qi = along_i[i];
            const Real qj = along_j[i];
            const Real qk = scaled(along_k[i], axes.sign);
            const bool sum = !upper;
            const Real x = sum ? (proper ? w : w - qj) : (proper ? qj : qj + w);
            const Real y = sum ? (proper ? qi : qi + qk) : (proper ? qk : qk - qi);
            const double sign = spec.sequence.intrinsic() ? third_sign : (sum ? 1.0 : -1.0);
            // the first of the numbers is that of the last fixed turn where the turns are intrinsic
            Vectors& free = axes.first_place == 0 ? first : third;
            Vectors& fixed = axes.first_place == 0 ? third : first;
            free.x.set(i, clean_difference(x, y) * clean_sum(x, y));
            free.y.set(i, scaled(x * y, 2.0 * sign));
            fixed.x.set(i, 1.0);
            fixed.y.set(i, 0.0);
        }
    }
    const AngleUnit unit = spec.unit;
    const double half_turn = half_turn_in(unit).hi;
    const double middle_factor = proper ? 2.0 : 1.0;
    Column angles[3];
    angles_of(first.x, first.y, rows, unit, angles[axes.first_place]);
    angles_of(middle.x, middle.y, rows, unit, angles[1]);
    angles_of(third.x, third.y, rows, unit, angles[2 - axes.first_place]);
    const double upper_limit = (proper ? 1.0 : 0.5) * half_turn;
    const double lower_limit = proper ? 0.0 : -upper_limit;
    for (std::size_t i = 0; i < rows; ++i) {
        const double e1 = angles[0].hi[i];
        const double e3 = angles[2].hi[i];
        numbers[3 * i] = e1 <= -half_turn ? half_turn : e1;
        numbers[3 * i + 1] = middle_factor * angles[1].hi[i];
        numbers[3 * i + 2] = e3 <= -half_turn ? half_turn : e3;
    }
    for (std::size_t i = 0; i < rows; ++i) {
        if (diagnostics[i].has(DiagnosticKind::gimbal_lock)) {
            numbers[3 * i + 1] = cosine_length[i] <= sine_length[i] ? upper_limit : lower_limit;
        }
    }
}

} // namespace

constinit const ExactCodec codecs::euler{.read = read, .write = write};
constinit const ExactCodec codecs::rpy{.read = read, .write = write};

} // namespace rotconv::ROTCONV_EXACT
