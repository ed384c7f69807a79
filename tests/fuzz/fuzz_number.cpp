// Any text, and what is left of it without its first bytes, as a text that begins with a number: scan_number() finds
// what fast_float finds, and reads no byte behind the text.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "reach.hpp"
#include "scan_comparison.hpp"

namespace {

fuzz::Reach reach{"texts without a number", "numbers scanned directly", "numbers left to fast_float",
                  "infinite numbers",       "subnormal numbers",        "numbers at the end"};

constexpr std::size_t longest = 256; // each of its bytes begins a text

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t given) {
    const std::size_t size = std::min(given, longest);
    const auto text = std::make_unique<char[]>(size); // of no byte more, as the sanitizer sees
    std::copy(data, data + size, text.get());
    const char* const end = text.get() + size;
    std::size_t none = 0, direct = 0, left = 0, infinite = 0, subnormal = 0, at_end = 0;
    for (const char* begin = text.get(); begin != end; ++begin) {
        const auto compared = compare_scan(begin, end);
        if (!compared.is_same) {
            std::fprintf(stderr, "another number than fast_float's at byte %td\n", begin - text.get());
            std::abort();
        }
        ++(!compared.is_number ? none : compared.is_direct ? direct : left);
        infinite += std::isinf(compared.value) ? 1 : 0;
        subnormal += std::fpclassify(compared.value) == FP_SUBNORMAL ? 1 : 0;
        at_end += compared.is_number && end - begin < rotconv::stream::NumberScan::reach ? 1 : 0;
    }
    reach.add("texts without a number", none);
    reach.add("numbers scanned directly", direct);
    reach.add("numbers left to fast_float", left);
    reach.add("infinite numbers", infinite);
    reach.add("subnormal numbers", subnormal);
    reach.add("numbers at the end", at_end);
    return 0;
}
