#pragma once

#include <cmath>

#include <rotconv/reading.hpp>

namespace rotconv {

/// theta in [0, pi].
inline double angle_of(const Rotation& rotation) noexcept {
    return 2.0 * std::atan2(rotation.vector_length(), std::fabs(rotation.w()));
}

/// pi - theta, without cancellation.
inline double angle_to_half_turn(const Rotation& rotation) noexcept {
    return 2.0 * std::atan2(std::fabs(rotation.w()), rotation.vector_length());
}

/// pi - theta <= half_turn_margin, from the parts of a quaternion; tan(x/2) = x/2 at this size.
inline DiagnosticSet note_half_turn(double w, double vector_length) noexcept {
    return {DiagnosticKind::half_turn, std::fabs(w) <= (0.5 * half_turn_margin) * vector_length};
}

inline DiagnosticSet note_half_turn(const Rotation& q) noexcept {
    // |w| <= length/2e15, whose square may underflow where w is not 0
    const double size = std::fabs(q.x()) + std::fabs(q.y()) + std::fabs(q.z());
    return std::fabs(q.w()) <= half_turn_margin * size ? note_half_turn(q.w(), q.vector_length()) : DiagnosticSet{};
}

} // namespace rotconv
