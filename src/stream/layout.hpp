#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "column_list.hpp"
#include "delimiter.hpp"
#include "event.hpp"
#include "io_block.hpp"
#include "json_keys.hpp"
#include "row_operation.hpp"

namespace rotconv::stream {

enum class HeaderMode : std::uint8_t { automatic, yes, no, add };
enum class Format : std::uint8_t { csv, json, pretty, f64 };
enum class OnError : std::uint8_t { stop, nan, skip };

/// What a run does with its rows.
struct Options {
    explicit Options(RowOperation given) : function(std::move(given)) {}
    explicit Options(const Conversion& conversion) : Options(conversion_operation(conversion)) {}

    RowOperation function;
    ColumnList columns;                 ///< empty: a row is its numbers and nothing else
    std::optional<Delimiter> delimiter; ///< nothing: that of the first data row
    std::size_t width = 0;              ///< doubles of a row of binary input; 0: the input is text
    HeaderMode header = HeaderMode::automatic;
    Format format = Format::csv;
    OnError on_error = OnError::stop;
    int precision = 0;                                    ///< significant digits; 0: the shortest text
    bool append = false;                                  ///< keep the row and add the result at its end
    bool diagnostic_columns = false;                      ///< margin, condition, defect and notes after the result
    bool show_diagnostics = true;                         ///< in words, under Format::pretty
    std::size_t threads = 1;                              ///< at most
    std::string (*describe)(const Diagnostic&) = nullptr; ///< those words
};

/// What the rows before the first data row settle, and then holds for all of them.
struct Layout {
    Delimiter delimiter = Delimiter::blanks();
    /// Positions of the selected fields, in the order of the function's numbers; empty: all.
    std::vector<std::size_t> positions;
    std::vector<std::size_t> in_row_order; ///< the same, sorted
    std::vector<std::size_t> replaced;     ///< those in whose place the result stands, sorted; empty: all
    JsonKeys keys;                         ///< of the other fields, under Format::json
    std::string line_end = "\n";           ///< for a last row that has none

    /// The first `kept` of the chosen fields are not replaced.
    void select(std::vector<std::size_t> chosen, std::size_t kept = 0);
    /// Nothing is chosen: a row is its numbers, of which the first `kept` are not replaced.
    void select_all(std::size_t count, std::size_t kept);
};

/// Calls `other(i)` for each of `count` fields that is not replaced and `result()` once, in the order of the output:
/// the result stands where the leftmost replaced field stood, or at the end where that is missing. Where all are
/// replaced the result is all there is.
template <class Other, class Result>
void for_each_output(const Layout& layout, std::size_t count, const Other& other, const Result& result) {
    const auto& replaced = layout.replaced;
    std::size_t next = 0; // of the replaced fields
    for (std::size_t i = 0; i < count && !replaced.empty(); ++i) {
        if (next == replaced.size() || i != replaced[next]) {
            other(i);
        } else if (next++ == 0) {
            result();
        }
    }
    if (next == 0) {
        result();
    }
}

/// The fields that are not replaced, with the result in its place, parted by the delimiter.
template <class Fields, class WriteResult> void write_fields(Buffer& to, const Layout& layout, const Fields& fields,
                                                             char delimiter, const WriteResult& write_result) {
    bool first = true;
    const auto part = [&] {
        if (!first) {
            to.push_back(delimiter);
        }
        first = false;
    };
    for_each_output(
        layout, fields.size(),
        [&](std::size_t i) {
            part();
            append(to, fields[i]);
        },
        [&] {
            part();
            write_result();
        });
}

/// The row less trailing blanks, and the result after it.
template <class WriteResult>
void write_appended(Buffer& to, std::string_view row, char delimiter, const WriteResult& write_result) {
    append(to, row.substr(0, row.find_last_not_of(delimiter == '\t' ? " " : " \t") + 1));
    to.push_back(delimiter);
    write_result();
}

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

    [[nodiscard]] bool has_selected(const Header& header) const noexcept;
    /// The texts of the selected fields.
    [[nodiscard]] std::vector<std::string> selected(const Header& header) const;
    /// All selected fields are there, and none of them is a number or a word for a missing one.
    [[nodiscard]] bool is_header(const Header& header) const;
    /// The row is the beginning of JSON, and nothing that can be converted.
    [[nodiscard]] bool is_json(const Line& row) const;
    /// Takes the comment that is held back as the header, if it is that of a row.
    bool take_comment(const Header& row, Output& output);
    /// Looks the names up under each delimiter, or the one given, until they are all there.
    [[nodiscard]] std::pair<Header, Lookup> find_names(const Line& line, std::optional<Delimiter> delimiter) const;
    /// Takes the last line of those that are held back which has all names, comments under the delimiter of the data
    /// where that is given: words in them are no names where commas delimit.
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
    std::string held_;
    std::size_t held_first_ = 0;     ///< bytes of the first line that is held back
    std::size_t held_line_ = 0;      ///< and its number
    std::vector<std::string> names_; ///< of the header, for JSON
};

inline constexpr std::array<std::string_view, 4> diagnostic_names{"margin", "condition", "defect", "notes"};

/// The names of the result's columns, parted by the delimiter.
void append_result_names(Buffer& to, const Options& options, char delimiter);

} // namespace rotconv::stream
