#include <memory>
#include <span>
#include <vector>

#include "operations.hpp"

namespace rotconv::operations {
namespace {

class RatesOfNumbers final : public stream::RowOperation {
public:
    RatesOfNumbers(const Spec& spec, const RateSettings& settings, bool sensitivity)
        : rates_(spec, settings), sensitivity_(sensitivity) {
        names = settings.inverse ? velocity_names(settings.degrees) : names_of(spec, "_rate");
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override {
        return std::make_unique<RatesOfNumbers>(*this);
    }

    void run(const stream::NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) override {
        found_.resize(rows.lines.size());
        rates_.run(rows.numbers, out, found_);
        reports.clear();
        for (std::size_t i = 0; i < found_.size(); ++i) {
            const RateReport& rate = found_[i];
            if (sensitivity_ || rate.error != Error::none || !rate.diagnostics.empty()) {
                reports.push_back({.row = i,
                                   .error = rate.error,
                                   .diagnostics = rate.diagnostics,
                                   .defect = rate.defect,
                                   .sensitivity = rate.sensitivity});
            }
        }
    }

private:
    Rates rates_;
    bool sensitivity_;
    std::vector<RateReport> found_;
};

} // namespace

stream::RowNumbers rates_numbers(const Spec& spec, const RateSettings& settings) {
    return {.names = joined(names_of(spec), settings.inverse ? names_of(spec, "_rate") : velocity_names(false)),
            .attitude = spec};
}

Operation rates(const Spec& spec, const RateSettings& settings, bool sensitivity) {
    return std::make_shared<RatesOfNumbers>(spec, settings, sensitivity);
}

} // namespace rotconv::operations
