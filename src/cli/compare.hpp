#pragma once

#include "command_line.hpp"
#include "exit_code.hpp"
#include "options.hpp"

/// The check of attitudes against others.
namespace rotconv::cli {

void define_compare(CLI::App& app, RawOptions& texts);

/// @throw Usage
[[nodiscard]] CompareCommand compare_command(const RawOptions& texts, const Operands& operands);

[[nodiscard]] ExitCode compare(const CompareCommand& command);

} // namespace rotconv::cli
