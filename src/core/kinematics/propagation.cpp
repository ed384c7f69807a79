#include <rotconv/propagation.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "../representations/half_turn.hpp"

namespace rotconv {
namespace {

using Eigen::Vector3d;

/// The least time between two samples: the product of three is then a normal number.
constexpr double least_interval = 1e-100;

/// A step that stretches less has an error far below what is reported, with every representation and integrator.
constexpr double harmless_stretch = 0.1;

/// The angle between the attitudes of two steppers; pi where one has none.
double angle_between(const Stepper& a, const Stepper& b) noexcept {
    const Reading p = a.attitude();
    const Reading q = b.attitude();
    if (!p || !q) {
        return std::numbers::pi;
    }
    return angle_of(p->inverse() * *q);
}

/// The polynomial through up to four points, in Newton's form.
class Polynomial {
public:
    void pass_through(double t, const Vector3d& value) noexcept {
        double product = 1.0;
        for (std::size_t i = 0; i < count_; ++i) {
            product *= t - at_[i];
        }
        factors_[count_] = (value - (*this)(t)) / product;
        at_[count_++] = t;
    }

    Vector3d operator()(double t) const noexcept {
        Vector3d value = Vector3d::Zero();
        for (std::size_t i = count_; i > 0; --i) {
            value = factors_[i - 1] + (t - at_[i - 1]) * value;
        }
        return value;
    }

private:
    std::array<double, 4> at_{};
    std::array<Vector3d, 4> factors_;
    std::size_t count_ = 0;
};

} // namespace

Propagator::Propagator(const PropagationSettings& settings)
    : settings_(settings), stepper_(settings.representation, settings.integrator, settings.renormalise) {
    if (settings.substeps == 0) {
        throw std::invalid_argument("rotconv: no substeps");
    }
    stepper_.start(settings.initial);
}

PushResult Propagator::push(double interval, const Vector3d& omega) noexcept {
    if (std::isnan(interval) || !omega.allFinite()) {
        return {.refused = Error::not_finite, .answer = {}};
    }
    if (count_ > 0 && interval < least_interval) {
        return {.refused = Error::time_order, .answer = {}};
    }
    samples_[count_++] = {interval, omega};
    const std::size_t late = settings_.interpolation == Interpolation::cubic ? 1 : 0;
    if (count_ <= late) {
        return {};
    }
    const std::size_t answered = count_ - 1 - late;
    std::optional<Propagated> answer;
    if (!std::exchange(flushed_, false)) {
        if (answered > 0) {
            advance(answered - 1);
        }
        answer = {stepper_.attitude(), step_error_};
    }
    if (count_ == 2 * (late + 1)) {
        std::shift_left(samples_.begin(), samples_.begin() + static_cast<std::ptrdiff_t>(count_--), 1);
    }
    return {.refused = Error::none, .answer = answer};
}

std::optional<Propagated> Propagator::flush() noexcept {
    if (count_ == 0 || flushed_ || settings_.interpolation == Interpolation::linear) {
        return std::nullopt;
    }
    flushed_ = true;
    if (count_ > 1) {
        advance(count_ - 2);
    }
    return Propagated{stepper_.attitude(), step_error_};
}

void Propagator::advance(std::size_t from) noexcept {
    const Sample& start = samples_[from];
    const Sample& end = samples_[from + 1];
    Polynomial omega;
    omega.pass_through(0.0, start.omega);
    omega.pass_through(end.interval, end.omega);
    if (from > 0) {
        omega.pass_through(-start.interval, samples_[from - 1].omega);
    }
    if (from + 2 < count_) {
        omega.pass_through(end.interval + samples_[from + 2].interval, samples_[from + 2].omega);
    }
    const double h = end.interval / static_cast<double>(settings_.substeps);
    step_error_ = 0.0;
    for (std::size_t i = 0; i < settings_.substeps; ++i) {
        const double time = static_cast<double>(i) * h;
        Stepper halves = stepper_;
        if (integrate(stepper_, omega, time, h, 1) != Error::none) {
            return;
        }
        if (stepper_.stretch() > harmless_stretch) {
            integrate(halves, omega, time, 0.5 * h, 2);
            step_error_ = std::max(step_error_, angle_between(stepper_, halves));
        }
    }
}

} // namespace rotconv
