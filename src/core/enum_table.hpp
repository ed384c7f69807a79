#pragma once

#include <cstddef>
#include <functional>

namespace rotconv {

/// Whether a table that an enumeration indexes has a line for each of its values, in their order.
template <class Table, class Key> constexpr bool is_indexed(const Table& table, std::size_t count, Key key) noexcept {
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (static_cast<std::size_t>(std::invoke(key, table[i])) != i) {
            return false;
        }
    }
    return table.size() == count;
}

} // namespace rotconv
