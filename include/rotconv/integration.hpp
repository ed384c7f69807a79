#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include <Eigen/Core>

#include <rotconv/reading.hpp>
#include <rotconv/spec.hpp>

namespace rotconv {

/// One-step methods for the kinematic equation.
enum class Integrator : std::uint8_t {
    rk4,     ///< the classical method of Runge and Kutta (Kutta 1901), on the set's own equation
    magnus4, ///< exponential steps on the quaternion (Iserles, Munthe-Kaas, Norsett and Zanna 2000): the rate at two
             ///< points of Gauss and Legendre, and their commutator
    magnus6, ///< the same to order six, with three points and three commutators (Blanes, Casas, Oteo and Ros 2009)
};

/// One line of the table of integrators.
struct IntegratorEntry {
    Integrator integrator;
    std::string_view text; ///< as on the command line
    int order;
    int evaluations;             ///< of the right-hand side a step, or exponentials with their commutators
    std::size_t node_count;      ///< angular velocities that a step asks for...
    std::array<double, 3> nodes; ///< ...at these parts of the step
    bool exponential;            ///< only for the quaternion
};

[[nodiscard]] std::span<const IntegratorEntry> integrators() noexcept;
[[nodiscard]] const IntegratorEntry& entry_of(Integrator integrator) noexcept;
/// rk4 goes with every set that has rates, exponential steps with the quaternion.
[[nodiscard]] bool can_integrate(RepresentationId set, Integrator integrator) noexcept;

/// The numbers of one set, carried on step by step. Of the set's Spec the sequence and `passive` count; angles are
/// radians.
///
/// Where a chart has another one of the same set, it changes: mrp to its shadow where |m| > 1, rotvec by a full turn
/// where |r| > pi, angles by full turns. Where it has none, a step from which the singular attitude is within reach
/// (euler: gimbal lock; cayley: a half-turn), because it is no further than the body turns in that step, is refused
/// with Error::singular: nothing that such a step finds can be trusted. So is, with Error::coarse_step, one in which
/// the body may turn, at the greatest rate in it, by as much as any attitude's distance to a singularity (euler: a
/// quarter turn; cayley, mrp, rotvec: half a turn), or by more than half a turn with any set. The state is then lost,
/// and every later step says the same until start().
class Stepper {
public:
    /// @pre can_integrate(set.name, integrator)
    Stepper(const Spec& set, Integrator integrator, bool renormalise = false) noexcept;

    /// The numbers of a rotation. Error: singular.
    Error start(const Rotation& rotation) noexcept;

    /// Parts of a step at which step() wants the angular velocity.
    [[nodiscard]] std::span<const double> nodes() const noexcept;

    /// Carries the numbers over `h` seconds. `rates`: the body's angular velocity in body axes, rad/s, at the nodes.
    /// Errors: singular; coarse_step; not_finite where a number overflows.
    Error step(double h, std::span<const Eigen::Vector3d> rates) noexcept;

    /// How far the last step went: the angle in radians that the body may have turned by, over the distance to a
    /// singularity where that is less than one radian.
    [[nodiscard]] double stretch() const noexcept { return stretch_; }

    /// The attitude of the numbers, and their exact defect: how far they have drifted off the set. An error where the
    /// state is lost, or where drift has left no attitude.
    [[nodiscard]] Reading attitude() const noexcept;

    /// In the set's own order.
    [[nodiscard]] std::span<const double> numbers() const noexcept { return {numbers_.data(), set_.size()}; }

private:
    using Numbers = Eigen::Matrix<double, 9, 1>; // unused ones are 0

    void runge_kutta(double h, std::span<const Eigen::Vector3d> rates) noexcept;
    void turn_by(const Eigen::Vector3d& turn) noexcept;
    Error renormalise() noexcept;

    Spec set_;
    Integrator integrator_;
    bool renormalised_;
    Numbers numbers_ = Numbers::Zero();
    double stretch_ = 0.0;
    Error error_ = Error::none;
};

/// Carries the stepper over `count` steps of `h` seconds from `start`; omega(t) is the body's angular velocity.
template <class Omega>
Error integrate(Stepper& stepper, const Omega& omega, double start, double h, std::size_t count) {
    std::array<Eigen::Vector3d, 3> rates;
    const auto nodes = stepper.nodes();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            rates[k] = omega(start + (static_cast<double>(i) + nodes[k]) * h);
        }
        const Error error = stepper.step(h, {rates.data(), nodes.size()});
        if (error != Error::none) {
            return error;
        }
    }
    return Error::none;
}

} // namespace rotconv
