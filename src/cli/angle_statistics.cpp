#include "angle_statistics.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

namespace rotconv::cli {
namespace {

constexpr unsigned dropped_bits = 43; // of 52: angles between two powers of two are told apart by 9
constexpr std::size_t most_kept = 4096;

} // namespace

void AngleStatistics::add(double angle) {
    least_ = count_ == 0 ? angle : std::min(least_, angle);
    if (angle > greatest_) {
        const double factor = greatest_ / angle;
        squares_ *= factor * factor;
        spread_ *= factor * factor;
        greatest_ = angle;
    }
    if (count_++ < most_kept) {
        first_.push_back(angle);
    }
    const double sum = sum_ + angle; // Kahan and Neumaier: what each addition loses is kept
    lost_ += sum_ >= angle ? (sum_ - sum) + angle : (angle - sum) + sum_;
    sum_ = sum;
    if (greatest_ > 0.0) {
        const double before = angle - mean_;
        mean_ += before / static_cast<double>(count_);
        squares_ += (angle / greatest_) * (angle / greatest_);
        spread_ += (before / greatest_) * ((angle - mean_) / greatest_);
    }
    const auto bits = std::bit_cast<std::uint64_t>(angle);
    ++counts_[bits >> dropped_bits];
}

double AngleStatistics::root_mean_square() const noexcept {
    return greatest_ * std::sqrt(squares_ / static_cast<double>(count_));
}

double AngleStatistics::standard_deviation() const noexcept {
    return greatest_ * std::sqrt(spread_ / static_cast<double>(count_));
}

double AngleStatistics::percentile(double percent) const noexcept {
    if (count_ == 0) {
        return 0.0;
    }
    // The product may be rounded up from a whole number.
    const double rank = std::ceil(percent / 100.0 * static_cast<double>(count_) * (1.0 - 0x1p-50));
    if (count_ <= most_kept) {
        std::vector<double> angles = first_;
        const auto found = angles.begin() + static_cast<std::ptrdiff_t>(rank) - 1;
        std::ranges::nth_element(angles, found);
        return *found;
    }
    double passed = 0.0;
    for (const auto& [bits, count] : std::map(counts_.begin(), counts_.end())) {
        passed += static_cast<double>(count);
        if (passed >= rank) {
            const std::uint64_t middle = (bits << dropped_bits) | (std::uint64_t{1} << (dropped_bits - 1));
            return bits == 0 ? 0.0 : std::clamp(std::bit_cast<double>(middle), least_, greatest_);
        }
    }
    return greatest_;
}

} // namespace rotconv::cli
