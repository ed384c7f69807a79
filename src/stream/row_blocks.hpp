#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "io_block.hpp"
#include "job.hpp"
#include "options.hpp"
#include "preamble.hpp"
#include "row_reader.hpp"

namespace rotconv::stream {

/// The blocks of one stream, without the lines before its first data row.
class RowBlocks final : public JobReader {
public:
    /// `written`: how the lines before the first row are written; null: not at all.
    RowBlocks(Source& source, const InputOptions& options, const Options* written, std::size_t block_size)
        : options_(&options), blocks_(source, options.width * sizeof(double), block_size), preamble_(options, written) {
    }

    bool read(Job& job) override {
        const bool goes_on = blocks_.read(job.block);
        IoBlock& block = job.block;
        preamble_.read(block.text, block.first_line, job.output);
        if (width_.line == 0 && options_->width == 0 && !options_->columns.empty()) {
            find_width(block);
        }
        return goes_on && !error();
    }
    /// Whether there was a data row: the layout is then final.
    [[nodiscard]] bool has_row() const noexcept { return preamble_.has_row(); }
    [[nodiscard]] bool is_ready() const override { return blocks_.is_ready(); }
    void finish(Output& output, bool at_end) override { preamble_.finish(output, at_end); }
    [[nodiscard]] std::optional<StreamError> error() const override {
        return preamble_.error() ? preamble_.error() : error_ ? error_ : blocks_.error();
    }
    [[nodiscard]] const Layout* layout(Side side) const override {
        return side == Side::stream ? &preamble_.layout() : nullptr;
    }
    [[nodiscard]] std::array<RowWidth, 2> widths() const override { return {width_}; }

private:
    /// Looks for the first row whose selected fields are numbers; a header with their names must be as wide.
    void find_width(IoBlock& block) {
        const RowReader reader(*options_, preamble_.layout());
        RowParts parts;
        std::size_t line = block.first_line;
        for (std::string_view text = block.text; !text.empty() && width_.line == 0; ++line) {
            const std::string_view row = next_line(text).text;
            parts.clear();
            if (!options_->is_row(row) || !reader.read(row, parts)) {
                continue;
            }
            width_ = {preamble_.layout().delimiter.count(parts.fields), line};
            const FieldCount names = preamble_.layout().header.fields;
            if (options_->columns.has_names() && !names.fits(width_.fields)) {
                error_ = {.what = StreamError::What::columns, .place = {line}};
                error_->column = {.what = ColumnError::What::other_width,
                                  .text = std::string(row),
                                  .count = names.all,
                                  .fields = width_.fields.all};
                block.text = block.text.substr(0, static_cast<std::size_t>(row.data() - block.text.data()));
            }
        }
    }

    const InputOptions* options_;
    IoBlockReader blocks_;
    Preamble preamble_;
    RowWidth width_{};
    std::optional<StreamError> error_{};
};

} // namespace rotconv::stream
