#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rotconv/conversion.hpp>

#include "fmt.hpp"

namespace rotconv::stream {

/// The numbers that an operation takes of a row.
struct RowNumbers {
    std::vector<std::string> names{}; ///< the numbers' names; empty: not yet known
    std::optional<Spec> attitude{};   ///< the first numbers after the kept ones, if they are an attitude
    std::optional<Spec> second{};     ///< the last numbers, if they are an attitude too
    std::size_t kept = 0;  ///< how many of the first are also written unchanged: a time or a key, which may be ISO 8601
    bool has_unit = false; ///< the kept ones are numbers in a unit, and ISO 8601 is an error
};

/// Rows that have their numbers, in the order of the stream.
struct NumberRows {
    std::span<const double> numbers;                ///< row by row, without the kept ones
    std::span<const std::size_t> lines;             ///< the rows' lines
    std::span<const double> kept{};                 ///< the kept numbers, row by row
    std::span<const std::string_view> keys{};       ///< their texts; empty if rows are doubles
    std::span<const std::size_t> reference_lines{}; ///< the partners' lines; empty without a reference
    bool are_last = true;                           ///< no row may wait for later rows
};

/// Where the numbers of two attitudes stand in a row for an operation. If the reference is interpolated, the second
/// attitude is the earlier of the row's two neighbours; the later one follows, and then the row's place between them, a
/// fraction. It is 0 if the reference has the row's key: both neighbours are then that row.
struct PairColumns {
    std::size_t first_size = 0;
    std::size_t second_size = 0;
    bool interpolates = false;

    [[nodiscard]] constexpr std::size_t later() const noexcept { return first_size + second_size; }
    [[nodiscard]] constexpr std::size_t fraction() const noexcept { return later() + second_size; }
    [[nodiscard]] constexpr std::size_t width() const noexcept { return interpolates ? fraction() + 1 : later(); }
};

/// A number whose range has an open end: if it is rounded to that end, the other one is written.
struct OpenEnd {
    std::size_t number = 0; ///< its index in a result
    double end = 0.0;
    double other = 0.0;
};

/// Computes results from the numbers of rows.
class RowOperation {
public:
    RowOperation() = default;
    virtual ~RowOperation() = default;
    /// A copy for another thread; state that follows the rows in their order is shared.
    [[nodiscard]] virtual std::unique_ptr<RowOperation> copy() const = 0;

    /// Answers rows: writes the results of each, of names.size() numbers. `reports` is set to the reports of the
    /// remarkable rows, in their order. If results depend on later rows, only the first rows are
    /// answered, as many as can be, or all with `rows.are_last`; the others come first in the next call.
    /// @return how many rows are answered
    virtual std::size_t run(const NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) = 0;
    /// Makes results follow each other: called after run() of the same rows, for all rows in their order.
    virtual void make_continuous(std::span<double> /*results*/, std::span<const RowReport> /*reports*/) {}

    RowNumbers input{};
    std::vector<std::string> names{}; ///< the columns of the result
    bool keeps_names = false;         ///< the result has the names of the last selected columns, if the input has names
    std::vector<Spec> attitudes{};    ///< the attitudes that the result is, one after the other, if it is any
    std::vector<OpenEnd> open_ends{};
    /// Seconds between the first two times, if the times are numbers, and the line of the second.
    std::pair<double, std::size_t> first_step{};
    std::string_view unit{};    ///< the unit of angles beyond a limit
    bool in_order = false;      ///< rows must come in their order; otherwise each copy may answer any rows
    bool is_continuous = false; ///< results then pass make_continuous()

protected:
    RowOperation(const RowOperation&) = default;
    RowOperation(RowOperation&&) = default;
    RowOperation& operator=(const RowOperation&) = default;
    RowOperation& operator=(RowOperation&&) = default;
};

/// Grows without setting its new elements, which are then read into.
using Numbers = fmt::basic_memory_buffer<double, 64>;

/// Rows that were answered together, see NumberRows, and their results, of the operation's names.size() numbers each,
/// nan if the row's report has an error.
struct AnsweredRows {
    Numbers numbers;
    std::vector<std::size_t> lines;
    std::vector<std::size_t> reference_lines;
    Numbers kept;
    std::vector<std::string_view> keys; ///< views into the block's text
    std::vector<double> results;
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
