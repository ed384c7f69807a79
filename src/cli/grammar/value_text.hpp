#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rotconv/spec.hpp>

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

/// What words mean in a text; some mean several things.
enum class WordKind : std::uint8_t {
    heading,
    declaration,      ///< before a name
    container,        ///< before a bracket
    container_xyzw,   ///< a container of a quaternion whose scalar is the last
    text_key,         ///< the label of something that is not a number
    xml_key,          ///< the same among the attributes of an element
    truth,            ///< true and its like
    degrees,          ///< a unit
    radians,          ///< a unit
    length,           ///< a unit
    aside,            ///< at the end of a label whose numbers are not read
    size,             ///< the label of a number that is not one of the attitude
    aside_anywhere,   ///< as a part of such a label
    aside_beginning,  ///< as the beginning or the end of a part of such a label
    operation,        ///< a part of a label that says that something is done to the numbers
    open_name,        ///< a name that does not contradict another
    attitude,         ///< at the end of a label of an attitude
    number_of_a_set,  ///< the label of one number
    vector_of_angles, ///< before x, y and z
};

/// The words of the kind, with blanks between.
[[nodiscard]] std::string_view words_of(WordKind kind);

/// Whether the word, in any case, is of the kind.
[[nodiscard]] bool is(WordKind kind, std::string_view word);

/// deg, rad, m for any length, or empty.
[[nodiscard]] std::string_view unit_of_word(std::string_view word);

/// What a word says of numbers: deg, rad, xyzw, wxyz, ypr, a modifier, a sequence or a name of a representation; or
/// empty. Case counts in a sequence alone.
[[nodiscard]] std::string convention_in(std::string_view word);

/// The representation that a word names, in any case and with what programs put around it, as Quaterniond or from_quat.
[[nodiscard]] std::optional<RepresentationId> named_representation(std::string_view word);

/// The words of a label: they end at _ . : blanks and where upper case begins.
[[nodiscard]] std::vector<std::string> parts_of_label(std::string_view label);

/// Whether a name says that something is done to the numbers: q_inv, R.T.
[[nodiscard]] bool is_operation(std::string_view label);

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
