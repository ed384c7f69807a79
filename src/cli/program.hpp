#pragma once

// For sources that are compiled by themselves: nothing is included but what costs no time.

#include <string>

namespace rotconv::cli {

/// All of the program; returns its exit status.
[[nodiscard]] int run_program(int argc, const char* const* argv);

/// The names that completion offers, as a function of the shell.
[[nodiscard]] std::string completion_words();

} // namespace rotconv::cli
