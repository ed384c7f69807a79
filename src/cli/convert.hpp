#pragma once

#include "command_line.hpp"
#include "exit_code.hpp"

namespace rotconv::cli {

/// Runs a conversion, tells on stderr what there is to tell, and returns the exit code.
[[nodiscard]] ExitCode convert(const ConvertCommand& command);

} // namespace rotconv::cli
