#include <rotconv/quaternion.hpp>

#include <cmath>
#include <limits>

#include "finite.hpp"
#include "scaling.hpp"

namespace rotconv::quaternion {

Reading to_rotation(const Quaternion& q) noexcept {
    if (!all_finite(q.w, q.x, q.y, q.z)) {
        return Reading::failed(Fault::not_finite);
    }
    const double largest = largest_magnitude(q.w, q.x, q.y, q.z);
    if (largest == 0.0) {
        return Reading::failed(Fault::zero_quaternion);
    }
    Reading reading;
    reading.rotation = Rotation::from_components(q.w, q.x, q.y, q.z);
    const double norm = PowerOfTwo::to_unit(largest).undone(std::sqrt(reading.rotation.squared_norm()));
    reading.defect = std::fabs(norm - 1.0);
    return reading;
}

Quaternion from_rotation(const Rotation& rotation) noexcept {
    // A Rotation's scale is a power of two, so a quaternion that came in with norm 1 is found by doubling.
    const double squared_norm = rotation.squared_norm();
    const double unit_scale = squared_norm > 0.5 ? 1.0 : 2.0;
    const double excess = squared_norm * (unit_scale * unit_scale) - 1.0;
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    const double divisor = std::fabs(excess) <= rounding ? 1.0 / unit_scale : std::sqrt(squared_norm);
    return {rotation.w() / divisor, rotation.x() / divisor, rotation.y() / divisor, rotation.z() / divisor};
}

Figures figures(const Rotation& /*rotation*/) noexcept { return {.condition = 0.5}; }

} // namespace rotconv::quaternion
