#pragma once

#include <string>
#include <utility>
#include <variant>

#include "../stream/options.hpp"
#include "messages.hpp"

namespace rotconv::cli {

enum class ShowDiagnostics { off, summary, rows, columns };

/// A command that makes something of each row, checked: `rotconv -f FROM -t TO ...`, `rotconv rates ...` and
/// `rotconv propagate ...`.
struct RowsCommand {
    RowsCommand(stream::RowOperation operation, messages::Subject about)
        : options(std::move(operation)), subject(std::move(about)) {}

    stream::Options options;
    messages::Subject subject; ///< what the rows are, for messages
    ShowDiagnostics diagnostics = ShowDiagnostics::summary;
    bool strict = false;
    std::string input = "-";
    std::string output = "-";
    bool has_values = false;
    std::string values;    ///< the VALUEs as one row
    bool progress = false; ///< where a terminal shows it
};

/// `rotconv survey ...`, checked.
struct SurveyCommand {
    RowsCommand rows; ///< the input, its attitudes not yet taken by anybody
    Spec from;
    double condition = 0.0; ///< the greatest that serves
    bool json = false;
};

/// `rotconv list [NAME]`.
struct ListCommand {
    std::string name;
};

/// A text to print on stdout: help or version.
struct PrintCommand {
    std::string text;
};

/// A mistake in the command line, in words.
struct UsageError {
    std::string message;
};

using Command = std::variant<RowsCommand, SurveyCommand, ListCommand, PrintCommand, UsageError>;

[[nodiscard]] Command read_command_line(int argc, const char* const* argv);

} // namespace rotconv::cli
