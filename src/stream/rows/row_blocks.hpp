#pragma once

#include <cstddef>
#include <optional>

#include "../beginning/preamble.hpp"
#include "../bytes/io_block.hpp"
#include "../job.hpp"
#include "../options.hpp"

namespace rotconv::stream {

/// The blocks of one stream, without the lines before its first data row.
class RowBlocks final : public JobReader {
public:
    /// `written`: how the lines before the first row are written; null: not at all.
    RowBlocks(Source& source, const InputOptions& options, const Options* written, std::size_t block_size)
        : blocks_(source, options.width * sizeof(double), block_size), preamble_(options, written) {}

    bool read(Job& job) override {
        const bool goes_on = blocks_.read(job.block);
        preamble_.read(job.block, !goes_on && !blocks_.error(), job.output);
        return goes_on && !error();
    }
    /// Whether there was a data row: the layout is then final.
    [[nodiscard]] bool has_row() const noexcept { return preamble_.has_row(); }
    [[nodiscard]] bool is_ready() const override { return blocks_.is_ready(); }
    void finish(Output& output, bool at_end) override { preamble_.finish(output, at_end); }
    [[nodiscard]] std::optional<StreamError> error() const override {
        return preamble_.error() ? preamble_.error() : blocks_.error();
    }
    [[nodiscard]] const Layout* layout(Side side) const override {
        return side == Side::stream ? &preamble_.layout() : nullptr;
    }
    [[nodiscard]] RowWidth width() const override { return preamble_.width(); }

private:
    IoBlockReader blocks_;
    Preamble preamble_;
};

} // namespace rotconv::stream
