// Any text as names of a header: names of a quaternion are found between any prefix and any suffix, in the right
// places, and the time for a longer name grows as its length, not as its square.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <string_view>
#include <vector>

#include <rotconv/spec.hpp>

#include "cli/grammar/column_names.hpp"
#include "reach.hpp"

namespace {

using Names = std::vector<std::string>;

fuzz::Reach reach{"prefixes", "suffixes", "units", "names of repeated texts"};

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

/// Processor time, in seconds, for names of so many bytes.
double time_of(std::string_view text, std::size_t size) {
    Names names(quat.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        while (names[i].size() < size) {
            names[i] += text;
        }
        names[i] += "abcd"[i];
    }
    timespec begin{};
    timespec end{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &begin);
    static_cast<void>(rotconv::cli::find_names(quat, names));
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &end);
    return static_cast<double>(end.tv_sec - begin.tv_sec) + 1e-9 * static_cast<double>(end.tv_nsec - begin.tv_nsec);
}

/// A name four times as long takes four times as long, and sixteen times where each byte is held against each: a
/// tenfold time and 50 ms are taken for a machine at work, and what a second look finds as well for the program's.
bool grows_with_size(std::string_view text) {
    constexpr std::size_t size = std::size_t{2} << 10U;
    return time_of(text, 4 * size) <= 10.0 * time_of(text, size) + 0.05;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (text.size() < longest_name) {
        look(text.substr(0, end), text.substr(std::min(end + 1, text.size())));
    }
    reach.add("units", rotconv::cli::name_and_unit(text).second.empty() ? 0 : 1);
    if (!text.empty()) {
        check(grows_with_size(text) || grows_with_size(text) || grows_with_size(text), "a long name takes too long");
        reach.add("names of repeated texts");
    }
    return 0;
}
