#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include <Eigen/Core>

#include <rotconv/reading.hpp>
#include <rotconv/spec.hpp>

namespace rotconv {

/// One-step methods for the kinematic equation.
enum class Integrator : std::uint8_t {
    rk4,     ///< the classical method of Runge and Kutta (Kutta 1901), on the representation's own equation
    magnus4, ///< exponential steps on the quaternion (Iserles, Munthe-Kaas, Norsett and Zanna 2000): the rate at two
             ///< points of Gauss and Legendre, and their commutator
    magnus6, ///< the same to order six, with three points and three commutators (Blanes, Casas, Oteo and Ros 2009)
};

/// One row of the table of integrators.
struct IntegratorEntry {
    Integrator integrator;
    std::string_view text; ///< as on the command line
    int order;
    int evaluations;             ///< in a step: of the right-hand side, or exponentials with their commutators
    std::size_t node_count;      ///< number of angular velocities that a step needs
    std::array<double, 3> nodes; ///< times of these velocities, as parts of the step
    bool exponential;            ///< only for the quaternion
};

/// The table, in the order of Integrator.
[[nodiscard]] std::span<const IntegratorEntry> integrators() noexcept;
/// Its row.
[[nodiscard]] const IntegratorEntry& entry_of(Integrator integrator) noexcept;
/// rk4 integrates any representation that has rates, the exponential steps only the quaternion.
[[nodiscard]] bool can_integrate(RepresentationId representation, Integrator integrator) noexcept;

/// Integrates the numbers of one representation step by step. Only the sequence and `passive` of its Spec count; angles
/// are in radians.
///
/// Where a representation has another chart, the stepper changes to it: mrp to its shadow where |m| > 1, rotvec by a
/// full turn where |r| > pi, angles by full turns. Where it has none, a step is refused with Error::singular if the
/// singular attitude (euler: gimbal lock; cayley: a half-turn) is no further away than the body turns in that step,
/// because the result of such a step cannot be trusted. A step is refused with Error::coarse_step if, at its greatest
/// rate, the body may turn by as much as the largest distance from any attitude to a singularity (euler: a quarter
/// turn; cayley, mrp, rotvec: half a turn), or, in any representation, by more than half a turn. The state is then
/// lost, and each later step returns the same error until start().
class Stepper {
public:
    /// @param renormalise after each step make the numbers exact again, such as a quaternion unit
    /// @throw std::invalid_argument if not can_integrate(representation.name, integrator)
    Stepper(const Spec& representation, Integrator integrator, bool renormalise = false);

    /// Begins at a rotation. Error: singular.
    Error start(const Rotation& rotation) noexcept;

    /// The times, as parts of a step, at which step() needs the angular velocity.
    [[nodiscard]] std::span<const double> nodes() const noexcept;

    /// Integrates over `h` seconds; backwards where it is negative. Errors: singular; coarse_step; not_finite if a
    /// number overflows; ended before start().
    /// @param rates the body's angular velocity in body axes, rad/s, at the nodes
    /// @throw std::invalid_argument if there are not as many rates as nodes
    Error step(double h, std::span<const Eigen::Vector3d> rates);

    /// The largest angle in radians by which the body may have turned in the last step, divided by the distance to a
    /// singularity if that is less than one radian.
    [[nodiscard]] double stretch() const noexcept { return stretch_; }

    /// The attitude of the numbers and their exact defect, which is due to drift. An error if the state is lost, or if
    /// drift has left no attitude.
    [[nodiscard]] Reading attitude() const noexcept;

    /// The numbers in the representation's own order.
    [[nodiscard]] std::span<const double> numbers() const noexcept { return {numbers_.data(), spec_.size()}; }

private:
    using Numbers = Eigen::Matrix<double, 9, 1>; // unused ones are 0

    void runge_kutta(double h, std::span<const Eigen::Vector3d> rates) noexcept;
    Error renormalise() noexcept;

    Spec spec_;
    Integrator integrator_;
    bool renormalised_;
    Numbers numbers_ = Numbers::Zero();
    double stretch_ = 0.0;
    Error error_ = Error::ended; ///< before start()
};

/// A function of the time that returns an Eigen::Vector3d. A lambda that returns an Eigen expression needs the return
/// type
/// `-> Eigen::Vector3d`: the expression may refer to what is gone.
template <class Function>
concept AngularVelocity =
    std::same_as<std::remove_cvref_t<std::invoke_result_t<const Function&, double>>, Eigen::Vector3d>;

/// Integrates over `count` steps of `h` seconds from the time `start`; omega(t) is the body's angular velocity in body
/// axes, rad/s. The stepper must have begun, see Stepper::start(). Returns the error of the first step that has one.
template <AngularVelocity Omega>
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
