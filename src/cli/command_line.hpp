#pragma once

#include <string>
#include <variant>

#include <rotconv/conversion.hpp>

#include "../stream/layout.hpp"

namespace rotconv::cli {

enum class ShowDiagnostics { off, summary, rows, columns };

/// `rotconv -f FROM -t TO ...`, checked.
struct ConvertCommand {
    explicit ConvertCommand(const Conversion& conversion) : options(conversion) {}

    stream::Options options;
    Settings settings;
    ShowDiagnostics diagnostics = ShowDiagnostics::summary;
    bool strict = false;
    std::string input = "-";
    std::string output = "-";
    bool has_values = false;
    std::string values; ///< the VALUEs as one row
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

using Command = std::variant<ConvertCommand, ListCommand, PrintCommand, UsageError>;

[[nodiscard]] Command read_command_line(int argc, const char* const* argv);

} // namespace rotconv::cli
