#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <rotconv/reading.hpp>
#include <rotconv/representation_id.hpp>

#include "column_list.hpp"
#include "key.hpp"
#include "number_text.hpp"
#include "row_operation.hpp"

namespace rotconv::stream {

/// A row that has no attitude: where, why, and the text at fault.
struct RowError {
    enum class What : std::uint8_t {
        not_a_number,   ///< `text` is the field
        too_large,      ///< `text` is the field
        wrong_count,    ///< `found` fields where the representation has `expected`
        missing_column, ///< `found` fields, column `expected` is selected
        other_width,    ///< `found` fields where the row at `first_line` has `expected`
        open_quote,
        key_order,  ///< `text` is a key that does not increase
        no_partner, ///< the row is in no pair; see Pairing::needs_partner
        key,        ///< `text` is no key that is read, and `key` says why
        attitude,   ///< the numbers describe none: see `error`, `defect`
    };
    std::size_t line = 0;
    What what = What::attitude;
    std::string text;
    std::size_t found = 0;
    std::size_t expected = 0;
    std::size_t first_line = 0;
    Error error = Error::none;
    double defect = 0.0;
    KeyError key = KeyError::none;
    double norm = 0.0;         ///< of a quaternion; 0 where it is not known
    bool of_reference = false; ///< the line is one of the reference
};

/// One diagnostic of one row; the figure is the defect, the margin, the condition or an error, by kind.
struct Diagnostic {
    std::size_t line = 0;
    DiagnosticKind kind = DiagnosticKind::normalized;
    double figure = 0.0;
    RepresentationId result{};
    bool of_reference = false; ///< the line is one of the reference
    std::string_view answer{}; ///< whose it is, of several answers to a row
    std::string_view unit{};   ///< of the figure, of a kind that has several
};

/// The first bytes of the stream, up to 64 KiB, before anything else is reported: for advice on what stands in the way.
struct FirstBytes {
    std::string text;
};

/// What the input says of its numbers that is at odds with how they are read, in words. Each kind is told once.
struct Note {
    enum class Kind : std::uint8_t { order, unit, time_unit, angle, pairing, comments, only_header, limit, axes };
    Kind kind = Kind::order;
    std::string text;
    bool ends_run = false;     ///< it is an error
    std::size_t line = 0;      ///< 0: it is about the command line
    bool of_reference = false; ///< the line is one of the reference
};

using Event = std::variant<RowError, Diagnostic, FirstBytes, Note>;

/// Rows of a stream that are in no pair.
struct Unpaired {
    std::size_t rows = 0;
    std::size_t first_line = 0; ///< of the first of them

    void add(const Unpaired& others) noexcept {
        if (others.rows > 0) {
            first_line = rows == 0 ? others.first_line : std::min(first_line, others.first_line);
            rows += others.rows;
        }
    }
};

/// Grows without setting what is then read.
using Numbers = fmt::basic_memory_buffer<double, 64>;

/// Rows that were answered together, for a fold.
struct AnsweredBatch {
    Numbers numbers;
    std::vector<std::size_t> lines;
    std::vector<std::size_t> reference_lines;
    std::vector<std::string_view> kept; ///< in the texts of the block
    std::vector<double> results;
    std::vector<RowReport> reports;

    [[nodiscard]] AnsweredRows rows() const noexcept {
        return {{numbers, lines, kept, reference_lines}, results, reports};
    }
};

/// What a block of rows became: bytes to write, rows to add to a fold, and then events to report, all in the order of
/// the rows.
struct Output {
    Buffer bytes;
    std::vector<AnsweredBatch> batches;
    std::vector<Event> events;
    std::size_t rows = 0;     ///< data rows of the stream
    std::size_t answered = 0; ///< those that have a result
    bool stopped = false;     ///< a row error ended the run
    Unpaired unpaired{};      ///< of the rows: their partner is not defined

    void clear() noexcept {
        bytes.clear();
        batches.clear();
        events.clear();
        rows = 0;
        answered = 0;
        stopped = false;
        unpaired = {};
    }
};

/// The keys of two streams, of which some may have been too far apart to be paired.
struct KeysMet {
    /// Of the stream, and of the reference: the first and the last that may be paired.
    struct Range {
        Key first, last;
    };
    std::array<std::optional<Range>, 2> ranges{};
    bool any_pair = false;
    bool interpolates = false;            ///< the difference of two keys is that of neighbours in the reference
    std::optional<KeyDistance> nearest{}; ///< the least difference of a key without a partner and its neighbours
    std::optional<std::string> likely{};  ///< of rows that are paired by number: see LikelyKey
    KeyDistance within{};                 ///< see Pairing
};

/// Why a run ended early, other than by a row error.
struct StreamError {
    enum class What : std::uint8_t {
        read,          ///< `error_number` is an errno
        write,         ///< `error_number` is an errno
        line_too_long, ///< line `line`
        partial_row,   ///< the input ends in row `line`, which begins at byte `offset`
        columns,       ///< the row at `line` is data or a header, and `column` says why no columns were found before it
        names,         ///< those in the header at `line` are at odds with how the columns are read; `wrong` says how
        count,         ///< of the fields in the row at `line`, which is `column.text`; `wrong` says why
        json,          ///< the input begins with JSON
        far_key,       ///< too much stands between the row at `line` and the next key, on which its partner depends
    };
    What what = What::read;
    std::size_t line = 0;
    int error_number = 0;
    ColumnError column{};
    std::size_t offset = 0;
    bool of_reference = false; ///< it is the reference that cannot be read
    std::string wrong{};
};

} // namespace rotconv::stream
