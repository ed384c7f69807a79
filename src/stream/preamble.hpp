#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io_block.hpp"
#include "layout.hpp"
#include "options.hpp"

namespace rotconv::stream {

/// A line as a header: its fields, behind a '#' and blanks if it has them.
struct HeaderLine {
    HeaderLine(const Line& line_, Delimiter delimiter_);

    [[nodiscard]] std::string name(std::size_t at) const;
    [[nodiscard]] std::vector<std::string> names() const;

    Line line;
    std::string_view prefix; ///< the '#' and the blanks before the first name
    Delimiter delimiter;
    std::vector<std::string_view> fields;
    bool is_closed; ///< no quote is left open
};

/// What the lines before the first data row are.
struct Beginning {
    enum class State : std::uint8_t {
        undecided, ///< a later line tells
        decided,
        error
    };
    State state = State::undecided;
    std::optional<HeaderLine> header{};
    std::size_t header_line = 0;          ///< its index among the lines
    bool is_data = false;                 ///< the last line is the first data row, or in its place
    std::vector<std::size_t> positions{}; ///< of columns that are selected by name
    StreamError error{};                  ///< its line is an index among the lines, from 0
};

/// Decides on lines that begin a stream, of which the last is a row, neither blank nor a comment. `is_end`: none
/// follows, and the last may be anything.
[[nodiscard]] Beginning decide(const std::vector<Line>& lines, const InputOptions& options, bool is_end);

/// Collects what stands before the first data row: comments, blank rows, the header. Where only a later row tells
/// whether a line is the header, that line waits, and what follows it, up to 64 KiB.
class Preamble {
public:
    explicit Preamble(const InputOptions& options);

    /// Takes lines off `rest` up to the first data row, and counts them in `line`.
    /// @return true once the layout is settled
    bool read(std::string_view& rest, std::size_t& line);
    /// To be called where no data row came: at the end of input, or at an error.
    void finish(bool at_end);

    /// Calls `pass(text)` for lines that go out as they are, and `take(header)` for the header, of all that has been
    /// decided since the last call.
    template <class Pass, class Take> void hand_out(const Pass& pass, const Take& take) {
        pass(before_);
        before_.clear();
        if (header_waits()) {
            take(HeaderLine({header_text_, header_end_}, header_delimiter_));
            header_is_out_ = true;
            pass(after_);
            after_.clear();
        }
    }

    [[nodiscard]] const Layout& layout() const noexcept { return layout_; }
    /// The header's names; none without one.
    [[nodiscard]] std::vector<std::string> names() const;
    [[nodiscard]] const std::optional<StreamError>& error() const noexcept { return error_; }

private:
    void hold(const Line& line);
    /// The lines that are held.
    [[nodiscard]] std::vector<Line> lines() const;
    /// Follows a decision; true where the last line is data, and not held any more.
    bool follow(const Beginning& beginning);
    /// The first bytes of what is held go out as they are.
    void release(std::size_t bytes);
    /// Lets go of what has waited for too long.
    void limit();
    void settle(const Line& row, std::size_t number);
    [[nodiscard]] bool header_waits() const noexcept { return has_header_ && !header_is_out_; }
    [[nodiscard]] std::string& passed() noexcept { return header_waits() ? after_ : before_; }

    const InputOptions* options_;
    Layout layout_;
    std::optional<StreamError> error_;
    bool header_done_;
    std::string held_;
    std::size_t held_line_ = 1;     ///< the number of the first line that is held
    std::size_t comment_begin_ = 0; ///< where the last comment among them stands
    std::size_t comment_end_ = 0;
    std::string before_; ///< what goes out before the header...
    std::string after_;  ///< ...and after it
    bool has_header_ = false;
    bool header_is_out_ = false;
    std::string header_text_;
    std::string header_end_;
    Delimiter header_delimiter_ = Delimiter::blanks();
};

} // namespace rotconv::stream
