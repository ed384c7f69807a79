#pragma once

#include "command.hpp"

namespace rotconv::cli {

/// Runs the rows, and tells on stderr what there is to tell.
[[nodiscard]] RowsResult run_rows(const RowsCommand& command);

} // namespace rotconv::cli
