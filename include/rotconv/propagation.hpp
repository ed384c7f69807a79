#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include <rotconv/integration.hpp>

namespace rotconv {

/// The angular velocity between two samples.
enum class Interpolation : std::uint8_t {
    linear, ///< the straight line from one sample to the next; each sample is answered at once
    cubic,  ///< the cubic through two samples before and two after, at the ends the parabola through three; answers are
            ///< one sample late
};

struct PropagationSettings {
    Spec representation{};                       ///< whose numbers are integrated; see Stepper
    Integrator integrator = Integrator::magnus4; ///< the default is for the quaternion; rk4 is for all
    std::size_t substeps = 1;                    ///< steps from one sample to the next, from 1
    Interpolation interpolation = Interpolation::linear;
    bool renormalise = false; ///< make the numbers exact again, such as unit, after each step
    Rotation initial{};       ///< the attitude at the first sample
};

/// The attitude at one sample's time.
struct Propagated {
    /// The defect is due to drift of the integrated numbers. After the error singular or coarse_step, all later answers
    /// have it too.
    Reading attitude;
    /// In radians: the largest error estimate of the steps since the sample before. Each estimate compares one step
    /// with two half steps; it is 0 if the step is so short that its error is far below `reported_step_error`.
    double step_error = 0.0;
};

/// The result of one sample.
struct PushResult {
    /// not_finite, time_order: the sample was refused and changed nothing.
    Error refused = Error::none;
    /// With linear of this sample, with cubic of the one accepted before it.
    std::optional<Propagated> answer;
};

/// Integrates a stream of samples of the body's angular velocity to attitudes, in constant memory.
///
/// With every integrator, the error of sampled rates is that of the interpolation. Over 20 s of coning (0.1 rad, 5
/// rad/s) it is 2.1e-4 rad with linear and 1.0e-7 with cubic at 100 Hz, and 2.1e-6 and 1.0e-11 at 1000 Hz; for a
/// tumbling motion of up to 3 rad/s it is 2.9e-4 and 1.6e-8, and 2.9e-6 and 1.6e-12. It falls with the second power of
/// the interval (linear) or the fourth (cubic).
class Propagator {
public:
    /// @throw std::invalid_argument if not can_integrate(settings.representation.name, settings.integrator), or if
    /// settings.substeps is 0
    explicit Propagator(const PropagationSettings& settings);

    /// The next sample.
    /// @param interval seconds since the last sample that was accepted, at least 1e-100; not used for the first sample
    /// @param omega the angular velocity in body axes, rad/s
    PushResult push(double interval, const Eigen::Vector3d& omega) noexcept;

    /// The answer still due for the samples so far. Call it at the end, or when no answer may wait: with cubic, it is
    /// one answer, by the parabola through the last three samples.
    std::optional<Propagated> flush() noexcept;

private:
    struct Sample {
        double interval = 0.0; ///< since the one before
        Eigen::Vector3d omega = Eigen::Vector3d::Zero();
    };

    /// Integrates from the sample `from` to the next.
    void advance(std::size_t from) noexcept;

    PropagationSettings settings_;
    Stepper stepper_;
    double step_error_ = 0.0;         ///< the latest advance's
    std::array<Sample, 4> samples_{}; ///< the latest, in order of time
    std::size_t count_ = 0;           ///< number of samples_
    bool flushed_ = false;            ///< flush() has answered the latest sample
};

} // namespace rotconv
