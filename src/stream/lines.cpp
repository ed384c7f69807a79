#include "lines.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace rotconv::stream {

std::optional<Block> BlockReader::next() {
    if (fault_ || finished_) {
        return std::nullopt;
    }
    if (begin_ > 0) {
        std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
        end_ -= begin_;
        begin_ = 0;
    }
    while (true) {
        if (end_ == buffer_.size()) {
            buffer_.resize(std::min(2 * buffer_.size(), longest_line + block_size));
        }
        const std::size_t searched = end_;
        const auto count = source_->read({buffer_.data() + end_, buffer_.size() - end_});
        if (count < 0) {
            fault_ = StreamFault{StreamFault::What::read, line_, errno, {}};
            return std::nullopt;
        }
        end_ += static_cast<std::size_t>(count);
        skip_byte_order_mark();
        const std::string_view unread(buffer_.data() + begin_, end_ - begin_);
        const std::size_t first_end =
            std::min(unread.find('\n', searched > begin_ ? searched - begin_ : 0), unread.size());
        if (first_end > longest_line) {
            fault_ = StreamFault{StreamFault::What::line_too_long, line_, 0, {}};
            return std::nullopt;
        }
        if (count == 0) {
            finished_ = true;
            return unread.empty() ? std::nullopt : take(end_);
        }
        if (first_end != unread.size()) {
            return take(begin_ + unread.rfind('\n') + 1);
        }
    }
}

std::optional<Block> BlockReader::take(std::size_t end) {
    const Block block{{buffer_.data() + begin_, end - begin_}, line_};
    line_ += static_cast<std::size_t>(std::ranges::count(block.text, '\n'));
    begin_ = end;
    return block;
}

void BlockReader::skip_byte_order_mark() noexcept {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (started_ || (end_ < mark.size() && mark.starts_with(std::string_view(buffer_.data(), end_)) && end_ > 0)) {
        return; // past it, or not yet whole
    }
    started_ = true;
    if (std::string_view(buffer_.data(), end_).starts_with(mark)) {
        begin_ = mark.size();
    }
}

Line next_line(std::string_view& text) noexcept {
    const std::size_t newline = text.find('\n');
    if (newline == std::string_view::npos) {
        const Line line{text, {}};
        text = {};
        return line;
    }
    const std::size_t length = newline > 0 && text[newline - 1] == '\r' ? newline - 1 : newline;
    const Line line{text.substr(0, length), text.substr(length, newline + 1 - length)};
    text.remove_prefix(newline + 1);
    return line;
}

bool is_blank(std::string_view line) noexcept { return line.find_first_not_of(" \t") == std::string_view::npos; }

} // namespace rotconv::stream
