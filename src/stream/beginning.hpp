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
    bool is_decided = false; ///< else a later line tells, unless there is an error
    std::optional<HeaderLine> header{};
    bool is_data = false;                 ///< the last line is the first data row, or an error in its place
    std::vector<std::size_t> positions{}; ///< of columns that are selected by name
    std::optional<StreamError> error{};   ///< its line is an index among the lines, from 0
};

/// Decides on lines that begin a stream, of which the last is a row, neither blank nor a comment. `is_end`: none
/// follows, and the last may be anything.
[[nodiscard]] Beginning decide(const std::vector<Line>& lines, const InputOptions& options, bool is_end);

} // namespace rotconv::stream
