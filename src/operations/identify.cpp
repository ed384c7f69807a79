#include <utility>

#include "../stream/fmt.hpp"
#include "operations.hpp"

namespace rotconv::operations {
namespace {

stream::RowNumbers numbers_of(const IdentificationRows& rows) {
    stream::RowNumbers numbers;
    if (rows.by_key) {
        numbers.names.emplace_back("key");
        numbers.kept = 1;
    }
    for (std::size_t i = 0; i < rows.count; ++i) {
        numbers.names.push_back(fmt::format("n{}", i + 1));
    }
    if (!rows.paired && rows.count > 0) {
        numbers.names = concatenated(numbers.names, names_of(rows.known));
        numbers.second = rows.known;
    }
    return numbers;
}

} // namespace

Operation identify(const IdentificationRows& rows, std::shared_ptr<Identification> identification) {
    const auto function = [identification = std::move(identification)](const auto& numbers, auto /*out*/, auto& reports,
                                                                       auto /*rest*/) {
        identification->add(numbers.numbers, numbers.lines, reports);
    };
    auto made = std::make_shared<RowsAtOnce>(function, numbers_of(rows), std::vector<std::string>{"angle"});
    made->in_order = true;
    return made;
}

} // namespace rotconv::operations
