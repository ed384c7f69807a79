#pragma once

#include <functional>
#include <optional>
#include <string>

#include "command_line.hpp"
#include "exit_code.hpp"

namespace rotconv::cli {

/// What is printed of a run in the place of its rows.
using Conclusion = std::function<std::string()>;

/// Runs the rows, tells on stderr what there is to tell, and returns the exit code. With a conclusion the rows are not
/// written; it is asked for at the end of a run that was not stopped.
[[nodiscard]] ExitCode run_rows(const RowsCommand& command, const Conclusion& conclusion = {});

} // namespace rotconv::cli
