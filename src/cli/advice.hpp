#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "../stream/options.hpp"

/// What helps against what stands in the way at the beginning of a stream: the ends of messages.
namespace rotconv::cli {

/// For a line at which reading stopped: the command or option that reads on, if it does on the text at hand, or
/// nothing. `file`: to be named in a command.
[[nodiscard]] std::string advice(std::string_view beginning, std::size_t line, const stream::InputOptions& input,
                                 const std::string& file);

/// For JSON: the filter that makes rows of it.
[[nodiscard]] std::string json_advice(std::string_view beginning, const stream::InputOptions& input);

/// For a command line without a SPEC: what the file holds, or nothing where it cannot be read twice.
[[nodiscard]] std::string contents_advice(const std::string& file);

} // namespace rotconv::cli
