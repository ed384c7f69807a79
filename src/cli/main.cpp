#include <cerrno>
#include <csignal>
#include <exception>
#include <string>
#include <variant>

#include "../stream/file.hpp"
#include "command_line.hpp"
#include "compare.hpp"
#include "exit_code.hpp"
#include "identify.hpp"
#include "messages.hpp"
#include "print_error.hpp"
#include "rows.hpp"
#include "survey.hpp"

namespace rotconv::cli {
namespace {

ExitCode print(const std::string& text) {
    stream::OutputFile out("-");
    int error = out.write(text);
    if (error == 0) {
        error = out.finish(true);
    }
    if (error == 0 || error == EPIPE) {
        return ExitCode::done;
    }
    print_error("-: " + messages::explain(stream::StreamError{stream::StreamError::What::write, 0, error, {}}, {}));
    return ExitCode::incomplete;
}

ExitCode usage(const std::string& message) {
    print_error(message);
    return ExitCode::incomplete;
}

/// One overload for each command.
struct Run {
    ExitCode operator()(const RowsCommand& command) const { return run_rows(command).code; }
    ExitCode operator()(const SurveyCommand& command) const { return survey(command); }
    ExitCode operator()(const CompareCommand& command) const { return compare(command); }
    ExitCode operator()(const IdentifyCommand& command) const { return identify(command); }
    ExitCode operator()(const PrintCommand& command) const { return print(command.text); }
    ExitCode operator()(const UsageError& error) const { return usage(error.message); }
};

} // namespace
} // namespace rotconv::cli

int main(int argc, char** argv) {
    try {
        rotconv::stream::guard_standard_descriptors();
        static_cast<void>(std::signal(SIGPIPE, SIG_IGN)); // a closed pipe is an error code of write()
        return static_cast<int>(std::visit(rotconv::cli::Run{}, rotconv::cli::read_command_line(argc, argv)));
    } catch (const std::exception& error) { // such as std::bad_alloc
        rotconv::cli::print_error(error.what());
    }
    return static_cast<int>(rotconv::cli::ExitCode::incomplete);
}
