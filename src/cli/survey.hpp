#pragma once

#include "command_line.hpp"
#include "exit_code.hpp"

namespace rotconv::cli {

/// Reads the attitudes and prints what they demand of each set, and the smallest set that serves.
[[nodiscard]] ExitCode survey(const SurveyCommand& command);

} // namespace rotconv::cli
