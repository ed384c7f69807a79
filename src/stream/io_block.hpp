#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "event.hpp"
#include "file.hpp"

namespace rotconv::stream {

/// Whole lines as they came in one read, each with its line end but perhaps the last of the stream.
struct IoBlock {
    Buffer bytes;          ///< room, used again
    std::string_view text; ///< the lines in it; empty where none is whole yet
    std::size_t first_line = 1;
};

/// Cuts a source into blocks of whole lines. A block holds what one read brought, so that a line that has arrived is
/// handed on before more is waited for. A UTF-8 byte order mark at the start is left out.
class IoBlockReader {
public:
    static constexpr std::size_t largest_block = std::size_t{64} << 10U;
    static constexpr std::size_t longest_line = std::size_t{4} << 20U;

    /// Rows are lines, or where `row_size` is not 0 that many bytes each. One read brings up to `block_size` bytes.
    explicit IoBlockReader(Source& source, std::size_t row_size = 0, std::size_t block_size = largest_block)
        : source_(&source), row_size_(row_size), block_size_(block_size) {}

    /// Reads once.
    /// @return false at the end or at an error: there is nothing more to read
    bool read(IoBlock& block);
    /// Whether read() would not have to wait.
    [[nodiscard]] bool is_ready() const { return finished_ || source_->is_ready(); }
    [[nodiscard]] const std::optional<StreamError>& error() const noexcept { return error_; }

private:
    bool cut_lines(IoBlock& block, std::size_t end);
    bool cut_rows(IoBlock& block, std::size_t end);
    /// Room for what is held and more, of the usual size unless a long line needs more.
    void make_room(Buffer& bytes) const;
    /// The end of the bytes without the mark, past which it is remembered not to look for it.
    [[nodiscard]] std::size_t without_mark(Buffer& bytes, std::size_t end) noexcept;
    /// Makes the first `size` of the block's `end` bytes its text and holds the others.
    void cut(IoBlock& block, std::size_t size, std::size_t end);

    Source* source_;
    std::size_t row_size_;
    std::size_t block_size_;
    Buffer rest_;          ///< the beginning of a line...
    std::size_t held_ = 0; ///< ...of this many bytes
    std::size_t line_ = 1;
    bool started_ = false;
    bool finished_ = false;
    std::optional<StreamError> error_;
};

/// One line and its line end ("\n", "\r\n" or none).
struct Line {
    std::string_view text;
    std::string_view end;
};

/// Cuts the first line off a text that is not empty.
[[nodiscard]] Line next_line(std::string_view& text) noexcept;

/// Nothing but blanks.
[[nodiscard]] bool is_blank(std::string_view line) noexcept;

/// Begins with '#'.
[[nodiscard]] inline bool is_comment(std::string_view line) noexcept { return line.starts_with('#'); }

} // namespace rotconv::stream
