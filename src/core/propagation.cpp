#include <rotconv/propagation.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rotconv {
namespace {

using Eigen::Vector3d;

/// The least time between two samples: the product of three is then a normal number.
constexpr double least_interval = 1e-100;

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

Propagator::Propagator(const PropagationSettings& settings) noexcept
    : settings_(settings), stepper_(settings.set, settings.integrator, settings.renormalise) {
    stepper_.start(settings.initial);
}

Pushed Propagator::push(double time, const Vector3d& omega) noexcept {
    if (!std::isfinite(time) || !omega.allFinite()) {
        return {.refused = Fault::not_finite, .answer = {}};
    }
    if (count_ > 0 && !(time - samples_[count_ - 1].time >= least_interval)) {
        return {.refused = Fault::time_order, .answer = {}};
    }
    samples_[count_++] = {time, omega};
    const std::size_t late = settings_.interpolation == Interpolation::cubic ? 1 : 0;
    if (count_ <= late) {
        return {};
    }
    const std::size_t answered = count_ - 1 - late;
    std::optional<Propagated> answer;
    if (!std::exchange(settled_, false)) {
        if (answered > 0) {
            advance(answered - 1);
        }
        answer = answer_at(samples_[answered].time);
    }
    if (count_ == 2 * (late + 1)) {
        std::shift_left(samples_.begin(), samples_.begin() + static_cast<std::ptrdiff_t>(count_--), 1);
    }
    return {.refused = Fault::none, .answer = answer};
}

std::optional<Propagated> Propagator::settle() noexcept {
    if (count_ == 0 || settled_ || settings_.interpolation == Interpolation::linear) {
        return std::nullopt;
    }
    settled_ = true;
    if (count_ > 1) {
        advance(count_ - 2);
    }
    return answer_at(samples_[count_ - 1].time);
}

void Propagator::advance(std::size_t from) noexcept {
    const Sample& start = samples_[from];
    const Sample& end = samples_[from + 1];
    Polynomial omega;
    omega.pass_through(0.0, start.omega);
    omega.pass_through(end.time - start.time, end.omega);
    if (from > 0) {
        omega.pass_through(samples_[from - 1].time - start.time, samples_[from - 1].omega);
    }
    if (from + 2 < count_) {
        omega.pass_through(samples_[from + 2].time - start.time, samples_[from + 2].omega);
    }
    const double h = (end.time - start.time) / static_cast<double>(settings_.substeps);
    integrate(stepper_, omega, 0.0, h, settings_.substeps);
}

Propagated Propagator::answer_at(double time) const noexcept {
    const Reading reading = stepper_.attitude();
    return {.time = time, .rotation = reading.rotation, .defect = reading.defect, .fault = reading.fault};
}

} // namespace rotconv
