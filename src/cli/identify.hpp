#pragma once

#include "command_line.hpp"
#include "exit_code.hpp"
#include "options.hpp"

namespace rotconv::cli {

void define_identify(CLI::App& app, RawOptions& texts);
/// @throw Usage
[[nodiscard]] IdentifyCommand identify_command(const RawOptions& texts, const Operands& operands);

/// Runs `rotconv identify`.
[[nodiscard]] ExitCode identify(const IdentifyCommand& command);

} // namespace rotconv::cli
