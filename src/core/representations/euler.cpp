#include <rotconv/euler.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "../numerics/angles.hpp"
#include "../numerics/double_double.hpp"
#include "../numerics/scaling.hpp"
#include "../numerics/trigonometry.hpp"
#include "codec.hpp"

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
/// m/2, m the middle angle (of m/2 + pi/4 for Tait-Bryan angles), times a common factor. Beside C and S only the ratios
/// a : b and c : d matter, so that these are brought to lengths between 1/2 and 1.
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
        cosine = take_length(a, b);
        sine = take_length(c, d);
    }

    /// The smaller of C and S over their hypotenuse: sin(margin/2).
    [[nodiscard]] double sine_of_half_margin() const noexcept {
        return std::min(cosine, sine) / std::sqrt(cosine * cosine + sine * sine);
    }

    /// Margin <= lock margin, as tan(margin/2) = min(C, S)/max(C, S) <= tan(lock margin/2).
    [[nodiscard]] bool locked(double lock_tangent) const noexcept {
        const double smaller = std::min(cosine, sine);
        return smaller == 0.0 || smaller <= lock_tangent * std::max(cosine, sine);
    }

    double a, b, c, d;
    double cosine, sine;

private:
    /// hypot(u, v); divides u and v by the power of two next to it.
    static double take_length(double& u, double& v) noexcept {
        const double square = u * u + v * v;
        const double length = square > 1e-280 ? std::sqrt(square) : std::hypot(u, v);
        if (length > 0.0) {
            const auto scale = PowerOfTwo::to_unit(length);
            u = scale(u);
            v = scale(v);
        }
        return length;
    }
};

double tangent_of_half(double lock_margin) noexcept {
    return lock_margin >= 0.5 * std::numbers::pi ? std::numeric_limits<double>::infinity()
                                                 : std::tan(0.5 * lock_margin);
}

DiagnosticSet diagnostics_of(const Halves& h, bool locked) noexcept {
    if (locked) {
        return {DiagnosticKind::gimbal_lock, true};
    }
    // condition = 1/(sqrt 2 sin(margin/2)), with sin(margin/2) = smaller/hypot
    const double smaller = std::min(h.cosine, h.sine);
    const double square = h.cosine * h.cosine + h.sine * h.sine;
    constexpr double factor = 2.0 * near_lock_condition * near_lock_condition;
    return {DiagnosticKind::near_gimbal_lock, factor * (smaller * smaller) < square};
}

/// Only s (where S = 0) or t (where C = 0) is defined; the angle that is not set to 0 is twice that.
std::array<double, 3> locked_angles(const Halves& h, EulerSequence sequence, const FixedAxes& axes,
                                    AngleUnit unit) noexcept {
    const bool proper = sequence.proper();
    const bool sum = h.sine < h.cosine;
    const double real = sum ? h.a : h.c;
    const double imaginary = sum ? h.b : h.d;
    const double sine_of_double = 2.0 * (real * imaginary);
    const double cosine_of_double = (real - imaginary) * (real + imaginary);
    const double limit = (proper ? 1.0 : 0.5) * pi_in(unit).hi;
    const double middle = sum ? (proper ? 0.0 : -limit) : limit;
    // Intrinsic turns are the fixed ones in reverse order: there it is the last fixed turn that comes first.
    const double third_sign = proper ? 1.0 : axes.sign;
    const double sign = sequence.intrinsic() ? third_sign : (sum ? 1.0 : -1.0);
    return {angle_of(sign * sine_of_double, cosine_of_double, unit), middle, 0.0};
}

/// Vectors of a batch_rows, and their angles.
struct Turns {
    PlaneVectors vectors;
    Angles angles;

    void set(std::size_t row, double x, double y) noexcept {
        vectors.x[row] = x;
        vectors.y[row] = y;
    }

    /// In (-pi, pi] or (-180, 180].
    [[nodiscard]] double outer_angle(std::size_t row, double limit) const noexcept {
        const double angle = angles.hi[row] + angles.lo[row];
        const double with_sign = vectors.y[row] < 0.0 ? -angle : angle;
        return with_sign <= -limit ? limit : with_sign;
    }
};

ROTCONV_TARGET_CLONES void write(const Spec& spec, double lock_margin, const Rotations& rotations, std::size_t rows,
                                 double* numbers, DiagnosticSet* diagnostics) noexcept {
    const EulerSequence sequence = spec.sequence;
    const AngleUnit unit = spec.unit;
    if (rows == 0) {
        return;
    }
    const FixedAxes axes(sequence);
    const bool proper = sequence.proper();
    const double third_sign = proper ? 1.0 : axes.sign;
    const double lock_tangent = tangent_of_half(lock_margin);
    Turns first;  // NOLINT(*-member-init): written before they are read
    Turns middle; // NOLINT(*-member-init)
    Turns third;  // NOLINT(*-member-init)
    // Squared lengths below this (of up to 8) are looked at one by one: locked, nearly so, or too small for plain
    // products.
    const double suspect_square =
        8.0 * std::max(lock_tangent * lock_tangent, 1.0 / (near_lock_condition * near_lock_condition));
    const std::array<const double*, 3> along{rotations.x.data(), rotations.y.data(), rotations.z.data()};
    const double* const w = rotations.w.data();
    const double* const qi = along[static_cast<std::size_t>(axes.i)];
    const double* const qj = along[static_cast<std::size_t>(axes.j)];
    const double* const qk = along[static_cast<std::size_t>(axes.k)];
    for (std::size_t i = 0; i < rows; ++i) { // a, b, c, d as in Halves
        const double d_part = axes.sign * qk[i];
        const double a = proper ? w[i] : w[i] - qj[i];
        const double b = proper ? qi[i] : qi[i] + d_part;
        const double c = proper ? qj[i] : qj[i] + w[i];
        const double d = proper ? d_part : d_part - qi[i];
        first.vectors.x[i] = a * c + b * d;
        first.vectors.y[i] = b * c - a * d;
        third.vectors.x[i] = a * c - b * d;
        third.vectors.y[i] = third_sign * (a * d + b * c);
        const double cosine_square = a * a + b * b;
        const double sine_square = c * c + d * d;
        middle.vectors.x[i] = cosine_square;
        middle.vectors.y[i] = sine_square;
        middle.vectors.sine[i] = std::sqrt(std::min(cosine_square, sine_square) / (cosine_square + sine_square));
    }
    for (std::size_t i = 0; i < rows; ++i) {
        const double smaller = std::min(middle.vectors.x[i], middle.vectors.y[i]);
        if (smaller <= suspect_square) [[unlikely]] {
            const Halves h(rotations.at(i), axes, proper);
            const bool locked = h.locked(lock_tangent);
            diagnostics[i] = diagnostics_of(h, locked);
            if (!locked) { // again, with (a, b) and (c, d) near 1
                first.set(i, h.a * h.c + h.b * h.d, h.b * h.c - h.a * h.d);
                third.set(i, h.a * h.c - h.b * h.d, third_sign * (h.a * h.d + h.b * h.c));
                middle.vectors.sine[i] = h.sine_of_half_margin();
            }
        }
    }
    first.vectors.set_sines(rows);
    third.vectors.set_sines(rows);
    angles_of(first.vectors, rows, unit, first.angles);
    angles_of(middle.vectors, rows, unit, middle.angles);
    angles_of(third.vectors, rows, unit, third.angles);
    const DoubleDouble half_turn_exact = pi_in(unit);
    const double limit = half_turn_exact.hi;
    const double quarters = proper ? 0.0 : 0.5; // of a half-turn, from half the middle angle to the middle angle
    const std::size_t first_place = sequence.intrinsic() ? 2 : 0;
    for (std::size_t i = 0; i < rows; ++i) {
        const DoubleDouble turned = exact_sum(2.0 * middle.angles.hi[i], -quarters * half_turn_exact.hi);
        numbers[3 * i + first_place] = first.outer_angle(i, limit);
        numbers[3 * i + 1] = turned.hi + (turned.lo + (2.0 * middle.angles.lo[i] - quarters * half_turn_exact.lo));
        numbers[3 * i + 2 - first_place] = third.outer_angle(i, limit);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        if (diagnostics[i].has(DiagnosticKind::gimbal_lock)) {
            const auto angles = locked_angles(Halves(rotations.at(i), axes, proper), sequence, axes, unit);
            std::ranges::copy(angles, numbers + 3 * i);
        }
    }
}

/// The axis of one outer turn, `near`, is fixed in the frame. Then w = near' e_n + R_n (middle' e_m + R_m far' e_f)
/// with R_n and R_m turns about the axes n and m, inverse in body axes, and e_f = e_k, or e_n for a proper sequence.
struct RateSystem {
    RateSystem(const EulerAngles& value, Frame frame) noexcept
        : near(value.sequence.intrinsic() == (frame == Frame::body) ? 2 : 0), far(2 - near),
          n(value.sequence.axis(static_cast<std::size_t>(near))), m(value.sequence.axis(1)), k(3 - n - m) {
        const double order = (m - n + 3) % 3 == 1 ? 1.0 : -1.0; // e_n x e_m = order e_k
        const double sense = frame == Frame::body ? -order : order;
        const Direction outer = direction_of(value.angles[near], value.unit);
        const Direction middle = direction_of(value.angles[1], value.unit);
        cosine = outer.cosine;
        sine = sense * outer.sine;
        far_along = value.sequence.proper() ? middle.cosine : sense * middle.sine;
        far_across = value.sequence.proper() ? -sense * middle.sine : middle.cosine;
    }

    int near, far;                // places of the outer turns
    int n, m, k;                  // axes
    double cosine, sine;          // of R_n in the plane from m to k
    double far_along, far_across; // components of R_m e_f along n and k
};

} // namespace

Reading to_rotation(const EulerAngles& value) noexcept {
    const auto& angles = value.angles;
    if (!angles.allFinite()) {
        return Error::not_finite;
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
    return Rotation::from_components(w, v[0], v[1], v[2]);
}

EulerAngles from_rotation(const Rotation& rotation, EulerSequence sequence, AngleUnit unit,
                          double lock_margin) noexcept {
    EulerAngles result{.sequence = sequence, .unit = unit};
    codecs::euler.write_row({.sequence = sequence, .unit = unit}, rotation, result.angles.data(), lock_margin);
    return result;
}

DiagnosticSet diagnostics(const Rotation& rotation, EulerSequence sequence, double lock_margin) noexcept {
    const Halves h(rotation, FixedAxes(sequence), sequence.proper());
    return diagnostics_of(h, h.locked(tangent_of_half(lock_margin)));
}

Sensitivity sensitivity(const Rotation& rotation, EulerSequence sequence) noexcept {
    const Halves h(rotation, FixedAxes(sequence), sequence.proper());
    return {.margin = 2.0 * std::atan2(std::min(h.cosine, h.sine), std::max(h.cosine, h.sine)),
            .condition = 1.0 / (std::numbers::sqrt2 * h.sine_of_half_margin())};
}

Eigen::Vector3d rate(const EulerAngles& value, const Eigen::Vector3d& w, Frame frame) noexcept {
    const RateSystem s(value, frame);
    const double across = s.cosine * w[s.k] - s.sine * w[s.m];
    Eigen::Vector3d rates;
    rates[s.far] = across / s.far_across;
    rates[1] = s.cosine * w[s.m] + s.sine * w[s.k];
    rates[s.near] = w[s.n] - s.far_along * rates[s.far];
    return rates * units_per_radian(value.unit);
}

Eigen::Vector3d angular_velocity(const EulerAngles& value, const Eigen::Vector3d& rates, Frame frame) noexcept {
    const RateSystem s(value, frame);
    const double across = s.far_across * rates[s.far];
    Eigen::Vector3d w;
    w[s.n] = rates[s.near] + s.far_along * rates[s.far];
    w[s.m] = s.cosine * rates[1] - s.sine * across;
    w[s.k] = s.cosine * across + s.sine * rates[1];
    return w / units_per_radian(value.unit);
}

} // namespace euler

namespace {

EulerAngles value_of(const Spec& spec, const double* v) noexcept {
    return {{v[0], v[1], v[2]}, spec.sequence, spec.unit};
}

/// One of the two triples of an attitude: the canonical one with whole turns, or a + pi, pi - b, c + pi (-b where first
/// = third).
struct Triple {
    Triple(const Spec& spec, bool is_other, const double* last, const double* v) noexcept
        : middle_sign(is_other ? -1.0 : 1.0) {
        const double pi = pi_in(spec.unit).hi;
        for (std::size_t i = 0; i < 3; ++i) {
            const double odd = is_other && !(i == 1 && spec.sequence.proper()) ? 1.0 : 0.0;
            const double way = last[i] - ((i == 1 ? middle_sign : 1.0) * v[i] + odd * pi);
            const double turns = nearest_turns(way, spec.unit);
            half_turns[i] = 2.0 * turns + odd;
            distance += (way - 2.0 * turns * pi) * (way - 2.0 * turns * pi);
        }
    }

    double middle_sign;
    std::array<double, 3> half_turns{}; ///< to be added to the angles
    double distance = 0.0;              ///< to the last numbers, squared
};

void nearest(const Spec& spec, const double* last, DiagnosticSet diagnostics, double* v) noexcept {
    const AngleUnit unit = spec.unit;
    if (diagnostics.has(DiagnosticKind::gimbal_lock)) { // only the sum or the difference of the outer angles counts
        const euler::FixedAxes axes(spec.sequence);
        const bool is_low = v[1] < (spec.sequence.proper() ? 0.5 * pi_in(unit).hi : 0.0);
        const double sum_sign = is_low == (spec.sequence.proper() || axes.sign > 0.0) ? 1.0 : -1.0;
        const DoubleDouble first = exact_sum(v[0], sum_sign * (v[2] - last[2]));
        v[0] = plus_half_turns(first, 2.0 * nearest_turns(last[0] - first.hi, unit), unit).hi;
        v[1] = plus_half_turns({v[1], 0.0}, 2.0 * nearest_turns(last[1] - v[1], unit), unit).hi;
        v[2] = last[2];
        return;
    }
    const double pi = pi_in(unit).hi;
    Triple chosen(spec, false, last, v);
    // Two outer angles of the other triple are half a turn or more away from these.
    if (chosen.distance >= 0.49 * (pi * pi)) {
        const Triple other(spec, true, last, v);
        chosen = other.distance < chosen.distance ? other : chosen;
    }
    v[1] = chosen.middle_sign * v[1] + 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (chosen.half_turns[i] != 0.0) {
            v[i] = plus_half_turns({v[i], 0.0}, chosen.half_turns[i], unit).hi;
        }
    }
}

double distance_to_lock(const Spec& spec, const double* v) noexcept {
    using std::numbers::pi;
    return spec.sequence.proper() ? std::min(v[1], pi - v[1]) : 0.5 * pi - std::fabs(v[1]);
}

/// The outer angles by whole turns.
void wrap(double* v) noexcept {
    v[0] = without_turns(v[0]);
    v[2] = without_turns(v[2]);
}

constexpr Codec codec_of_angles(const Representation& representation) noexcept {
    return {
        .representation = representation,
        .read = read_each<Eigen::Vector3d, euler::to_rotation, value_of>,
        .write = euler::write,
        .sensitivity = [](const Spec& spec,
                          const Rotation& rotation) noexcept { return euler::sensitivity(rotation, spec.sequence); },
        .nearest = nearest,
        .rate = rate_of<Eigen::Vector3d, euler::rate, value_of>,
        .angular_velocity = angular_velocity_of<Eigen::Vector3d, euler::angular_velocity, value_of>,
        .greatest_distance = 0.5 * std::numbers::pi,
        .distance_to_singularity = distance_to_lock,
        .switch_chart = wrap};
}

} // namespace

constinit const Codec codecs::euler = codec_of_angles(
    {.name = RepresentationId::euler,
     .text = "euler",
     .size = 3,
     .columns = {"e1", "e2", "e3"},
     .modifiers = {Modifier::passive, Modifier::deg},
     .takes_sequence = true,
     .has_gimbal_lock = true,
     .range = "1st, 3rd in (-pi, pi]; 2nd in [-pi/2, pi/2] (ABC) or [0, pi] (ABA)",
     .singular = "gimbal lock: 2nd at its limit",
     .singular_attitude = "gimbal lock",
     .formula = "ABC: R = R_A(e1) R_B(e2) R_C(e3), own axes; abc: R = R_c(e3) R_b(e2) R_a(e1), fixed axes"});

constinit const Codec codecs::rpy = codec_of_angles({.name = RepresentationId::rpy,
                                                     .text = "rpy",
                                                     .size = 3,
                                                     .columns = {"roll", "pitch", "yaw"},
                                                     .modifiers = {Modifier::passive, Modifier::deg},
                                                     .has_gimbal_lock = true,
                                                     .range = "roll, yaw in (-pi, pi]; pitch in [-pi/2, pi/2]",
                                                     .singular = "gimbal lock: pitch at its limit",
                                                     .singular_attitude = "gimbal lock",
                                                     .formula = "R = R_z(yaw) R_y(pitch) R_x(roll)"});

} // namespace rotconv
