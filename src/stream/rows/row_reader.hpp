#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../event.hpp"
#include "../options.hpp"
#include "layout.hpp"

namespace rotconv::stream {

/// A row of a stream.
struct Row {
    // Without a constructor all bytes would be cleared first, which takes longer than what it does.
    explicit Row(const Line& line_ = {}, std::size_t number_ = 0) noexcept : line(line_), number(number_) {}

    Line line;
    std::size_t number;              ///< the line's; 0 if there is only a row of the reference
    bool passes = false;             ///< blank or comment: goes out as it is
    const RowError* error = nullptr; ///< why it has no numbers, or no partner
    // Set when the row is read:
    std::string_view numbers{}; ///< their text, if the row was scanned without looking for fields
    std::size_t first_field = 0;
    std::size_t field_count = 0;
    std::size_t index = 0; ///< its place among the rows with numbers

    [[nodiscard]] bool is_scanned() const noexcept { return numbers.data() != nullptr; }
    [[nodiscard]] bool has_numbers() const noexcept { return !passes && error == nullptr; }
};

/// A row of the reference.
struct Partner {
    std::string_view text;
    std::size_t number = 0; ///< the line's; 0: there is none
};

/// The partner of a row.
struct Pair {
    Partner partner{};
    Partner later{};      ///< the next row of the reference, if the partner is interpolated
    std::string fields{}; ///< partner_names, each after a delimiter, if they are written
};

/// Rows, and what was read of them, one after the other.
struct ReadRows : NumberRows {
    std::vector<Row> rows;
    std::vector<std::string_view> fields; ///< of the rows whose fields were looked for
    RowError error;                       ///< of the row that failed last, without its line
    std::deque<RowError> errors;          ///< what Row::error points to: they stay in their place
    std::vector<Pair> pairs;              ///< of each row, if they are paired

    void clear() noexcept {
        numbers.clear();
        lines.clear();
        kept.clear();
        reference_lines.clear();
        neighbours.clear();
        between.clear();
        rows.clear();
        fields.clear();
        errors.clear();
        pairs.clear();
    }
    /// Why the last row has no numbers.
    void fail(RowError why) { rows.back().error = &errors.emplace_back(std::move(why)); }
};

/// Reads the numbers of a row.
class RowReader {
public:
    RowReader(const InputOptions& options, const Layout& layout) : options_(&options), layout_(&layout) {}

    /// From here on rows of another width are errors, unless the options take them.
    void expect(const RowWidth& width) noexcept { width_ = options_->ragged ? RowWidth() : width; }

    /// Takes a row off the text, and adds what is read of it. Its fields are looked for only where one scan does not
    /// do.
    /// @return whether it has numbers; otherwise it passes, or `to.error` says why, without its place, and only what is
    /// kept of it may have been added
    [[nodiscard]] bool take(std::string_view& text, Row& row, ReadRows& to) const {
        const bool is_comment = options_->width == 0 && options_->is_comment(text);
        if (is_comment || !scan(text, row, to)) {
            return take_line(text, row, to);
        }
        text.remove_prefix(row.line.text.size() + row.line.end.size());
        return true;
    }
    /// A key as it is compared.
    [[nodiscard]] ReadKey key_of(std::string_view text) const;
    /// The fields that hold the numbers, with the delimiter between them.
    [[nodiscard]] std::string selected_text(std::string_view row) const;

private:
    /// Adds what is read of the row that begins the text, but not its fields, in one scan, if it is of doubles, or as
    /// most are: the numbers stand side by side without blanks around them, and it has no quotes.
    /// @return false, and nothing is added, for any other row
    [[nodiscard]] bool scan(std::string_view text, Row& row, ReadRows& to) const;
    /// The same for a line that was not scanned.
    [[nodiscard]] bool take_line(std::string_view& text, Row& row, ReadRows& to) const;
    /// Adds what is read of a row of text, and its fields.
    /// @return false where `to.error` says why there are no numbers; fields and numbers may be there
    [[nodiscard]] bool read(std::string_view row, ReadRows& to) const;
    void add_doubles(std::string_view row, ReadRows& to) const;

    const InputOptions* options_;
    const Layout* layout_;
    RowWidth width_{};
};

} // namespace rotconv::stream
