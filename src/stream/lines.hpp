#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "event.hpp"
#include "file.hpp"

namespace rotconv::stream {

/// Whole lines as they came in one read, each with its line end but perhaps the last of the stream.
struct Block {
    std::string_view text;
    std::size_t first_line = 1;
};

/// Cuts a source into blocks of whole lines. A block holds what one read brought, so that a line that has arrived is
/// handed on before more is waited for. A UTF-8 byte order mark at the start is left out.
class BlockReader {
public:
    static constexpr std::size_t block_size = std::size_t{128} << 10U;
    static constexpr std::size_t longest_line = std::size_t{4} << 20U;

    explicit BlockReader(Source& source) : source_(&source), buffer_(block_size) {}

    /// The next block, valid until the next call; nothing at the end or at a fault.
    std::optional<Block> next();
    [[nodiscard]] const std::optional<StreamFault>& fault() const noexcept { return fault_; }

private:
    std::optional<Block> take(std::size_t end);
    void skip_byte_order_mark() noexcept;

    Source* source_;
    std::vector<char> buffer_;
    std::size_t begin_ = 0; ///< of what has not been handed on
    std::size_t end_ = 0;   ///< of what has been read
    std::size_t line_ = 1;
    bool started_ = false;
    bool finished_ = false;
    std::optional<StreamFault> fault_;
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
