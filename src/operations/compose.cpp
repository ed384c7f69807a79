#include <optional>

#include "between.hpp"
#include "operations.hpp"

namespace rotconv::operations {
namespace {

PairFunction function_of(const Composition& composition) {
    return {[composition](auto in, auto out, auto& reports, auto rest) { composition.run(in, out, reports, rest); },
            composition.to().size()};
}

class Compose final : public AttitudeOperation {
public:
    Compose(const Composition& composition, const PairedRows& rows, bool continuous)
        : AttitudeOperation(composition.to(), continuous), composition_(composition),
          columns_(rows.columns(composition.first(), composition.second())) {
        if (rows.interpolates) {
            between_.emplace(
                function_of(composition),
                function_of(Composition(composition.first(), Spec{}, composition.to(), composition.settings())),
                columns_, composition.second(), composition.settings());
        }
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Compose>(*this); }

    std::size_t run(const stream::NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) override {
        const auto rest = rest_of(out);
        if (between_) {
            between_->run(rows.numbers, out, reports, rest);
        } else {
            composition_.run(without_keys(rows.numbers, columns_, attitudes_), out, reports, rest);
        }
        return rows.lines.size();
    }

private:
    Composition composition_;
    stream::PairColumns columns_;
    std::vector<double> attitudes_;
    std::optional<Between> between_; ///< if the reference is interpolated
};

} // namespace

stream::RowNumbers pair_numbers(const Spec& first, const Spec& second, const PairedRows& rows) {
    stream::RowNumbers numbers = attitude_numbers(first, rows.by_key);
    if (!rows.paired) {
        numbers.names = joined(numbers.names, names_of(second));
        numbers.second = second;
    }
    return numbers;
}

Operation compose(const Composition& composition, const PairedRows& rows, bool continuous) {
    return std::make_shared<Compose>(composition, rows, continuous);
}

} // namespace rotconv::operations
