#include <utility>

#include "../stream/fmt.hpp"
#include "operations.hpp"

namespace rotconv::operations {
namespace {

class Identify final : public stream::RowOperation {
public:
    Identify(const IdentificationRows& rows, std::shared_ptr<Identification> identification)
        : rows_(rows), identification_(std::move(identification)) {
        names = {"angle"};
        in_order = true;
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Identify>(*this); }

    std::size_t run(const stream::NumberRows& rows, std::span<double> /*out*/,
                    std::vector<RowReport>& reports) override {
        const stream::PairColumns columns{identification_->count(), rows_.known.size(), rows_.by_key};
        identification_->add(without_keys(rows.numbers, columns, attitudes_), rows.lines, reports);
        return rows.lines.size();
    }

private:
    IdentificationRows rows_;
    std::shared_ptr<Identification> identification_;
    std::vector<double> attitudes_;
};

} // namespace

stream::RowNumbers identification_numbers(const IdentificationRows& rows) {
    stream::RowNumbers numbers;
    if (rows.by_key) {
        numbers.names.emplace_back("key");
        numbers.kept = 1;
    }
    for (std::size_t i = 0; i < rows.count; ++i) {
        numbers.names.push_back(fmt::format("n{}", i + 1));
    }
    if (!rows.paired && rows.count > 0) {
        numbers.names = joined(numbers.names, names_of(rows.known));
        numbers.second = rows.known;
    }
    return numbers;
}

Operation identify(const IdentificationRows& rows, std::shared_ptr<Identification> identification) {
    return std::make_shared<Identify>(rows, std::move(identification));
}

} // namespace rotconv::operations
