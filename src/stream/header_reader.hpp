#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "io_block.hpp"
#include "layout.hpp"
#include "options.hpp"

namespace rotconv::stream {

/// Reads what stands before the first data row: comments, blank rows, the header. Where only a later row tells whether
/// a line is the header, that line waits, and what follows it, up to `most_held` bytes.
class HeaderReader {
public:
    explicit HeaderReader(const Options& options);

    /// Takes lines off `rest` up to the first data row and counts them in `line`; what comes out of them is added to
    /// `output`.
    /// @return true once the layout is settled
    bool read(std::string_view& rest, std::size_t& line, Output& output);
    /// To be called where no data row came: at the end of input, or at a error.
    void finish(Output& output, bool at_end);

    [[nodiscard]] const Layout& layout() const noexcept { return layout_; }
    [[nodiscard]] const std::optional<StreamError>& error() const noexcept { return error_; }

private:
    static constexpr std::size_t most_held = std::size_t{64} << 10U;

    /// A line as a header.
    struct Header {
        Line line;
        std::string_view prefix; ///< the '#' and the blanks before the first name
        Delimiter delimiter;
        std::vector<std::string_view> fields;
        bool is_closed; ///< no quote is left open

        [[nodiscard]] std::string name(std::size_t at) const;
        [[nodiscard]] std::vector<std::string> names() const;
    };
    using Lookup = std::variant<std::vector<std::size_t>, ColumnError>;

    [[nodiscard]] static Header header_of(const Line& line, Delimiter delimiter);
    [[nodiscard]] Delimiter delimiter_of(std::string_view row) const noexcept;

    /// Deals with the line unless it is the first data row.
    bool is_data(const Line& line, std::size_t number, Output& output);
    /// Of the first row, where columns are selected by index; takes it, or the comment before it, if that is the
    /// header.
    bool is_header_line(const Line& line, Output& output);
    /// The line goes out as it is, after what is held back.
    void pass(const Line& line, Output& output);
    void hold(const Line& line, Output& output);
    /// What is held back goes out as it is.
    void release(Output& output);
    void write(std::string_view text, Output& output) const;
    void settle(const Line& row, Output& output);
    void tell_selected() const;

    [[nodiscard]] bool has_selected(const Header& header) const noexcept;
    /// The texts of the selected fields.
    [[nodiscard]] std::vector<std::string> selected(const Header& header) const;
    /// All selected fields are there, and none of them is a number or a word for a missing one.
    [[nodiscard]] bool is_header(const Header& header) const;
    /// What the columns are called, where the row, or else the comment before it, has names.
    [[nodiscard]] std::vector<std::string> names_near(const Header& row) const;
    /// The row is the beginning of JSON, and nothing that can be converted.
    [[nodiscard]] bool is_json(const Line& row) const;
    /// Takes the comment that is held back as the header, if it is that of a row.
    bool take_comment(const Header& row, Output& output);
    /// Looks the names up under each delimiter, or the one given, until they are all there.
    [[nodiscard]] std::pair<Header, Lookup> find_names(const Line& line, std::optional<Delimiter> delimiter) const;
    /// The header is the last line held back that has all names. A comment is split by the delimiter of the data where
    /// that is given, so that prose is not taken for names.
    bool take_named(std::optional<Delimiter> delimiter, Output& output);
    /// The line is the header.
    void take(const Header& header, Output& output);
    void write_header(const Header& header, Output& output) const;
    void write_added_header(std::size_t field_count, Output& output) const;

    const Options* options_;
    Layout layout_;
    std::optional<StreamError> error_;
    bool met_row_ = false; ///< that is not blank
    bool header_done_ = false;
    std::string comment_; ///< the last one, where columns are selected by name
    std::string held_;
    std::size_t held_first_ = 0;     ///< bytes of the first line that is held back
    std::size_t held_line_ = 0;      ///< and its number
    std::vector<std::string> names_; ///< of the header, for JSON
};

} // namespace rotconv::stream
