#include "operations.hpp"

namespace rotconv::operations {
namespace {

class RatesOfNumbers final : public stream::RowOperation {
public:
    RatesOfNumbers(const Spec& spec, const RateSettings& settings) : rates_(spec, settings) {
        names = settings.inverse ? velocity_names(settings.degrees) : names_of(spec, "_rate");
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override {
        return std::make_unique<RatesOfNumbers>(*this);
    }

    std::size_t run(const stream::NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) override {
        rates_.run(rows.numbers, out, reports);
        return rows.lines.size();
    }

private:
    Rates rates_;
};

} // namespace

stream::RowNumbers rates_numbers(const Spec& spec, const RateSettings& settings) {
    return {.names = joined(names_of(spec), settings.inverse ? names_of(spec, "_rate") : velocity_names(false)),
            .attitude = spec};
}

Operation rates(const Spec& spec, const RateSettings& settings) {
    return std::make_shared<RatesOfNumbers>(spec, settings);
}

} // namespace rotconv::operations
