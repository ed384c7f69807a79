#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "../bytes/io_block.hpp"
#include "../event.hpp"
#include "../options.hpp"
#include "header_line.hpp"

namespace rotconv::stream {

/// What the lines are that begin a stream: those before `rows` pass, but for the header and its units.
struct Beginning {
    std::optional<HeaderLine> header{};
    std::optional<HeaderLine> units{}; ///< the line below the header that has its units
    std::size_t rows = 0;              ///< index of the first line that is a row; all lines after it are rows too
    std::optional<HeaderLine> row{};   ///< the one that fixes the delimiter and the number of fields, if there is one
    std::vector<std::size_t> positions{}; ///< where the numbers stand that are selected by names or a project
    std::optional<Note> choice{};         ///< says so, if nobody asked for these columns
    std::optional<StreamError> error{};   ///< without its place
    Line error_line{};                    ///< the line that the error is about
};

/// Decides where rows begin. A line, neither blank nor a comment, is numeric if its selected fields are numbers or
/// words for a missing one, at least one of them a number. The first numeric line is the first row, and fixes the
/// delimiter and the number of fields; the header stands above it. With `is_end` no line is looked at after these.
/// @return nothing if a later line decides
[[nodiscard]] std::optional<Beginning> decide(std::span<const Line> lines, const InputOptions& options, bool is_end);

} // namespace rotconv::stream
