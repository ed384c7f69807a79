#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include <rotconv/integration.hpp>

namespace rotconv {

/// What the angular velocity does between two samples.
enum class Interpolation : std::uint8_t {
    linear, ///< each sample is answered at once
    cubic,  ///< the cubic through two samples before and two after (at the ends the parabola through three): one late
};

struct PropagationSettings {
    Spec set{};                                  ///< what is integrated; see Stepper
    Integrator integrator = Integrator::magnus4; ///< the default serves a quaternion
    std::size_t substeps = 1;                    ///< steps from one sample to the next, from 1
    Interpolation interpolation = Interpolation::linear;
    bool renormalise = false; ///< bring the numbers back to the set after every step
    Rotation initial{};       ///< the attitude at the first sample
};

/// The attitude at one sample's time.
struct Propagated {
    /// Its defect is how far the integrated numbers have drifted off their set; its errors singular and coarse_step say
    /// that the chart was left, here and in all that follows.
    Reading attitude;
    /// Radians: the greatest of the estimates of their own error by the steps from the sample before. Two half steps
    /// against the one; 0 where the steps are so short that it is far below `reported_step_error`.
    double step_error = 0.0;
};

/// What came of one sample.
struct PushResult {
    /// not_finite, time_order: the sample was refused and changed nothing.
    Error refused = Error::none;
    /// linear: of this sample; cubic: of the one accepted before it.
    std::optional<Propagated> answer;
};

/// Integrates a stream of samples of the body's angular velocity to attitudes, in constant memory.
///
/// The error of sampled rates is that of the interpolation, whatever the integrator: over 20 s of coning (0.1 rad, 5
/// rad/s) it is 2.1e-4 rad with linear and 1.0e-7 with cubic at 100 Hz, 2.1e-6 and 1.0e-11 at 1000 Hz; of a tumbling
/// motion of up to 3 rad/s 2.9e-4 and 1.6e-8, 2.9e-6 and 1.6e-12. It falls with the second power of the interval
/// (linear), or the fourth (cubic).
class Propagator {
public:
    /// @pre can_integrate(settings.set.name, settings.integrator) and settings.substeps > 0
    explicit Propagator(const PropagationSettings& settings) noexcept;

    /// A sample: the seconds since the last one that was accepted (1e-100 at least; of the first sample they mean
    /// nothing), and the angular velocity in body axes, rad/s.
    PushResult push(double interval, const Eigen::Vector3d& omega) noexcept;

    /// What is still owed of the samples so far, at the end or where nothing may wait: with cubic one answer, by the
    /// parabola through the last three samples.
    std::optional<Propagated> flush() noexcept;

private:
    struct Sample {
        double interval = 0.0; ///< since the one before
        Eigen::Vector3d omega = Eigen::Vector3d::Zero();
    };

    /// Integrates from the sample `from` to the next. Others shape the interpolation: at most one on each side.
    void advance(std::size_t from) noexcept;
    [[nodiscard]] Propagated answer() const noexcept;

    PropagationSettings settings_;
    Stepper stepper_;
    double step_error_ = 0.0;         ///< of the latest advance
    std::array<Sample, 4> samples_{}; ///< the latest, in order of time
    std::size_t count_ = 0;           ///< how many of them there are
    bool flushed_ = false;            ///< the latest has its answer although it was to wait
};

} // namespace rotconv
