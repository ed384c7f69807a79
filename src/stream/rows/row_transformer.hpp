#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "../../core/numerics/row_batch.hpp"
#include "../event.hpp"
#include "../job.hpp"
#include "../options.hpp"
#include "layout.hpp"
#include "row_reader.hpp"
#include "row_writer.hpp"

namespace rotconv::stream {

/// Converts blocks of rows to their output. The output depends only on the block, the options and the layout (unless
/// the operation remembers rows), so that several transformers may work on the blocks of one stream.
class RowTransformer {
public:
    RowTransformer(const Options& options, const Layout& layout, const Layout* reference_layout = nullptr);

    /// Sets the width of the rows that follow.
    void expect(const RowWidth& width) noexcept { readers_[0].expect(width); }
    /// Adds the output of the rows of `text`, whole lines from line `line` on. The results of a continuous operation
    /// are made continuous once, for all rows of the text, by `ordered` if it is given. `is_end`: no row may wait.
    void transform(std::string_view text, std::size_t line, Output& output, const Ordered& ordered = {},
                   bool is_end = false);
    /// The same of pairs of rows, which are taken over.
    void transform(ReadRows& pairs, Output& output, const Ordered& ordered);
    /// To be called at the end: adds the output of rows that still wait.
    void finish(Output& output);

private:
    static constexpr std::size_t most_waiting = std::size_t{1} << 16U;
    static constexpr std::size_t every_row = static_cast<std::size_t>(-1);

    /// How many rows are answered together. If results depend on later rows, a row without a result, and the rows after
    /// it, wait for the next call, up to `most_waiting` bytes.
    [[nodiscard]] std::size_t rows_at_once() const noexcept {
        return operation_->is_continuous() && !operation_->in_order ? every_row : batch_rows;
    }
    /// Takes rows off the text, up to `most_rows` and `most_bytes`; with OnError::stop none after an error.
    void gather(std::string_view& text, std::size_t& line, std::size_t most_rows, std::size_t most_bytes);
    /// Reads doubles that hold only the numbers, up to `most_rows`; there are no rows then.
    void gather_numbers(std::string_view& doubles, std::size_t& line, std::size_t most_rows);
    /// Adds the rows whose numbers were taken off these doubles.
    void add_rows(std::string_view doubles);
    /// Runs the operation on the rows that have numbers; returns how many are answered, see RowOperation::run().
    std::size_t answer(bool flush, Output& output, const Ordered& ordered);
    /// Writes the rows, which were taken off the text, and hands them over with their results if there is a fold.
    void finish_batch(std::string_view text, Output& output);
    void write(Output& output);
    void write_row(Row& row, Output& output);
    /// Whether the next report belongs to the row.
    [[nodiscard]] bool is_reported(const Row& row) const noexcept {
        return row.has_numbers() && next_report_ < reports_.size() && reports_[next_report_].row == row.index;
    }
    /// The report on the row's result, empty if there is none; to be called for each row in order.
    [[nodiscard]] const RowReport& report_of(const Row& row) noexcept;
    /// The pair of one of the rows; an empty one without a reference.
    [[nodiscard]] const Pair& pair_of(const Row& row) const noexcept;
    /// The error of a row without a result. `given`: the row as it was read.
    [[nodiscard]] RowError error_of(const Row& row, const RowReport& report, std::string_view given) const;
    /// The norm of the quaternion of a row; 0 if the attitude is not a quaternion.
    [[nodiscard]] double norm_of(Side side, std::string_view row) const;
    /// Looks for the fields of a row, unless they are known. A binary row's fields are its numbers' bytes, or their
    /// text if the output is text: the row becomes that text.
    void split(Row& row);

    const Options* options_;
    const Layout* layout_;
    std::shared_ptr<RowOperation> operation_; ///< a copy, as it may have its own working memory
    std::size_t width_;                       ///< numbers of a result
    std::vector<RowReader> readers_;          ///< by Side
    RowWriter writer_;
    bool are_doubles_alone_;       ///< doubles in and only the result out: rows are looked at if one has a report
    std::string waiting_;          ///< rows of earlier blocks that are not yet answered
    std::size_t waiting_line_ = 0; ///< the line of the first of them
    // One batch, reused: once it has grown, nothing is allocated for a row without an error.
    ReadRows read_;
    Buffer made_; ///< the text of a binary row
    Numbers results_;
    std::vector<RowReport> reports_; ///< one for each remarkable row
    std::size_t next_report_ = 0;    ///< index of the first report that is not yet written
    std::string no_partner_;         ///< the fields partner_names of a row that has none
    std::vector<double> nans_;       ///< the result of a failed row
};

} // namespace rotconv::stream
