#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "../core/numerics/row_batch.hpp"
#include "event.hpp"
#include "gathered_rows.hpp"
#include "job.hpp"
#include "layout.hpp"
#include "options.hpp"
#include "row_writer.hpp"

namespace rotconv::stream {

/// Runs what all blocks have done in the order of the stream, once those before have had it done.
/// @return false where the run is over: nothing was done and nothing is to be written
using InTurn = std::function<bool(const std::function<void()>& what)>;

/// Turns blocks of rows into their output. What a block becomes depends on the block, the options and the layout alone
/// (unless the operation remembers rows), so that several transformers may work on the blocks of one stream.
class RowTransformer {
public:
    RowTransformer(const Options& options, const Layout& layout, const Layout* reference_layout = nullptr);

    /// What follows has rows of these widths, in the stream and the reference.
    void expect(const std::array<RowWidth, 2>& widths) noexcept { gathered_.expect(widths); }
    /// Adds what the rows of `text`, whole lines of which the first is line `line`, become. An operation that is
    /// continuous has its turn once, with all rows of the text; at once without turns.
    void transform(std::string_view text, std::size_t line, Output& output, const InTurn& in_turn = {});
    /// The same of pairs of rows.
    void transform(const PairBlock& pairs, Output& output);
    /// To be called at the end: adds what still waits.
    void finish(Output& output);

private:
    static constexpr std::size_t most_waiting = std::size_t{1} << 16U;
    static constexpr std::size_t every_row = static_cast<std::size_t>(-1);

    /// Rows that are answered together. Where answers depend on the rows after them, a row that has none yet, and what
    /// follows it, wait for the next call, up to `most_waiting` bytes.
    [[nodiscard]] std::size_t rows_at_once() const noexcept {
        return operation_->is_continuous && !operation_->in_order ? every_row : batch_rows;
    }
    void transform_all(std::string_view text, std::size_t line, bool is_end, Output& output, const InTurn& in_turn);
    /// Doubles in and nothing but the result out: as many rows are written at once as there is nothing to tell of.
    [[nodiscard]] bool is_doubles_alone() const noexcept;
    void transform_doubles(std::string_view text, std::size_t line, Output& output, const InTurn& in_turn);
    /// Answers the rows that have numbers, or only the first of them, see RowOperation::run().
    std::size_t answer(bool flush);
    /// Makes the first answers continuous, in turn.
    void make_continuous(std::size_t answered, Output& output, const InTurn& in_turn);
    void write(Output& output);
    /// Hands over the rows at hand and their answers, if there is a fold.
    void give_away(std::size_t answered, Output& output);
    void write_row(Row& row, Output& output);
    /// Whether the report that comes next is of one of the row's answers before that index.
    [[nodiscard]] bool is_reported_before(const Row& row, std::size_t answer) const noexcept {
        return row.has_numbers() && next_report_ < reports_.size() && reports_[next_report_].row < answer;
    }
    /// What is to be told of the row's answer of that index; to be asked of each in turn.
    [[nodiscard]] const RowReport& report_of(const Row& row, std::size_t answer) noexcept;
    /// Has the output say with which row it is paired. `given`: the row as it was read.
    void find_partner(const Row& row, std::string_view given);

    const Options* options_;
    const Layout* layout_;
    std::shared_ptr<RowOperation> operation_; ///< a copy, for it may have room of its own to work in
    GatheredRows gathered_;
    RowWriter writer_;
    std::string waiting_;          ///< rows of earlier blocks that are not yet answered...
    std::size_t waiting_line_ = 0; ///< ...and the first one's line
    // Of one batch, reused.
    std::vector<double> results_;
    std::vector<RowReport> reports_; ///< of the remarkable rows...
    std::size_t next_report_ = 0;    ///< ...of which this is the first that is not yet written
    std::string partner_;            ///< what the output says of the row's partner
    RowParts key_parts_;             ///< of both
    std::vector<double> nans_;       ///< the result of a row that failed
};

} // namespace rotconv::stream
