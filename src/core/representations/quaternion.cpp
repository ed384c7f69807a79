#include <rotconv/quaternion.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "../numerics/finite.hpp"
#include "../numerics/scaling.hpp"
#include "batches.hpp"

namespace rotconv::quaternion {

Reading to_rotation_of_any_size(const Quaternion& q) noexcept {
    if (!all_finite(q.w, q.x, q.y, q.z)) {
        return Reading::failed(Error::not_finite);
    }
    if (largest_magnitude(q.w, q.x, q.y, q.z) == 0.0) {
        return Reading::failed(Error::zero_quaternion);
    }
    return {.rotation = Rotation::from_components(q.w, q.x, q.y, q.z), .defect = defect(q)};
}

ROTCONV_TARGET_CLONES
void write(const Rotations& rotations, std::size_t rows, double* numbers, DiagnosticSet* diagnostics) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        const Quaternion q = from_rotation(rotations.at(i));
        numbers[4 * i] = q.w;
        numbers[4 * i + 1] = q.x;
        numbers[4 * i + 2] = q.y;
        numbers[4 * i + 3] = q.z;
    }
    std::fill_n(diagnostics, rows, DiagnosticSet{});
}

double defect(const Quaternion& q) noexcept {
    const auto scale = PowerOfTwo::to_unit(largest_magnitude(q.w, q.x, q.y, q.z));
    const Rotation scaled = Rotation::near_unit(scale(q.w), scale(q.x), scale(q.y), scale(q.z));
    return std::fabs(scale.undone(std::sqrt(scaled.squared_norm())) - 1.0);
}

Sensitivity sensitivity(const Rotation& /*rotation*/) noexcept { return {.condition = 0.5}; }

Quaternion rate(const Quaternion& q, const Eigen::Vector3d& w, Frame frame) noexcept {
    const Eigen::Vector3d v{q.x, q.y, q.z};
    const Eigen::Vector3d turn = frame == Frame::body ? v.cross(w) : w.cross(v);
    const Eigen::Vector3d rates = 0.5 * (q.w * w + turn);
    return {-0.5 * v.dot(w), rates.x(), rates.y(), rates.z()};
}

Eigen::Vector3d angular_velocity(const Quaternion& q, const Quaternion& rates, Frame frame) noexcept {
    // Both times one power of two, so that |q|^2 is near 1.
    const auto scale = PowerOfTwo::to_unit(largest_magnitude(q.w, q.x, q.y, q.z));
    const Eigen::Vector3d v{scale(q.x), scale(q.y), scale(q.z)};
    const Eigen::Vector3d v_rate{scale(rates.x), scale(rates.y), scale(rates.z)};
    const double w = scale(q.w);
    const Eigen::Vector3d turn = frame == Frame::body ? v_rate.cross(v) : v.cross(v_rate);
    return (2.0 / (w * w + v.squaredNorm())) * (w * v_rate - scale(rates.w) * v + turn);
}

} // namespace rotconv::quaternion
