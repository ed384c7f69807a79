// Any text as SPEC and as list of columns: never a crash, and what is accepted keeps its promises.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <rotconv/spec.hpp>

#include "reach.hpp"
#include "stream/beginning/column_list.hpp"
#include "stream/beginning/delimiter.hpp"
#include "stream/numbers/number_text.hpp"

namespace {

fuzz::Reach reach{
    "spec",      "refused spec", "columns by index", "columns by name", "refused columns", "columns found in a header",
    "delimiter", "number"};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto parsed = rotconv::parse_spec(text);
    if (const auto* spec = std::get_if<rotconv::Spec>(&parsed)) {
        unsigned seen = 0;
        for (std::size_t i = 0; i < spec->size(); ++i) {
            seen |= 1U << spec->order()[i];
        }
        if (seen + 1 != 1U << spec->size()) {
            std::abort(); // the order is no permutation
        }
    }
    reach.add(std::holds_alternative<rotconv::Spec>(parsed) ? "spec" : "refused spec");
    const auto list = rotconv::stream::ColumnList::parse(text, 4);
    if (const auto* columns = std::get_if<rotconv::stream::ColumnList>(&list)) {
        if (columns->positions().size() != 4) {
            std::abort();
        }
        const auto found = columns->positions({"timestamp", "q_w []", "q_x", "q_y", "q_z"});
        reach.add("columns found in a header", columns->has_names() && found.index() == 0 ? 1 : 0);
        reach.add(columns->has_names() ? "columns by name" : "columns by index");
    } else {
        reach.add("refused columns");
    }
    reach.add("delimiter", rotconv::stream::Delimiter::parse(text) ? 1 : 0);
    double value = 0.0;
    reach.add("number", rotconv::stream::read_number(text, value) == rotconv::stream::NumberError::none ? 1 : 0);
    return 0;
}
