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
    RowReader(const Options& options, const Layout& layout) : options_(&options), layout_(&layout) {}

    /// The output has fields of the input beside the result, or not all of the input's are numbers.
    [[nodiscard]] bool needs_fields() const noexcept { return options_->append || !layout_->replaced.empty(); }

    /// Adds what is read of a row, of text or of doubles.
    /// @return false where `to.error` says why there is nothing; fields may be there
    [[nodiscard]] bool read(std::string_view row, RowParts& to) const;
    /// The fields that hold the numbers, parted by the delimiter.
    [[nodiscard]] std::string selected_text(std::string_view row) const;

private:
    [[nodiscard]] bool read_text(std::string_view text, RowParts& to) const;
    void read_binary(std::string_view row, RowParts& to) const;
    /// A row of nothing but plain numbers, as most are, which needs no fields; false for any other.
    [[nodiscard]] bool read_plain(std::string_view text, std::vector<double>& numbers) const;
    [[nodiscard]] std::size_t position(std::size_t number) const noexcept {
        return layout_->positions.empty() ? number : layout_->positions[number];
    }

    const Options* options_;
    const Layout* layout_;
};

} // namespace rotconv::stream
