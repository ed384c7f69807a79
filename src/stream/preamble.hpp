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

/// Reads and writes what stands before the first data row: comments, blank rows, the header. Where only a later row
/// tells whether a line is the header, that line waits, and what follows it, up to 64 KiB.
class Preamble {
public:
    /// `written`: how it is written; null: not at all.
    explicit Preamble(const InputOptions& options, const Options* written = nullptr);

    /// Takes lines off `rest` up to the first data row, and counts them in `line`; all of them where there is an error.
    /// @return true where there is a data row, in this text or before it
    bool read(std::string_view& rest, std::size_t& line, Output& output);
    /// To be called at the end of input or at an error. Without effect if there was a data row.
    void finish(Output& output, bool at_end);

    [[nodiscard]] const Layout& layout() const noexcept { return layout_; }
    /// The header's names; none without one.
    [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }
    /// How many there are, without empty ones at the end.
    [[nodiscard]] std::size_t name_count() const noexcept { return name_count_; }
    [[nodiscard]] const std::optional<StreamError>& error() const noexcept { return error_; }

private:
    void hold(std::string_view line);
    /// The lines that are held, without blank ones, and the number of one.
    [[nodiscard]] std::vector<Line> lines() const;
    [[nodiscard]] std::size_t number_of(const Line& line) const;
    /// Follows a decision; true where the last line is data, and not held any more.
    bool follow(const Beginning& beginning, Output& output);
    [[nodiscard]] bool is_written() const noexcept { return written_ != nullptr && written_->writes_all_lines(); }
    /// Text that goes out as it is.
    void pass(std::string_view text, Output& output) const;
    /// The first bytes of what is held go out as they are.
    void release(std::size_t bytes, Output& output);
    /// Lets go of what has waited for too long.
    void limit(Output& output);
    /// Adds what is to be told of it, or ends the run.
    void hear(const Said& said, std::size_t line);
    void hear_names(const HeaderLine& header, std::size_t line);
    /// The result has the names of the last selected columns where its operation says so.
    void keep_names(const HeaderLine& header);
    /// The layout becomes that of the first row.
    void take_layout(const Line& row, std::size_t number);
    /// The layout is final.
    void begin_rows(Output& output);

    const InputOptions* options_;
    const Options* written_;
    Layout layout_;
    std::optional<StreamError> error_;
    bool header_done_;
    bool has_row_ = false;
    bool only_comments_ = true; ///< and blank rows, so far
    std::string held_;
    std::size_t held_line_ = 1;     ///< the number of the first line that is held
    std::size_t comment_begin_ = 0; ///< where the last comment among them stands
    std::size_t comment_end_ = 0;
    std::size_t blank_ = 0; ///< bytes of blank lines behind that comment
    std::vector<std::string> names_;
    std::size_t name_count_ = 0;
    std::size_t header_line_ = 0; ///< its number; 0: there is none
};

} // namespace rotconv::stream
