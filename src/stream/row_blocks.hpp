#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "io_block.hpp"
#include "job.hpp"
#include "options.hpp"
#include "preamble.hpp"

namespace rotconv::stream {

/// The blocks of one stream, without what stands before its first data row.
class RowBlocks final : public JobReader {
public:
    /// `written`: how what stands before the first row is written; null: not at all.
    RowBlocks(Source& source, const InputOptions& options, const Options* written, std::size_t block_size)
        : is_told_(written != nullptr && options.width == 0),
          blocks_(source, options.width * sizeof(double), block_size), preamble_(options, written) {}

    bool read(Job& job) override {
        const bool goes_on = blocks_.read(job.block);
        job.rest = job.block.text;
        job.line = job.block.first_line;
        if (is_told_ && job.line == 1 && !job.rest.empty()) {
            job.output.events.emplace_back(FirstBytes{std::string(job.rest.substr(0, most_first_bytes))});
        }
        preamble_.read(job.rest, job.line, job.output);
        return goes_on && !preamble_.error();
    }
    [[nodiscard]] bool is_ready() const override { return blocks_.is_ready(); }
    void finish(Output& output, bool at_end) override { preamble_.finish(output, at_end); }
    [[nodiscard]] std::optional<StreamError> error() const override {
        return preamble_.error() ? preamble_.error() : blocks_.error();
    }
    [[nodiscard]] const Layout& layout() const override { return preamble_.layout(); }

private:
    static constexpr std::size_t most_first_bytes = std::size_t{64} << 10U;

    bool is_told_; ///< what the stream begins with
    IoBlockReader blocks_;
    Preamble preamble_;
};

} // namespace rotconv::stream
