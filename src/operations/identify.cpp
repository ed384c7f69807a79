#include <utility>

#include "../stream/fmt.hpp"
#include "operations.hpp"

namespace rotconv::operations {
namespace {

class Identify final : public stream::RowOperation {
public:
    Identify(const IdentificationRows& rows, std::function<Identification&()> identification,
             std::vector<std::size_t>& positions)
        : rows_(rows), identification_(std::move(identification)), positions_(&positions) {
        names = {"angle"};
        in_order = true;
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Identify>(*this); }

    void run(const stream::NumberRows& rows, std::span<double> /*out*/, std::vector<RowReport>& reports) override {
        Identification& identification = identification_();
        if (rows_.by_key) {
            identification.add(without_keys(rows.numbers, identification.count(), rows_.known.size()), rows.lines,
                               reports);
        } else {
            identification.add(rows.numbers, rows.lines, reports);
        }
    }
    void take_positions(const std::vector<std::size_t>& positions) override {
        positions_->assign(positions.begin() + (rows_.by_key ? 1 : 0), positions.end());
    }

private:
    IdentificationRows rows_;
    std::function<Identification&()> identification_;
    std::vector<std::size_t>* positions_;
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

Operation identify(const IdentificationRows& rows, std::function<Identification&()> identification,
                   std::vector<std::size_t>& positions) {
    return std::make_shared<Identify>(rows, std::move(identification), positions);
}

} // namespace rotconv::operations
