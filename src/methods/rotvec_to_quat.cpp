#include "formulas.hpp"

#include <limits>

namespace rotconv::formula::rotvec_to_quat {
namespace {

void set(double t, double scale, const double* r, double* q) noexcept {
    q[0] = std::cos(0.5 * t);
    Vector{q + 1} = scale * Eigen::Map<const Eigen::Vector3d>(r);
}

} // namespace

/// Euler-Rodrigues parameters, (cos t/2, sin(t/2)/t r).
void half_angle(const double* r, double* q) noexcept {
    const double t = length(r);
    set(t, std::sin(0.5 * t) / t, r, q);
}

/// The same with sin(t/2)/t by three terms of its series up to t = 1e-3, as SciPy has it.
void taylor(const double* r, double* q) noexcept {
    const double t = length(r);
    set(t, t <= 1e-3 ? 0.5 - t * t / 48.0 + (t * t) * (t * t) / 3840.0 : std::sin(0.5 * t) / t, r, q);
}

/// The same without a branch: with the least normal number added to t it is not 0, and not changed elsewhere.
void branchless(const double* r, double* q) noexcept {
    const double t = length(r) + std::numeric_limits<double>::min();
    set(t, std::sin(0.5 * t) / t, r, q);
}

} // namespace rotconv::formula::rotvec_to_quat
