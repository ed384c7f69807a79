#include <memory>
#include <span>
#include <vector>

#include "operations.hpp"

namespace rotconv::operations {
namespace {

class Compare final : public stream::RowOperation {
public:
    Compare(const Comparison& comparison, const ComparisonRows& rows) : comparison_(comparison), rows_(rows) {
        names = {"angle"};
        attitude = comparison.settings().relative;
        if (rows.with_line) {
            names.emplace_back("line");
        } else if (attitude) {
            names = joined(names, names_of(*attitude));
        }
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Compare>(*this); }

    void run(const stream::NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) override {
        const auto numbers =
            rows_.by_key ? without_keys_(rows.numbers, comparison_.from().size(), comparison_.reference().size())
                         : rows.numbers;
        if (!rows_.with_line) {
            comparison_.run(numbers, out, reports);
            return;
        }
        angles_.resize(rows.lines.size());
        comparison_.run(numbers, angles_, reports);
        for (std::size_t i = 0; i < angles_.size(); ++i) {
            out[2 * i] = angles_[i];
            out[2 * i + 1] = static_cast<double>(rows.lines[i]);
        }
    }

private:
    Comparison comparison_;
    ComparisonRows rows_;
    KeyRemover without_keys_;
    std::vector<double> angles_;
};

} // namespace

stream::RowNumbers comparison_numbers(const Comparison& comparison, const ComparisonRows& rows) {
    stream::RowNumbers numbers = attitude_numbers(comparison.from(), rows.by_key);
    if (!rows.paired) {
        numbers.names = joined(numbers.names, names_of(comparison.reference()));
        numbers.second = comparison.reference();
    }
    return numbers;
}

Operation compare(const Comparison& comparison, const ComparisonRows& rows) {
    return std::make_shared<Compare>(comparison, rows);
}

} // namespace rotconv::operations
