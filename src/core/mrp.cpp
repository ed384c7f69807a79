#include <rotconv/mrp.hpp>

#include <algorithm>
#include <cmath>

#include "double_double.hpp"
#include "finite.hpp"
#include "half_turn.hpp"
#include "scaling.hpp"

namespace rotconv::mrp {

Reading to_rotation(const Eigen::Vector3d& m) noexcept {
    if (!all_finite(m.x(), m.y(), m.z())) {
        return Reading::failed(Fault::not_finite);
    }
    // Times the square of a power of two f <= 1, so that |m|^2 cannot overflow.
    const auto scale = PowerOfTwo::to_unit(std::max(0.5, m.cwiseAbs().maxCoeff()));
    const double f = scale(1.0);
    const double x = scale(m.x());
    const double y = scale(m.y());
    const double z = scale(m.z());
    // The rounding of |m|^2 would be the largest part of the error where |m| is about 1 or more.
    const DoubleDouble square = squared_length(x, y, z);
    const double w = (f * f - square.hi) - square.lo;
    return {.rotation = Rotation::from_components(w, 2.0 * f * x, 2.0 * f * y, 2.0 * f * z)};
}

Eigen::Vector3d from_rotation(const Rotation& rotation) noexcept {
    const double divisor = std::sqrt(rotation.squared_norm()) + rotation.w();
    return {rotation.x() / divisor, rotation.y() / divisor, rotation.z() / divisor};
}

Notes notes(const Rotation& rotation) noexcept { return note_half_turn(rotation); }

Figures figures(const Rotation& rotation) noexcept {
    const double norm = std::sqrt(rotation.squared_norm());
    return {.margin = angle_to_half_turn(rotation), .condition = 0.5 * norm / (norm + rotation.w())};
}

} // namespace rotconv::mrp
