#include "rows.hpp"

#include <algorithm>
#include <cerrno>
#include <memory>
#include <utility>
#include <vector>

#include <unistd.h>

#include "../stream/fmt.hpp"
#include "../stream/run.hpp"
#include "print_error.hpp"
#include "progress.hpp"
#include "reporter.hpp"

namespace rotconv::cli {
namespace {

/// A message that ends the run.
RowsResult failed(const std::string& message) {
    print_error(message);
    return {.code = ExitCode::incomplete};
}

RowsResult failed(const std::string& file, stream::StreamError::What what, int error) {
    return failed(fmt::format("{}: {}", shown(file), messages::explain({.what = what, .error_number = error}, {})));
}

std::unique_ptr<stream::File> open(const std::string& path) {
    return path == "-" ? std::make_unique<stream::File>(STDIN_FILENO)
                       : std::make_unique<stream::File>(path.c_str(), stream::File::Mode::read);
}

} // namespace

RowsResult run_rows(const RowsCommand& command) {
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

    Conclusion* const conclusion = command.conclusion.get();
    stream::Sink* const other = conclusion != nullptr ? conclusion->rows() : nullptr;
    stream::Sink& sink = other != nullptr ? *other : output;
    stream::TextSource values(command.values);
    const bool on_screen = other == nullptr && command.output == "-" && ::isatty(STDOUT_FILENO) != 0;
    auto progress = std::make_unique<Progress>(*inputs.front(), !on_screen);
    stream::Source& source = command.has_values ? static_cast<stream::Source&>(values) : *progress;
    Reporter reporter(command, other == nullptr && command.options.on_error == stream::OnError::nan);
    const auto report = [&reporter](const stream::Event& event) { reporter(event); };
    stream::Source* const reference = inputs.size() > 1 ? inputs.back().get() : nullptr;
    const stream::RunResult ending = stream::run(source, sink, command.options, report, reference);
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
    const bool is_whole = !ending.error && !ending.stopped;
    const bool strict = command.strict && reporter.met_singularity();
    RowsResult result{.code = !is_whole                         ? ExitCode::incomplete
                              : reporter.errors() > 0 || strict ? ExitCode::completed_with_failures
                                                                : ExitCode::done,
                      .answered = ending.answered,
                      .failed = reporter.errors(),
                      .beyond = reporter.rows(DiagnosticKind::beyond),
                      .first_beyond = reporter.first_line(DiagnosticKind::beyond),
                      .unpaired = ending.unpaired};
    if (is_whole) {
        reporter(result.unpaired[0], false);
        reporter(result.unpaired[1], true);
    }
    reporter.count_rest();
    if (conclusion != nullptr && is_whole) {
        const int error = output.write(conclusion->text(result));
        if (error == EPIPE) {
            return {.reader_left = true};
        }
        if (error != 0) {
            return failed(command.output, What::write, error);
        }
        if (result.code == ExitCode::done && !conclusion->holds(result)) {
            result.code = ExitCode::completed_with_failures;
        }
    }
    if (const int error = output.finish(is_whole); error != 0) {
        return failed(command.output, What::write, error);
    }
    return result;
}

} // namespace rotconv::cli
