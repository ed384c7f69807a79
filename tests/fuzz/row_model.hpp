#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A second, plain implementation of the row rules as the manual states them: fields, columns, errors and order of one
/// stream of text, written as csv. It is slow and shares no code with the program. Headers, times, notes, pairs and
/// other formats are not modelled: the transcripts and the tests of the parts have them.
namespace fuzz {

/// What the numbers of a row become; nothing if they have no result.
using Calculate = std::function<std::optional<std::vector<double>>(const std::vector<double>& numbers,
                                                                   const std::vector<std::string>& texts)>;

/// The options as they are written, and what the command makes of numbers.
struct Rules {
    std::size_t inputs = 0;
    std::size_t kept = 0;    ///< of the inputs, the first that stay in the row
    std::size_t results = 0; ///< numbers of a result
    Calculate calculate;
    std::string comment, columns, delimiter, header, on_error;
    bool append = false, ragged = false;
};

/// What a stream becomes.
struct Outcome {
    std::string bytes;
    std::vector<std::size_t> failed; ///< lines of rows without a result
    std::size_t answered = 0;
    bool to_the_end = true;
    std::vector<std::string> met; ///< rules that had a part in it
};

/// The outcome; nothing where the text meets rules that are not modelled.
[[nodiscard]] std::optional<Outcome> model(std::string_view text, const Rules& rules);

} // namespace fuzz
