#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../../stream/beginning/delimiter.hpp"
#include "../../stream/event.hpp"
#include "../../stream/rows/row_operation.hpp"

/// Numbers as people type them, and as programs print them.
namespace rotconv::cli {

/// What errors of values_of() begin with.
inline constexpr std::string_view argument_error = "argument: ";

/// The word is a number, or begins with one before a separator; after brackets its first character is enough.
[[nodiscard]] bool is_value(std::string_view word);

/// VALUEs as one row, in the order of the numbers that are read.
struct Values {
    std::string row{};
    stream::Delimiter delimiter = stream::Delimiter::blanks();
    std::vector<stream::Note> notes{}; ///< what was chosen although the command line does not say it
    bool has_other_label = false;      ///< the numbers are called something that says nothing of them

    [[nodiscard]] std::vector<std::string_view> fields() const {
        std::vector<std::string_view> parts;
        static_cast<void>(delimiter.split(row, parts));
        return parts;
    }
};

/// Reads VALUEs by the grammar of value_text.hpp: chooses the numbers of the attitude among others, and orders them by
/// their labels. Several words are a row with commas or blanks, whatever delimiter is `given`.
/// @param from the SPEC of the attitude as it is given, which may name an order
/// @param are_selected numbers are selected by their index: they stay as they stand
/// @throw Usage for anything that is not understood, or that contradicts the SPEC
[[nodiscard]] Values values_of(const std::vector<std::string>& words, std::optional<stream::Delimiter> given,
                               const stream::RowNumbers& numbers, std::string_view from, bool are_selected);

/// The same of a text that is one attitude; nothing where it is none.
/// @param means_other is set where it is that of another SPEC
[[nodiscard]] std::optional<Values> attitude_in(const std::string& text, const stream::RowNumbers& numbers,
                                                std::string_view from, bool& means_other);

} // namespace rotconv::cli
