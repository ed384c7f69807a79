#pragma once

#include <cstdint>
#include <numbers>

#include <rotconv/version.hpp>

namespace rotconv {

/// The unit of an angle. Degrees are reduced modulo 360 exactly before any conversion, and multiples of 90 degrees are
/// exact both ways.
enum class AngleUnit : std::uint8_t { radians, degrees };

inline constexpr double radians_per_degree = std::numbers::pi / 180.0;
inline constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

} // namespace rotconv
