#pragma once

#include <array>
#include <cstdint>

#include <rotconv/version.hpp>

/// The table of representations, in the order in which they are listed, one row `line(identifier)` for each. Everything
/// else about a representation is in its codec and its kernel.
// clang-format off
#define ROTCONV_REPRESENTATIONS(line) \
    line(dcm) \
    line(two_column) \
    line(five_d) \
    line(quat) \
    line(axis_angle) \
    line(rotvec) \
    line(euler) \
    line(rpy) \
    line(cayley) \
    line(mrp)
// clang-format on

namespace rotconv {

#define ROTCONV_LINE(id) id,
/// Names a representation in code; representation() has the rest.
enum class RepresentationId : std::uint8_t { ROTCONV_REPRESENTATIONS(ROTCONV_LINE) };
#undef ROTCONV_LINE

#define ROTCONV_LINE(id) RepresentationId::id,
inline constexpr std::array all_representations{ROTCONV_REPRESENTATIONS(ROTCONV_LINE)};
#undef ROTCONV_LINE

} // namespace rotconv
