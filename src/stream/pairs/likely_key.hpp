#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../rows/layout.hpp"
#include "key.hpp"

namespace rotconv::stream {

/// Looks for a column that may be a key, in rows that are paired by their number: over the first pairs it increases in
/// both streams, and differs between the rows of a pair.
class LikelyKey {
public:
    /// Looks at times of the same name, and at the first column of FILE; selected columns are left out.
    explicit LikelyKey(const std::array<const Layout*, 2>& layouts);

    void add(const std::array<std::string_view, 2>& rows);
    /// The column as --key takes it.
    [[nodiscard]] std::optional<std::string> found() const;

private:
    struct Column {
        std::string text;                ///< its name, or its index from 1
        std::array<std::size_t, 2> at{}; ///< its position in the rows of each stream
        std::array<Key, 2> last{};       ///< its keys in the last pair
        bool differs = false;
    };
    /// Later pairs are not looked at.
    static constexpr std::size_t most_pairs = 1000;

    std::array<const Layout*, 2> layouts_;
    std::vector<Column> columns_;
    std::array<std::vector<std::string_view>, 2> fields_; ///< of a pair, reused
    std::size_t pairs_ = 0;
};

} // namespace rotconv::stream
