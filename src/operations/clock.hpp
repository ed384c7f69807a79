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
    /// @param power times that are no keys are in units of 10^power seconds
    explicit Clock(int power) : per_second_(std::pow(10.0, -power)) {}

    /// Seconds from the last accepted time to that of a row, which is kept; nan if it is not finite. Rounded once if
    /// both times are keys.
    double seconds_to(const stream::NumberRows& rows, std::size_t row) {
        next_ = rows.kept[row];
        const auto& [next, error] = next_.key;
        const stream::Key last = last_.key.value;
        if (error != stream::KeyError::none || last_.key.error != stream::KeyError::none) {
            const double units = number_of(next_) - number_of(last_);
            return std::isfinite(number_of(next_)) ? units / per_second_ : std::numeric_limits<double>::quiet_NaN();
        }
        const double seconds = distance(next, last).rounded();
        return next < last ? -seconds : seconds;
    }
    /// @param seconds those since the previous time
    void accept(double seconds, std::size_t line) {
        const bool is_number = next_.text.find_first_of("T:") == std::string_view::npos; // not ISO 8601
        if (++times_ == 2 && is_number) {
            *first_step_ = {seconds, line};
        }
        last_ = next_;
    }
    /// See stream::RowOperation; copies share it.
    [[nodiscard]] const auto& first_step() const noexcept { return first_step_; }

private:
    [[nodiscard]] double number_of(const stream::Kept& time) const {
        return time.key.error == stream::KeyError::none ? time.key.value.rounded() * per_second_ : time.number;
    }

    double per_second_;
    stream::Kept last_{.key = {}};
    stream::Kept next_{};
    std::size_t times_ = 0; ///< number of accepted times
    std::shared_ptr<std::pair<double, std::size_t>> first_step_ = std::make_shared<std::pair<double, std::size_t>>();
};

} // namespace rotconv::operations
