#include <rotconv/integration.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <Eigen/Geometry>

#include <rotconv/quaternion.hpp>
#include <rotconv/rates.hpp>

#include "../checks.hpp"
#include "../numerics/elementary.hpp"
#include "../representations/codec.hpp"

namespace rotconv {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

constexpr double root3 = std::numbers::sqrt3;
constexpr double root15 = 3.872983346207417;

constexpr std::array<IntegratorEntry, 3> table{{
    {Integrator::rk4, "rk4", 4, 4, 3, {0.0, 0.5, 1.0}, false},
    {Integrator::magnus4, "magnus4", 4, 2, 2, {0.5 - root3 / 6.0, 0.5 + root3 / 6.0, 0.0}, true},
    {Integrator::magnus6, "magnus6", 6, 3, 3, {0.5 - root15 / 10.0, 0.5, 0.5 + root15 / 10.0}, true},
}};

/// The commutator of [a]_x and [b]_x as a vector, reversed: the published series are for Ydot = A Y, and here
/// Rdot = R [w]_x.
Vector3d commutator(const Vector3d& a, const Vector3d& b) noexcept { return b.cross(a); }

Vector3d magnus4(double h, std::span<const Vector3d> w) noexcept {
    return (0.5 * h) * (w[0] + w[1]) - (root3 / 12.0 * h * h) * commutator(w[0], w[1]);
}

Vector3d magnus6(double h, std::span<const Vector3d> w) noexcept {
    const Vector3d a1 = h * w[1];
    const Vector3d a2 = (root15 / 3.0 * h) * (w[2] - w[0]);
    const Vector3d a3 = (10.0 / 3.0 * h) * ((w[2] - w[1]) - (w[1] - w[0]));
    const Vector3d c1 = commutator(a1, a2);
    const Vector3d c2 = commutator(a1, 2.0 * a3 + c1) / -60.0;
    return a1 + a3 / 12.0 + commutator(-20.0 * a1 - a3 + c1, a2 + c2) / 240.0;
}

/// Without reduction where there is nothing to reduce, to the same bits.
SineCosine<double> sine_cosine_of_step(double half) noexcept {
    constexpr double least_reduced_angle = 0x1.9p-6; // below half a step of pi/64
    if (half > least_reduced_angle) {
        return sine_cosine<double>(half, AngleUnit::radians);
    }
    const SmallAngle small(half);
    return {half + small.sine_rest, 1.0 + small.cosine_less_1};
}

/// The quaternion at the beginning of the numbers, turned.
void turn_by(const Vector3d& turn, Eigen::Matrix<double, 9, 1>& numbers) noexcept {
    const double half = 0.5 * turn.norm();
    const auto sides = sine_cosine_of_step(half);
    const double w = sides.cosine;
    const Vector3d v = (half == 0.0 ? 0.5 : 0.5 * (sides.sine / half)) * turn;
    const Vector3d kept = numbers.segment<3>(1);
    const double kept_w = numbers[0];
    numbers[0] = kept_w * w - kept.dot(v);
    numbers.segment<3>(1) = kept_w * v + w * kept + kept.cross(v);
}

/// The greatest rate in a step: at its nodes, or at its ends as the rates at the outer nodes and the one between them
/// (on a line, or a parabola) go on.
double greatest_rate(Integrator integrator, std::span<const Vector3d> w) noexcept {
    double square = 0.0;
    const auto look = [&square](const Vector3d& rate) { square = std::max(square, rate.squaredNorm()); };
    std::ranges::for_each(w, look);
    if (integrator == Integrator::magnus4) {
        const Vector3d further = (0.5 * (root3 - 1.0)) * (w[1] - w[0]);
        look(w[0] - further);
        look(w[1] + further);
    } else if (integrator == Integrator::magnus6) {
        const Vector3d slope = (0.5 * 5.0 / root15) * (w[2] - w[0]);
        const Vector3d middle = w[1] + (5.0 / 6.0) * ((w[2] - w[1]) - (w[1] - w[0]));
        look(middle - slope);
        look(middle + slope);
    }
    return std::sqrt(square);
}

} // namespace

std::span<const IntegratorEntry> integrators() noexcept { return table; }

const IntegratorEntry& entry_of(Integrator integrator) noexcept {
    return *std::ranges::find(table, integrator, &IntegratorEntry::integrator);
}

bool can_integrate(RepresentationId representation, Integrator integrator) noexcept {
    return entry_of(integrator).exponential ? representation == RepresentationId::quat : has_rates(representation);
}

Stepper::Stepper(const Spec& representation, Integrator integrator, bool renormalise)
    : spec_(representation), integrator_(integrator), renormalised_(renormalise && representation.size() > 3) {
    if (!can_integrate(spec_.name, integrator)) {
        throw std::invalid_argument("rotconv: this integrator does not serve this representation");
    }
    spec_.unit = AngleUnit::radians;
    if (entry_of(integrator).exponential) {
        spec_.passive = false; // the conjugate would be carried on by the same exponential
    }
}

Error Stepper::start(const Rotation& rotation) noexcept {
    const Rotation kept = spec_.passive ? rotation.inverse() : rotation;
    numbers_.setZero();
    write_row(spec_, kept, numbers_.data());
    error_ = numbers_.allFinite() ? Error::none : Error::singular;
    return error_;
}

std::span<const double> Stepper::nodes() const noexcept {
    const IntegratorEntry& entry = entry_of(integrator_);
    return {entry.nodes.data(), entry.node_count};
}

Error Stepper::step(double h, std::span<const Vector3d> rates) {
    check_size(rates.size(), nodes().size());
    if (error_ != Error::none) {
        return error_;
    }
    const Codec& codec = codec_of(spec_.name);
    const double reach = std::fabs(h) * greatest_rate(integrator_, rates);
    if (!(reach <= pi && reach < codec.greatest_distance)) {
        return error_ = Error::coarse_step;
    }
    const double distance = codec.distance(spec_, numbers_.data());
    if (distance <= reach) {
        return error_ = Error::singular;
    }
    stretch_ = reach / std::min(1.0, distance);
    if (integrator_ == Integrator::rk4) {
        runge_kutta(h, rates);
    } else {
        turn_by(integrator_ == Integrator::magnus4 ? magnus4(h, rates) : magnus6(h, rates), numbers_);
    }
    if (codec.switch_chart != nullptr) {
        codec.switch_chart(numbers_.data());
    }
    if ((numbers_ - numbers_).sum() != 0.0) { // or nan
        return error_ = Error::not_finite;
    }
    if (!(codec.distance(spec_, numbers_.data()) > 0.0)) {
        return error_ = Error::singular;
    }
    return error_ = renormalised_ ? renormalise() : Error::none;
}

void Stepper::runge_kutta(double h, std::span<const Vector3d> rates) noexcept {
    const auto equation = codec_of(spec_.name).rate;
    const Frame frame = spec_.passive ? Frame::reference : Frame::body;
    const double sign = spec_.passive ? -1.0 : 1.0;
    const auto rate = [&](const Numbers& numbers, const Vector3d& w) {
        Numbers result = Numbers::Zero();
        equation(spec_, numbers.data(), sign * w, frame, result.data());
        return result;
    };
    const Numbers first = rate(numbers_, rates[0]);
    const Numbers second = rate(numbers_ + (0.5 * h) * first, rates[1]);
    const Numbers third = rate(numbers_ + (0.5 * h) * second, rates[1]);
    const Numbers fourth = rate(numbers_ + h * third, rates[2]);
    numbers_ += (h / 6.0) * ((first + fourth) + 2.0 * (second + third));
}

Error Stepper::renormalise() noexcept {
    const Reading reading = read_row(spec_, numbers_.data());
    if (reading) {
        write_row(spec_, *reading, numbers_.data());
    }
    return reading.error();
}

Reading Stepper::attitude() const noexcept {
    if (error_ != Error::none) {
        return error_;
    }
    const Codec& codec = codec_of(spec_.name);
    const Reading reading =
        spec_.name == RepresentationId::quat // most often, and quicker
            ? quaternion::to_rotation({numbers_[0], numbers_[1], numbers_[2], numbers_[3]}, any_defect)
            : read_row(spec_, numbers_.data());
    if (!reading) {
        return reading;
    }
    return {spec_.passive ? reading->inverse() : *reading,
            codec.exact_defect == nullptr ? reading.defect() : codec.exact_defect(numbers_.data())};
}

} // namespace rotconv
