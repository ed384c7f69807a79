#include "operations.hpp"

namespace rotconv::operations {
namespace {

class Sample final : public stream::RowOperation {
public:
    Sample(const Spec& spec, const SampleSettings& settings) : sampler_(spec, settings) {
        names = names_of(spec);
        attitudes = {spec};
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Sample>(*this); }

    std::size_t run(const stream::NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) override {
        reports.clear();
        sampler_.run(rows.numbers, out);
        return rows.lines.size();
    }

private:
    Sampler sampler_;
};

} // namespace

Operation sample(const Spec& spec, const SampleSettings& settings) { return std::make_shared<Sample>(spec, settings); }

} // namespace rotconv::operations
