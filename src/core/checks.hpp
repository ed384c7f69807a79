#pragma once

#include <cstddef>

#include <rotconv/spec.hpp>

namespace rotconv {

/// @throw std::invalid_argument if there are fewer numbers than needed
void check_size(std::size_t given, std::size_t needed);

/// The count of rows of `width` numbers.
/// @throw std::invalid_argument if the numbers are not whole rows, or if there is no room for the numbers of the
/// results
[[nodiscard]] std::size_t checked_rows(std::size_t numbers, std::size_t width, std::size_t room, std::size_t out_width);

/// The spec.
/// @throw std::invalid_argument if it has a modifier that has no meaning for its representation
const Spec& checked(const Spec& spec);

} // namespace rotconv
