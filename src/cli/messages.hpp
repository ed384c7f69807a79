#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rotconv/axes.hpp>
#include <rotconv/spec.hpp>

#include "../stream/column_list.hpp"
#include "../stream/event.hpp"
#include "../stream/options.hpp"
#include "words.hpp"

/// Messages on rows, files, columns, SPECs and diagnostics. A sentence about one option stands with that option.
namespace rotconv::cli::messages {

/// The name of a representation and its aliases.
[[nodiscard]] std::vector<std::string_view> names_of(const Representation& entry);
/// Those of all representations, and of the projects that are SPECs.
[[nodiscard]] std::vector<std::string_view> all_names();
[[nodiscard]] std::vector<std::string_view> all_presets();
[[nodiscard]] std::vector<std::string> all_sequences();

/// The words of modifiers, in the order of the table.
[[nodiscard]] std::vector<std::string_view> words_of(const ModifierSet& modifiers);

[[nodiscard]] bool is_spec(std::string_view word);
[[nodiscard]] bool is_preset(std::string_view word);

/// Why a text is not a SPEC, with the legal words and the nearest.
[[nodiscard]] std::string explain(const SpecError& error);

/// What the rows of a run are.
struct Subject {
    std::string text{};                                       ///< what the numbers are, such as "quat"
    RepresentationId representation = RepresentationId::quat; ///< its singularities may be met
    double tolerance = 0.0;                                   ///< see ConversionSettings
    bool has_steps = false;                                   ///< the rows are integrated
};

/// Rows of numbers, named by the attitudes among them.
[[nodiscard]] Subject subject_of(const stream::RowNumbers& numbers, double tolerance);

/// Why a row has no result, with the text at fault.
[[nodiscard]] std::string explain(const stream::RowError& error, const Subject& subject);

/// Why a run ended, other than by a row.
[[nodiscard]] std::string explain(const stream::StreamError& error, const Subject& subject);

/// @param subject see Subject::text
[[nodiscard]] std::string explain(const stream::ColumnError& error, std::string_view subject);

/// For a run without an attitude.
inline constexpr std::string_view nothing_read = "there was no row with an attitude";

/// For a run in which rows were to be paired by key, and most were not.
[[nodiscard]] std::string few_keys_met(const stream::KeysMet& keys);

/// A diagnostic in words, with its figure.
[[nodiscard]] std::string describe(const stream::Diagnostic& diagnostic);

/// What a diagnostic means.
[[nodiscard]] std::string_view meaning(const stream::Diagnostic& diagnostic);

/// "'text' is not a format" and the like, with the legal words and the nearest.
[[nodiscard]] std::string no_such_word(std::string_view what, std::string_view text,
                                       const std::vector<std::string_view>& legal);

/// The same for an option, perhaps with its argument.
[[nodiscard]] std::string no_such_option(std::string_view text, const std::vector<std::string_view>& legal);

/// Why a word does not name a method of the pair, with the methods of the pair and the input for which they hold.
[[nodiscard]] std::string no_such_method(RepresentationId from, RepresentationId to, std::string_view text);

/// Why a word that is not an option can be used neither as a number nor as a FILE, with the nearest command.
[[nodiscard]] std::string no_operand(std::string_view word, int error, const std::vector<std::string_view>& commands);

// The ends of messages that say how to read what stands in the way at the beginning of a stream:

/// The most bytes of a stream that they are about: the first.
inline constexpr std::size_t most_first_bytes = std::size_t{64} << 10U;

/// For a line at which reading stopped: a command or option with which the text at hand can be read, or nothing.
/// @param has_header the message names the columns of a header: only a later one that has the names is looked for
/// @param file its name in the command
[[nodiscard]] std::string advice(std::string_view beginning, std::size_t line, bool has_header,
                                 const stream::Options& options, const std::string& file);

/// For JSON: the filter that makes rows of it.
[[nodiscard]] std::string json_advice(std::string_view beginning, const stream::InputOptions& input);

/// For a command line without a SPEC: the columns of the file, or nothing if it cannot be read twice.
[[nodiscard]] std::string contents_advice(const std::string& path);

/// What to write for a VALUE or ATTITUDE that is almost numbers, with "; " in front; or nothing.
[[nodiscard]] std::string mend(std::string_view text);
[[nodiscard]] std::string mend(const stream::RowError& error);

/// The command or option that does what the word names in other programs, or why there is none; empty for other words.
[[nodiscard]] std::string meaning_of_verb(std::string_view word);

} // namespace rotconv::cli::messages
