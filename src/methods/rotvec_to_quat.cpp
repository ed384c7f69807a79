#include "formulas.hpp"

#include <cmath>
#include <limits>

namespace rotconv::formula::rotvec_to_quat {
namespace {

void set(double w, double scale, const double* r, double* q) noexcept {
    q[0] = w;
    Vector{q + 1} = scale * Eigen::Map<const Eigen::Vector3d>(r);
}

double square(const double* r) noexcept { return (r[0] * r[0] + r[1] * r[1]) + r[2] * r[2]; }

} // namespace

/// Euler-Rodrigues parameters, (cos t/2, sin(t/2)/t r).
void half_angle(const double* r, double* q) noexcept {
    const double t = std::sqrt(square(r));
    set(std::cos(0.5 * t), std::sin(0.5 * t) / t, r, q);
}

/// The same with sin(t/2)/t by three terms of its series up to t = 1e-3, as SciPy has it.
void taylor(const double* r, double* q) noexcept {
    const double t = std::sqrt(square(r));
    const double t2 = t * t;
    set(std::cos(0.5 * t), t <= 1e-3 ? 0.5 - t2 / 48.0 + t2 * t2 / 3840.0 : std::sin(0.5 * t) / t, r, q);
}

/// The same without a branch: the least normal number is added to t^2, so that t is not 0. That changes nothing but the
/// rounding, as sin(t/2)/t does not depend on a t so small.
void branchless(const double* r, double* q) noexcept {
    const double t = std::sqrt(square(r) + std::numeric_limits<double>::min());
    set(std::cos(0.5 * t), std::sin(0.5 * t) / t, r, q);
}

} // namespace rotconv::formula::rotvec_to_quat
