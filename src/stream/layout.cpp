#include "layout.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rotconv::stream {

void Layout::select(std::vector<std::size_t> chosen, std::size_t number_count, std::size_t kept) {
    count = number_count;
    positions = std::move(chosen);
    in_row_order = positions;
    std::ranges::sort(in_row_order);
    replaced.clear();
    if (!positions.empty()) {
        replaced.assign(positions.begin() + static_cast<std::ptrdiff_t>(kept), positions.end());
        std::ranges::sort(replaced);
    } else if (kept > 0) {
        replaced.resize(count - kept);
        std::iota(replaced.begin(), replaced.end(), kept);
    }
}

} // namespace rotconv::stream
