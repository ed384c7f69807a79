#include "../numerics/elementary.hpp"
#include "../representations/fixed_axes.hpp"
#include "codec.hpp"
#include "scaling.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

/// a - b, and 0 where so much cancels that the rest is the operands' own error: 0 and lock are met exactly.
ROTCONV_INLINE Real clean_difference(Real a, Real b) noexcept {
    const Real difference = a - b;
    return choose(__builtin_fabs(difference.hi) <= 0x1p-97 * __builtin_fabs(a.hi), 0.0, difference);
}
ROTCONV_INLINE double clean_difference(double a, double b) noexcept { return a - b; }
template <class T> ROTCONV_INLINE T clean_sum(T a, T b) noexcept { return clean_difference(a, -b); }

template <class T>
void read(const Spec& spec, const double* numbers, std::size_t rows, BasicReadings<T>& readings) noexcept {
    const FixedAxes axes(spec.sequence);
    Column<Real> angles;
    Column<T> cosines[3];
    Column<T> sines[3];
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
    Column<T>* const along[] = {&readings.x, &readings.y, &readings.z};
    Column<T>& along_i = *along[axes.i];
    Column<T>& along_j = *along[axes.j];
    Column<T>& along_k = *along[axes.k];
    for (std::size_t i = 0; i < rows; ++i) {
        const T cc = cosines[2][i] * cosines[0][i];
        const T ss = sines[2][i] * sines[0][i];
        const T sc = sines[2][i] * cosines[0][i];
        const T cs = cosines[2][i] * sines[0][i];
        const T c = cosines[1][i];
        const T s = sines[1][i];
        const T signed_s = scaled(s, axes.sign);
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
    if (lock_margin >= 0.5 * exact_pi.hi) {
        return __builtin_inf();
    }
    const auto half = sine_cosine<Real>(0.5 * lock_margin, AngleUnit::radians);
    return (half.sine / half.cosine).hi;
}

/// The vectors whose angles are the middle one and the outer ones.
template <class T> struct Vectors { Column<T> x, y; };

template <class T> void write(const Spec& spec, double lock_margin, const BasicRotations<T>& rotations,
                              std::size_t rows, double* numbers, DiagnosticSet* diagnostics) noexcept {
    const FixedAxes axes(spec.sequence);
    const bool proper = axes.proper;
    const double third_sign = proper ? 1.0 : axes.sign;
    const double lock_tangent = tangent_of_half(lock_margin);
    const Column<T>* const along[] = {&rotations.x, &rotations.y, &rotations.z};
    const Column<T>& along_i = *along[axes.i];
    const Column<T>& along_j = *along[axes.j];
    const Column<T>& along_k = *along[axes.k];
    Vectors<T> first;
    Vectors<T> middle;
    Vectors<T> third;
    double sine_length[batch_rows];
    double cosine_length[batch_rows];
    // a + ib = C e^(is), c + id = S e^(it), where s + t and s - t are the outer angles, and C, S are cosine and sine of
    // m/2, m the middle angle (of m/2 + pi/4 for Tait-Bryan angles), times a common factor
    for (std::size_t i = 0; i < rows; ++i) {
        const T w = rotations.w[i];
        const T qi = along_i[i];
        const T qj = along_j[i];
        const T qk = scaled(along_k[i], axes.sign);
        const ScaledVector<T> ab(proper ? w : clean_difference(w, qj), proper ? qi : clean_sum(qi, qk));
        const ScaledVector<T> cd(proper ? qj : clean_sum(qj, w), proper ? qk : clean_difference(qk, qi));
        const T ac = ab.x * cd.x;
        const T bd = ab.y * cd.y;
        const T bc = ab.y * cd.x;
        const T ad = ab.x * cd.y;
        const T difference = clean_difference(bc, ad);
        const T sum = clean_sum(bc, ad);
        first.x.set(i, clean_sum(ac, bd));
        first.y.set(i, difference);
        third.x.set(i, clean_difference(ac, bd));
        third.y.set(i, scaled(sum, third_sign));
        // a Tait-Bryan angle by its own tangent, (S^2 - C^2)/(2 S C): near 0 it keeps its digits
        middle.x.set(i, proper ? ab.length : ab.length * cd.length);
        middle.y.set(i, proper ? cd.length : scaled(clean_difference(w * qj, qi * qk), 2.0));
        cosine_length[i] = nearly(ab.length);
        sine_length[i] = nearly(cd.length);
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
            const T w = rotations.w[i];
            const T qi = along_i[i];
            const T qj = along_j[i];
            const T qk = scaled(along_k[i], axes.sign);
            const bool sum = !upper;
            const T x = sum ? (proper ? w : w - qj) : (proper ? qj : qj + w);
            const T y = sum ? (proper ? qi : qi + qk) : (proper ? qk : qk - qi);
            const double sign = spec.sequence.intrinsic() ? third_sign : (sum ? 1.0 : -1.0);
            // the first of the numbers is that of the last fixed turn where the turns are intrinsic
            Vectors<T>& free = axes.first_place == 0 ? first : third;
            Vectors<T>& fixed = axes.first_place == 0 ? third : first;
            free.x.set(i, clean_difference(x, y) * clean_sum(x, y));
            free.y.set(i, scaled(x * y, 2.0 * sign));
            fixed.x.set(i, 1.0);
            fixed.y.set(i, 0.0);
        }
    }
    const AngleUnit unit = spec.unit;
    const double half_turn = half_turn_in(unit).hi;
    const double middle_factor = proper ? 2.0 : 1.0;
    Column<Real> angles[3];
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

constinit const BatchCodec batch_codecs::euler{.fast = {.read = read<double>, .write = write<double>},
                                               .exact = {.read = read<Real>, .write = write<Real>}};
constinit const BatchCodec batch_codecs::rpy{.fast = {.read = read<double>, .write = write<double>},
                                             .exact = {.read = read<Real>, .write = write<Real>}};

} // namespace ROTCONV_TARGET
} // namespace rotconv
