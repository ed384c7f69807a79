#pragma once

#include <cstddef>
#include <span>

#include <rotconv/frame.hpp>
#include <rotconv/reading.hpp>
#include <rotconv/spec.hpp>

namespace rotconv {

/// Whether the representation has a kinematic equation: all but axis-angle, whose axis has no rate at the identity.
[[nodiscard]] bool has_rates(RepresentationId name) noexcept;

/// Nearer than this (radians) to a singularity of the equation there are no rates. That of rotvec and mrp is regular at
/// a half-turn and singular at full turns.
inline constexpr double singular_margin = 1e-15;

/// What rows of numbers and rates are.
struct RateSettings {
    bool inverse = false;      ///< from the rates of the numbers to the angular velocity
    bool degrees = false;      ///< the angular velocity in degrees a second
    Frame frame = Frame::body; ///< axes of the angular velocity
    double tolerance = 1e-3;   ///< largest defect that is accepted; see Reading::defect
};

/// What is known of one row.
struct RateReport {
    Error error = Error::none;   ///< singular; overflow of the result; those of readings
    DiagnosticSet diagnostics{}; ///< normalized; near_gimbal_lock of Euler angles
    double defect = 0.0;         ///< as in RowReport
    Sensitivity sensitivity{};   ///< of the numbers (they differ from the attitude's for a rotation vector past a
                                 ///< half-turn); not known with any other error
};

/// The kinematic equation of a representation on rows of numbers written as its Spec says. Numbers that are angles have
/// rates in their own unit a second. Of a `passive` Spec the numbers, and so the rates, are those of the inverse; the
/// angular velocity remains that of the body. Limits of the relative error, both ways, with the worst found: 11.75 eps
/// (10.1) while the condition is below 10, and 1 eps (0.84) times the condition above; of rotation vectors past a
/// half-turn 5.25 eps (4.46) times the condition.
/// Thread-safe: running it changes nothing in it.
class Rates {
public:
    /// Throws std::invalid_argument where not has_rates(spec.name).
    explicit Rates(const Spec& spec, const RateSettings& settings = {});

    /// n numbers and wx, wy, wz; inverse: n numbers and their n rates.
    [[nodiscard]] std::size_t in_size() const noexcept { return spec_.size() + (settings_.inverse ? spec_.size() : 3); }
    /// n rates, in the order of the numbers; inverse: wx, wy, wz.
    [[nodiscard]] std::size_t out_size() const noexcept { return settings_.inverse ? 3 : spec_.size(); }

    /// reports.size() rows. The results of a row with an error become nan. No number becomes -0.
    /// @pre in.size() >= rows * in_size() and out.size() >= rows * out_size()
    void run(std::span<const double> in, std::span<double> out, std::span<RateReport> reports) const noexcept;

private:
    [[nodiscard]] RateReport run_row(const double* in, double* out) const noexcept;

    Spec spec_;
    RateSettings settings_;
};

} // namespace rotconv
