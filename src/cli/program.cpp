#include <csignal>
#include <exception>
#include <new>
#include <string>
#include <variant>

#include "../stream/bytes/file.hpp"
#include "messages/answers.hpp"
#include "program.hpp"

namespace rotconv::cli {

int run_program(int argc, const char* const* argv) {
    std::vector<std::string> words;
    try {
        stream::guard_standard_descriptors();
#ifdef SIGPIPE
        static_cast<void>(std::signal(SIGPIPE, SIG_IGN)); // a closed pipe is an error code of write()
#endif
        words = words_of(argc, argv);
        Command command = read_command_line(words);
        const auto* text = std::get_if<std::string>(&command);
        return static_cast<int>(text != nullptr ? print(*text) : run_rows(std::get<RowsCommand>(std::move(command))));
    } catch (const std::bad_alloc&) {
        print_error("out of memory");
    } catch (const Usage& error) {
        const std::string commands = answers(words);
        std::string hint = error.otherwise;
        if (hint.empty() && !error.mends.empty() && error.specs.empty() && !error.guesses_spec &&
            !std::string_view(error.what()).ends_with('?')) { // which alone is not enough
            const auto& by = error.mends.front().edits.back().by;
            hint = by.empty() ? "" : fmt::format("; did you mean {}?", fmt::join(by, " "));
        }
        print_error(error.what() + (commands.empty() ? hint : "\n" + commands.substr(0, commands.size() - 1)));
    } catch (const std::exception& error) {
        print_error(error.what());
    }
    return static_cast<int>(ExitCode::incomplete);
}

} // namespace rotconv::cli
