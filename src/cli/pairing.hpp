#pragma once

#include "options.hpp"

/// What the commands share that read a FILE and its REFERENCE side by side.
namespace rotconv::cli {

void define_pairing(CLI::App& app, RawOptions& texts);

/// There is a REFERENCE.
/// @throw Usage where both are stdin
[[nodiscard]] bool is_paired(const Operands& operands);

/// The options that read FILE: with the key, where there is one, as the first of the columns; or where the rows hold
/// both attitudes, with the columns of both.
/// @throw Usage
[[nodiscard]] RawOptions file_options(const RawOptions& texts, bool paired);

/// Has the command's rows paired with those of the REFERENCE, of which `operation` says how they are read.
/// @throw Usage
void pair(RowsCommand& command, const RawOptions& texts, const Operands& operands, stream::RowOperation operation,
          messages::Subject subject);

} // namespace rotconv::cli
