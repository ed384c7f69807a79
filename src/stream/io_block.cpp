#include "io_block.hpp"

#include <algorithm>
#include <cerrno>
#include <span>
#include <utility>

namespace rotconv::stream {
namespace {

std::size_t count_newlines(std::string_view text) noexcept {
    constexpr std::size_t most = 255; // that a byte counts, so that the inner loop runs over vectors of bytes
    std::size_t count = 0;
    for (; !text.empty(); text.remove_prefix(std::min(most, text.size()))) {
        unsigned char part = 0;
        for (const char c : text.substr(0, most)) {
            part = static_cast<unsigned char>(part + (c == '\n' ? 1 : 0));
        }
        count += part;
    }
    return count;
}

} // namespace

bool IoBlockReader::read(IoBlock& block) {
    block.text = {};
    if (error_ || finished_) {
        return false;
    }
    std::swap(block.bytes, rest_);
    make_room(block.bytes);
    const auto count = source_->read(std::span(block.bytes.data(), block.bytes.size()).subspan(held_));
    if (count < 0) {
        error_ = StreamError{StreamError::What::read, line_, errno, {}};
        return false;
    }
    finished_ = count == 0;
    const std::size_t end = held_ + static_cast<std::size_t>(count);
    return row_size_ > 0 ? cut_rows(block, end) : cut_lines(block, end);
}

bool IoBlockReader::cut_lines(IoBlock& block, std::size_t end) {
    const std::size_t searched = started_ ? held_ : 0;
    end = without_mark(block.bytes, end);
    const std::string_view unread(block.bytes.data(), end);
    const std::size_t newline = unread.find('\n', searched);
    if (std::min(newline, end) > longest_line) {
        error_ = StreamError{StreamError::What::line_too_long, line_, 0, {}};
        return false;
    }
    if (finished_) {
        cut(block, end, end);
    } else if (newline == std::string_view::npos) {
        std::swap(block.bytes, rest_);
        held_ = end;
    } else {
        cut(block, unread.rfind('\n') + 1, end);
    }
    return true;
}

bool IoBlockReader::cut_rows(IoBlock& block, std::size_t end) {
    if (finished_ && end > 0) {
        error_ = StreamError{.what = StreamError::What::partial_row, .line = line_, .offset = (line_ - 1) * row_size_};
        return false;
    }
    cut(block, end - end % row_size_, end);
    return true;
}

void IoBlockReader::make_room(Buffer& bytes) const {
    if (held_ >= block_size_) {
        if (held_ == bytes.size()) {
            bytes.resize(std::min(2 * held_, longest_line + block_size_));
        }
        return;
    }
    if (bytes.size() > block_size_) { // a long line is over
        Buffer usual;
        append(usual, {bytes.data(), held_});
        bytes = std::move(usual);
    }
    bytes.resize(block_size_);
}

std::size_t IoBlockReader::without_mark(Buffer& bytes, std::size_t end) noexcept {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    const std::string_view text(bytes.data(), end);
    if (started_ || (end < mark.size() && mark.starts_with(text) && end > 0)) {
        return end; // past it, or not yet whole
    }
    started_ = true;
    if (!text.starts_with(mark)) {
        return end;
    }
    std::copy(bytes.data() + mark.size(), bytes.data() + end, bytes.data());
    return end - mark.size();
}

void IoBlockReader::cut(IoBlock& block, std::size_t size, std::size_t end) {
    held_ = end - size;
    rest_.resize(std::max(rest_.size(), held_));
    std::copy_n(block.bytes.data() + size, held_, rest_.data());
    block.text = {block.bytes.data(), size};
    block.first_line = line_;
    line_ += row_size_ > 0 ? size / row_size_ : count_newlines(block.text);
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
