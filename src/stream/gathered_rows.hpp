#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "event.hpp"
#include "job.hpp"
#include "layout.hpp"
#include "options.hpp"
#include "row_reader.hpp"

namespace rotconv::stream {

/// Rows that are answered together, and what was read of them. One batch, reused: nothing is allocated for each row
/// once it has grown.
class GatheredRows {
public:
    /// @param reference_layout null where rows are not paired
    GatheredRows(const Options& options, const Layout& layout, const Layout* reference_layout);

    /// What follows has rows of these widths, in the stream and the reference.
    void expect(const std::array<RowWidth, 2>& widths) noexcept;
    void clear() noexcept;
    /// Reads rows off the text, as many and as many bytes as are wanted at most; under `stop` none after an error.
    void gather(std::string_view& text, std::size_t& line, std::size_t most_rows, std::size_t most_bytes);
    /// Reads a row and its partner.
    void add(const Row& pair, const std::vector<RowError>& errors_of_pairs);
    /// Rows of doubles that are nothing but their numbers.
    void add_doubles(std::string_view doubles, std::size_t line);
    /// Leaves the rows from this one on to a later batch.
    /// @return where its text begins
    const char* drop_from(std::size_t index);

    [[nodiscard]] std::vector<Row>& rows() noexcept { return rows_; }
    [[nodiscard]] bool has_error() const noexcept { return !errors_.empty(); }
    [[nodiscard]] const RowError& error_of(const Row& row) const { return errors_[row.error]; }
    /// Of the rows that have them.
    [[nodiscard]] NumberRows numbers() const noexcept {
        return {parts_.numbers, lines_, parts_.kept, reference_lines_};
    }
    /// Of a row, and of its partner.
    [[nodiscard]] std::span<const double> numbers_of(const Row& row) const noexcept;
    /// How many have numbers.
    [[nodiscard]] std::size_t count() const noexcept { return lines_.size(); }
    /// Looks for the fields of a row, if nobody has, those of a binary row are its numbers' bytes, or text where the
    /// output is text: the row becomes that text.
    void split(Row& row);
    [[nodiscard]] std::span<const std::string_view> fields_of(const Row& row) const noexcept {
        return std::span(parts_.fields).subspan(row.first_field, row.field_count);
    }
    /// Hands over what was read of the rows with numbers.
    void move_to(AnsweredBatch& batch);

    [[nodiscard]] const RowReader& reader() const noexcept { return reader_; }
    /// Where rows are paired.
    [[nodiscard]] const RowReader& reference_reader() const noexcept { return *reference_reader_; }

private:
    void read(Row& row);
    /// Reads what stands in the reference; see PairColumns.
    [[nodiscard]] bool read_partner(const Row& row);
    [[nodiscard]] bool read_reference(std::string_view text, std::size_t line);
    void split_doubles(Row& row);

    const Options* options_;
    const Layout* layout_;
    RowReader reader_;
    std::optional<RowReader> reference_reader_;
    std::vector<Row> rows_;
    RowParts parts_;
    std::vector<RowError> errors_;
    std::vector<std::size_t> lines_; ///< of the rows with numbers
    std::vector<std::size_t> reference_lines_;
    Buffer made_; ///< the text of a binary row
};

} // namespace rotconv::stream
