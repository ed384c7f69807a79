#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "event.hpp"
#include "file.hpp"
#include "options.hpp"

namespace rotconv::stream {

/// How a run ended.
struct RunResult {
    bool reader_left = false; ///< the other end of the pipe was closed: not an error
    bool stopped = false;     ///< at a row error, which was reported
    std::optional<StreamError> error;
    std::size_t rows = 0;                 ///< data rows of the stream, paired or not
    std::size_t answered = 0;             ///< those that have a result
    std::array<Unpaired, 2> unpaired{};   ///< of the stream, and of the reference
    KeysMet keys{};                       ///< by which rows were paired
    std::vector<std::size_t> positions{}; ///< of the fields that hold the numbers, from 0; none where all do
};

/// Converts a stream. Every row is written, or added to the fold, before anything is reported of it, and as soon as it
/// has been read.
/// @param sink null where the options write no rows
/// @param reference with whose rows those of the stream are paired, if the options have a pairing
RunResult run(Source& source, Sink* sink, const Options& options, const std::function<void(const Event&)>& report,
              Source* reference = nullptr);

} // namespace rotconv::stream
