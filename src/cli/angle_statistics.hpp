#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
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
    /// Angles between two powers of two, by their first digits in base 2.
    static constexpr unsigned digits = 9;
    static constexpr std::uint64_t steps = 1U << digits;
    using Octave = std::array<std::uint64_t, steps>;

    std::vector<double> first_; ///< as many as that
    std::size_t count_ = 0;
    double least_ = 0.0;
    double greatest_ = 0.0;
    double sum_ = 0.0;
    double lost_ = 0.0;
    double mean_ = 0.0;    ///< so far, by Welford's method
    double squares_ = 0.0; ///< of the angles over the greatest so far, as squares of small ones would underflow...
    double spread_ = 0.0;  ///< ...and of their differences from the mean
    std::array<std::unique_ptr<Octave>, 2048> octaves_; ///< by the exponent
};

} // namespace rotconv::cli
