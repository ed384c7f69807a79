#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "beginning/column_list.hpp"
#include "beginning/delimiter.hpp"
#include "bytes/io_block.hpp"
#include "event.hpp"
#include "numbers/number_text.hpp"
#include "pairs/key.hpp"
#include "rows/row_operation.hpp"

namespace rotconv::stream {

enum class HeaderMode : std::uint8_t {
    automatic, ///< there is one if its names say so: see decide()
    yes,       ///< there is one, whatever it says
    no,        ///< there is none
    add,       ///< there is none, and the output gets one
};

enum class Format : std::uint8_t { csv, json, pretty, f64 };

enum class OnError : std::uint8_t { stop, nan, skip };

/// What the input says of its numbers: one of these at a time.
struct HeaderFacts {
    std::vector<std::string> names{};  ///< the selected columns' names in the header, as they are selected
    std::vector<std::string> header{}; ///< all names of the header
    std::vector<std::string> units{};  ///< the selected columns' units, if a line below the header has them
    bool only_header = false;          ///< a stream without a data row has a header
    std::size_t passed = 0;            ///< lines before the rows that are no comments, and pass all the same
    std::string_view comment{};        ///< the first of them, or the first comment of a stream that has no row
};

/// Where numbers stand in rows that have more fields, although nobody said so.
struct ChosenColumns {
    bool are_known = false;               ///< there are such columns
    std::vector<std::size_t> positions{}; ///< the only ones, of each number
    std::string text{};                   ///< the note that says so, or why none can be chosen
};

/// How the rows of a stream are read.
struct InputOptions { // NOLINT(*.Padding): one a run, in the order of its reader
    RowNumbers numbers{};
    ColumnList columns{};                 ///< empty: a row is its numbers and nothing else
    std::optional<Delimiter> delimiter{}; ///< nothing: the first data row's
    std::size_t width = 0;                ///< doubles of a row of binary input; 0: the input is text
    int key_power = 0; ///< keys are read in units of 10^key_power of the unit in which they are compared
    Key key_offset{};  ///< added to each key
    HeaderMode header = HeaderMode::automatic;
    std::string comment = "#"; ///< what comments begin with; empty: there are none
    bool stops = false;        ///< a row error ends the run
    bool are_chosen = false;   ///< no columns are selected, and a row is not its numbers alone: see columns_of
    bool ragged = false;       ///< rows may have any number of fields, if the selected ones are there
    /// Given the field count of the first row, returns how many numbers it holds, or an error. Only for numbers that
    /// are not yet known.
    std::function<std::variant<std::size_t, std::string>(std::size_t fields)> take_count{};
    /// Returns the notes on the header, or on comments of a stream without a row.
    std::function<std::vector<Note>(const HeaderFacts& said)> notes_of{};
    /// Given the names of the selected columns, says where the numbers are among them.
    std::function<std::vector<std::size_t>(const std::vector<std::string>& names)> order_of{};
    /// Given the names of all columns, says which are those of the numbers; null if columns are read as they stand.
    std::function<ChosenColumns(const std::vector<std::string>& names)> columns_of{};
    /// Given the number of fields, says where files of a project have the numbers.
    std::function<ChosenColumns(std::size_t fields)> project_columns{};
    /// Whether a text is a unit.
    bool (*is_unit)(std::string_view text) = nullptr;
    /// Reads a whole input, if it is one attitude in a form other than a row: the row, and notes that say so.
    std::function<std::optional<std::pair<std::string, std::vector<Note>>>(std::string_view text)> read_text{};

    /// A blank line is not a comment, whatever comments begin with.
    [[nodiscard]] bool is_comment(std::string_view line) const noexcept {
        return !comment.empty() && !line.empty() && line.front() == comment.front() && line.starts_with(comment) &&
               !is_blank(line);
    }
    [[nodiscard]] bool is_row(std::string_view line) const noexcept { return !is_comment(line) && !is_blank(line); }
};

/// How the rows of two streams are paired. The operation gets the numbers of a row, then those of its partner.
struct Pairing {
    InputOptions reference{}; ///< how the other stream is read
    bool by_key = false;      ///< by the first selected column, which increases; otherwise by the rows' number
    KeyDistance within{};     ///< the largest difference of two keys
    /// The partner is interpolated at the row's key between two rows of the reference, whose keys differ by at most
    /// `within`. See NumberRows::between.
    bool interpolates = false;
    bool needs_partner = false; ///< a row of the stream without a partner is a row error
    bool looks_for_key = false; ///< among the columns of rows that are paired by their number: see LikelyKey
    bool tells_partner = true;  ///< text has the columns partner_names, if rows are paired by key
};

/// What a run does with its rows: it writes them, adds them to a fold, or both.
struct Options {
    InputOptions input{};
    std::shared_ptr<RowOperation> operation{};
    bool writes_rows = true;
    std::shared_ptr<Fold> fold{}; ///< null: there is none
    Format format = Format::csv;
    OnError on_error = OnError::stop;
    Digits digits{};                                      ///< how the result's numbers are printed
    bool append = false;                                  ///< keep the row and add the result at its end
    bool diagnostic_columns = false;                      ///< margin, condition, defect and notes after the result
    bool show_diagnostics = true;                         ///< in words, with Format::pretty
    std::size_t threads = 1;                              ///< at most
    std::string (*describe)(const Diagnostic&) = nullptr; ///< returns the words of a diagnostic
    /// With pretty and json, a single row has its numbers under their SPECs, and this text after it.
    std::optional<std::string> block{};
    std::optional<Pairing> pairing{}; ///< nothing: there is no reference

    /// Whether comments, blank lines and the header are written too.
    [[nodiscard]] bool writes_all_lines() const noexcept { return writes_rows && format == Format::csv; }
    [[nodiscard]] bool writes_partners() const noexcept {
        return pairing && pairing->by_key && pairing->tells_partner && writes_all_lines();
    }
};

/// The columns after a row that is paired by key.
inline constexpr std::array<std::string_view, 3> partner_names{"reference_line", "reference_key", "key_difference"};
inline constexpr std::array<std::string_view, 4> diagnostic_names{"margin", "condition", "defect", "notes"};

} // namespace rotconv::stream
