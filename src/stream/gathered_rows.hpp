#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <span>
#include <string_view>
#include <vector>

#include "event.hpp"
#include "job.hpp"
#include "layout.hpp"
#include "options.hpp"
#include "row_reader.hpp"

namespace rotconv::stream {

/// Rows that are answered together, with their numbers and fields. One batch, reused: once it has grown, nothing is
/// allocated for a row without an error.
class GatheredRows {
public:
    /// @param reference_layout null if rows are not paired
    GatheredRows(const Options& options, const Layout& layout, const Layout* reference_layout);

    /// Sets the widths of the rows that follow, in the stream and the reference.
    void expect(const std::array<RowWidth, 2>& widths) noexcept;
    void clear() noexcept;
    /// Takes rows off the text, up to `most_rows` and `most_bytes`; with OnError::stop none after an error.
    void gather(std::string_view& text, std::size_t& line, std::size_t most_rows, std::size_t most_bytes);
    /// Reads a row and its partner, unless the row has an error.
    void add(const Row& pair);
    /// Takes the numbers of rows off doubles that are nothing else, up to `most_rows`, without rows() of them.
    void gather_numbers(std::string_view& doubles, std::size_t& line, std::size_t most_rows);
    /// Adds the rows() whose numbers were taken off these doubles.
    void add_rows(std::string_view doubles);
    /// Drops the rows from that index on, which are left to a later batch.
    /// @return where the text of the first begins
    const char* drop_from(std::size_t index);

    [[nodiscard]] std::vector<Row>& rows() noexcept { return rows_; }
    /// Whether a row that was read here has an error.
    [[nodiscard]] bool has_error() const noexcept { return !errors_.empty(); }
    /// The error of a row without a result. `given`: the row as it was read.
    [[nodiscard]] RowError error_of(const Row& row, const RowReport& report, std::string_view given) const;
    /// The numbers of the rows that have them.
    [[nodiscard]] NumberRows numbers() const noexcept {
        return {parts_.numbers, lines_, parts_.kept, parts_.keys, reference_lines_};
    }
    /// How many rows have numbers.
    [[nodiscard]] std::size_t count() const noexcept { return lines_.size(); }
    /// Looks for the fields of a row, unless they are known. A binary row's fields are its numbers' bytes, or their
    /// text if the output is text: the row becomes that text.
    void split(Row& row);
    [[nodiscard]] std::span<const std::string_view> fields_of(const Row& row) const noexcept {
        return std::span(parts_.fields).subspan(row.first_field, row.field_count);
    }
    /// Hands over the numbers, lines and texts of the rows with numbers.
    void move_to(AnsweredRows& batch);

    /// @pre rows are paired, for Side::reference
    [[nodiscard]] const RowReader& reader(Side side) const noexcept { return readers_[index_of(side)]; }

private:
    /// Adds the numbers of a row and its partner, or the error.
    void take(Row& row);
    /// Adds the numbers from the reference; see PairColumns.
    [[nodiscard]] bool take_partner(const Row& row);
    /// Adds the numbers of one line of either stream. The text of a line `of_pair` is in a PairBlock.
    [[nodiscard]] bool take_line(std::string_view text, Side side, bool of_pair);
    void split_doubles(Row& row);
    /// The norm of the quaternion that the report is about; 0 if the attitude is not a quaternion.
    [[nodiscard]] double norm_of(const Row& row, const RowReport& report) const;

    const Options* options_;
    const Layout* layout_;
    std::vector<RowReader> readers_; ///< by Side
    std::vector<Row> rows_;
    RowParts parts_;
    std::deque<RowError> errors_;    ///< they stay in their place
    std::vector<std::size_t> lines_; ///< those of the rows with numbers
    std::vector<std::size_t> reference_lines_;
    Buffer made_; ///< the text of a binary row
};

} // namespace rotconv::stream
