#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rotconv/spec.hpp>

#include "../stream/delimiter.hpp"

/// Numbers as people type them, and as programs print them.
namespace rotconv::cli {

/// The word is a number, or begins with one before a separator; after brackets its first character is enough.
[[nodiscard]] bool is_value(std::string_view word);

/// A number stands in the word by itself: bounded by its ends, blanks, commas, semicolons, brackets, quotes, : or =.
[[nodiscard]] bool holds_number(std::string_view word);

/// VALUEs as one row, with what the numbers are called.
struct Values {
    std::string row{};
    stream::Delimiter delimiter = stream::Delimiter::blanks();
    std::vector<std::string> labels{}; ///< of each number, empty where it has none; none at all: no number has one
};

/// Several words are a row with commas or blanks, whatever delimiter is `given`. Brackets, semicolons and line ends
/// separate numbers too, as commas do if there are any, otherwise as blanks do: so a matrix of NumPy, MATLAB or JSON
/// can be pasted. A word before :, = or a blank and a number is its label; words before brackets and quotes, keys
/// without a number, a word before the first number alone, and marks without letters and digits are left out.
[[nodiscard]] Values values_of(const std::vector<std::string>& words, std::optional<stream::Delimiter> given);

/// Leaves the rotation of a matrix of 4x4, row by row, whose last row is 0 0 0 1.
/// @throw Usage if there are more numbers than the SPEC has, and labels that name its own among them
void take_attitude(Values& values, const Spec& spec);

} // namespace rotconv::cli
