#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>

#include "../stream/pairs/key.hpp"
#include "../stream/rows/row_operation.hpp"

namespace rotconv::operations {

/// The times of rows that are accepted.
class Clock {
public:
    explicit Clock(int power) : power_(power), per_second_(std::pow(10.0, -power)) {}

    /// Seconds from the last accepted time to that of a row, its kept number; nan if it is not finite. Rounded once if
    /// both times are keys.
    double seconds_to(const stream::NumberRows& rows, std::size_t row) {
        const double time = rows.kept[row];
        if (!std::isfinite(time)) {
            return std::numeric_limits<double>::quiet_NaN();
        }
        next_ = time;
        next_key_ = rows.keys.empty() ? no_key : stream::read_key(rows.keys[row], power_);
        is_number_ = rows.keys.empty() || rows.keys[row].find_first_of("T:") == std::string_view::npos;
        if (next_key_.error != stream::KeyError::none || last_key_.error != stream::KeyError::none) {
            return (next_ - last_) / per_second_;
        }
        const double seconds = distance(next_key_.value, last_key_.value).rounded();
        return next_key_.value < last_key_.value ? -seconds : seconds;
    }
    /// @param seconds those since the previous time
    void accept(double seconds, std::size_t line) {
        if (++times_ == 2 && is_number_) {
            *first_step_ = {seconds, line};
        }
        last_key_ = next_key_;
        last_ = next_;
    }
    /// See stream::RowOperation; copies share it.
    [[nodiscard]] const auto& first_step() const noexcept { return first_step_; }

private:
    static constexpr stream::ReadKey no_key{.error = stream::KeyError::not_a_number};
    int power_;
    double per_second_;
    stream::ReadKey last_key_{};
    stream::ReadKey next_key_{};
    double last_ = 0.0;
    double next_ = 0.0;
    std::size_t times_ = 0; ///< number of accepted times
    bool is_number_ = true; ///< the last time is a number, not ISO 8601
    std::shared_ptr<std::pair<double, std::size_t>> first_step_ = std::make_shared<std::pair<double, std::size_t>>();
};

} // namespace rotconv::operations
