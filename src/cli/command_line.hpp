#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <rotconv/identification.hpp>
#include <rotconv/survey.hpp>

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
    std::string values; ///< the VALUEs as one row

    /// The stream that the rows are paired with; see stream::Pairing.
    std::string reference;
    messages::Subject reference_subject{}; ///< likewise of its rows
};

/// `rotconv survey ...`, checked.
struct SurveyCommand {
    RowsCommand rows;
    std::shared_ptr<Survey> survey; ///< that takes their attitudes
    double condition = 0.0;         ///< the greatest that serves
    bool json = false;
};

/// `rotconv compare ...`, checked.
struct CompareCommand {
    enum class Format { pretty, json, csv };
    RowsCommand rows;
    std::optional<double> within;
    Format format = Format::pretty;
};

/// `rotconv identify ...`, checked.
struct IdentifyCommand {
    RowsCommand rows;                     ///< the input, not yet identified by anybody
    stream::IdentificationRows layout;    ///< its count is 0 where the first row tells it
    std::optional<RepresentationId> name; ///< the only one that is tried
    IdentificationSettings settings;
    bool degrees = false; ///< the angles of the answer
    bool json = false;
};

/// A text to print on stdout: a list, help or version.
struct PrintCommand {
    std::string text;
};

/// A mistake in the command line, in words.
struct UsageError {
    std::string message;
};

using Command = std::variant<RowsCommand, SurveyCommand, CompareCommand, IdentifyCommand, PrintCommand, UsageError>;

[[nodiscard]] Command read_command_line(int argc, const char* const* argv);

/// An option as --help shows it.
struct OptionText {
    std::vector<std::string> names;
    std::string argument; ///< what stands for it; empty where it takes none
    std::string about;
};

struct CommandText {
    std::string name; ///< empty: the conversion
    std::string about;
    std::vector<OptionText> options;
    bool takes_name = false; ///< in the place of FILEs and VALUEs
};

/// The conversion and the commands, for completion.
[[nodiscard]] std::vector<CommandText> command_table();

} // namespace rotconv::cli
