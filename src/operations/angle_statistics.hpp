#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace rotconv::operations {

/// Means and percentiles of angles, or of any numbers from 0, in constant memory. The order of the angles changes only
/// the rounding.
class AngleStatistics {
public:
    void add(double angle) {
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
        const double sum = sum_ + angle; // Kahan and Neumaier: lost_ keeps the rounding of each sum
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

    [[nodiscard]] std::size_t count() const noexcept { return count_; }
    [[nodiscard]] double mean() const noexcept { return (sum_ + lost_) / static_cast<double>(count_); }
    [[nodiscard]] double root_mean_square() const noexcept {
        return greatest_ * std::sqrt(squares_ / static_cast<double>(count_));
    }
    /// The squares are divided by the count.
    [[nodiscard]] double standard_deviation() const noexcept {
        return greatest_ * std::sqrt(spread_ / static_cast<double>(count_));
    }
    /// By nearest rank: the smallest angle that at least `percent` in 100 do not exceed; 0 without angles. Max error: 0
    /// for up to 4,096 angles or equal ones, otherwise 1 part in 1024. Valid range: percent above 0, to 100.
    [[nodiscard]] double percentile(double percent) const {
        if (count_ == 0) {
            return 0.0;
        }
        // The product may be rounded up from a whole number.
        const double rank = std::max(1.0, std::ceil(percent / 100.0 * static_cast<double>(count_) * (1.0 - 0x1p-50)));
        if (count_ <= most_kept) {
            std::vector<double> angles = first_;
            const auto found = angles.begin() + static_cast<std::ptrdiff_t>(rank) - 1;
            std::ranges::nth_element(angles, found);
            return *found;
        }
        std::vector<std::pair<std::uint64_t, std::uint64_t>> counts(counts_.begin(), counts_.end());
        std::ranges::sort(counts);
        double passed = 0.0;
        for (const auto& [bits, count] : counts) {
            passed += static_cast<double>(count);
            if (passed >= rank) {
                const std::uint64_t middle = (bits << dropped_bits) | (std::uint64_t{1} << (dropped_bits - 1));
                return bits == 0 ? 0.0 : std::clamp(std::bit_cast<double>(middle), least_, greatest_);
            }
        }
        return greatest_;
    }

private:
    static constexpr unsigned dropped_bits = 43; // of 52 bits: 9 tell angles between two powers of two apart
    static constexpr std::size_t most_kept = 4096;
    std::vector<double> first_; ///< the first angles, for exact percentiles
    std::size_t count_ = 0;
    double least_ = 0.0;
    double greatest_ = 0.0;
    double sum_ = 0.0;
    double lost_ = 0.0;
    double mean_ = 0.0;    ///< the mean so far, by Welford's method
    double squares_ = 0.0; ///< sum of (angle over the largest so far)^2: small squares would underflow
    double spread_ = 0.0;  ///< the same of their differences from the mean
    std::unordered_map<std::uint64_t, std::uint64_t> counts_; ///< how many angles have the same first bits
};

} // namespace rotconv::operations
