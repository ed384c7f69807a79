#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// A second, plain implementation of the row rules as the manual states them: what a stream of text becomes. It is slow
/// and shares no code with the program.
namespace fuzz {

/// What the numbers of a row become; nothing where they have no result.
struct Answer {
    std::vector<double> numbers;
    std::string notes; ///< kinds joined by '+'
};
using Calculate =
    std::function<std::optional<Answer>(const std::vector<double>& numbers, const std::vector<std::string>& texts)>;

/// The options as they are written, and what the command makes of numbers.
struct Rules {
    std::size_t inputs = 0;
    std::size_t kept = 0;           ///< of them, the first that stay in the row
    std::vector<std::string> names; ///< of the result's columns, those of diagnostics included
    Calculate calculate;
    std::vector<std::string> input_names; ///< of the numbers that are read
    std::string columns, delimiter, header = "auto", format = "csv", on_error = "stop";
    int precision = 0;
    bool append = false, diagnostic_columns = false;
};

/// What a stream becomes.
struct Outcome {
    std::string bytes;
    std::vector<std::size_t> failed; ///< lines
    bool to_the_end = true;
    std::vector<std::string> met;                 ///< rules that had a part in it
    std::vector<std::vector<std::string>> others; ///< under json, of each row the values of its other fields; "": any
};

/// The outcome; nothing where the text meets rules that are not modelled.
[[nodiscard]] std::optional<Outcome> model(std::string_view text, const Rules& rules);

/// Whether the lines of JSON hold what the outcome says.
[[nodiscard]] bool json_agrees(std::string_view json, const Outcome& outcome, const Rules& rules);

} // namespace fuzz
