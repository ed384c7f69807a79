#include <rotconv/quaternion.hpp>

#include "finite.hpp"
#include "scaling.hpp"

namespace rotconv::quaternion {

Reading to_rotation_of_any_size(const Quaternion& q) noexcept {
    if (!all_finite(q.w, q.x, q.y, q.z)) {
        return Reading::failed(Fault::not_finite);
    }
    if (largest_magnitude(q.w, q.x, q.y, q.z) == 0.0) {
        return Reading::failed(Fault::zero_quaternion);
    }
    return {.rotation = Rotation::from_components(q.w, q.x, q.y, q.z), .defect = defect(q)};
}

double defect(const Quaternion& q) noexcept {
    const auto scale = PowerOfTwo::to_unit(largest_magnitude(q.w, q.x, q.y, q.z));
    const Rotation scaled = Rotation::near_unit(scale(q.w), scale(q.x), scale(q.y), scale(q.z));
    return std::fabs(scale.undone(std::sqrt(scaled.squared_norm())) - 1.0);
}

Figures figures(const Rotation& /*rotation*/) noexcept { return {.condition = 0.5}; }

} // namespace rotconv::quaternion
