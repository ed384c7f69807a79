#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "../stream/options.hpp"
#include "../stream/run.hpp"
#include "messages/messages.hpp"
#include "option_set.hpp"

namespace rotconv::cli {

enum class ExitCode : std::uint8_t {
    done = 0,
    completed_with_failures = 1, ///< finished, but rows failed, --strict met a diagnostic, or a check did not hold
    incomplete = 2,              ///< stopped
};

enum class ShowDiagnostics : std::uint8_t { off, summary, rows, columns };

using Operation = std::shared_ptr<stream::RowOperation>;

/// What came of a run.
struct RowsResult : stream::RunResult {
    ExitCode code = ExitCode::done;
    std::array<std::size_t, 2>
        failed{}; ///< rows by Side: those without a result, and those of the reference without a key
};

/// What a command says of its rows as a whole.
struct Conclusion {
    std::string text;   ///< printed at the end
    bool holds = false; ///< what was to be found or checked
};

struct CommandOptions;

/// A command that makes something of each row, checked.
struct RowsCommand {
    stream::Options options{};
    std::shared_ptr<messages::Subject> subject{}; ///< what the rows are, for messages
    ShowDiagnostics diagnostics = ShowDiagnostics::summary;
    bool strict = false;
    bool allow_failed = false;                    ///< rows that fail do not make the exit status 1
    bool allow_unpaired = true;                   ///< rows of the reference that are in no pair do not make it 1
    std::shared_ptr<const CommandOptions> line{}; ///< as it is given
    std::string input = "-";
    std::string output = "-";
    bool has_values = false;
    std::shared_ptr<stream::Source> source{}; ///< of the rows, in the place of the input; null: there is none
    std::string reference{};                  ///< the stream with which the rows are paired; see stream::Pairing
    messages::Subject reference_subject{};    ///< what the rows of the reference are
    std::vector<stream::Note> notes{};        ///< of the command line
    /// Called before the run, where there is something to look for in the rows; in words why it is not found.
    std::function<std::optional<std::string>(RowsCommand& command)> prepare{};
    /// Called at the end of a run that was not stopped. None: the rows are all there is.
    std::function<Conclusion(const RowsCommand& command, const RowsResult& result)> conclude{};
    /// The run goes on, without output, where nobody reads that any more: its exit status counts.
    bool is_check = false;
};

/// Runs another operation over a command's rows, and tells nothing.
/// @return why the run did not come to its end, in words, or empty if that of the command says it; nothing if it did
[[nodiscard]] std::optional<std::string> look_through(const RowsCommand& command, const Operation& operation,
                                                      const std::shared_ptr<stream::Fold>& fold = nullptr);

/// Runs the rows, and prints on stderr what there is to report.
[[nodiscard]] ExitCode run_rows(RowsCommand command);

/// Prints a text on stdout.
[[nodiscard]] ExitCode print(std::string_view text);

/// What to do with rows, or a text to print on stdout: a list, help or version.
using Command = std::variant<RowsCommand, std::string>;

/// The options of a command, with those that several kinds of commands have.
struct CommandOptions : OptionSet {
    Option input{"-i,--input", "FILE", "Read FILE; - is standard input"};
    Option help_flag{"-h,--help", "", "Print this help and exit"};
    Option version_flag{"--version", "", "Print the version and exit"}; ///< only without the name of a command

    /// FILE, or the first of two, as it is given; empty: there is none.
    [[nodiscard]] const std::string& file() const noexcept { return files.empty() ? input.text() : files[0]; }
    /// The mend by which the FILE, or the first of two, is read by a command, and perhaps others behind a | each.
    [[nodiscard]] Mend piped(Mend mend, const std::string& command, std::optional<std::string> text,
                             std::string_view others = {}) const;

    /// Called first; refuses arguments whose words may have been taken for VALUEs and FILEs.
    /// @throw Usage
    virtual void check_attitudes() const {}
    /// @throw Usage
    [[nodiscard]] virtual Command command() const = 0;
};

/// The conversion, whose name is empty, or another command. Its texts are literals.
struct CommandEntry {
    std::string_view name;
    std::string_view about;
    std::string_view usage;
    std::unique_ptr<CommandOptions> (*own_options)();
    std::size_t most_files = 1;

    /// With those that all commands have.
    [[nodiscard]] std::unique_ptr<CommandOptions> options() const;
};

/// The `own_options` of a command.
template <class Options> std::unique_ptr<CommandOptions> make_options() { return std::make_unique<Options>(); }

/// Each command stands in a source of its name.
[[nodiscard]] CommandEntry convert_command();
[[nodiscard]] CommandEntry list_command();
[[nodiscard]] CommandEntry rates_command();
[[nodiscard]] CommandEntry propagate_command();
[[nodiscard]] CommandEntry survey_command();
[[nodiscard]] CommandEntry compare_command();
[[nodiscard]] CommandEntry identify_command();
[[nodiscard]] CommandEntry sample_command();
[[nodiscard]] CommandEntry compose_command();
[[nodiscard]] CommandEntry rotate_command();
/// All of them, the conversion first.
[[nodiscard]] std::vector<CommandEntry> command_table();

/// Whether a word is the name of one.
[[nodiscard]] bool is_command(std::string_view word);

/// What follows the options in the help: the words of SPECs, the exit status and examples.
[[nodiscard]] std::string help_footer();

/// What a word may become after these, of a command line that is being written: a line `files` where it may be a file
/// too, `open` where more may follow it at once, otherwise `words`; then a line for each, and what is said of it behind
/// a blank. The shells get it by `rotconv --complete WORD BEFORE...`.
[[nodiscard]] std::string completions(std::span<const std::string> before, std::string word);

/// Those of a command line, with what `help` and `--list` in front stand for.
[[nodiscard]] std::vector<std::string> words_of(int argc, const char* const* argv);

/// @throw Usage
[[nodiscard]] Command read_command_line(const std::vector<std::string>& words);

} // namespace rotconv::cli
