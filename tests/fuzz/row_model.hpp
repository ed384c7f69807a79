#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// A second, plain implementation of the row rules as the manual states them: fields, columns, errors, order and pairs
/// of a stream of text, written as csv. It is slow and shares no code with the program. Which line is a header, times,
/// notes and other formats are not modelled: the transcripts have them.
namespace fuzz {

/// What the numbers of a row become.
struct Answer {
    std::vector<double> numbers;
    std::string notes;         ///< kinds joined by '+'
    bool failed = false;       ///< they have no result...
    bool of_reference = false; ///< ...because those of the reference have none
};
using Calculate = std::function<Answer(const std::vector<double>& numbers, const std::vector<std::string>& texts)>;

/// The options as they are written, and what the command makes of numbers.
struct Rules {
    std::size_t inputs = 0;
    std::vector<std::string> numbers; ///< their names, as rotconv writes them
    std::size_t kept = 0;             ///< of them, the first that stay in the row
    std::vector<std::string> names;   ///< of the result's columns, those of diagnostics included
    Calculate calculate;
    std::string comment = "#", columns, delimiter, header = "auto", format = "csv", on_error = "stop";
    int precision = 0;
    int decimals = -1;
    bool append = false, diagnostic_columns = false, ragged = false;

    /// How the stream is read whose rows stand beside these; the numbers of both are one row for `calculate`. Under the
    /// format `result` a row is its result's doubles, the last of them its line, and nothing else.
    std::shared_ptr<const Rules> reference;
    bool by_key = false; ///< the first number of both
    std::string key_within;
    std::string key_offset; ///< of the stream's keys; empty: 0
};

/// A row without a result.
struct Failure {
    std::size_t line = 0;
    bool of_reference = false; ///< the line is one of the reference, which has no key
    std::size_t cause = 0;     ///< the line of the reference that is at fault; 0: the row itself is
    friend auto operator<=>(const Failure&, const Failure&) = default;
};

/// What a stream becomes.
struct Outcome {
    std::string bytes;
    std::vector<Failure> failed;
    std::size_t answered = 0;
    std::array<std::vector<std::size_t>, 2> unpaired; ///< lines, of the stream and of the reference
    bool to_the_end = true;
    std::vector<std::string> met; ///< rules that had a part in it
};

/// The outcome; nothing where the text meets rules that are not modelled.
[[nodiscard]] std::optional<Outcome> model(std::string_view text, const Rules& rules);
/// The same of two streams.
[[nodiscard]] std::optional<Outcome> model(std::string_view text, std::string_view reference, const Rules& rules);

} // namespace fuzz
