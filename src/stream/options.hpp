#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "column_list.hpp"
#include "delimiter.hpp"
#include "event.hpp"
#include "io_block.hpp"
#include "key.hpp"
#include "number_text.hpp"
#include "row_operation.hpp"

namespace rotconv::stream {

enum class HeaderMode : std::uint8_t { automatic, yes, no, add };

enum class Format : std::uint8_t { csv, json, pretty, f64 };

enum class OnError : std::uint8_t { stop, nan, skip };

/// What the input says of its numbers: one of these at a time.
struct Said {
    std::vector<std::string> names{};  ///< those of the selected columns in the header...
    std::vector<std::string> header{}; ///< ...among all of it
    bool only_header = false;          ///< a stream without a data row has a header
    std::string_view comment{};        ///< the first of a stream that has no row
};

/// How the rows of a stream are read.
struct InputOptions {
    RowNumbers numbers{};
    ColumnList columns{};                 ///< empty: a row is its numbers and nothing else
    std::optional<Delimiter> delimiter{}; ///< nothing: that of the first data row
    std::size_t width = 0;                ///< doubles of a row of binary input; 0: the input is text
    int key_power = 0;                    ///< keys are in units of 10^key_power of those in which they are compared...
    Key key_offset{};                     ///< ...and this is added to them
    HeaderMode header = HeaderMode::automatic;
    std::string comment = "#"; ///< what comments begin with; empty: there are none
    bool refuses_json = false; ///< a first row that is JSON ends the run
    bool ragged = false;       ///< rows may have any number of fields, if the selected ones are there
    /// Where the numbers are not yet known: of the count of fields of the first row, the count of numbers, or what is
    /// wrong with it.
    std::function<std::variant<std::size_t, std::string>(std::size_t fields)> take_count{};
    /// What is to be told of the header, or of comments alone.
    std::function<std::vector<Note>(const Said& said)> notes_of{};
    /// The numbers' own names, of those under which a header has them: "qw" for "W" and "q_RS_w []".
    std::function<std::vector<std::string>(std::vector<std::string> names)> own_names{};

    /// A blank line is not one, whatever comments begin with.
    [[nodiscard]] bool is_comment(std::string_view line) const noexcept {
        return !comment.empty() && !line.empty() && line.front() == comment.front() && line.starts_with(comment) &&
               !is_blank(line);
    }
    [[nodiscard]] bool is_row(std::string_view line) const noexcept { return !is_comment(line) && !is_blank(line); }
};

/// How the rows of two streams are paired. The operation gets the numbers of a row, then those of its partner.
struct Pairing {
    InputOptions reference{}; ///< how the other stream is read
    bool by_key = false;      ///< the first selected column of both, a number that increases; else by the rows' number
    KeyDistance within{};     ///< the greatest difference of two keys
    /// The partner lies at the row's key between two rows of the reference, whose keys differ by no more than that. See
    /// PairColumns.
    bool interpolates = false;
    bool needs_partner = false; ///< a row of the stream without a partner is a row error
    bool tells_partner = true;  ///< in text, rows that are paired by key have the columns partner_names
};

/// What a run does with its rows: it writes them, adds them to a fold, or both.
struct Options {
    InputOptions input{};
    std::shared_ptr<RowOperation> operation{};
    bool writes_rows = true;
    std::shared_ptr<Fold> fold{}; ///< null: there is none
    Format format = Format::csv;
    OnError on_error = OnError::stop;
    Digits digits{};                                      ///< of the numbers of the result
    bool append = false;                                  ///< keep the row and add the result at its end
    bool diagnostic_columns = false;                      ///< margin, condition, defect and notes after the result
    bool show_diagnostics = true;                         ///< in words, under Format::pretty
    std::size_t threads = 1;                              ///< at most
    std::string (*describe)(const Diagnostic&) = nullptr; ///< those words
    /// With pretty and json: one row by itself, its numbers under their SPECs, and the line after it.
    std::optional<std::string> block{};
    std::optional<Pairing> pairing{}; ///< where the rows are paired with those of a reference

    /// Other lines than those of the rows go out too.
    [[nodiscard]] bool writes_all_lines() const noexcept { return writes_rows && format == Format::csv; }
    [[nodiscard]] bool writes_partners() const noexcept {
        return pairing && pairing->by_key && pairing->tells_partner && writes_all_lines();
    }
};

/// What follows a row that is paired by key.
inline constexpr std::array<std::string_view, 3> partner_names{"reference_line", "reference_key", "key_difference"};
inline constexpr std::array<std::string_view, 4> diagnostic_names{"margin", "condition", "defect", "notes"};

} // namespace rotconv::stream
