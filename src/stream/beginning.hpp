#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "event.hpp"
#include "header_line.hpp"
#include "io_block.hpp"
#include "options.hpp"

namespace rotconv::stream {

/// What the lines before the first data row are.
struct Beginning {
    std::optional<HeaderLine> header{};
    bool is_data = false;                 ///< the last line is the first data row, or an error instead of it
    std::vector<std::size_t> positions{}; ///< where columns stand that are selected by name
    std::optional<StreamError> error{};   ///< without its place
    Line error_line{};                    ///< the line that the error is about
};

/// Decides on the lines that begin a stream. The last is a row, neither blank nor a comment; with `is_end` no line
/// follows, and the last may be anything.
/// @return nothing if a later line decides
[[nodiscard]] std::optional<Beginning> decide(std::span<const Line> lines, const InputOptions& options, bool is_end);

} // namespace rotconv::stream
