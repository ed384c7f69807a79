#include "angle_statistics.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rotconv::cli {
namespace {

constexpr unsigned mantissa_bits = 52;
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
    auto& octave = octaves_.at(bits >> mantissa_bits);
    if (!octave) {
        octave = std::make_unique<Octave>();
    }
    ++octave->at(bits >> (mantissa_bits - digits) & (steps - 1));
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
    for (std::uint64_t exponent = 0; exponent < octaves_.size(); ++exponent) {
        for (std::uint64_t i = 0; octaves_.at(exponent) && i < steps; ++i) {
            passed += static_cast<double>(octaves_.at(exponent)->at(i));
            if (passed >= rank) {
                const auto low = (exponent << digits | i) << (mantissa_bits - digits);
                const auto middle = low | std::uint64_t{1} << (mantissa_bits - digits - 1);
                return low == 0 ? 0.0 : std::clamp(std::bit_cast<double>(middle), least_, greatest_);
            }
        }
    }
    return greatest_;
}

} // namespace rotconv::cli
