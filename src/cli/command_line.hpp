#pragma once

#include <string>
#include <vector>

#include "command.hpp"

namespace rotconv::cli {

[[nodiscard]] Command read_command_line(int argc, const char* const* argv);

/// The conversion, whose name is empty, or a command.
struct CommandText {
    std::string name;
    std::string about;
    std::unique_ptr<CommandOptions> options;
};

/// All of them, for completion.
[[nodiscard]] std::vector<CommandText> command_table();

} // namespace rotconv::cli
