#include <csignal>
#include <exception>
#include <new>
#include <string>
#include <variant>

#include "../stream/file.hpp"
#include "command.hpp"
#include "program.hpp"

namespace rotconv::cli {

int run_program(int argc, const char* const* argv) {
    try {
        stream::guard_standard_descriptors();
#ifdef SIGPIPE
        static_cast<void>(std::signal(SIGPIPE, SIG_IGN)); // a closed pipe is an error code of write()
#endif
        Command command = read_command_line(argc, argv);
        const auto* text = std::get_if<std::string>(&command);
        return static_cast<int>(text != nullptr ? print(*text) : run_rows(std::get<RowsCommand>(std::move(command))));
    } catch (const std::bad_alloc&) {
        print_error("out of memory");
    } catch (const std::exception& error) {
        print_error(error.what());
    }
    return static_cast<int>(ExitCode::incomplete);
}

} // namespace rotconv::cli
