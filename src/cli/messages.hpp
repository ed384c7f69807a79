#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rotconv/spec.hpp>

#include "../stream/column_list.hpp"
#include "../stream/event.hpp"
#include "words.hpp"

/// What is told of rows, files, columns, SPECs and diagnostics. A sentence about one option stands with that option.
namespace rotconv::cli::messages {

/// The words of modifiers, in the order of the table.
[[nodiscard]] std::string words_of(const ModifierSet& modifiers, std::string_view separator);

/// The names of a list of columns stand in another order than the SPEC's, but perhaps in that of another SPEC.
[[nodiscard]] std::string other_order(std::string_view list, const Spec& from,
                                      const std::vector<std::string_view>& order, const std::optional<Spec>& right);

/// Why a SPEC is none, with the legal words and the nearest.
[[nodiscard]] std::string explain(const SpecError& error);

/// What the rows of a run are.
struct Subject {
    std::string text;                                         ///< what has `count` numbers, such as "quat"
    std::size_t count = 0;                                    ///< numbers of a row
    RepresentationId representation = RepresentationId::quat; ///< whose singularities may be met
    double tolerance = 0.0;                                   ///< see ConversionSettings
    bool has_steps = false;                                   ///< of an integration
};

/// Rows of attitudes.
[[nodiscard]] Subject subject_of(const Spec& spec, double tolerance);

/// Why a row has no result, with the text at fault.
[[nodiscard]] std::string explain(const stream::RowError& error, const Subject& subject);

/// Why a run ended, other than by a row.
[[nodiscard]] std::string explain(const stream::StreamError& error, const Subject& subject);

[[nodiscard]] std::string explain(const stream::ColumnError& error, const Subject& subject);

/// Of a run that had no attitude to look at.
inline constexpr std::string_view nothing_read = "there was no row with an attitude";

/// A diagnostic in words, with its figure.
[[nodiscard]] std::string describe(const stream::Diagnostic& diagnostic);

/// What a kind of diagnostic means, without a figure.
[[nodiscard]] std::string_view meaning(DiagnosticKind kind);

/// "'text' is not a format" and the like, with the legal words and the nearest.
[[nodiscard]] std::string no_such_word(std::string_view what, std::string_view text,
                                       const std::vector<std::string_view>& legal);

/// The same of an option.
[[nodiscard]] std::string no_such_option(std::string_view text, const std::vector<std::string_view>& legal);

/// Why a word names no method of the pair, with those that there are and where they hold.
[[nodiscard]] std::string no_such_method(RepresentationId from, RepresentationId to, std::string_view text);

/// Why a word that is no option can be used neither as a number nor as a file, with the nearest command.
[[nodiscard]] std::string no_operand(std::string_view word, int error, const std::vector<std::string_view>& commands);

} // namespace rotconv::cli::messages
