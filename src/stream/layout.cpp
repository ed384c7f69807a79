#include "layout.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rotconv::stream {

void Layout::select(std::vector<std::size_t> chosen, std::size_t kept) {
    positions = std::move(chosen);
    in_row_order = positions;
    std::ranges::sort(in_row_order);
    replaced.assign(positions.begin() + static_cast<std::ptrdiff_t>(kept), positions.end());
    std::ranges::sort(replaced);
}

void Layout::select_all(std::size_t count, std::size_t kept) {
    replaced.resize(kept > 0 ? count - kept : 0);
    std::iota(replaced.begin(), replaced.end(), kept);
}

} // namespace rotconv::stream
