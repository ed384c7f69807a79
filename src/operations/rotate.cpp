#include "operations.hpp"

namespace rotconv::operations {
namespace {

class Rotate final : public stream::RowOperation {
public:
    explicit Rotate(const VectorRotation& rotation) : rotation_(rotation) {
        names = {"x", "y", "z"};
        keeps_names = true;
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Rotate>(*this); }

    std::size_t run(const stream::NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) override {
        rotation_.run(rows.numbers, out, reports);
        return rows.lines.size();
    }

private:
    VectorRotation rotation_;
};

} // namespace

stream::RowNumbers rotation_numbers(const Spec& spec) {
    return {.names = joined(names_of(spec), {"x", "y", "z"}), .attitude = spec};
}

Operation rotate(const VectorRotation& rotation) { return std::make_shared<Rotate>(rotation); }

} // namespace rotconv::operations
