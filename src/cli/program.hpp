#pragma once

// For sources that are compiled by themselves: nothing is included but what costs no time.

namespace rotconv::cli {

/// All of the program; returns its exit status.
[[nodiscard]] int run_program(int argc, const char* const* argv);

} // namespace rotconv::cli
