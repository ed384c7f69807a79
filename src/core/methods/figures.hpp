#pragma once

#include <limits>
#include <string_view>

#include <rotconv/method.hpp>

namespace rotconv {

/// The measured worst errors of a method.
struct Measurement {
    RepresentationId from;
    RepresentationId to;
    std::string_view name;
    Worst clean;
    Worst hostile;
};

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Those of examples/charts/methods.csv to two digits, as figures.awk prints them.
inline constexpr Measurement figures[] = {
#include "figures.inc"
};

} // namespace rotconv
