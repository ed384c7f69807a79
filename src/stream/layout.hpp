#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "delimiter.hpp"
#include "event.hpp"
#include "json.hpp"
#include "number_text.hpp"

namespace rotconv::stream {

/// How many fields the rows of a stream have, without empty ones at the end: as many as the first row whose selected
/// fields are numbers.
struct RowWidth {
    std::size_t fields = 0; ///< 0: there was no such row yet
    std::size_t line = 0;   ///< of that row
};

/// Where things stand in a row. It is known once the first data row has come, and is the same for all rows.
struct Layout {
    Delimiter delimiter = Delimiter::blanks();
    std::size_t count = 0;       ///< numbers of a row
    std::size_t field_count = 0; ///< of the first data row; 0 before it
    /// Positions of the selected fields, in the order of the operation's numbers; empty where --columns selects none
    /// and a row is its numbers.
    std::vector<std::size_t> positions{};
    /// If the selected fields are adjacent, and those that are kept (see RowNumbers) come first: the number that field
    /// `first_field` + i holds. Else empty.
    std::vector<std::size_t> number_of_field{};
    std::size_t first_field = 0;
    std::vector<std::size_t> replaced{}; ///< those in whose place the result stands, sorted; empty: the whole row is
    bool appends = false;                ///< nothing is replaced: the result stands at the end
    JsonKeys keys{};                     ///< of the other fields, under Format::json
    std::string line_end = "\n";         ///< for a last row that has none
    std::vector<std::string>
        kept_names{};          ///< of the result, as they stand in the header; see RowOperation::keeps_names
    std::vector<Note> notes{}; ///< of the header and the first row, or of comments alone

    /// The numbers stand in the chosen fields, or are the whole row where none is chosen; the first `kept` of them are
    /// not replaced.
    void select(std::vector<std::size_t> chosen, std::size_t number_count, std::size_t kept) {
        count = number_count;
        positions = std::move(chosen);
        replaced = positions;
        if (positions.empty() && kept > 0) {
            replaced.resize(count);
            std::iota(replaced.begin(), replaced.end(), std::size_t{0});
        }
        if (!replaced.empty()) {
            replaced.erase(replaced.begin(), replaced.begin() + static_cast<std::ptrdiff_t>(kept));
        }
        std::ranges::sort(replaced);
        first_field = positions.empty() ? 0 : std::ranges::min(positions);
        number_of_field.assign(count, count);
        for (std::size_t i = 0; i < number_of_field.size(); ++i) {
            const std::size_t place = positions.empty() ? i : positions[i] - first_field;
            if (place >= count || number_of_field[place] != count || (i < kept && place != i)) {
                number_of_field.clear();
                return;
            }
            number_of_field[place] = i;
        }
    }
    [[nodiscard]] bool replaces(std::size_t field) const noexcept {
        return !appends && std::ranges::binary_search(replaced, field);
    }
    /// The output has fields of the input beside the result.
    [[nodiscard]] bool has_other_fields() const noexcept { return appends || !replaced.empty(); }
};

/// Calls `other(i)` for each of `count` fields that is not replaced and `result()` once, in the order of the output:
/// the result stands where the leftmost replaced field stood, or at the end where that is missing.
template <class Other, class Result>
void for_each_output(const Layout& layout, std::size_t count, const Other& other, const Result& result) {
    std::size_t next = 0; // of the replaced fields
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
