#pragma once

#include <cmath>

namespace rotconv {

/// True when no argument is nan or infinite.
template <class... Numbers> bool all_finite(Numbers... numbers) noexcept { return (... && std::isfinite(numbers)); }

} // namespace rotconv
