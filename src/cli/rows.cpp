#include "rows.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "../stream/run.hpp"
#include "exit_code.hpp"
#include "messages.hpp"
#include "print_error.hpp"
#include "progress.hpp"

namespace rotconv::cli {
namespace {

/// Words events as they come, counts them, and words the summary.
class Reporter {
public:
    Reporter(const RowsCommand& command, std::string where) : command_(&command), where_(std::move(where)) {}

    void operator()(const stream::Event& event) {
        if (const auto* error = std::get_if<stream::RowError>(&event)) {
            ++errors_;
            tell(error->line, messages::explain(*error, command_->subject));
            return;
        }
        const auto& diagnostic = std::get<stream::Diagnostic>(event);
        Count& count = counts_.at(static_cast<std::size_t>(diagnostic.kind));
        if (count.rows++ == 0) {
            count.first = diagnostic;
        }
        if (command_->diagnostics == ShowDiagnostics::rows) {
            tell(diagnostic.line, messages::describe(diagnostic));
        }
    }

    void tell(std::size_t line, const std::string& message) const {
        if (line == 0 || command_->has_values) {
            print_error(fmt::format("{}: {}", where_, message));
        } else {
            print_error(fmt::format("{}:{}: {}", where_, line, message));
        }
    }

    void summarize() const {
        if (command_->diagnostics != ShowDiagnostics::summary) {
            return;
        }
        for (const Count& count : counts_) {
            if (count.rows == 0) {
                continue;
            }
            if (command_->has_values) {
                tell(0, messages::describe(count.first));
            } else {
                tell(0, fmt::format("{}: {} row{}, first at line {}; {}", name_of(count.first.kind), count.rows,
                                    count.rows == 1 ? "" : "s", count.first.line, messages::meaning(count.first.kind)));
            }
        }
    }

    [[nodiscard]] bool met_error() const noexcept { return errors_ > 0; }
    /// Any kind but normalized.
    [[nodiscard]] bool met_singularity() const noexcept {
        return std::ranges::any_of(counts_, [](const Count& count) {
            return count.rows > 0 && count.first.kind != DiagnosticKind::normalized;
        });
    }

private:
    struct Count {
        std::size_t rows = 0;
        stream::Diagnostic first;
    };
    const RowsCommand* command_;
    std::string where_;
    std::array<Count, diagnostic_kind_count> counts_{};
    std::size_t errors_ = 0;
};

/// Where rows go that nobody wants.
class NullSink final : public stream::Sink {
public:
    int write(std::string_view /*bytes*/) override { return 0; }
};

ExitCode failed(const std::string& message) {
    print_error(message);
    return ExitCode::incomplete;
}

std::string reason(int error) { return std::generic_category().message(error); }

} // namespace

ExitCode run_rows(const RowsCommand& command, const Conclusion& conclusion) {
    const std::string input_name = messages::shown(command.input);
    auto input = command.input == "-" ? std::make_unique<stream::File>(STDIN_FILENO)
                                      : std::make_unique<stream::File>(command.input.c_str(), stream::File::Mode::read);
    if (!input->is_open()) {
        return failed(fmt::format("{}: cannot be read: {}", input_name, reason(errno)));
    }
    stream::OutputFile output(command.output);
    if (!command.has_values && output.is_same(*input)) {
        return failed("the same file is input and output");
    }
    const auto unwritten = [&command](int error) {
        return failed(fmt::format("{}: cannot be written: {}", messages::shown(command.output), reason(error)));
    };
    if (!command.has_values) {
        input->widen();
    }

    Reporter reporter(command, command.has_values ? "argument" : input_name);
    stream::TextSource values(command.values);
    const bool on_screen = command.output == "-" && ::isatty(STDOUT_FILENO) != 0;
    const auto progress = std::make_unique<Progress>(*input, command.progress && !on_screen);
    stream::Source& source = command.has_values ? static_cast<stream::Source&>(values) : *progress;
    NullSink nowhere;
    stream::Sink& sink = conclusion ? static_cast<stream::Sink&>(nowhere) : output;
    const stream::RunResult ending =
        stream::run(source, sink, command.options, [&reporter](const stream::Event& event) { reporter(event); });
    if (ending.reader_left) {
        return ExitCode::done;
    }
    reporter.summarize();
    if (ending.error) {
        if (ending.error->what == stream::StreamError::What::write) {
            return unwritten(ending.error->error_number);
        }
        reporter.tell(ending.error->what == stream::StreamError::What::read ? 0 : ending.error->line,
                      messages::explain(*ending.error, command.subject));
    }
    const bool is_whole = !ending.error && !ending.stopped;
    if (conclusion && is_whole) {
        const int error = output.write(conclusion());
        if (error == EPIPE) {
            return ExitCode::done;
        }
        if (error != 0) {
            return unwritten(error);
        }
    }
    if (const int error = output.finish(is_whole); error != 0) {
        return unwritten(error);
    }
    if (!is_whole) {
        return ExitCode::incomplete;
    }
    const bool strict = command.strict && reporter.met_singularity();
    return reporter.met_error() || strict ? ExitCode::reservations : ExitCode::done;
}

} // namespace rotconv::cli
