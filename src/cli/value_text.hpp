#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rotconv/representation_id.hpp>

/// The grammar of attitudes as people type them and programs print them.
///
///     text     = { item | separator | mark }
///     item     = number | label value | { container } [ remark ] bracket | word
///     number   = decimal [ unit | "f" | "i" | "j" | "k" ]
///     label    = name [ "[" unit "]" ] ( ":" | "=" ) | name blank         (a blank only before a number)
///     value    = number { number } | { container } bracket | block        (a block is the deeper lines of YAML)
///     bracket  = ( "[" | "(" | "{" | "<" | quote ) text closing | "<" name text ( "/>" | ">" | "</" name ">" )
///     remark   = "(" word of convention or unit ")"
///     word     = heading | word of convention | unit
///
/// Everything else is an error that names the word.
namespace rotconv::cli {

/// Numbers that belong together, because they stand in a bracket, a block or a list after a label.
struct ValueGroup {
    std::string label;      ///< empty: that of the text as a whole
    std::size_t parent = 0; ///< its index
    std::string unit;       ///< of all its numbers: deg or rad
};

/// A number and what the text says of it.
struct ValueNumber {
    std::string text{};      ///< empty: nothing between two commas
    std::string label{};     ///< its own
    std::string unit{};      ///< deg, rad, or m for any length
    char component = '\0';   ///< i, j or k in the sum of a quaternion
    std::size_t group = 0;   ///< the index of the innermost group with a label
    std::size_t bracket = 0; ///< counts the brackets before it, so that equal ones are those of one bracket
    bool is_joined = false;  ///< nothing but blanks separates it from the number before it
};

/// A word that says how numbers are meant: xyzw, ZYX, rpy, passive, quat.
struct ValueWord {
    std::string text;
    std::size_t group = 0;
    bool is_order = false; ///< letters after `order`, which mean two things
};

struct ValueText {
    std::vector<ValueGroup> groups;
    std::vector<ValueNumber> numbers;
    std::vector<ValueWord> words;
};

/// @throw Usage if the text holds anything that the grammar does not have
[[nodiscard]] ValueText parse_values(std::string_view text);

/// The representation that a word names, in any case and with what programs put around it, as Quaterniond or from_quat.
[[nodiscard]] std::optional<RepresentationId> named_representation(std::string_view word);

/// The words of a label, in lower case: they end at _ . : blanks and where upper case begins.
[[nodiscard]] std::vector<std::string> parts_of_label(std::string_view label);

/// Where a number stands by itself: bounded by the ends, blanks, commas, semicolons, brackets, quotes, : or =.
[[nodiscard]] bool holds_number(std::string_view word);

} // namespace rotconv::cli
