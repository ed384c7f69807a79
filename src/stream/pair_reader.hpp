#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "job.hpp"
#include "key.hpp"
#include "likely_key.hpp"
#include "options.hpp"
#include "row_blocks.hpp"
#include "row_reader.hpp"

namespace rotconv::stream {

/// Reads two streams side by side and pairs their rows: those of the same number, or those whose keys are each the
/// other's nearest, of equals the earlier, or rows with the two of the reference around their keys. It looks one row
/// ahead, and gives up where too much stands in between, so that memory stays flat. In what pieces the streams arrive
/// makes no difference.
class PairReader final : public JobReader {
public:
    /// @pre options.pairing
    PairReader(Source& source, Source& reference, const Options& options, std::size_t block_size);

    bool read(Job& job) override;
    [[nodiscard]] bool is_ready() const override { return dry_ == nullptr || dry_->is_ready(); }
    void finish(Output& output, bool at_end) override { rows_.blocks.finish(output, at_end); }
    [[nodiscard]] std::optional<StreamError> error() const override;
    [[nodiscard]] const Layout& layout() const override { return rows_.blocks.layout(); }
    [[nodiscard]] const Layout* reference_layout() const override { return &references_.blocks.layout(); }
    [[nodiscard]] std::array<RowWidth, 2> widths() const override {
        return {rows_.blocks.widths()[0], references_.blocks.widths()[0]};
    }
    [[nodiscard]] std::array<Unpaired, 2> unpaired() const override { return {rows_.unpaired, references_.unpaired}; }
    [[nodiscard]] KeysMet keys() const override;

private:
    /// A line that is read and not yet disposed of.
    struct Waiting {
        Line line{};
        std::size_t number = 0;
        bool passes = false;
        bool ends_text = false;            ///< it is the last line of a text
        std::unique_ptr<RowError> error{}; ///< of the key

        [[nodiscard]] bool has_key() const noexcept { return !passes && !error; }
    };

    /// Whether a row is at hand.
    enum class At : std::uint8_t { row, end, dry, too_far };

    /// One of the two streams.
    struct Side {
        Side(Source& source, const InputOptions& given, const Options* written, bool with_keys, std::size_t block_size)
            : options(&given), by_key(with_keys), blocks(source, given, written, block_size),
              reader(given, blocks.layout()) {}

        /// Whether its `ahead`-th row from here is at hand; takes lines off the text for it.
        At look(std::size_t ahead);
        /// Reads a block, by means of the job.
        void read_block(Job& job);
        void take_line();
        void find_key(Waiting& row);
        void drop_row(bool is_paired);
        void drop_line();
        /// Has the block hold the first texts for as long as its rows are used.
        void hold(std::size_t count, PairBlock& pairs);
        [[nodiscard]] bool is_done() const { return ended && rest.empty() && rows_waiting == 0; }
        [[nodiscard]] bool is_ready() const { return ended || !rest.empty() || blocks.is_ready(); }

        const InputOptions* options;
        bool by_key; ///< the first selected column
        RowBlocks blocks;
        RowReader reader;
        RowParts parts;
        std::deque<std::shared_ptr<const Buffer>> texts; ///< the blocks of the lines at hand...
        std::size_t held = 0;                            ///< ...the first ones that the job holds...
        std::string_view rest;                           ///< ...and the lines that do not wait yet
        std::size_t line = 1;
        bool ended = false; ///< of the blocks
        std::deque<Waiting> waiting;
        std::deque<Key> keys;                ///< of the rows among them, where they have keys
        std::size_t bytes_waiting = 0;       ///< of those lines
        std::size_t rows_waiting = 0;        ///< that may be paired
        std::optional<KeysMet::Range> range; ///< of the keys that increased
        std::optional<Key> disposed;         ///< the last key before the first waiting row
        Unpaired unpaired;
    };

    /// Pairs the first rows of both, or disposes of one of them.
    /// @return the side whose next row must be known first, or null
    Side* match(Job& job, At row, At reference);
    /// Whether the row with the lower key has no partner, because the other is too far from it or has a nearer one.
    [[nodiscard]] bool is_alone(const Side& low, const Side& high) const;
    /// The row lies behind the first of the reference. `next`: whether the next one is at hand.
    void match_between(Job& job, At next);
    /// `is_between`: it lies between the first two of the reference.
    void pair(Job& job, bool is_between = false);
    /// Disposes of the side's next row, which has no partner.
    void drop_alone(Job& job, Side& side);
    void compare_distance(KeyDistance found);
    [[nodiscard]] std::optional<StreamError> reference_error() const;
    /// What needs no other row: lines that pass, rows whose key is at fault. `of_both`: those of the reference too,
    /// which come after all of the stream that stand before its next row.
    void hand_on_alone(Job& job, bool of_both);

    const Pairing* pairing_;
    Side rows_;
    Side references_;
    bool any_pair_ = false;
    std::optional<KeyDistance> nearest_; ///< of the keys of a row without a partner and of its neighbours
    Job reference_job_;                  ///< room for its blocks
    Side* dry_ = nullptr;                ///< that the last job ended at
    std::optional<StreamError> error_;
    std::optional<LikelyKey> likely_key_; ///< of text that is paired by number, from the first pair on
};

} // namespace rotconv::stream
