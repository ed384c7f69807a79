#pragma once

namespace rotconv {

/// True when no argument is nan or infinite: x - x is 0 for those alone, and nan stays nan in a sum.
template <class... Numbers> bool all_finite(Numbers... numbers) noexcept { return (... + (numbers - numbers)) == 0.0; }

} // namespace rotconv
