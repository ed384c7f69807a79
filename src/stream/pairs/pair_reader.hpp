#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string_view>

#include "../../core/conversion/kernels.hpp"
#include "../job.hpp"
#include "../options.hpp"
#include "../rows/row_blocks.hpp"
#include "../rows/row_reader.hpp"
#include "key.hpp"
#include "likely_key.hpp"

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
    [[nodiscard]] PairingStats keys() const override;

private:
    /// A line that is read and not yet paired, handed on or dropped.
    struct Waiting {
        Line line{};
        std::size_t number = 0;
        bool passes = false;
        bool ends_text = false; ///< it is the last line of a text
        bool may_be_paired = false;
        std::unique_ptr<RowError> error{}; ///< why it has no key or no partner, or, if it may be paired, no numbers
        Kept kept{};                       ///< the key
        std::array<double, most_numbers> numbers{};
        static constexpr auto nowhere = static_cast<std::size_t>(-1);
        std::size_t place = nowhere; ///< among the neighbours of the job, see NumberRows

        [[nodiscard]] const Key& key() const noexcept { return kept.key.value; }
    };

    /// Whether a row is at hand.
    enum class At : std::uint8_t { row, end, dry, too_far };

    /// What becomes of the first rows of both streams, r and R, beside the next ones, s and S; keys increase to the
    /// right.
    ///
    ///     rR       pair                one key, or rows without keys
    ///     r R s    pair                R may be before r, too; `s` is not nearer, and they are within the limit
    ///     r  sR    row_alone           also beyond the limit, and where R is no farther from the row before r
    ///     R  Sr    reference_alone     the same with the streams exchanged
    ///     R r S    pair_between        interpolated: R and S are within the limit of each other; otherwise row_alone
    ///     r R      row_alone           interpolated: none is before it
    ///     R S r    reference_alone     interpolated: it is not next to the key
    ///     r ... R  row_unknown         s must be read first; reference_unknown: S
    enum class Match : std::uint8_t {
        pair,
        pair_between,
        row_alone,
        reference_alone,
        row_unknown,
        reference_unknown,
        ended, ///< by an error
    };

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
        /// Takes a line off the text, and reads its key and its numbers.
        void take_line();
        /// Takes the key that was read; false, with an error, if it is none, or does not increase.
        [[nodiscard]] bool take_key(Waiting& row);
        /// Leaves the next row, which has no partner, to be handed on with an error.
        void fail_row();
        void drop_row();
        /// Takes the next row out of those that may be paired.
        void dispose_row();
        void drop_line();
        /// Lets the pairs hold the texts at hand for as long as their rows are used.
        void hold(PairBlock& pairs);
        /// Whether the layout stays as it is: until then nothing is handed on, for others read it.
        [[nodiscard]] bool is_settled() const { return ended || blocks.has_row(); }
        [[nodiscard]] bool is_ready() const { return ended || !unread.empty() || blocks.is_ready(); }

        Side side;
        const InputOptions* options;
        bool by_key; ///< the key is the first selected column
        RowBlocks blocks;
        RowReader reader;
        ReadRows taken;                                  ///< what was read of the last line
        std::deque<std::shared_ptr<const Buffer>> texts; ///< the blocks of the lines at hand
        std::size_t held = 0;                            ///< how many of the first texts the job holds
        std::string_view unread;                         ///< lines that do not wait yet
        std::size_t line = 1;
        bool ended = false; ///< there are no more blocks
        std::deque<Waiting> waiting;
        std::deque<Waiting*> pairable;            ///< those that may be paired
        std::size_t bytes_waiting = 0;            ///< size of the waiting lines
        std::optional<PairingStats::Range> range; ///< the first and the last key that increased
        std::optional<Key> disposed;              ///< the key of the last row that was paired, dropped or failed
    };

    [[nodiscard]] Match match(At row, At reference);
    [[nodiscard]] Match match_nearest();
    [[nodiscard]] Match match_between();
    /// Whether the stream's next but one row is at hand; an error ends the run if it is too far.
    [[nodiscard]] At look_ahead(Stream& stream);
    /// @return the stream whose next row must be known first, or null
    Stream* act(Job& job, Match match);
    /// Pairs the first rows. `is_between`: the row lies between the first two of the reference.
    void pair(Job& job, bool is_between);
    /// Adds the numbers of a pair whose rows have them.
    void add_numbers(ReadRows& read, Waiting& later);
    /// Drops FILE's next row, which has no partner, or leaves it to be handed on with an error.
    void drop_alone(Output& output);
    void compare_distance(KeyDistance found);
    [[nodiscard]] std::optional<StreamError> reference_error() const;
    /// Hands on lines that are not to be paired: comments, blank lines, rows with an error. `of_both`: also the
    /// reference's, which follow all lines of the stream before its next row.
    void hand_on_alone(Job& job, bool of_both);

    const Pairing* pairing_;
    bool writes_partners_;
    Stream rows_;
    Stream references_;
    PairingStats stats_;    ///< so far
    Job reference_job_;     ///< memory for the reference's blocks
    Stream* dry_ = nullptr; ///< the stream that had no row at hand at the end of the last job
    std::optional<StreamError> error_;
    std::optional<LikelyKey> likely_key_; ///< for text paired by number, from the first pair on
};

} // namespace rotconv::stream
