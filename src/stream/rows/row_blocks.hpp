#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../beginning/beginning.hpp"
#include "../beginning/header_line.hpp"
#include "../bytes/io_block.hpp"
#include "../job.hpp"
#include "../options.hpp"
#include "layout.hpp"

namespace rotconv::stream {

/// The blocks of one stream, without the lines before its first row: comments, blank lines, the header. It reads and
/// writes these. They wait until a line shows which of them are rows (see decide()): at most 100 lines that are no
/// comments, or 64 KiB.
class RowBlocks final : public JobReader {
public:
    /// `written`: how the lines before the first row are written; null: not at all.
    RowBlocks(Source& source, const InputOptions& options, const Options* written, std::size_t block_size);

    bool read(Job& job) override;
    [[nodiscard]] bool is_ready() const override { return blocks_.is_ready(); }
    void finish(Output& output, bool at_end) override;
    [[nodiscard]] std::optional<StreamError> error() const override { return error_ ? error_ : blocks_.error(); }
    [[nodiscard]] const Layout* layout(Side side) const override { return side == Side::stream ? &layout_ : nullptr; }
    /// Unknown if rows are their numbers and nothing else.
    [[nodiscard]] RowWidth width() const override { return width_; }
    /// Whether there was a data row: the layout is then final.
    [[nodiscard]] bool has_row() const noexcept { return has_row_; }

private:
    /// Takes lines off the block up to the first row, or all at an error; lines that came before are put back if they
    /// turn out to be rows. `is_end`: no block follows.
    void find_rows(IoBlock& block, bool is_end, Output& output);
    /// Takes lines into those that are held, up to one that settles where rows begin.
    [[nodiscard]] std::optional<Beginning> hold(std::string_view& text, Output& output);
    [[nodiscard]] std::vector<Line> held_lines() const;
    [[nodiscard]] std::vector<Line> looked_at_lines() const; ///< the first of them
    [[nodiscard]] std::size_t number_of(const Line& line) const;
    /// Writes the held lines that are no rows. @return the rows, of which the first is line `first_line`
    [[nodiscard]] std::string_view start(const Beginning& beginning, std::size_t& first_line, Output& output);
    /// Takes what a header says, with a line of units or null, and writes it.
    void start_below(const HeaderLine& header, const HeaderLine* units, Output& output);
    /// Puts a row in the place of the input, if that is one attitude in another form. @return whether it is
    [[nodiscard]] bool read_as_one(IoBlock& block, Output& output);
    [[nodiscard]] bool is_written() const noexcept { return written_ != nullptr && written_->writes_all_lines(); }
    /// Writes text unchanged.
    void pass(std::string_view text, Output& output) const;
    /// Adds the note on those of the first lines that are no comments, although they pass.
    void tell_passed(std::string_view text);
    /// Adds the notes on what the input says.
    void add_notes(const HeaderFacts& said, std::size_t line);
    /// Gives the result the names of the last selected columns, if the operation keeps names.
    void keep_names(const HeaderLine& header);
    /// Sets what is known of the layout; from here on it is final.
    /// @param row null if rows are doubles, or if there is none
    void set_layout(const HeaderLine* row, std::size_t number, Output& output);

    IoBlockReader blocks_;
    const InputOptions* options_;
    const Options* written_;
    Layout layout_;
    RowWidth width_{};
    std::optional<StreamError> error_;
    bool has_row_ = false;
    std::string held_;
    std::size_t held_line_ = 1;                 ///< the number of the first line that is held
    std::size_t looked_at_ = 0;                 ///< lines so far that are neither blank nor comments
    std::optional<std::size_t> last_comment_{}; ///< where the last comment begins that is held
    std::size_t behind_ = 0;                    ///< bytes after the last line that may be the header
    bool is_settled_ = false;                   ///< what is above the first row is known, though no row is
    std::size_t header_line_ = 0;               ///< the header's line; 0: there is none
};

} // namespace rotconv::stream
