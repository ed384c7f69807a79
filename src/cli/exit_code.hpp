#pragma once

namespace rotconv::cli {

enum class ExitCode : int {
    done = 0,
    reservations = 1, ///< ran to the end, but rows failed or --strict met a diagnostic
    incomplete = 2,   ///< did not run to the end
};

} // namespace rotconv::cli
