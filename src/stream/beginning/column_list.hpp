#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rotconv::stream {

/// Why a list of columns cannot be used.
struct ColumnError {
    enum class What : std::uint8_t { not_an_item, wrong_count, twice, missing, ambiguous, other_width, none };
    What what = What::not_an_item;
    std::string text;                   ///< the item at fault, or the row that lacks names or has another width
    std::size_t count = 0;              ///< how many columns the list names, or the header
    std::size_t fields = 0;             ///< the row's count, if it is another than that
    std::size_t wanted = 0;             ///< how many the list should name
    std::vector<std::string> lacking{}; ///< names that the row lacks
    std::vector<std::string> present{}; ///< names that the row has
    std::vector<std::string> header{};  ///< all names of the header that lacks them, if there is one
    std::vector<std::size_t> indices{}; ///< of the columns with the same name, from 1
};

/// The input columns of `--columns LIST`, in the order of the representation's numbers: 1-based indices, ranges 5-8,
/// names. Empty: the whole row.
class ColumnList {
public:
    /// Reads the list, which must name `count` different columns.
    [[nodiscard]] static std::variant<ColumnList, ColumnError> parse(std::string_view list, std::size_t count);

    [[nodiscard]] bool empty() const noexcept { return items_.empty(); }
    [[nodiscard]] bool has_names() const noexcept;
    /// The names in the order of the list; empty for an index.
    [[nodiscard]] std::vector<std::string_view> names() const;
    /// 0-based positions of a list without names.
    [[nodiscard]] std::vector<std::size_t> positions() const;
    /// 0-based positions, with the names looked up in a header. A name matches a name of the header, whole or up to its
    /// first blank.
    [[nodiscard]] std::variant<std::vector<std::size_t>, ColumnError>
    positions(const std::vector<std::string>& header) const;

private:
    struct Item {
        std::string name; ///< empty: an index
        std::size_t position = 0;
    };
    std::vector<Item> items_;
};

} // namespace rotconv::stream
