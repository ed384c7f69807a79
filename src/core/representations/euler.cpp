#include <rotconv/euler.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "../numerics/angles.hpp"
#include "../numerics/exact_number.hpp"
#include "../numerics/power_of_two.hpp"
#include "codec.hpp"
#include "euler_formulas.hpp"

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

std::string EulerSequence::text() const {
    std::string text;
    for (std::size_t i = 0; i < 3; ++i) {
        text += signs_[i] < 0 ? "-" : "";
        text += static_cast<char>((intrinsic_ ? 'X' : 'x') + axes_[i]);
    }
    return text;
}

namespace euler {
namespace {

Eigen::Vector3d signed_by(EulerSequence sequence, const Eigen::Vector3d& numbers) noexcept {
    return {sequence.sign(0) * numbers[0], sequence.sign(1) * numbers[1], sequence.sign(2) * numbers[2]};
}

/// The axis of one outer turn, `near`, is fixed in the frame. Then w = near' e_n + R_n (middle' e_m + R_m far' e_f)
/// with R_n and R_m turns about the axes n and m, inverse in body axes, and e_f = e_k, or e_n for a proper sequence.
struct RateSystem {
    RateSystem(const EulerAngles& value, Frame frame) noexcept
        : near(value.sequence.intrinsic() == (frame == Frame::body) ? 2 : 0), far(2 - near),
          n(value.sequence.axis(static_cast<std::size_t>(near))), m(value.sequence.axis(1)), k(3 - n - m) {
        const double order = (m - n + 3) % 3 == 1 ? 1.0 : -1.0; // e_n x e_m = order e_k
        const double sense = frame == Frame::body ? -order : order;
        const Eigen::Vector3d angles = signed_by(value.sequence, value.angles);
        const auto outer = sine_cosine<double>(angles[near], value.unit);
        const auto middle = sine_cosine<double>(angles[1], value.unit);
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

Sensitivity sensitivity_of(double cosine_length, double sine_length) noexcept {
    const double smaller = std::min(cosine_length, sine_length);
    const double larger = std::max(cosine_length, sine_length);
    return {.margin = 2.0 * angle_of(larger, smaller, AngleUnit::radians).hi,
            .condition = std::sqrt(smaller * smaller + larger * larger) / (std::numbers::sqrt2 * smaller)};
}

} // namespace

Reading to_rotation(const EulerAngles& value) noexcept {
    return read_row({.name = RepresentationId::euler, .sequence = value.sequence, .unit = value.unit},
                    value.angles.data());
}

EulerAngles from_rotation(const Rotation& rotation, EulerSequence sequence, AngleUnit unit,
                          double lock_margin) noexcept {
    EulerAngles result(Eigen::Vector3d::Zero(), sequence, unit);
    write_row({.name = RepresentationId::euler, .sequence = sequence, .unit = unit}, rotation, result.angles.data(),
              lock_margin);
    return result;
}

DiagnosticSet diagnostics(const Rotation& rotation, EulerSequence sequence, double lock_margin) noexcept {
    std::array<double, 3> angles{};
    return write_row({.name = RepresentationId::euler, .sequence = sequence}, rotation, angles.data(), lock_margin);
}

Sensitivity sensitivity(const Rotation& rotation, EulerSequence sequence) noexcept {
    const FixedAxes axes(sequence);
    const std::array<double, 4> q{rotation.w(), rotation.along(axes.i), rotation.along(axes.j), rotation.along(axes.k)};
    if (std::ranges::all_of(q, is_plain_component)) {
        const TurnVectors<double> vectors(axes, {q[0], q[1], q[2], q[3]});
        return sensitivity_of(vectors.cosine_length, vectors.sine_length);
    }
    const TurnVectors<Wide> vectors(axes, {q[0], q[1], q[2], q[3]});
    return sensitivity_of(to_double(vectors.cosine_length), to_double(vectors.sine_length));
}

Eigen::Vector3d rate(const EulerAngles& value, const Eigen::Vector3d& w, Frame frame) noexcept {
    const RateSystem s(value, frame);
    const double across = s.cosine * w[s.k] - s.sine * w[s.m];
    Eigen::Vector3d rates;
    rates[s.far] = across / s.far_across;
    rates[1] = s.cosine * w[s.m] + s.sine * w[s.k];
    rates[s.near] = w[s.n] - s.far_along * rates[s.far];
    return signed_by(value.sequence, rates) * units_per_radian(value.unit);
}

Eigen::Vector3d angular_velocity(const EulerAngles& value, const Eigen::Vector3d& rates, Frame frame) noexcept {
    const RateSystem s(value, frame);
    const Eigen::Vector3d turning = signed_by(value.sequence, rates);
    const double across = s.far_across * turning[s.far];
    Eigen::Vector3d w;
    w[s.n] = turning[s.near] + s.far_along * turning[s.far];
    w[s.m] = s.cosine * turning[1] - s.sine * across;
    w[s.k] = s.cosine * across + s.sine * turning[1];
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
        const double pi = half_turn_in(spec.unit).hi;
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

/// Below so many squared half turns a triple is the nearest: two outer angles of the other are half a turn or more
/// away.
constexpr double near_enough = 0.49;

template <class T> bool choose(const Spec& spec, const double* last, DiagnosticSet diagnostics,
                               std::span<const double> rest, double* v) noexcept {
    const AngleUnit unit = spec.unit;
    const std::size_t rest_size = rest.size() / 3;
    const auto number = [&](std::size_t i) { return exact_number<T>(v[i], rest.subspan(i * rest_size, rest_size)); };
    const std::array<T, 3> exact{number(0), number(1), number(2)};
    if (diagnostics.has(DiagnosticKind::gimbal_lock)) { // only the sum or the difference of the outer angles counts
        const FixedAxes axes(spec.sequence);
        const bool is_low = axes.proper ? v[1] < 0.5 * half_turn_in(unit).hi : spec.sequence.sign(1) * v[1] < 0.0;
        const double sum_sign =
            (is_low == (axes.proper || axes.sign > 0.0) ? 1.0 : -1.0) * spec.sequence.sign(0) * spec.sequence.sign(2);
        const T first = exact[0] + scaled(exact[2] - T(last[2]), sum_sign);
        const double turns[] = {nearest_turns(last[0] - to_double(first), unit), nearest_turns(last[1] - v[1], unit)};
        const double turn = 2.0 * half_turn_in(unit).hi;
        const double error = 0x1p-69 * (std::fabs(last[2]) + (2.0 + std::fabs(turns[0]) + std::fabs(turns[1])) * turn);
        v[2] = last[2];
        const bool decided = round_to(plus_half_turns(first, 2.0 * turns[0], unit), false, error, v[0]);
        return round_to(plus_half_turns(exact[1], 2.0 * turns[1], unit), false, error, v[1]) && decided;
    }
    const double pi = half_turn_in(unit).hi;
    Triple chosen(spec, false, last, v);
    if (chosen.distance >= near_enough * (pi * pi)) {
        const Triple other(spec, true, last, v);
        chosen = other.distance < chosen.distance ? other : chosen;
    }
    // The vectors of the angles are turned by at most 2^-92 r, see the kernel's bound_of(), and the attitude is off by
    // as much after 1,000 turns.
    const double middle = std::fabs(v[1]);
    const double from_lock = spec.sequence.proper() ? std::min(middle, pi - middle) : 0.5 * pi - middle;
    const double off = 0x1p-82 * units_per_radian(unit) * units_per_radian(unit) / from_lock;
    bool decided = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const double sign = i == 1 ? chosen.middle_sign : 1.0;
        if (chosen.half_turns[i] == 0.0) {
            v[i] = sign * v[i] + 0.0;
            continue;
        }
        const bool is_exact = unit == AngleUnit::degrees && is_exactly_none(rest[i * rest_size]);
        const double error = off + 0x1p-100 * std::fabs(chosen.half_turns[i]) * pi;
        const T angle = plus_half_turns(scaled(exact[i], sign), chosen.half_turns[i], unit);
        decided = round_to(angle, is_exact, error, v[i]) && decided;
    }
    return decided;
}

bool choose_nearest(const Spec& spec, const double* last, DiagnosticSet diagnostics, std::span<const double> rest,
                    double* v) noexcept {
    const Eigen::Map<Eigen::Vector3d> own(v);
    const double pi = half_turn_in(spec.unit).hi;
    const double distance = (Eigen::Map<const Eigen::Vector3d>(last) - own).squaredNorm();
    if (!diagnostics.has(DiagnosticKind::gimbal_lock) && distance < near_enough * (pi * pi)) { // as nearly all are
        std::for_each_n(v, 3, [](double& number) { number += 0.0; });                          // -0 becomes 0
        return true;
    }
    return in_scalar_of(rest, 3, [&]<class T>(T /*scalar*/) { return choose<T>(spec, last, diagnostics, rest, v); });
}

double distance_to_lock(const Spec& spec, const double* v) noexcept {
    using std::numbers::pi;
    return spec.sequence.proper() ? std::min(v[1], pi - v[1]) : 0.5 * pi - std::fabs(v[1]);
}

/// The outer angles, in (-pi, pi] or [0, 2 pi).
OpenEnds open_ends(const Spec& spec) noexcept {
    const double half_turn = half_turn_in(spec.unit).hi;
    return {{0, 2}, spec.positive ? 2.0 * half_turn : -half_turn, spec.positive ? 0.0 : half_turn};
}

/// The outer angles by whole turns.
void wrap(double* v) noexcept {
    v[0] = without_turns(v[0]);
    v[2] = without_turns(v[2]);
}

constexpr auto presets_of_sequences =
    std::to_array<PresetMeaning>({{"bunge", {}, EulerSequence("ZXZ")}, {"opk", {}, EulerSequence("XYZ")}});

constexpr Codec codec_of_angles(const Representation& representation, std::string_view range, std::string_view lock,
                                std::string_view formula) noexcept {
    return {
        .representation = representation,
        .range = range,
        .singular = lock,
        .singular_attitude = "gimbal lock",
        .formula = formula,
        .sensitivity = [](const Spec& spec,
                          const Rotation& rotation) noexcept { return euler::sensitivity(rotation, spec.sequence); },
        .open_ends = open_ends,
        .choose_nearest = choose_nearest,
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
     .modifiers = {Modifier::passive, Modifier::deg, Modifier::positive},
     .presets = presets_of_sequences,
     .takes_sequence = true,
     .has_gimbal_lock = true},
    "1st, 3rd in (-pi, pi]; 2nd in [-pi/2, pi/2] (ABC) or [0, pi] (ABA)", "gimbal lock: 2nd at its limit",
    "ABC: R = R_A(e1) R_B(e2) R_C(e3), own axes; abc: R = R_c(e3) R_b(e2) R_a(e1), fixed axes");

constinit const Codec codecs::rpy =
    codec_of_angles({.name = RepresentationId::rpy,
                     .text = "rpy",
                     .size = 3,
                     .columns = {"roll", "pitch", "yaw"},
                     .modifiers = {Modifier::passive, Modifier::deg, Modifier::positive},
                     .has_gimbal_lock = true},
                    "roll, yaw in (-pi, pi]; pitch in [-pi/2, pi/2]", "gimbal lock: pitch at its limit",
                    "R = R_z(yaw) R_y(pitch) R_x(roll)");

} // namespace rotconv
