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

/// Watches rows that are paired by their number for a column that looks like a key, such as a time: it increases in
/// both streams, and is not the same in both rows of a pair.
class LikelyKey {
public:
    /// The rows and the names of one stream.
    struct Side {
        const Layout* layout = nullptr;
        const std::vector<std::string>* names = nullptr; ///< none without a header
    };

    /// The columns of the same name, otherwise the first column of both; without those that are selected.
    explicit LikelyKey(const std::array<Side, 2>& sides);

    void add(const std::array<std::string_view, 2>& rows);
    /// The column as --key takes it, once it is found.
    [[nodiscard]] const std::optional<std::string>& found() const noexcept { return found_; }

private:
    struct Column {
        std::string text;                ///< its name, or its index from 1
        std::array<std::size_t, 2> at{}; ///< in the rows of either stream
        std::array<Key, 2> last{};       ///< of the pairs that were looked at
    };
    /// Of so many pairs the columns increase; later ones are looked at if the texts differ...
    static constexpr std::size_t first_pairs = 3;
    /// ...and from so many on one in 16, which finds a lost row as well, and costs nothing.
    static constexpr std::size_t close_pairs = 64;

    std::array<Side, 2> sides_;
    std::vector<Column> columns_;
    /// A field of a row; empty where it is missing.
    [[nodiscard]] std::string_view field(std::size_t side, std::string_view row, std::size_t at);

    std::vector<std::string_view> fields_; ///< of a row
    std::size_t pairs_ = 0;
    std::optional<std::string> found_;
};

} // namespace rotconv::stream
