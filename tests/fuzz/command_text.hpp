#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.hpp"

namespace fuzz {

/// The words of a text, parted by `mark`.
inline std::vector<std::string> words_of(std::string_view text, char mark) {
    std::vector<std::string> words;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(mark));
        words.emplace_back(word.substr(0, word.find('\0'))); // where an argument of a program ends
        text.remove_prefix(std::min(word.size() + 1, text.size()));
    }
    return words;
}

/// What the program makes of these arguments.
inline rotconv::cli::Command command_of(const std::vector<std::string>& words) {
    std::vector<const char*> arguments{"rotconv"};
    for (const std::string& word : words) {
        arguments.push_back(word.c_str());
    }
    const auto count = static_cast<int>(arguments.size());
    arguments.push_back(nullptr);
    return rotconv::cli::read_command_line(rotconv::cli::words_of(count, arguments.data()));
}

} // namespace fuzz
