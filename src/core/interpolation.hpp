#pragma once

#include <optional>

#include <rotconv/rotation.hpp>

namespace rotconv {

/// The attitude a (a^-1 b)^fraction, on the shortest turn from `a` to `b`: of the same digits where both have the same,
/// otherwise unit to rounding and right to 4 eps. The same bits on every machine. Nothing where the two are, to
/// rounding, half a turn apart: then no turn between them is the shortest.
/// @pre fraction is in [0, 1]
[[nodiscard]] std::optional<Rotation> interpolated(const Rotation& a, const Rotation& b, double fraction) noexcept;

} // namespace rotconv
