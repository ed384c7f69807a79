#pragma once

#include <memory>

#include "command.hpp"

/// Each command stands in a source of its name.
namespace rotconv::cli {

[[nodiscard]] std::unique_ptr<CommandOptions> convert_options();
[[nodiscard]] std::unique_ptr<CommandOptions> rates_options();
[[nodiscard]] std::unique_ptr<CommandOptions> propagate_options();
[[nodiscard]] std::unique_ptr<CommandOptions> survey_options();
[[nodiscard]] std::unique_ptr<CommandOptions> compare_options();
[[nodiscard]] std::unique_ptr<CommandOptions> identify_options();
[[nodiscard]] std::unique_ptr<CommandOptions> list_options();

/// What follows the options in the help: the words of SPECs, the exit status and examples.
[[nodiscard]] std::string help_footer();

} // namespace rotconv::cli
