// write_completion TEMPLATE: the completion of bash and zsh, from the program's own tables, in the place of @words@.

#include <fstream>
#include <iostream>
#include <string>

#include "program.hpp"

int main(int argc, char** argv) {
    std::ifstream lines(argc > 1 ? argv[1] : "");
    std::string line;
    while (std::getline(lines, line)) {
        std::cout << (line == "@words@" ? rotconv::cli::completion_words() : line + "\n");
    }
    return lines.eof() && std::cout.flush() ? 0 : 1;
}
