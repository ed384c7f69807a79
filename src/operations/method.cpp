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
            const bool is_taken = std::ranges::find(names, "angle") != names.end(); // by axis-angle
            names.emplace_back(is_taken ? "method_angle" : "angle");
        }
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Methods>(*this); }

    void run(const stream::NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) override {
        if (answers.empty()) {
            conversion_.run(rows.numbers, out, angles_, reports);
            return;
        }
        const std::size_t size = conversion_.to().size();
        numbers_.resize(out.size() / (size + 1) * size);
        conversion_.run(rows.numbers, numbers_, angles_, reports);
        for (std::size_t i = 0; i < angles_.size(); ++i) {
            std::copy_n(numbers_.data() + i * size, size, out.data() + i * (size + 1));
            out[i * (size + 1) + size] = angles_[i];
        }
    }

private:
    MethodConversion conversion_;
    std::vector<double> angles_;
    std::vector<double> numbers_;
};

} // namespace

Operation method(const MethodConversion& conversion, bool all, bool continuous) {
    return std::make_shared<Methods>(conversion, all, continuous);
}

} // namespace rotconv::operations
