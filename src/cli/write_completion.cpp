// write_completion SCRIPT: the completion of bash and zsh, with the words of the program's own tables in the place of
// @words@. write_completion SCRIPT FISH: that of fish, with SCRIPT up to "# The rest ..." in the place of @candidates@,
// quoted.

#include <fstream>
#include <iostream>
#include <string>
#include <string_view>

#include "program.hpp"

namespace {

/// The lines of a file up to one that begins with `end`; what is `mark` becomes `words`.
std::string filled(const char* file, std::string_view mark, const std::string& words, std::string_view end) {
    std::ifstream lines(file);
    std::string text;
    std::string line;
    while (std::getline(lines, line) && (end.empty() || !line.starts_with(end))) {
        text += line == mark ? words : line + "\n";
    }
    return text;
}

std::string in_fish(const std::string& script) {
    std::string text;
    for (const char c : script) {
        text += c == '\'' || c == '\\' ? std::string{'\\', c} : std::string{c};
    }
    return text;
}

} // namespace

int main(int argc, char** argv) {
    const bool is_fish = argc > 2;
    const std::string script =
        filled(argv[1], "@words@", rotconv::cli::completion_words(), is_fish ? "# The rest" : "");
    std::cout << (is_fish ? filled(argv[2], "@candidates@", in_fish(script), "") : script);
    return !script.empty() && std::cout.flush() ? 0 : 1;
}
