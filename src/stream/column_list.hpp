#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rotconv::stream {

/// Why a list of columns cannot be used.
struct ColumnFault {
    enum class What { not_an_item, wrong_count, twice, ambiguous };
    What what;
    std::string text;      ///< the item at fault
    std::size_t count = 0; ///< how many columns the list names
};

/// The input columns of `--columns LIST`, in the order of the representation's numbers: 1-based indices, ranges 5-8,
/// names. Empty: the whole row.
class ColumnList {
public:
    /// Reads the list, which must name `count` different columns.
    [[nodiscard]] static std::variant<ColumnList, ColumnFault> parse(std::string_view list, std::size_t count);

    [[nodiscard]] bool empty() const noexcept { return items_.empty(); }
    [[nodiscard]] bool has_names() const noexcept;
    /// The names, for messages.
    [[nodiscard]] std::vector<std::string> names() const;

    /// 0-based positions of a list without names.
    [[nodiscard]] std::vector<std::size_t> positions() const;
    /// 0-based positions with the names looked up among a header's fields; empty where one is not there. A name matches
    /// a field's trimmed text, or that text up to its first blank.
    [[nodiscard]] std::variant<std::vector<std::size_t>, ColumnFault>
    positions(const std::vector<std::string_view>& header) const;

private:
    struct Item {
        std::string name; ///< empty: an index
        std::size_t position = 0;
    };
    std::vector<Item> items_;
};

} // namespace rotconv::stream
