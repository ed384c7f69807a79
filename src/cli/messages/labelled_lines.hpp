#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../../stream/rows/row_operation.hpp"

namespace rotconv::cli {

/// Commands of the shell that make rows of lines that also have words: of their numbers alone.
struct LabelledLines {
    std::string command;   ///< that reads the file
    std::string others;    ///< behind a |
    std::string text;      ///< what they make of the lines
    std::string line;      ///< the first
    bool is_ragged;        ///< its lines have different counts of numbers
    std::string columns;   ///< of the attitude among the numbers, as a LIST
    bool is_named = false; ///< labels say which numbers these are
};

/// Of the lines that hold an attitude as VALUEs do, such as XP1={X 445,Y 0,Z 790,A 30,B 20,C 10}, those with a word of
/// the first one, or all that have numbers: the most that hold it at the same place. Nothing where there are none.
/// @param from the SPEC as it is given
/// @param by_labels only numbers count whose labels say which they are
[[nodiscard]] std::optional<LabelledLines> labelled_lines(const std::vector<std::string_view>& lines,
                                                          const stream::RowNumbers& numbers, const std::string& from,
                                                          bool by_labels);

/// The numbers of a text whose labels are the names of all numbers of a row, as words with their labels; none where the
/// text also has what may change their meaning.
[[nodiscard]] std::vector<std::string> labelled_numbers(const std::string& text, const stream::RowNumbers& numbers);

/// Of lines such as `x: 0.5` and `Q1 = 0.5`, those with the names of a SPEC below each other, perhaps under a name that
/// tells them from others, as in a message of ROS: two sets of names at most.
/// @param is_cut more lines follow, so that the last row may not be whole
[[nodiscard]] std::vector<LabelledLines> named_lines(const std::vector<std::string_view>& lines, const Spec& spec,
                                                     bool is_cut);

} // namespace rotconv::cli
