#include <memory>
#include <span>
#include <vector>

#include <rotconv/continuous.hpp>

#include "operations.hpp"

namespace rotconv::operations {
namespace {

class Convert final : public stream::RowOperation {
public:
    Convert(const Conversion& conversion, bool continuous)
        : conversion_(conversion), numbers_(std::make_shared<ContinuousNumbers>(conversion.to())) {
        names = names_of(conversion.to());
        attitude = conversion.to();
        is_continuous = continuous && numbers_->have_choice();
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Convert>(*this); }

    void run(const stream::NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) override {
        rest_.resize(is_continuous ? out.size() : 0);
        conversion_.run(rows.numbers, out, reports, rest_);
    }
    void make_continuous(std::span<double> results, std::span<const RowReport> reports) override {
        numbers_->run(results, reports, rest_);
    }

private:
    Conversion conversion_;
    std::shared_ptr<ContinuousNumbers> numbers_; ///< of all threads
    std::vector<double> rest_;                   ///< what the exact numbers have beside the results
};

} // namespace

stream::RowNumbers attitude_numbers(const Spec& spec, bool with_key) {
    return {.names = with_key ? joined({"key"}, names_of(spec)) : names_of(spec),
            .attitude = spec,
            .kept = with_key ? std::size_t{1} : 0};
}

Operation convert(const Conversion& conversion, bool continuous) {
    return std::make_shared<Convert>(conversion, continuous);
}

} // namespace rotconv::operations
