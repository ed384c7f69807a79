#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "io_block.hpp"
#include "job.hpp"
#include "layout.hpp"
#include "options.hpp"
#include "preamble.hpp"

namespace rotconv::stream {

/// The blocks of a stream without what stands before its first data row.
class RowBlocks {
public:
    /// `written`: how that is written; null: not at all.
    RowBlocks(Source& source, const InputOptions& options, const Options* written, std::size_t block_size);

    /// Reads a block; `rest` becomes its data rows, of which the first is line `line`. What stands before them is added
    /// to the output.
    /// @return false where nothing comes after it
    bool read(IoBlock& block, std::string_view& rest, std::size_t& line, Output& output);
    /// To be called at the end of a run, of the stream if `at_end`. Adds what still waits where no data row came.
    void finish(Output& output, bool at_end);

    [[nodiscard]] bool is_ready() const { return blocks_.is_ready(); }
    [[nodiscard]] bool has_layout() const noexcept { return has_layout_; }
    [[nodiscard]] const Layout& layout() const noexcept { return layout_; }
    [[nodiscard]] std::optional<StreamError> error() const {
        return preamble_.error() ? preamble_.error() : blocks_.error();
    }

private:
    void hand_out(Output& output);
    void settle(Output& output);

    const InputOptions* options_;
    const Options* written_;
    IoBlockReader blocks_;
    Preamble preamble_;
    Layout layout_;
    bool has_begun_ = false;
    bool has_layout_ = false;
};

/// The jobs of one stream.
class BlockReader final : public JobReader {
public:
    BlockReader(Source& source, const Options& options, std::size_t block_size)
        : blocks_(source, options.input, &options, block_size) {}

    bool read(Job& job) override { return blocks_.read(job.block, job.rest, job.line, job.output); }
    [[nodiscard]] bool is_ready() const override { return blocks_.is_ready(); }
    void finish(Output& output) override { blocks_.finish(output, !error()); }
    [[nodiscard]] std::optional<StreamError> error() const override { return blocks_.error(); }
    [[nodiscard]] const Layout& layout() const noexcept { return blocks_.layout(); }

private:
    RowBlocks blocks_;
};

} // namespace rotconv::stream
