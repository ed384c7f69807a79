#include "reach.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace fuzz {

Reach::Reach(std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
        counts_.emplace_back(name, 0);
    }
}

Reach::~Reach() {
    for (const auto& [name, count] : counts_) {
        std::fprintf(stderr, "reached %s: %zu\n", name.c_str(), count.load());
    }
}

void Reach::add(std::string_view name, std::size_t count) {
    const auto found = std::ranges::find(counts_, name, [](const auto& entry) { return entry.first; });
    if (found == counts_.end()) {
        std::fprintf(stderr, "nobody asks for the reach of %.*s\n", static_cast<int>(name.size()), name.data());
        std::abort();
    }
    found->second += count;
}

} // namespace fuzz
