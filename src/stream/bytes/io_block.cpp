#include "io_block.hpp"

#include <algorithm>
#include <cerrno>
#include <span>
#include <utility>

namespace rotconv::stream {

bool IoBlockReader::read(IoBlock& block) {
    block.text = {};
    if (error_ || finished_) {
        return false;
    }
    std::swap(block.bytes, begun_);
    Buffer& bytes = block.bytes;
    const std::size_t held = bytes.size();
    if (held < block_size_ && bytes.capacity() > 2 * block_size_) { // a long line is over
        Buffer copy;
        append(copy, {bytes.data(), held});
        bytes = std::move(copy);
    }
    bytes.resize(held < block_size_ ? block_size_ : std::min(2 * held, longest_line + block_size_));
    const auto count = source_->read(std::span(bytes.data(), bytes.size()).subspan(held));
    if (count < 0) {
        error_ = StreamError{StreamError::What::read, {line_}, errno};
        return false;
    }
    finished_ = count == 0;
    const std::string_view all(bytes.data(), held + static_cast<std::size_t>(count));
    const auto size = whole_rows(all, held);
    if (!size) {
        return false;
    }
    if (*size == 0) {
        bytes.resize(all.size());
        std::swap(bytes, begun_);
        return true;
    }
    begun_.clear();
    append(begun_, all.substr(*size));
    block.text = all.substr(0, *size);
    block.first_line = line_;
    if (row_size_ == 0 && line_ == 1) {
        block.text = without_byte_order_mark(block.text);
    }
    line_ += row_size_ > 0 ? *size / row_size_ : count_of('\n', block.text);
    return true;
}

std::optional<std::size_t> IoBlockReader::whole_rows(std::string_view bytes, std::size_t searched) {
    if (row_size_ > 0) {
        if (finished_ && !bytes.empty()) {
            error_ = StreamError{
                .what = StreamError::What::partial_row, .place = {line_}, .offset = (line_ - 1) * row_size_};
            return std::nullopt;
        }
        return bytes.size() - bytes.size() % row_size_;
    }
    const std::size_t newline = bytes.find('\n', searched);
    if (std::min(newline, bytes.size()) > longest_line) {
        error_ = StreamError{StreamError::What::line_too_long, {line_}};
        return std::nullopt;
    }
    return finished_ ? bytes.size() : newline == std::string_view::npos ? 0 : bytes.rfind('\n') + 1;
}

std::size_t count_of(char character, std::string_view text) noexcept {
    constexpr std::size_t most = 240; // fits one byte, so that the inner loop runs over whole vectors of bytes
    std::size_t count = 0;
    for (; !text.empty(); text.remove_prefix(std::min(most, text.size()))) {
        unsigned char part = 0;
        for (const char c : text.substr(0, most)) {
            part = static_cast<unsigned char>(part + (c == character ? 1 : 0));
        }
        count += part;
    }
    return count;
}

Line next_line(std::string_view& text) noexcept {
    const std::size_t newline = text.find('\n');
    if (newline == std::string_view::npos) {
        const Line line{text, {}};
        text = {};
        return line;
    }
    const std::size_t length = newline > 0 && text[newline - 1] == '\r' ? newline - 1 : newline;
    const Line line{{text.data(), length}, {text.data() + length, newline + 1 - length}};
    text.remove_prefix(newline + 1);
    return line;
}

std::string_view without_byte_order_mark(std::string_view text) noexcept {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return text.substr(text.starts_with(mark) ? mark.size() : 0);
}

bool is_blank(std::string_view line) noexcept { return line.find_first_not_of(" \t") == std::string_view::npos; }

} // namespace rotconv::stream
