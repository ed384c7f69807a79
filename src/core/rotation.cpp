#include <rotconv/quaternion.hpp>

#include <ostream>

#include "numerics/power_of_two.hpp"

namespace rotconv {

Rotation Rotation::scaled(double w, double x, double y, double z) noexcept {
    const auto scale = PowerOfTwo::to_unit(largest_magnitude(w, x, y, z));
    return {scale(w), scale(x), scale(y), scale(z)};
}

std::ostream& operator<<(std::ostream& out, const Rotation& rotation) {
    const Eigen::Quaterniond q = quaternion::from_rotation(rotation);
    return out << q.w() + 0.0 << ' ' << q.x() + 0.0 << ' ' << q.y() + 0.0 << ' ' << q.z() + 0.0; // never -0
}

double Rotation::vector_length() const noexcept { return norm_of(q_[1], q_[2], q_[3]); }

} // namespace rotconv
