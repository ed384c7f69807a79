#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <rotconv/reading.hpp>

#include "beginning/column_list.hpp"
#include "beginning/delimiter.hpp"
#include "numbers/number_text.hpp"
#include "pairs/key.hpp"
#include "rows/row_operation.hpp"

namespace rotconv::stream {

/// One of the streams of a run: the one whose rows are answered, or the reference that is read beside it.
enum class Side : std::uint8_t { stream, reference };
inline constexpr std::array both_sides{Side::stream, Side::reference};

[[nodiscard]] constexpr std::size_t index_of(Side side) noexcept { return static_cast<std::size_t>(side); }

/// A line of a stream; line 0: the stream as a whole.
struct Place {
    std::size_t line = 0;
    Side side = Side::stream;

    [[nodiscard]] bool is_in_reference() const noexcept { return side == Side::reference; }
};

/// The number of fields that a stream's lines have: that of the line that sets it.
struct RowWidth {
    FieldCount fields{};
    std::size_t line = 0; ///< 0: there was no such line so far
};

/// A row error: where, why, and the text at fault.
struct RowError {
    enum class What : std::uint8_t {
        not_a_number,   ///< `text` is the field; the row's width may be told too
        too_large,      ///< `text` is the field
        wrong_count,    ///< `found` fields where the representation has `expected`
        missing_column, ///< `found` fields, column `expected` is selected
        other_width,    ///< `found` fields where the row at `first_line` has `expected`
        open_quote,
        key_order,  ///< `text` is a key that does not increase
        no_partner, ///< the row is in no pair, see Pairing::needs_partner; `error` may say why
        key,        ///< `text` is not read as a key, and `key` says why
        attitude,   ///< the numbers are not an attitude: see `error`, `defect`
    };
    Place place{};
    Place cause{}; ///< the row of the reference that is at fault; line 0: the row itself is
    What what = What::attitude;
    std::string text{};
    std::size_t found = 0;
    std::size_t expected = 0;
    std::size_t first_line = 0;
    Error error = Error::none;
    double defect = 0.0;
    KeyError key = KeyError::none;
    double norm = 0.0; ///< the quaternion's; 0 if it is not known

    /// Has it say that the row has another number of fields than a line above, if it has.
    void tell_width(const FieldCount& count, const RowWidth& width) {
        if (width.line > 0 && !count.fits(width.fields)) {
            found = count.all;
            expected = width.fields.all;
            first_line = width.line;
        }
    }
};

/// One diagnostic of one row; the figure is the defect, the margin, the condition or an error, by kind.
struct Diagnostic {
    Place place{};
    DiagnosticKind kind = DiagnosticKind::normalized;
    double figure = 0.0;
    std::string_view unit{}; ///< the figure's, for kinds with several units
};

/// A remark in words: the input describes its numbers otherwise than they are read. Each kind is reported once.
struct Note {
    enum class Kind : std::uint8_t {
        order,
        unit,
        time_unit,
        angle,
        pairing,
        comments,
        only_header,
        axes,
        passed,
        columns,
        text,
        chosen
    };
    Kind kind = Kind::order;
    std::string text;
    Place place{};                    ///< line 0: the note is about the command line
    std::vector<std::string> words{}; ///< an option and its argument that the command line lacks, if it lacks one
};

using Event = std::variant<RowError, Diagnostic, Note>;

/// Rows of a stream that are in no pair.
struct Unpaired {
    std::size_t rows = 0;
    std::size_t first_line = 0; ///< line of the first of them

    void add(const Unpaired& others) noexcept {
        if (others.rows > 0) {
            first_line = rows == 0 ? others.first_line : std::min(first_line, others.first_line);
            rows += others.rows;
        }
    }
};

/// The output of a block of rows: bytes to write, rows to add to a fold, and events to report after both, each in the
/// order of the rows.
struct Output {
    Buffer bytes{};
    std::vector<AnsweredRows> batches{};
    std::vector<Event> events{};
    std::size_t rows = 0;               ///< data rows of the stream, paired or not
    std::size_t answered = 0;           ///< data rows that have a result
    bool stopped = false;               ///< a row error ended the run
    std::array<Unpaired, 2> unpaired{}; ///< by Side

    /// Keeps its memory.
    void clear() {
        bytes.clear();
        batches.clear();
        events.clear();
        *this = Output{.bytes = std::move(bytes), .batches = std::move(batches), .events = std::move(events)};
    }
};

/// The keys of two streams, of which some may have been too far apart to be paired.
struct PairingStats {
    /// The first and the last key of a stream that may be paired.
    struct Range {
        Key first, last;
    };
    std::array<std::optional<Range>, 2> ranges{}; ///< by Side
    bool any_pair = false;
    /// The smallest difference of a key without a partner and its neighbours; where the partner is interpolated, of
    /// these.
    std::optional<KeyDistance> nearest{};
    std::optional<std::string> likely{}; ///< a column that may be the key of rows paired by number: see LikelyKey
};

/// Why a run ended early, other than by a row error.
struct StreamError {
    enum class What : std::uint8_t {
        read,  ///< `error_number` is an errno
        write, ///< `error_number` is an errno
        line_too_long,
        partial_row, ///< the input ends in the row, which begins at byte `offset`
        columns,     ///< the row is data or a header, and `column` says why no columns were found before it
        count,       ///< the row, `column.text`, has a wrong number of fields; `wrong` says why
        json,        ///< the input begins with JSON
        far_key,     ///< too much lies between the row and the next key, which its partner depends on
    };
    What what = What::read;
    Place place{};
    int error_number = 0;
    ColumnError column{};
    std::size_t offset = 0;
    std::string wrong{};
};

} // namespace rotconv::stream
