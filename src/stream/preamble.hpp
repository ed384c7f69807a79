#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "beginning.hpp"
#include "header_line.hpp"
#include "io_block.hpp"
#include "layout.hpp"
#include "options.hpp"

namespace rotconv::stream {

/// Reads and writes the lines before the first data row: comments, blank lines, the header. If only a later row shows
/// whether a line is the header, that line and those after it wait, up to 64 KiB.
class Preamble {
public:
    /// `written`: how these lines are written; null: not at all.
    explicit Preamble(const InputOptions& options, const Options* written = nullptr);

    /// Takes lines off `text` up to the first data row, or all at an error, and counts them in `line`.
    /// @return whether there is a data row, in this text or before it
    bool read(std::string_view& text, std::size_t& line, Output& output);
    /// To be called at the end of input or at an error; has no effect if there was a data row.
    void finish(Output& output, bool at_end);

    [[nodiscard]] bool has_row() const noexcept { return has_row_; }
    [[nodiscard]] const Layout& layout() const noexcept { return layout_; }
    [[nodiscard]] const std::optional<StreamError>& error() const noexcept { return error_; }

private:
    void hold(std::string_view line);
    /// The lines that are held, without blank ones.
    [[nodiscard]] std::vector<Line> held_lines() const;
    [[nodiscard]] std::size_t number_of(const Line& line) const;
    /// Decides on the held lines, see decide(). @return whether the last line is data, and no longer held
    bool find_header(bool is_end, Output& output);
    [[nodiscard]] bool is_written() const noexcept { return written_ != nullptr && written_->writes_all_lines(); }
    /// Writes text unchanged.
    void pass(std::string_view text, Output& output) const;
    /// Writes the first bytes of the held lines unchanged.
    void release(std::size_t bytes, Output& output);
    /// Writes lines that have waited for too long.
    void limit(Output& output);
    /// Has each number read from the field whose name says that it is there.
    void read_by(const std::vector<std::string>& names);
    /// Adds the notes on what the input says.
    void add_notes(const Said& said, std::size_t line);
    /// Gives the result the names of the last selected columns, if the operation keeps names.
    void keep_names(const HeaderLine& header);
    /// Sets what is known of the layout from the first row of text on; from here on it is final.
    /// @param row null if rows are doubles, or if there is none
    void set_layout(const Line* row, std::size_t number, Output& output);

    const InputOptions* options_;
    const Options* written_;
    Layout layout_;
    std::optional<StreamError> error_;
    bool header_done_;
    bool has_row_ = false;
    bool only_comments_ = true; ///< there were only comments and blank lines so far
    std::string held_;
    std::size_t held_line_ = 1;     ///< the number of the first line that is held
    std::size_t comment_begin_ = 0; ///< where the last comment among the held lines begins
    std::size_t comment_end_ = 0;
    std::size_t blank_ = 0;       ///< bytes of blank lines after that comment
    std::size_t header_line_ = 0; ///< the header's line; 0: there is none
};

} // namespace rotconv::stream
