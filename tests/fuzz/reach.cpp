#include "reach.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace fuzz {

Reach::Reach(std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
        entries_.push_back({std::string(name)});
    }
}

Reach::~Reach() {
    for (const Entry& entry : entries_) {
        std::fprintf(stderr, "reached %s: %zu\n", entry.name.c_str(), entry.count);
    }
}

void Reach::add(std::string_view name, std::size_t count) {
    const auto found = std::ranges::find(entries_, name, &Entry::name);
    if (found == entries_.end()) {
        std::fprintf(stderr, "nobody asks for the reach of %.*s\n", static_cast<int>(name.size()), name.data());
        std::abort();
    }
    found->count += count;
    if (count > 0 && (found->input.empty() || input_.size() <= found->input.size())) {
        found->input = input_; // mutations lengthen it
    }
}

const std::string& Reach::rarest() const {
    static const std::string none;
    const auto reached = [](const Entry& entry) { return entry.input.empty() ? ~std::size_t{0} : entry.count; };
    const auto found = std::ranges::min_element(entries_, {}, reached);
    return found == entries_.end() ? none : found->input;
}

} // namespace fuzz
