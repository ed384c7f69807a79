#include <rotconv/cayley.hpp>

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "../numerics/finite.hpp"
#include "batches.hpp"
#include "half_turn.hpp"

namespace rotconv::cayley {
namespace {

double infinite_along(double component) noexcept {
    return component == 0.0 ? 0.0 : std::copysign(std::numeric_limits<double>::infinity(), component);
}

} // namespace

Eigen::Vector3d from_rotation(const Rotation& rotation) noexcept {
    Eigen::Vector3d c;
    DiagnosticSet diagnostics;
    write(OneRotation(rotation), 1, c.data(), &diagnostics);
    return c;
}

ROTCONV_TARGET_CLONES void write(const Rotations& rotations, std::size_t rows, double* numbers,
                                 DiagnosticSet* diagnostics) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        numbers[3 * i] = rotations.x[i] / rotations.w[i];
        numbers[3 * i + 1] = rotations.y[i] / rotations.w[i];
        numbers[3 * i + 2] = rotations.z[i] / rotations.w[i];
    }
    for (std::size_t i = 0; i < rows; ++i) {
        double* const c = numbers + 3 * i;
        const bool finite = all_finite(c[0], c[1], c[2]);
        diagnostics[i] = {DiagnosticKind::infinite, !finite};
        if (!finite) {
            const Rotation q = rotations.at(i).canonical();
            c[0] = infinite_along(q.x());
            c[1] = infinite_along(q.y());
            c[2] = infinite_along(q.z());
        }
    }
}

Sensitivity sensitivity(const Rotation& rotation) noexcept {
    const double length = rotation.vector_length() / rotation.w();
    return {.margin = angle_to_half_turn(rotation), .condition = 0.5 * (1.0 + length * length)};
}

Eigen::Vector3d rate(const Eigen::Vector3d& c, const Eigen::Vector3d& w, Frame frame) noexcept {
    const Eigen::Vector3d turn = frame == Frame::body ? c.cross(w) : w.cross(c);
    return 0.5 * (w + turn + c.dot(w) * c);
}

Eigen::Vector3d angular_velocity(const Eigen::Vector3d& c, const Eigen::Vector3d& rates, Frame frame) noexcept {
    const Eigen::Vector3d turn = frame == Frame::body ? rates.cross(c) : c.cross(rates);
    return (2.0 / (1.0 + c.squaredNorm())) * (rates + turn);
}

} // namespace rotconv::cayley
