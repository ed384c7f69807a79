#include <utility>

#include "../stream/fmt.hpp"
#include "operations.hpp"

namespace rotconv::operations {

Operation identify(const IdentificationRows& rows, std::shared_ptr<Identification> identification) {
    const auto function = [identification = std::move(identification)](const auto& numbers, auto /*out*/, auto& reports,
                                                                       auto /*rest*/) {
        identification->add(numbers.numbers, numbers.lines, reports);
    };
    stream::RowNumbers numbers;
    for (std::size_t i = 0; i < rows.count; ++i) {
        numbers.names.push_back(fmt::format("n{}", i + 1));
    }
    const bool is_known_beside = rows.paired || rows.count == 0; // or not yet known
    auto made = std::make_shared<RowsAtOnce>(
        function, pair_numbers(std::move(numbers), {is_known_beside, rows.by_key}, rows.known),
        std::vector<std::string>{"angle"});
    made->in_order = true;
    return made;
}

} // namespace rotconv::operations
