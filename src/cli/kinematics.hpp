#pragma once

#include "command_line.hpp"
#include "options.hpp"

/// The commands about motions: their options, and what these mean.
namespace rotconv::cli {

void define_rates(CLI::App& app, RawOptions& texts);
void define_propagate(CLI::App& app, RawOptions& texts);
void define_survey(CLI::App& app, RawOptions& texts);

/// @throw Usage
[[nodiscard]] RowsCommand rates_command(const RawOptions& texts, const Operands& operands);
[[nodiscard]] RowsCommand propagate_command(const RawOptions& texts, const Operands& operands);
[[nodiscard]] SurveyCommand survey_command(const RawOptions& texts, const Operands& operands);

} // namespace rotconv::cli
