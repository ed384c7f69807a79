#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "../beginning/delimiter.hpp"
#include "../event.hpp"
#include "../numbers/json.hpp"
#include "../numbers/number_text.hpp"

namespace rotconv::stream {

/// What stands where in a row: known from the first data row on, and the same for all rows.
struct Layout {
    Delimiter delimiter = Delimiter::blanks();
    std::size_t count = 0;       ///< numbers of each row
    std::size_t field_count = 0; ///< fields of the first data row; 0 before it
    bool is_whole = true;        ///< a row is its numbers and nothing else: nothing is selected
    /// Positions of the fields that hold the numbers, in the order of the operation's; empty: 0, 1, 2...
    std::vector<std::size_t> positions{};
    static constexpr auto no_number = static_cast<std::size_t>(-1);
    std::size_t first_field = 0; ///< the first that holds a number that is not kept (see RowNumbers)
    /// The number, of those that are not kept, that field `first_field` + i holds, or none, up to the last selected
    /// field; empty if the kept one is not in front of them, or a field holds two.
    std::vector<std::size_t> number_of_field{};
    bool is_scattered = false;             ///< some of these hold none
    std::vector<std::size_t> replaced{};   ///< the fields that the result replaces, sorted; empty: all
    bool appends = false;                  ///< the result replaces nothing, and stands at the end
    JsonKeys keys{};                       ///< keys of the other fields, with Format::json
    std::string line_end = "\n";           ///< the line end of a last row that has none
    std::vector<std::string> kept_names{}; ///< the result's, as in the header; see RowOperation::keeps_names
    std::vector<std::string> names{};      ///< all names of the header; empty without a header
    RowWidth header{};                     ///< the header's
    std::vector<Note> notes{};             ///< about the header and the first row, or about comments alone

    /// Sets the fields that hold the numbers. The result does not replace the first `kept` of them.
    void select(std::vector<std::size_t> chosen, std::size_t number_count, std::size_t kept) {
        count = number_count;
        positions = std::move(chosen);
        replaced.clear();
        number_of_field.clear();
        for (std::size_t i = kept; i < count; ++i) {
            replaced.push_back(position(i));
        }
        std::ranges::sort(replaced);
        const bool is_twice = std::ranges::adjacent_find(replaced) != replaced.end();
        if (!replaced.empty() && !is_twice && (kept == 0 || position(0) < replaced.front())) {
            first_field = replaced.front();
            number_of_field.assign(replaced.back() - first_field + 1, no_number);
            for (std::size_t i = kept; i < count; ++i) {
                number_of_field[position(i) - first_field] = i - kept;
            }
        }
        is_scattered = number_of_field.size() > replaced.size();
        if (kept == 0 && is_whole) {
            replaced.clear();
        }
    }
    /// The position of the field that holds a number.
    [[nodiscard]] std::size_t position(std::size_t number) const noexcept {
        return positions.empty() ? number : positions[number];
    }
    [[nodiscard]] bool replaces(std::size_t field) const noexcept {
        return !appends && std::ranges::binary_search(replaced, field);
    }
    /// Whether the output has fields of the input beside the result.
    [[nodiscard]] bool has_other_fields() const noexcept { return appends || !replaced.empty(); }
};

/// Calls `other(i)` for each of `count` fields that is not replaced and `result()` once, in the order of the output:
/// the result takes the place of the leftmost replaced field, or stands at the end if that is missing.
template <class Other, class Result>
void for_each_output(const Layout& layout, std::size_t count, const Other& other, const Result& result) {
    std::size_t next = 0; // index of a replaced field
    for (std::size_t i = 0; i < count && layout.has_other_fields(); ++i) {
        if (layout.appends || next == layout.replaced.size() || i != layout.replaced[next]) {
            other(i);
        } else if (next++ == 0) {
            result();
        }
    }
    if (next == 0) {
        result();
    }
}

} // namespace rotconv::stream
