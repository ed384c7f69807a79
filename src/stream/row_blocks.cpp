#include "row_blocks.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "row_writer.hpp"

namespace rotconv::stream {

RowBlocks::RowBlocks(Source& source, const InputOptions& options, const Options* written, std::size_t block_size)
    : options_(&options), written_(written), blocks_(source, options.width * sizeof(double), block_size),
      preamble_(options) {}

bool RowBlocks::read(IoBlock& block, std::string_view& rest, std::size_t& line, Output& output) {
    const bool goes_on = blocks_.read(block);
    rest = block.text;
    line = block.first_line;
    if (written_ != nullptr && options_->width == 0 && !rest.empty() && !std::exchange(has_begun_, true)) {
        output.events.emplace_back(FirstBytes{std::string(rest.substr(0, std::size_t{64} << 10U))});
    }
    if (has_layout_ || rest.empty()) {
        return goes_on;
    }
    const bool settled = preamble_.read(rest, line);
    hand_out(output);
    if (settled) {
        settle(output);
    }
    if (preamble_.error()) {
        rest = {};
    }
    return goes_on && !preamble_.error();
}

void RowBlocks::finish(Output& output, bool at_end) {
    if (has_layout_) {
        return;
    }
    preamble_.finish(at_end);
    hand_out(output);
    if (at_end && !preamble_.error()) {
        layout_ = preamble_.layout();
        layout_.delimiter = options_->delimiter.value_or(Delimiter::character(','));
        layout_.field_count = options_->width > 0 ? options_->width : options_->columns.empty() ? layout_.count : 0;
        if (written_ != nullptr && layout_.field_count > 0) {
            write_added_header(output.bytes, *written_, layout_);
        }
    }
}

void RowBlocks::hand_out(Output& output) {
    const bool is_written = written_ != nullptr && written_->format == Format::csv;
    preamble_.hand_out(
        [&](std::string_view text) {
            if (is_written) {
                append(output.bytes, text);
            }
        },
        [&](const HeaderLine& header) {
            if (is_written) {
                write_header(output.bytes, *written_, preamble_.layout(), header);
            }
        });
}

void RowBlocks::settle(Output& output) {
    has_layout_ = true;
    layout_ = preamble_.layout();
    if (written_ == nullptr) {
        return;
    }
    write_added_header(output.bytes, *written_, layout_);
    if (written_->format == Format::json) {
        layout_.keys = JsonKeys(preamble_.names(), result_columns(*written_), [this](std::size_t at) {
            return written_->append || !std::ranges::binary_search(layout_.replaced, at);
        });
    }
    written_->operation->take_positions(layout_.positions);
}

} // namespace rotconv::stream
