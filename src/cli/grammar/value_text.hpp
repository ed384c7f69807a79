#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "vocabulary.hpp"

/// The grammar of attitudes as people type them and programs print them.
///
///     text     = { item | separator | mark }
///     item     = number | sum | label value | { container | word } [ remark ] bracket | word | remark
///     number   = decimal [ unit | "f" ]
///     sum      = number ( "i" | "j" | "k" ) { [ "+" | "-" ] number [ "i" | "j" | "k" ]    (or the other way round)
///     label    = name [ remark ] ( ":" | "=" ) | name blank                  (a blank only before a number)
///     value    = number { number } | { container } bracket | block           (a block is the deeper lines of YAML)
///     bracket  = ( "[" | "(" | "{" | "<" | quote ) text closing [ unit | remark ]
///              | "<" name text ( "/>" | ">" | ">" text "</" name ">" )
///     remark   = ( "[" | "(" ) ( unit | word of convention | w x y z | x y z w ) closing
///     word     = heading | word of convention | unit
///
/// Everything else is an error that names the word.
namespace rotconv::cli {

/// Numbers that belong together, because they stand in a bracket, a block or a list after a label.
struct ValueGroup {
    std::string label;      ///< empty: that of the text as a whole
    std::size_t parent = 0; ///< its index
};

/// A number and what the text says of it.
struct ValueNumber {
    std::string text{};      ///< empty: nothing between two commas
    std::string label{};     ///< its own
    std::string unit{};      ///< deg, rad, or m for any length
    std::size_t group = 0;   ///< the index of the innermost group with a label
    std::size_t bracket = 0; ///< counts the brackets before it, so that equal ones are those of one bracket
    bool is_joined = false;  ///< nothing but blanks separates it from the number before it
    bool after_comma = false;
};

/// A word that says how the numbers of a group are meant: a unit, or a word of convention.
struct ValueWord {
    std::string text;
    std::size_t group = 0;
};

struct ValueText {
    std::vector<ValueGroup> groups;
    std::vector<ValueNumber> numbers;
    std::vector<ValueWord> words;
};

/// @throw Usage if the text holds anything that the grammar does not have
[[nodiscard]] ValueText parse_values(std::string_view text);

/// Where a number, perhaps with its unit, stands by itself: it is no part of a word.
[[nodiscard]] bool holds_number(std::string_view word);

} // namespace rotconv::cli
