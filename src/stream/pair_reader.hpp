#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string_view>

#include "job.hpp"
#include "key.hpp"
#include "likely_key.hpp"
#include "options.hpp"
#include "row_blocks.hpp"
#include "row_reader.hpp"

namespace rotconv::stream {

/// Reads two streams side by side and pairs their rows: those with the same number, or those whose keys are each the
/// other's nearest (the earlier, if two are as near), or each row with the two rows of the reference around its key. It
/// looks one row ahead, and gives up if too much lies in between, so that memory stays flat. The pieces in which the
/// streams arrive make no difference.
class PairReader final : public JobReader {
public:
    /// @pre options.pairing
    PairReader(Source& source, Source& reference, const Options& options, std::size_t block_size);

    bool read(Job& job) override;
    [[nodiscard]] bool is_ready() const override { return dry_ == nullptr || dry_->is_ready(); }
    void finish(Output& output, bool at_end) override {
        rows_.blocks.finish(output, at_end);
        references_.blocks.finish(output, at_end);
    }
    [[nodiscard]] std::optional<StreamError> error() const override;
    [[nodiscard]] const Layout* layout(Side side) const override {
        return (side == Side::stream ? rows_ : references_).layout();
    }
    [[nodiscard]] std::array<RowWidth, 2> widths() const override {
        return {rows_.blocks.widths()[0], references_.blocks.widths()[0]};
    }
    [[nodiscard]] std::array<Unpaired, 2> unpaired() const override { return {rows_.unpaired, references_.unpaired}; }
    [[nodiscard]] KeysMet keys() const override;

private:
    /// A line that is read and not yet paired, handed on or dropped.
    struct Waiting {
        Line line{};
        std::size_t number = 0;
        bool passes = false;
        bool ends_text = false;            ///< it is the last line of a text
        std::unique_ptr<RowError> error{}; ///< why it has no key or no partner

        [[nodiscard]] bool may_be_paired() const noexcept { return !passes && !error; }
    };

    /// Whether a row is at hand.
    enum class At : std::uint8_t { row, end, dry, too_far };

    /// One of the two streams.
    struct Stream {
        Stream(Side which, Source& source, const Options& all, std::size_t block_size)
            : side(which), options(which == Side::stream ? &all.input : &all.pairing->reference),
              by_key(all.pairing->by_key), blocks(source, *options, which == Side::stream ? &all : nullptr, block_size),
              reader(*options, *layout()) {}

        [[nodiscard]] const Layout* layout() const { return blocks.layout(Side::stream); }
        /// Whether the `ahead`-th next row is at hand; takes lines off the text until it is.
        At look(std::size_t ahead);
        /// Reads a block into the job, and takes it over.
        void take_block(Job& job);
        void take_line();
        void find_key(Waiting& row);
        /// Leaves the next row, which has no partner, to be handed on with an error.
        void fail_row();
        void drop_row(bool is_paired);
        /// Takes the next row out of those that may be paired.
        void dispose_row();
        void drop_line();
        /// Lets the pairs hold the first texts for as long as their rows are used.
        void hold(std::size_t count, PairBlock& pairs);
        /// Whether the layout stays as it is: until then nothing is handed on, for others read it.
        [[nodiscard]] bool is_settled() const { return ended || blocks.has_row(); }
        [[nodiscard]] bool is_ready() const { return ended || !unread.empty() || blocks.is_ready(); }

        Side side;
        const InputOptions* options;
        bool by_key; ///< the key is the first selected column
        RowBlocks blocks;
        RowReader reader;
        RowParts parts;
        std::deque<std::shared_ptr<const Buffer>> texts; ///< the blocks of the lines at hand
        std::size_t held = 0;                            ///< how many of the first texts the job holds
        std::string_view unread;                         ///< lines that do not wait yet
        std::size_t line = 1;
        bool ended = false; ///< there are no more blocks
        std::deque<Waiting> waiting;
        std::deque<Key> keys;                ///< the waiting rows' keys, if rows have keys
        std::size_t bytes_waiting = 0;       ///< size of the waiting lines
        std::size_t rows_waiting = 0;        ///< waiting rows that may be paired
        std::optional<KeysMet::Range> range; ///< the first and the last key that increased
        std::optional<Key> disposed;         ///< the key of the last row that was paired, dropped or failed
        Unpaired unpaired;
    };

    /// Pairs the first rows of both streams, or leaves one of them without a partner.
    /// @return the stream whose next row must be known first, or null
    Stream* match(Job& job, At row, At reference);
    /// Pairs a row, or leaves it alone, after the first row of the reference, whose next row is at hand as `next` says.
    void match_between(Job& job, At next);
    /// Pairs the first rows. `is_between`: the row lies between the first two of the reference.
    void pair(Job& job, bool is_between = false);
    /// Drops the stream's next row, which has no partner, or leaves it to be handed on with an error.
    void drop_alone(Stream& stream);
    void compare_distance(KeyDistance found);
    [[nodiscard]] std::optional<StreamError> reference_error() const;
    /// Hands on lines that are not to be paired: comments, blank lines, rows with an error. `of_both`: also the
    /// reference's, which follow all lines of the stream before its next row.
    void hand_on_alone(Job& job, bool of_both);

    const Pairing* pairing_;
    Stream rows_;
    Stream references_;
    bool any_pair_ = false;
    std::optional<KeyDistance> nearest_; ///< smallest distance of a key without a partner to its neighbours
    Job reference_job_;                  ///< memory for the reference's blocks
    Stream* dry_ = nullptr;              ///< the stream that had no row at hand at the end of the last job
    std::optional<StreamError> error_;
    std::optional<LikelyKey> likely_key_; ///< for text paired by number, from the first pair on
};

} // namespace rotconv::stream
