#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "bytes/file.hpp"
#include "event.hpp"
#include "options.hpp"

namespace rotconv::stream {

/// How a run ended.
struct RunResult {
    bool reader_left = false; ///< the other end of the output's pipe was closed, which is not an error
    bool stopped = false;     ///< at a row error, which was reported
    std::optional<StreamError> error;
    std::size_t rows = 0;                 ///< data rows of the stream, paired or not
    std::size_t answered = 0;             ///< data rows that have a result
    std::array<Unpaired, 2> unpaired{};   ///< by Side
    PairingStats keys{};                  ///< the keys by which rows were paired
    std::vector<std::size_t> positions{}; ///< the fields that hold the numbers, from 0; empty: all do
};

/// Converts a stream. Every row is written, or added to the fold, as soon as it has been read, and before anything is
/// reported of it.
/// @param sink null: no rows are written
/// @param reference the other stream, if the options have a pairing
RunResult run(Source& source, Sink* sink, Options options, const std::function<void(const Event&)>& report,
              Source* reference = nullptr);

} // namespace rotconv::stream
