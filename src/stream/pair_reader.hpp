#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "decimal.hpp"
#include "io_block.hpp"
#include "job.hpp"
#include "options.hpp"
#include "row_blocks.hpp"

namespace rotconv::stream {

/// Reads two streams side by side and pairs their rows: those of the same number, or those whose keys are each the
/// other's nearest, of equals the earlier. It looks one row ahead, past a few thousand other lines at most, so that
/// memory stays flat. In what pieces the streams arrive makes no difference.
class PairReader final : public JobReader {
public:
    /// @pre options.pairing
    PairReader(Source& source, Source& reference, const Options& options, std::size_t block_size);

    bool read(Job& job) override;
    [[nodiscard]] bool is_ready() const override { return dry_ == nullptr || dry_->is_ready(); }
    void finish(Output& output) override;
    [[nodiscard]] std::optional<StreamError> error() const override;

    [[nodiscard]] const Layout& layout() const noexcept { return rows_.blocks.layout(); }
    [[nodiscard]] const Layout& reference_layout() const noexcept { return references_.blocks.layout(); }
    [[nodiscard]] std::array<Unpaired, 2> unpaired() const noexcept { return {rows_.unpaired, references_.unpaired}; }

private:
    /// A line that is read and not yet disposed of.
    struct Waiting {
        Line line;
        std::size_t number = 0;
        std::size_t text = 0; ///< in which it stands, counted from the first of all
        bool passed = false;
        Decimal key{};
        std::optional<RowError> error{}; ///< of the key
    };

    /// Whether a row is at hand.
    enum class At : std::uint8_t { row, end, dry };

    /// One of the two streams.
    struct Side {
        Side(Source& source, const InputOptions& given, const Options* written, bool with_keys, std::size_t block_size);

        /// Whether its `ahead`-th row from here is at hand; takes lines off the text for it.
        At look(std::size_t ahead);
        /// The first of them.
        [[nodiscard]] const Waiting& row() const { return waiting.front(); }
        /// The key of the one after it.
        [[nodiscard]] const Decimal& next_key() const;
        void read_block(Output& output);
        void take_line();
        void find_key(Waiting& row);
        void drop_row(bool is_paired);
        void drop_line();
        [[nodiscard]] bool is_done() const { return ended && rest.empty() && rows_waiting == 0; }
        [[nodiscard]] bool is_ready() const { return ended || !rest.empty() || blocks.is_ready(); }
        [[nodiscard]] std::optional<StreamError> error() const { return blocks.error(); }

        const InputOptions* options;
        bool by_key; ///< the first selected column
        RowBlocks blocks;
        std::deque<std::shared_ptr<IoBlock>> texts; ///< in which the waiting lines and the rest stand
        std::size_t texts_gone = 0;                 ///< before them
        std::string_view rest;                      ///< of the last block
        std::size_t line = 1;
        bool ended = false; ///< of the blocks
        std::deque<Waiting> waiting;
        std::size_t bytes_waiting = 0;   ///< of those lines
        std::size_t rows_waiting = 0;    ///< that may be paired
        std::optional<Decimal> newest;   ///< of the keys that increased
        std::optional<Decimal> disposed; ///< the last key before the first waiting row
        Unpaired unpaired;
        std::vector<std::string_view> fields; ///< of one row
    };

    /// Pairs the first rows of both, or disposes of one of them.
    /// @return the side of which a row more must be known first, or null
    Side* match(Job& job, At row, At reference);
    /// The first rows of both are a pair.
    void pair(Job& job);
    /// What needs no other row: lines that pass, rows whose key is at fault. `of_both`: those of the reference too,
    /// which come after all of the stream that stand before its next row.
    void hand_on_alone(Job& job, bool of_both);
    /// Reads a block of that side for the job.
    void fill(Side& side, Job& job);
    /// Gives the job the texts that lines of either side stand in.
    void keep_texts(Job& job) const;

    const Pairing* pairing_;
    Side rows_;
    Side references_;
    Side* dry_ = nullptr; ///< that the last job ended at
};

} // namespace rotconv::stream
