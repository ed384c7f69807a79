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

namespace rotconv::stream {

/// What a row gives to an operation.
struct RowNumbers {
    std::vector<std::string> names{}; ///< what its numbers are called; none: that is not yet known
    std::optional<Spec> attitude{}; ///< what the first of them are, after those that are kept, if they are an attitude
    std::optional<Spec> second{};   ///< what the last of them are, if they are an attitude too
    std::size_t kept = 0; ///< how many of the first also pass through unchanged: a time or a key, which may be ISO 8601
    bool has_unit = false; ///< those are numbers in a unit, and ISO 8601 is an error
};

/// Rows that have their numbers, in the order of the stream.
struct NumberRows {
    std::span<const double> numbers;    ///< of all of them, row by row
    std::span<const std::size_t> lines; ///< where they stand
    /// The texts of the numbers that are kept, row by row; empty where rows are doubles.
    std::span<const std::string_view> kept{};
    std::span<const std::size_t> reference_lines{}; ///< those of their partners; empty where there is no reference
    bool are_last = true;                           ///< no answer is to wait for later rows
};

/// Where the numbers of two attitudes stand in a row for an operation. Paired by key, each has its key before it. Where
/// the reference is interpolated, the second is the earlier of its neighbours; the later one's numbers follow, without
/// a key, and how far the row is from the earlier to the later, as a fraction: 0 where the reference has the row's key,
/// and both are that row.
struct PairColumns {
    std::size_t first_size = 0;
    std::size_t second_size = 0;
    bool by_key = false;
    bool interpolates = false;

    [[nodiscard]] constexpr std::size_t first() const noexcept { return by_key ? 1 : 0; }
    [[nodiscard]] constexpr std::size_t second_key() const noexcept { return first() + first_size; }
    [[nodiscard]] constexpr std::size_t second() const noexcept { return second_key() + first(); }
    [[nodiscard]] constexpr std::size_t later() const noexcept { return second() + second_size; }
    [[nodiscard]] constexpr std::size_t fraction() const noexcept { return later() + second_size; }
    [[nodiscard]] constexpr std::size_t width() const noexcept { return interpolates ? fraction() + 1 : later(); }
};

/// What a run makes of the numbers of its rows.
class RowOperation {
public:
    RowOperation() = default;
    virtual ~RowOperation() = default;
    /// For another thread; what has to follow the rows in their order is shared.
    [[nodiscard]] virtual std::unique_ptr<RowOperation> copy() const = 0;

    /// Answers rows with names.size() numbers each, or as many for each of the answers. `reports` becomes those of the
    /// rows of which there is something to report, in their order. Where an answer may depend on the rows after it,
    /// only as many of the first rows are answered as can be, or all with `rows.are_last`; the others come first in the
    /// next call.
    /// @return how many are answered
    virtual std::size_t run(const NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) = 0;
    /// Makes each result follow from the one before: called after run() of the same rows, for all rows in their order.
    virtual void make_continuous(std::span<double> /*results*/, std::span<const RowReport> /*reports*/) {}

    [[nodiscard]] std::size_t answers_of_row() const noexcept { return answers.empty() ? 1 : answers.size(); }

    std::vector<std::string> names{}; ///< the columns of the result
    bool keeps_names = false;         ///< where the input has names, the result has those of the last selected columns
    std::vector<Spec> attitudes{};    ///< what the result is, one after the other, if it is attitudes
    /// Where each row gets several answers, a line each: their names, for the column `method` before the last number.
    /// RowReport::row is then the index of the answer among those of all rows.
    std::vector<std::string> answers{};
    /// Seconds between the first two times, if these are numbers, and the line of the second.
    std::pair<double, std::size_t> first_step{};
    std::string_view unit{};    ///< of the angles that are beyond a limit
    bool in_order = false;      ///< all rows must come to it in their order; else each copy answers any of them whole
    bool is_continuous = false; ///< by make_continuous()

protected:
    RowOperation(const RowOperation&) = default;
    RowOperation(RowOperation&&) = default;
    RowOperation& operator=(const RowOperation&) = default;
    RowOperation& operator=(RowOperation&&) = default;
};

/// Rows with what an operation answered: `results` of its names.size() numbers each, nan where a report has an error.
struct AnsweredRows {
    NumberRows rows;
    std::span<const double> results;
    std::span<const RowReport> reports;
};

/// What all rows of a run come to. The caller owns it, and looks at it after the run.
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
