#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../bytes/io_block.hpp"
#include "delimiter.hpp"

namespace rotconv::stream {

/// A line as a header: its fields, after the mark of a comment and blanks if it has them.
struct HeaderLine {
    HeaderLine(const Line& line_, Delimiter delimiter_, std::string_view comment = {});

    /// The header with a mark before the first name, such as the % of "%time", moved to the prefix. A mark has no
    /// letters, digits, _ or quotes.
    [[nodiscard]] HeaderLine without_mark() const;
    /// Whether the first field is such a mark and nothing else.
    [[nodiscard]] bool begins_with_mark() const;
    /// Whether the line is not a header, although it may look like one: it is a remark of another program (COMMENT, KEY
    /// = value, FMT), or has a name followed by a number. `has_names`: all that are looked for, so that = may be one.
    [[nodiscard]] bool is_remark(bool has_names = false) const;
    [[nodiscard]] FieldCount width() const { return delimiter.count(fields); }
    [[nodiscard]] std::string name(std::size_t at) const;
    [[nodiscard]] std::vector<std::string> names() const;
    /// The names at these positions, or nothing if one is missing; without positions, all but empty ones at
    /// the end.
    [[nodiscard]] std::optional<std::vector<std::string>> names_at(const std::vector<std::size_t>& positions) const;

    Line line;
    std::string_view prefix; ///< the mark and the blanks before the first name
    Delimiter delimiter;
    std::vector<std::string_view> fields;
    bool is_closed; ///< no quote is left open
};

} // namespace rotconv::stream
