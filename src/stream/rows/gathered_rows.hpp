#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "../event.hpp"
#include "../job.hpp"
#include "../options.hpp"
#include "layout.hpp"
#include "row_reader.hpp"

namespace rotconv::stream {

/// Rows that are answered together, with their numbers and fields. One batch, reused: once it has grown, nothing is
/// allocated for a row without an error.
class GatheredRows {
public:
    /// @param reference_layout null if rows are not paired
    GatheredRows(const Options& options, const Layout& layout, const Layout* reference_layout);

    /// Sets the width of the rows that follow.
    void expect(const RowWidth& width) noexcept { readers_[0].expect(width); }
    /// Takes over pairs of rows.
    void take(ReadRows& pairs) noexcept { std::swap(read_, pairs); }
    /// Takes rows off the text, up to `most_rows` and `most_bytes`; with OnError::stop none after an error.
    void gather(std::string_view& text, std::size_t& line, std::size_t most_rows, std::size_t most_bytes);
    /// Reads doubles that hold only the numbers, up to `most_rows`; rows() stays empty.
    void gather_numbers(std::string_view& doubles, std::size_t& line, std::size_t most_rows);
    /// Adds the rows() whose numbers were taken off these doubles.
    void add_rows(std::string_view doubles);
    /// Drops the rows from that index on, which are left to a later batch.
    /// @return where the text of the first begins
    const char* drop_from(std::size_t index);

    [[nodiscard]] std::vector<Row>& rows() noexcept { return read_.rows; }
    /// The pair of one of the rows; an empty one without a reference.
    [[nodiscard]] const Pair& pair_of(const Row& row) const noexcept;
    /// Whether a row has an error.
    [[nodiscard]] bool has_error() const noexcept { return !read_.errors.empty(); }
    /// The error of a row without a result. `given`: the row as it was read.
    [[nodiscard]] RowError error_of(const Row& row, const RowReport& report, std::string_view given) const;
    /// The numbers of the rows that have them.
    [[nodiscard]] NumberRows numbers() const noexcept { return read_.parts.view(); }
    /// How many rows have numbers.
    [[nodiscard]] std::size_t count() const noexcept { return read_.parts.lines.size(); }
    /// Looks for the fields of a row, unless they are known. A binary row's fields are its numbers' bytes, or their
    /// text if the output is text: the row becomes that text.
    void split(Row& row);
    [[nodiscard]] std::span<const std::string_view> fields_of(const Row& row) const noexcept {
        return std::span(read_.parts.fields).subspan(row.first_field, row.field_count);
    }
    /// The rows that have numbers, to be taken over.
    [[nodiscard]] HeldRows& held() noexcept { return read_.parts; }

private:
    /// Adds the numbers of the last row, or the error.
    void read_last();
    void split_doubles(Row& row);
    /// The norm of the quaternion that the report is about; 0 if the attitude is not a quaternion.
    [[nodiscard]] double norm_of(const Row& row, const RowReport& report) const;

    const Options* options_;
    const Layout* layout_;
    std::vector<RowReader> readers_; ///< by Side
    ReadRows read_;
    Buffer made_; ///< the text of a binary row
};

} // namespace rotconv::stream
