#include <rotconv/propagation.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "../representations/rotation_angle.hpp"

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
    explicit Polynomial(const Vector3d& at_0) noexcept { factors_[0] = at_0; }

    void pass_through(double t, const Vector3d& value) noexcept {
        double product = t;
        for (std::size_t i = 1; i < count_; ++i) {
            product *= t - at_[i];
        }
        factors_[count_] = (value - (*this)(t)) / product;
        at_[count_++] = t;
    }

    Vector3d operator()(double t) const noexcept {
        Vector3d value = factors_[count_ - 1];
        for (std::size_t i = count_ - 1; i > 0; --i) {
            value = factors_[i - 1] + (t - at_[i - 1]) * value;
        }
        return value;
    }

private:
    std::array<double, 4> at_{};
    std::array<Vector3d, 4> factors_;
    std::size_t count_ = 1;
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
    PushResult result; // the only one, which is not copied
    if (std::isnan(interval) || !omega.allFinite()) {
        result.refused = Error::not_finite;
        return result;
    }
    if (count_ > 0 && interval < least_interval) {
        result.refused = Error::time_order;
        return result;
    }
    samples_[count_++] = {interval, omega};
    const std::size_t late = settings_.interpolation == Interpolation::cubic ? 1 : 0;
    if (count_ <= late) {
        return result;
    }
    const std::size_t answered = count_ - 1 - late;
    if (!std::exchange(flushed_, false)) {
        if (answered > 0) {
            advance(answered - 1);
        }
        struct Made { // in its place, where a copy would have to wait for it
            const Propagator& of;
            operator Propagated() const noexcept { return {of.stepper_.attitude(), of.step_error_}; }
        };
        result.answer.emplace(Made{*this});
    }
    if (count_ == 2 * (late + 1)) {
        std::shift_left(samples_.begin(), samples_.begin() + static_cast<std::ptrdiff_t>(count_--), 1);
    }
    return result;
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
    Polynomial omega(start.omega);
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
