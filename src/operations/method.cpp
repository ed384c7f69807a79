#include <algorithm>

#include "operations.hpp"

namespace rotconv::operations {
namespace {

class Methods final : public AttitudeOperation {
public:
    Methods(const MethodConversion& conversion, bool all, bool continuous)
        : AttitudeOperation(conversion.to(), continuous), conversion_(conversion) {
        if (all) {
            const auto methods = conversion.names();
            answers.assign(methods.begin(), methods.end());
            const bool is_taken = std::ranges::find(names, "angle") != names.end(); // axis-angle has one
            names.emplace_back(is_taken ? "method_angle" : "angle");
        }
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Methods>(*this); }

    std::size_t run(const stream::NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) override {
        conversion_.run(rows.numbers, out, angles_, reports, !answers.empty());
        return rows.lines.size();
    }

private:
    MethodConversion conversion_;
    std::vector<double> angles_;
};

} // namespace

Operation method(const MethodConversion& conversion, bool all, bool continuous) {
    return std::make_shared<Methods>(conversion, all, continuous);
}

} // namespace rotconv::operations
