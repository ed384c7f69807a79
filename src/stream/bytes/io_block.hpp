#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "../event.hpp"
#include "file.hpp"

namespace rotconv::stream {

/// One line and its line end ("\n", "\r\n" or none).
struct Line {
    std::string_view text;
    std::string_view end;
};

/// Cuts the first line off a text that is not empty.
[[nodiscard]] Line next_line(std::string_view& text) noexcept;

/// Cuts the first row off a text: a line, or `width` doubles if that is not 0.
[[nodiscard]] inline Line next_row(std::string_view& text, std::size_t width) noexcept {
    if (width == 0) {
        return next_line(text);
    }
    const Line row{text.substr(0, width * sizeof(double)), {}};
    text.remove_prefix(row.text.size());
    return row;
}

/// How often the character stands in the text. std::count adds up numbers of eight bytes, and takes twice as long.
[[nodiscard]] std::size_t count_of(char character, std::string_view text) noexcept;

/// A text without the UTF-8 byte order mark at its start.
[[nodiscard]] std::string_view without_byte_order_mark(std::string_view text) noexcept;

/// Whether a line is nothing but blanks.
[[nodiscard]] bool is_blank(std::string_view line) noexcept;

/// Whole lines as they came in one read, each with its line end except perhaps the last of the stream.
struct IoBlock {
    Buffer bytes;          ///< memory, used again
    std::string_view text; ///< the lines in `bytes` that are not yet taken off; empty if none is whole yet
    std::size_t first_line = 1;
};

/// Cuts a source into blocks of whole lines. A block holds what one read brought, so that a line that has arrived is
/// handed on before more is waited for. A UTF-8 byte order mark at the start is left out.
class IoBlockReader {
public:
    static constexpr std::size_t largest_block = std::size_t{64} << 10U;
    static constexpr std::size_t longest_line = std::size_t{4} << 20U;

    /// Rows are lines, or `row_size` bytes each if that is not 0. One read brings up to `block_size` bytes.
    explicit IoBlockReader(Source& source, std::size_t row_size = 0, std::size_t block_size = largest_block)
        : source_(&source), row_size_(row_size), block_size_(block_size) {}

    /// Reads once.
    /// @return false at the end or at an error
    bool read(IoBlock& block);
    /// Whether read() would not have to wait.
    [[nodiscard]] bool is_ready() const { return finished_ || source_->is_ready(); }
    [[nodiscard]] const std::optional<StreamError>& error() const noexcept { return error_; }

private:
    /// The size of the whole rows in `bytes`; nothing after an error.
    std::optional<std::size_t> whole_rows(std::string_view bytes, std::size_t searched);

    Source* source_;
    std::size_t row_size_;
    std::size_t block_size_;
    Buffer begun_; ///< the beginning of a row
    std::size_t line_ = 1;
    bool finished_ = false;
    std::optional<StreamError> error_;
};

} // namespace rotconv::stream
