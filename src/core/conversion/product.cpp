#include <rotconv/product.hpp>

#include <memory>

#include "input_batch.hpp"
#include "kernels.hpp"

namespace rotconv {

// NOLINTNEXTLINE(modernize-pass-by-value): the other arguments are references, too
Composition::Composition(const Spec& first, const Spec& second, const Spec& to, const ConversionSettings& settings)
    : first_(checked(first)), second_(checked(second)), to_(checked(to)), settings_(settings),
      zeros_(std::make_shared<ZeroTable>()) {}

Composition Composition::interpolating() const {
    Composition other = *this;
    other.interpolates_ = true;
    other.zeros_ = std::make_shared<ZeroTable>();
    return other;
}

void Composition::run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports,
                      std::span<double> rest) const {
    run_task({.first = &first_, .to = &to_, .zeros = zeros_.get(), .second = &second_}, settings_, interpolates_, in,
             out, reports, rest);
}

void Composition::again(std::span<const double> row, std::span<double> numbers, std::span<double> rest) const {
    std::vector<RowReport> reports;
    const std::size_t rest_size = rest.size() / to_.size();
    run_task({.first = &first_, .to = &to_, .zeros = zeros_.get(), .rest_size = rest_size, .second = &second_},
             settings_, interpolates_, row, numbers, reports, rest);
}

// NOLINTNEXTLINE(modernize-pass-by-value): the other arguments are references, too
VectorRotation::VectorRotation(const Spec& from, const ConversionSettings& settings)
    : from_(checked(from)), settings_(settings), zeros_(std::make_shared<ZeroTable>()) {}

void VectorRotation::run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports) const {
    run_task({.first = &from_, .zeros = zeros_.get()}, settings_, false, in, out, reports, {});
}

} // namespace rotconv
