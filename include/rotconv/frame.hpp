#pragma once

#include <cstdint>

#include <rotconv/version.hpp>

namespace rotconv {

/// The axes in which an angular velocity is given: w_ref = R w_body. The angular velocity is always that of the body
/// relative to the reference, in radians a second: Rdot = R [w_body]_x = [w_ref]_x R (Stuelpnagel 1964, section 1: Xdot
/// = Omega X with X = R' and Omega = -[w_body]_x).
enum class Frame : std::uint8_t { body, reference };

} // namespace rotconv
