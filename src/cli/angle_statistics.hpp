#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace rotconv::cli {

/// Means and percentiles of angles, or of any numbers from 0, at constant memory. Depends on their order only by
/// rounding.
class AngleStatistics {
public:
    void add(double angle);

    [[nodiscard]] std::size_t count() const noexcept { return count_; }
    [[nodiscard]] double mean() const noexcept { return (sum_ + lost_) / static_cast<double>(count_); }
    [[nodiscard]] double root_mean_square() const noexcept;
    /// Dividing by the count.
    [[nodiscard]] double standard_deviation() const noexcept;
    /// By nearest rank: the least angle that at least `percent` in 100 do not exceed. Exact of up to 4,096 angles and
    /// where all are equal, else to 1 part in 1024.
    /// @param percent above 0, to 100
    [[nodiscard]] double percentile(double percent) const noexcept;

private:
    std::vector<double> first_; ///< those of which percentiles are exact
    std::size_t count_ = 0;
    double least_ = 0.0;
    double greatest_ = 0.0;
    double sum_ = 0.0;
    double lost_ = 0.0;
    double mean_ = 0.0;    ///< so far, by Welford's method
    double squares_ = 0.0; ///< of the angles over the greatest so far, as squares of small ones would underflow...
    double spread_ = 0.0;  ///< ...and of their differences from the mean
    std::unordered_map<std::uint64_t, std::uint64_t> counts_; ///< by the first bits
};

} // namespace rotconv::cli
