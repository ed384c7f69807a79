#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rotconv/axes.hpp>
#include <rotconv/spec.hpp>

#include "../../stream/beginning/column_list.hpp"
#include "../../stream/event.hpp"
#include "../../stream/options.hpp"
#include "../grammar/words.hpp"
#include "../option_set.hpp"

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

/// Nothing for other texts.
[[nodiscard]] std::optional<Spec> spec_of(std::string_view text);
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
[[nodiscard]] std::string few_keys_met(const stream::PairingStats& keys, const stream::Pairing& pairing);

/// A diagnostic in words, with its figure.
[[nodiscard]] std::string describe(const stream::Diagnostic& diagnostic);

/// What a diagnostic means.
[[nodiscard]] std::string_view meaning(const stream::Diagnostic& diagnostic);

/// Why a word does not name a method of the pair, with the methods of the pair and the input for which they hold.
[[nodiscard]] Usage no_such_method(RepresentationId from, RepresentationId to, const Option& option);

/// "'text' is not a known format" and the like, with the legal words.
/// @param text the argument of the option, or a part of it
[[nodiscard]] Usage no_such_word(std::string_view what, const Option& option, std::string_view text,
                                 const std::vector<std::string_view>& legal);

/// The same for the unknown option, with what it means elsewhere.
[[nodiscard]] Usage no_such_option(const OptionSet& options);

/// The same for a SPEC in the argument of an option.
[[nodiscard]] Usage no_such_spec(const Option& option, const std::string& item, const SpecError& error);

/// What a word of the command line may mean that is neither an option nor a number nor a FILE.
[[nodiscard]] std::vector<Mend> meant_by_operand(const OptionSet& options, std::size_t at);

/// The command line whose options that are given twice are, the second time, those of REFERENCE; nothing if there are
/// none.
[[nodiscard]] std::vector<Mend> with_second_options(const OptionSet& options);

/// The command line with the SPECs that stand before numbers in words, as in "quat: 1 0 0 0", as options; nothing if
/// one of the words is no such text.
[[nodiscard]] std::vector<Mend> with_specs_of_words(const OptionSet& options, const std::vector<WordEnd>& words);

/// The command line with numbers for its multiples of pi; nothing if it has none.
[[nodiscard]] std::vector<Mend> with_numbers_for_pi(const OptionSet& options);

/// What VALUEs may mean that are not as many numbers as expected: each group a reading, the likeliest first.
[[nodiscard]] MendGroups meant_by_values(const OptionSet& options, const stream::RowNumbers& numbers);

/// The command line with --from and --to for other options whose arguments are SPECs; nothing if there are none.
[[nodiscard]] std::vector<Mend> with_specs_of_others(const OptionSet& options);

/// What the word means in other programs, with "; " in front; empty for others.
[[nodiscard]] std::string meaning_of_word(std::string_view word);
/// Whether people write it in the place of a command.
[[nodiscard]] bool is_verb(std::string_view word);

/// What to write for a VALUE or ATTITUDE that is almost numbers, with "; " in front; or nothing.
[[nodiscard]] std::string fix_hint(std::string_view text);
[[nodiscard]] std::string fix_hint(const stream::RowError& error);

} // namespace rotconv::cli::messages
