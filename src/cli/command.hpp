#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "../stream/event.hpp"
#include "../stream/file.hpp"
#include "../stream/options.hpp"
#include "messages.hpp"
#include "option_set.hpp"
#include "usage.hpp"

namespace rotconv::cli {

enum class ExitCode : std::uint8_t {
    done = 0,
    completed_with_failures = 1, ///< to the end, but rows failed, --strict met a diagnostic, or a check did not hold
    incomplete = 2,              ///< did not run to the end
};

enum class ShowDiagnostics : std::uint8_t { off, summary, rows, columns };

/// What came of a run.
struct RowsResult {
    ExitCode code = ExitCode::done;
    bool reader_left = false; ///< closed the pipe: nothing more is known, and nothing to be said
    std::size_t answered = 0; ///< rows with a result
    std::size_t failed = 0;
    std::size_t beyond = 0;                     ///< rows with that diagnostic...
    std::size_t first_beyond = 0;               ///< ...and the line of the first
    std::array<stream::Unpaired, 2> unpaired{}; ///< of the input, and of the reference
};

/// What a command makes of its rows as a whole.
class Conclusion {
public:
    Conclusion() = default;
    Conclusion(const Conclusion&) = delete;
    Conclusion& operator=(const Conclusion&) = delete;
    virtual ~Conclusion() = default;

    /// Where the rows go; null: to the output.
    [[nodiscard]] virtual stream::Sink* rows() { return nullptr; }
    /// What is printed at the end of a run that was not stopped.
    [[nodiscard]] virtual std::string text(const RowsResult& result) = 0;
    /// Whether what was to be found or checked is so. Asked after text().
    [[nodiscard]] virtual bool holds(const RowsResult& result) const = 0;
};

/// A command that makes something of each row, checked.
struct RowsCommand {
    stream::Options options{};
    std::shared_ptr<messages::Subject> subject{}; ///< what the rows are, for messages
    ShowDiagnostics diagnostics = ShowDiagnostics::summary;
    bool strict = false;
    std::string input = "-";
    std::string output = "-";
    bool has_values = false;
    std::string values{};                     ///< the VALUEs as one row
    std::string reference{};                  ///< the stream that the rows are paired with; see stream::Pairing
    messages::Subject reference_subject{};    ///< likewise of its rows
    std::shared_ptr<Conclusion> conclusion{}; ///< null: the rows are all there is
};

/// A text to print on stdout: a list, help or version.
struct PrintCommand {
    std::string text;
};

/// A mistake in the command line, in words.
struct UsageError {
    std::string message;
};

using Command = std::variant<RowsCommand, PrintCommand, UsageError>;

/// What stands on the command line beside the options.
struct Operands {
    std::vector<std::string> values{};
    std::vector<std::string> files{};
};

/// A command's options, and what they ask for. They are read into it, so that it stays where it is.
class CommandOptions {
public:
    CommandOptions() = default;
    CommandOptions(const CommandOptions&) = delete;
    CommandOptions& operator=(const CommandOptions&) = delete;
    virtual ~CommandOptions() = default;

    [[nodiscard]] virtual Command command(const Operands& operands) const = 0;
    /// The argument of --input; empty where it is not given.
    [[nodiscard]] virtual std::string input() const { return {}; }

    OptionSet set{};
    bool wants_help = false;
    bool wants_version = false;
};

} // namespace rotconv::cli
