// Any text as names of a header: names of a quaternion are found between any prefix and any suffix, in the right
// places.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <rotconv/spec.hpp>

#include "cli/grammar/column_names.hpp"
#include "reach.hpp"

namespace {

using Names = std::vector<std::string>;

fuzz::Reach reach{"prefixes", "suffixes", "units"};

constexpr std::size_t longest_name = 200; // a longer one is in no set

const auto quat = std::get<rotconv::Spec>(rotconv::parse_spec("quat"));

void check(bool holds, const char* what) {
    if (!holds) {
        std::fprintf(stderr, "%s\n", what);
        std::abort();
    }
}

/// Looks for the names of a quaternion with the prefix and the suffix.
void look(const std::string& prefix, const std::string& suffix) {
    Names names;
    for (const char letter : {'x', 'y', 'w', 'z'}) {
        names.push_back(prefix + letter + suffix);
    }
    const auto found = rotconv::cli::find_names(quat, names);
    check(found.has_value(), "names of a quaternion are not found");
    check(found->places == std::vector<std::size_t>{2, 0, 1, 3}, "other names are found");
    reach.add("prefixes", prefix.empty() ? 0 : 1);
    reach.add("suffixes", suffix.empty() ? 0 : 1);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (text.size() < longest_name) {
        look(text.substr(0, end), text.substr(std::min(end + 1, text.size())));
    }
    reach.add("units", rotconv::cli::name_and_unit(text).second.empty() ? 0 : 1);
    return 0;
}
