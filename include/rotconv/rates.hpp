#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <rotconv/reading.hpp>
#include <rotconv/spec.hpp>

namespace rotconv {

/// Whether the representation has a kinematic equation. All have one except axis-angle, whose axis has no rate at the
/// identity.
[[nodiscard]] bool has_rates(RepresentationId name) noexcept;

/// Nearer than this (radians) to a singularity of the equation there are no rates. The equations of rotvec and mrp are
/// regular at a half-turn and singular at full turns.
inline constexpr double singular_margin = 1e-15;

/// What the rows hold.
struct RateSettings {
    bool inverse = false;                 ///< convert the rates of the numbers to the angular velocity
    bool degrees = false;                 ///< the angular velocity in degrees a second
    Frame frame = Frame::body;            ///< axes of the angular velocity
    double tolerance = default_tolerance; ///< largest defect that is accepted; see Reading::defect
    bool sensitivity = false;             ///< report each row
};

/// The kinematic equation of a representation on rows of numbers in the conventions of its Spec. Angles have rates in
/// their own unit a second. With a `passive` Spec the numbers and their rates are those of the inverse; the angular
/// velocity is still that of the body. Limits of the relative error, both ways, with the worst found: 11.75 eps (10.1)
/// while the condition is below 10, and 1 eps (0.84) times the condition above; for rotation vectors past a half-turn
/// 5.25 eps (4.46) times the condition. Thread-safe: run() changes nothing in it.
class Rates {
public:
    /// @throw std::invalid_argument if not has_rates(spec.name), or if a modifier of the spec has no meaning
    explicit Rates(const Spec& spec, const RateSettings& settings = {});

    /// n numbers and wx, wy, wz; with inverse, n numbers and their n rates.
    [[nodiscard]] std::size_t in_size() const noexcept { return spec_.size() + (settings_.inverse ? spec_.size() : 3); }
    /// n rates, in the order of the numbers; with inverse, wx, wy, wz.
    [[nodiscard]] std::size_t out_size() const noexcept { return settings_.inverse ? 3 : spec_.size(); }

    /// Converts rows of in_size() numbers into rows of out_size() numbers. The results of a row with an error become
    /// nan. No number becomes -0.
    /// @param reports is replaced by the reports of the rows that have an error (singular; overflow of the result;
    /// those of a Reading) or a diagnostic (normalized; near_gimbal_lock of Euler angles), in row order. Their
    /// sensitivity is that of the numbers, which past a half-turn is not that of the attitude for a rotation vector
    /// @throw std::invalid_argument if `in` is not whole rows, or `out` has no room for the results
    void run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports) const;

private:
    [[nodiscard]] RowReport run_row(const double* in, double* out) const noexcept;

    Spec spec_;
    RateSettings settings_;
};

} // namespace rotconv
