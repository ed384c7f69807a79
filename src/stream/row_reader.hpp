#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "event.hpp"
#include "layout.hpp"
#include "options.hpp"

namespace rotconv::stream {

/// What was read of the rows of a batch, one after the other.
struct RowParts {
    std::vector<std::string_view> fields; ///< of the rows whose fields were looked for
    std::vector<double> numbers;
    std::vector<std::string_view> kept; ///< texts of the numbers that are kept
    RowError error;                     ///< of the row that failed last, without its line

    void clear() noexcept {
        fields.clear();
        numbers.clear();
        kept.clear();
    }
};

/// Reads the numbers of a row.
class RowReader {
public:
    RowReader(const InputOptions& options, const Layout& layout) : options_(&options), layout_(&layout) {}

    /// Not all of the row's fields are numbers that the result replaces.
    [[nodiscard]] bool has_other_fields() const noexcept { return !layout_->replaced.empty(); }

    /// Adds what is read of a row, of text or of doubles. `needs_fields`: its fields too.
    /// @return false where `to.error` says why there is nothing; fields may be there
    [[nodiscard]] bool read(std::string_view row, RowParts& to, bool needs_fields) const;
    /// The fields that hold the numbers, parted by the delimiter.
    [[nodiscard]] std::string selected_text(std::string_view row) const;

private:
    [[nodiscard]] bool read_text(std::string_view text, RowParts& to, bool needs_fields) const;
    void read_binary(std::string_view row, RowParts& to) const;
    /// A row of nothing but plain numbers, as most are, which needs no fields; false for any other.
    [[nodiscard]] bool read_plain(std::string_view text, std::vector<double>& numbers) const;
    [[nodiscard]] std::size_t position(std::size_t number) const noexcept {
        return layout_->positions.empty() ? number : layout_->positions[number];
    }

    const InputOptions* options_;
    const Layout* layout_;
};

} // namespace rotconv::stream
