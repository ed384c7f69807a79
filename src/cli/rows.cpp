#include "rows.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <vector>

#include <unistd.h>

#include "../stream/first_row.hpp"
#include "../stream/fmt.hpp"
#include "../stream/run.hpp"
#include "exit_code.hpp"
#include "first_look.hpp"
#include "messages.hpp"
#include "print_error.hpp"
#include "progress.hpp"

namespace rotconv::cli {
namespace {

/// Words events as they come, counts them, and words the summary.
class Reporter {
public:
    /// @param failed_rows_show_it in the output, so that not all of them need be told of
    /// @param beginning of the input
    Reporter(const RowsCommand& command, bool failed_rows_show_it, const std::string& beginning)
        : command_(&command), most_errors_(failed_rows_show_it ? told_errors : every_error), beginning_(&beginning),
          where_(command.has_values ? "argument" : messages::shown(command.input)),
          reference_(messages::shown(command.reference)) {}

    void operator()(const stream::Event& event) {
        if (const auto* error = std::get_if<stream::RowError>(&event)) {
            if (++errors_ > most_errors_) {
                return;
            }
            std::string message = messages::explain(*error, subject_of(error->of_reference));
            if (errors_ == 1 && !error->of_reference) {
                message += advice_at(error->line);
            }
            tell(error->line, message, error->of_reference);
            return;
        }
        const auto& diagnostic = std::get<stream::Diagnostic>(event);
        Count& count = counts_.at(index_of(diagnostic.kind, diagnostic.of_reference));
        if (count.rows == 0) {
            count.first = diagnostic;
        }
        if (count.rows == 0 || count.last_line != diagnostic.line) { // a row may have several answers
            ++count.rows;
            count.last_line = diagnostic.line;
        }
        if (command_->diagnostics == ShowDiagnostics::rows || is_told_apart(diagnostic)) {
            tell(diagnostic.line, messages::describe(diagnostic), diagnostic.of_reference);
        }
    }

    void tell(std::size_t line, const std::string& message, bool of_reference = false) const {
        const std::string& where = of_reference ? reference_ : where_;
        if (line == 0 || command_->has_values) {
            print_error(fmt::format("{}: {}", where, message));
        } else {
            print_error(fmt::format("{}:{}: {}", where, line, message));
        }
    }

    void operator()(const stream::StreamError& error) const {
        const bool advises =
            error.what == stream::StreamError::What::columns && error.column.header.empty() && !error.of_reference;
        tell(error.what == stream::StreamError::What::read ? 0 : error.line,
             messages::explain(error, subject_of(error.of_reference)) + (advises ? advice_at(error.line) : ""),
             error.of_reference);
    }

    void operator()(const stream::Unpaired& unpaired, bool of_reference) const {
        if (unpaired.rows > 0) {
            tell(0, fmt::format("unpaired: {}", rows_from(unpaired.rows, unpaired.first_line)), of_reference);
        }
    }

    void summarize() const {
        if (command_->diagnostics != ShowDiagnostics::summary) {
            return;
        }
        for (const Count& count : counts_) {
            if (count.rows == 0 || is_told_apart(count.first)) {
                continue;
            }
            if (command_->has_values) {
                tell(0, messages::describe(count.first));
            } else {
                tell(0,
                     fmt::format("{}: {}; {}", name_of(count.first.kind), rows_from(count.rows, count.first.line),
                                 messages::meaning(count.first.kind)),
                     count.first.of_reference);
            }
        }
    }

    /// What the limit has left out.
    void count_rest() const {
        if (errors_ > most_errors_) {
            const std::size_t rest = errors_ - most_errors_;
            tell(0, fmt::format("{} more row{} without a result", rest, rest == 1 ? "" : "s"));
        }
    }

    [[nodiscard]] std::size_t errors() const noexcept { return errors_; }
    [[nodiscard]] std::size_t rows(DiagnosticKind kind) const { return count_of(kind).rows; }
    [[nodiscard]] std::size_t first_line(DiagnosticKind kind) const { return count_of(kind).first.line; }
    /// Any kind but normalized.
    [[nodiscard]] bool met_singularity() const noexcept {
        return std::ranges::any_of(counts_, [](const Count& count) {
            return count.rows > 0 && count.first.kind != DiagnosticKind::normalized;
        });
    }

private:
    static constexpr std::size_t told_errors = 20;
    static constexpr std::size_t every_error = static_cast<std::size_t>(-1);

    /// Of a line before the first row that could be read.
    [[nodiscard]] std::string advice_at(std::size_t line) const {
        const bool is_text = !command_->has_values && command_->options.width == 0;
        const std::size_t count = command_->options.columns.empty() ? command_->subject.count : 0;
        const std::string text = is_text ? advice(*beginning_, line, count, command_->input) : std::string();
        return text.empty() ? text : "; " + text;
    }

    /// Of the one row, one of several answers: each is told, as a summary would name one only.
    [[nodiscard]] bool is_told_apart(const stream::Diagnostic& diagnostic) const noexcept {
        return command_->has_values && command_->diagnostics == ShowDiagnostics::summary && !diagnostic.answer.empty();
    }

    struct Count {
        std::size_t rows = 0;
        std::size_t last_line = 0;
        stream::Diagnostic first;
    };
    [[nodiscard]] const Count& count_of(DiagnosticKind kind) const { return counts_.at(index_of(kind, false)); }
    static constexpr std::size_t index_of(DiagnosticKind kind, bool of_reference) noexcept {
        return static_cast<std::size_t>(kind) + (of_reference ? diagnostic_kind_count : 0);
    }
    [[nodiscard]] const messages::Subject& subject_of(bool of_reference) const noexcept {
        return of_reference ? command_->reference_subject : command_->subject;
    }
    static std::string rows_from(std::size_t rows, std::size_t first_line) {
        return fmt::format("{} row{}, first at line {}", rows, rows == 1 ? "" : "s", first_line);
    }
    const RowsCommand* command_;
    std::size_t most_errors_;
    const std::string* beginning_;
    std::string where_;
    std::string reference_;
    std::array<Count, 2 * diagnostic_kind_count> counts_{}; ///< of the input, and of the reference
    std::size_t errors_ = 0;
};

/// A message that ends the run.
RowsResult failed(const std::string& message) {
    print_error(message);
    return {.code = ExitCode::incomplete};
}

RowsResult failed(const std::string& file, stream::StreamError::What what, int error) {
    return failed(fmt::format("{}: {}", messages::shown(file),
                              messages::explain(stream::StreamError{.what = what, .error_number = error}, {})));
}

std::unique_ptr<stream::File> open(const std::string& path) {
    return path == "-" ? std::make_unique<stream::File>(STDIN_FILENO)
                       : std::make_unique<stream::File>(path.c_str(), stream::File::Mode::read);
}

} // namespace

RowsResult run_rows(RowsCommand command, const std::optional<Conclusion>& conclusion, const Settle& settle) {
    using What = stream::StreamError::What;
    stream::OutputFile output(command.output);
    std::vector<std::unique_ptr<stream::File>> inputs;
    for (const std::string& path : {command.input, command.reference}) {
        if (path.empty()) {
            continue;
        }
        const auto& input = *inputs.emplace_back(open(path));
        if (!input.is_open()) {
            return failed(path, What::read, errno);
        }
        if (!command.has_values) {
            if (output.is_same(input)) {
                return failed("the same file is input and output");
            }
            input.widen();
        }
    }

    stream::TextSource values(command.values);
    const bool on_screen = !conclusion && command.output == "-" && ::isatty(STDOUT_FILENO) != 0;
    auto progress = std::make_unique<Progress>(*inputs.front(), !on_screen);
    KeptBeginning input(command.has_values ? static_cast<stream::Source&>(values) : *progress);
    stream::FirstRow source(input);
    const bool failed_rows_show_it = !conclusion && command.options.on_error == stream::OnError::nan;
    Reporter reporter(command, failed_rows_show_it, input.text());
    if (settle) {
        const std::string_view first = source.text();
        if (const std::string wrong = settle(first, command); !wrong.empty()) {
            reporter.tell(source.line(), wrong);
            return {.code = ExitCode::incomplete};
        }
    }
    stream::Sink& sink = conclusion ? conclusion->rows : output;
    const auto report = [&reporter](const stream::Event& event) { reporter(event); };
    const stream::RunResult ending = inputs.size() > 1
                                         ? stream::run(source, *inputs.back(), sink, command.options, report)
                                         : stream::run(source, sink, command.options, report);
    if (ending.reader_left) {
        return {.reader_left = true};
    }
    reporter.summarize();
    if (ending.error) {
        if (ending.error->what == What::write) {
            return failed(command.output, What::write, ending.error->error_number);
        }
        reporter(*ending.error);
    }
    progress.reset();
    RowsResult result{.answered = ending.answered,
                      .failed = reporter.errors(),
                      .beyond = reporter.rows(DiagnosticKind::beyond),
                      .first_beyond = reporter.first_line(DiagnosticKind::beyond),
                      .unpaired = ending.unpaired};
    const bool is_whole = !ending.error && !ending.stopped;
    if (is_whole) {
        reporter(result.unpaired[0], false);
        reporter(result.unpaired[1], true);
    }
    reporter.count_rest();
    if (conclusion && is_whole) {
        const int error = output.write(conclusion->text(result));
        if (error == EPIPE) {
            return {.reader_left = true};
        }
        if (error != 0) {
            return failed(command.output, What::write, error);
        }
    }
    if (const int error = output.finish(is_whole); error != 0) {
        return failed(command.output, What::write, error);
    }
    const bool strict = command.strict && reporter.met_singularity();
    result.code = !is_whole                         ? ExitCode::incomplete
                  : reporter.errors() > 0 || strict ? ExitCode::reservations
                                                    : ExitCode::done;
    return result;
}

} // namespace rotconv::cli
