#pragma once

#include <cstdint>

namespace rotconv {

/// The unit that travels with every angle. Degrees are reduced modulo 360 exactly before any conversion, and multiples
/// of 90 degrees are exact both ways.
enum class AngleUnit : std::uint8_t { radians, degrees };

} // namespace rotconv
