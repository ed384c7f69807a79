#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "../stream/file.hpp"
#include "../stream/job.hpp"

#include "command_line.hpp"
#include "exit_code.hpp"

namespace rotconv::cli {

/// What came of a run.
struct RowsResult {
    ExitCode code = ExitCode::done;
    bool reader_left = false; ///< closed the pipe: nothing more is known, and nothing to be said
    std::size_t answered = 0; ///< rows with a result
    std::size_t failed = 0;
    std::size_t beyond = 0;                     ///< rows with that diagnostic...
    std::size_t first_beyond = 0;               ///< ...and the line of the first
    std::array<stream::Unpaired, 2> unpaired{}; ///< of the input, and of the reference
};

/// What is made of a run in the place of rows on stdout.
struct Conclusion {
    stream::Sink& rows;                                        ///< where they go
    std::function<std::string(const RowsResult& result)> text; ///< printed at the end of a run that was not stopped
};

/// Settles what depends on the first row, neither blank nor a comment; it is empty where there is none.
/// @return what is wrong with the row, or nothing
using Settle = std::function<std::string(std::string_view first_row, RowsCommand& command)>;

/// Runs the rows, and tells on stderr what there is to tell.
[[nodiscard]] RowsResult run_rows(RowsCommand command, const std::optional<Conclusion>& conclusion = {},
                                  const Settle& settle = {});

} // namespace rotconv::cli
