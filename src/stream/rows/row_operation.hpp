#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rotconv/continuous.hpp>
#include <rotconv/conversion.hpp>

#include "../numbers/number_text.hpp"
#include "../pairs/key.hpp"

namespace rotconv::stream {

/// The numbers that an operation takes of a row.
struct RowNumbers {
    std::vector<std::string> names{}; ///< the numbers' names; empty: not yet known
    std::optional<Spec> attitude{};   ///< the first numbers after the kept ones, if they are an attitude
    std::optional<Spec> second{};     ///< the last numbers, if they are an attitude too
    std::size_t kept = 0;  ///< 1 if the first is also written unchanged: a time or a key, which may be ISO 8601
    bool has_unit = false; ///< the kept one is a number in a unit, and ISO 8601 is an error
};

/// The kept field of a row.
struct Kept {
    std::string_view text{}; ///< empty if it is a double
    ReadKey key{.error = KeyError::not_a_number};
    double number = 0.0; ///< known where there is no key

    [[nodiscard]] std::string written() const { return text.empty() ? number_text(number) : std::string(text); }
};

/// Where a key is between those of two rows of a reference, which may be one row, with that key.
struct InterpolatedPair {
    std::size_t earlier = 0; ///< their indices among NumberRows::neighbours
    std::size_t later = 0;
    KeyDistance way{};    ///< from the earlier key
    KeyDistance whole{1}; ///< between their keys

    [[nodiscard]] double fraction() const { return ratio(way, whole); } ///< from 0 to 1
    [[nodiscard]] bool is_at_row() const noexcept { return earlier == later; }
};

/// Grows without setting its new elements, which are then read into.
using Numbers = fmt::basic_memory_buffer<double, 64>;

/// Rows that have their numbers, in the order of the stream.
struct NumberRows {
    Numbers numbers;                          ///< row by row, without the kept ones
    std::vector<std::size_t> lines;           ///< the rows' lines
    std::vector<Kept> kept;                   ///< the rows', each followed by its partner's in pairs
    std::vector<std::size_t> reference_lines; ///< the partners' lines; empty without a reference
    Numbers neighbours;                       ///< the rows of a reference that is interpolated, each once
    std::vector<InterpolatedPair> between;    ///< where each row is among them
    bool are_last = true;                     ///< no row may wait for later rows
};

/// Calls `what` once all blocks before have come to their call of it; each block does so once.
/// @return false if the run is over: nothing was done and nothing is to be written
using Ordered = std::function<bool(const std::function<void()>& what)>;

/// Answers rows: writes the numbers of each, and sets `reports` to those of the remarkable rows, in their order. If
/// results depend on later rows, only the first rows are answered, as many as can be, or all with `rows.are_last`; the
/// others come first in the next call. `rest`: see Conversion::run(); empty if it is not needed.
/// @return how many rows are answered
using RowFunction = std::function<std::size_t(const NumberRows& rows, std::span<double> out,
                                              std::vector<RowReport>& reports, std::span<double> rest)>;

/// A part of a result: the numbers of an attitude, or others.
struct ResultPart {
    std::vector<std::string> names{};
    std::optional<Spec> attitude{};
    RowFunction function{};
    std::shared_ptr<ContinuousNumbers> follows{}; ///< makes the numbers continuous, for all threads; null: nothing does
    /// The numbers of one row, for that, and their rest in as many doubles as there is room for; may be empty.
    std::function<void(const NumberRows& rows, std::size_t row, std::span<double> numbers, std::span<double> rest)>
        again{};
    // Of the rows at hand, reused:
    std::vector<double> out{};
    std::vector<double> rest{};
    std::vector<RowReport> reports{};
};

/// Computes results from the numbers of rows. A copy for another thread has copies of the functions and their memory.
struct RowOperation {
    RowNumbers input{};
    std::vector<ResultPart> parts{};
    bool keeps_names = false; ///< the result has the names of the last selected columns, if the input has names
    bool in_order = false;    ///< rows must come in their order; otherwise each copy may answer any rows
    std::string_view unit{};  ///< the unit of angles beyond a limit
    /// Seconds between the first two times, if the times are numbers, and the line of the second; may be null.
    std::shared_ptr<const std::pair<double, std::size_t>> first_step{};

    /// How many numbers a result has.
    [[nodiscard]] std::size_t width() const noexcept;
    [[nodiscard]] std::vector<std::string> names() const;
    /// Whether results follow each other, by `ordered` of run().
    [[nodiscard]] bool is_continuous() const noexcept;

    /// Answers rows with all parts, see RowFunction. Of several parts a row has the diagnostics of all, the smallest
    /// margin and the largest condition.
    std::size_t run(const NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports,
                    const Ordered& ordered = {});
};

/// The report on the row among reports in the order of the rows; an empty one is added if there is none.
[[nodiscard]] RowReport& report_of(std::size_t row, std::vector<RowReport>& reports);

/// Rows that were answered together, and their results, of the operation's width() numbers each, nan if the row's
/// report has an error.
struct AnsweredRows : NumberRows {
    Numbers results;
    std::vector<RowReport> reports;
};

/// Collects something from all rows of a run. The caller owns it, and reads it after the run.
class Fold {
public:
    Fold() = default;
    Fold(const Fold&) = delete;
    Fold& operator=(const Fold&) = delete;
    virtual ~Fold() = default;

    /// Called with all rows that have numbers, in the order of the stream, by one thread at a time.
    virtual void add(const AnsweredRows& rows) = 0;
};

} // namespace rotconv::stream
