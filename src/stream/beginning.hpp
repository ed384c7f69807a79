#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "event.hpp"
#include "header_line.hpp"
#include "io_block.hpp"
#include "options.hpp"

namespace rotconv::stream {

/// What the lines before the first data row are.
struct Beginning {
    bool is_decided = false; ///< otherwise a later line decides, unless there is an error
    std::optional<HeaderLine> header{};
    bool is_data = false;                 ///< the last line is the first data row, or an error instead of it
    std::vector<std::size_t> positions{}; ///< where columns stand that are selected by name
    std::optional<StreamError> error{};   ///< its line is an index among the lines, from 0
};

/// Decides on the lines that begin a stream. The last is a row, neither blank nor a comment; with `is_end` no line
/// follows, and the last may be anything.
[[nodiscard]] Beginning decide(const std::vector<Line>& lines, const InputOptions& options, bool is_end);

} // namespace rotconv::stream
