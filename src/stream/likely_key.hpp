#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "key.hpp"
#include "layout.hpp"

namespace rotconv::stream {

/// Looks for a column that may be a key, such as a time, in rows that are paired by their number: it increases in both
/// streams, and differs between the rows of a pair.
class LikelyKey {
public:
    /// Looks at columns of the same name, otherwise at the first column of both; selected columns are left out.
    explicit LikelyKey(const std::array<const Layout*, 2>& layouts);

    void add(const std::array<std::string_view, 2>& rows);
    /// The column as --key takes it, once it is found.
    [[nodiscard]] const std::optional<std::string>& found() const noexcept { return found_; }

private:
    struct Column {
        std::string text;                ///< its name, or its index from 1
        std::array<std::size_t, 2> at{}; ///< its position in the rows of each stream
        std::array<Key, 2> last{};       ///< its keys in the last pair that was looked at
    };
    /// Keys must increase in the first pairs, so many; later pairs are looked at only if their texts differ.
    static constexpr std::size_t first_pairs = 3;
    /// After so many pairs only one in 16 is looked at, which finds a lost row as well and costs nothing.
    static constexpr std::size_t close_pairs = 64;

    std::array<const Layout*, 2> layouts_;
    std::vector<Column> columns_;
    /// A field of a row; empty where it is missing.
    [[nodiscard]] std::string_view field(std::size_t side, std::string_view row, std::size_t at);

    std::vector<std::string_view> fields_; ///< a row's, reused
    std::size_t pairs_ = 0;
    std::optional<std::string> found_;
};

} // namespace rotconv::stream
