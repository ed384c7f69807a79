#include <cerrno>
#include <csignal>
#include <exception>
#include <new>
#include <string>
#include <variant>

#include "../stream/file.hpp"
#include "command.hpp"
#include "program.hpp"

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
    print_error("-: " + messages::explain(
                            stream::StreamError{.what = stream::StreamError::What::write, .error_number = error}, {}));
    return ExitCode::incomplete;
}

/// One overload for each command.
struct Run {
    ExitCode operator()(const RowsCommand& command) const { return run_rows(command); }
    ExitCode operator()(const PrintCommand& command) const { return print(command.text); }
    ExitCode operator()(const UsageError& error) const {
        print_error(error.message);
        return ExitCode::incomplete;
    }
};

} // namespace

int run_program(int argc, const char* const* argv) {
    try {
        stream::guard_standard_descriptors();
        static_cast<void>(std::signal(SIGPIPE, SIG_IGN)); // a closed pipe is an error code of write()
        return static_cast<int>(std::visit(Run{}, read_command_line(argc, argv)));
    } catch (const std::bad_alloc&) {
        print_error("out of memory");
    } catch (const std::exception& error) {
        print_error(error.what());
    }
    return static_cast<int>(ExitCode::incomplete);
}

} // namespace rotconv::cli
