#pragma once

#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "../stream/decimal.hpp"

namespace rotconv::operations {

/// The times of rows that are accepted.
class Clock {
public:
    explicit Clock(int power) : power_(power), per_second_(stream::Decimal::parse("1")->rounded(-power)) {}

    /// Seconds since the last accepted time, rounded once if times are texts; nan for a time that is not finite.
    double seconds_to(double time, const std::string_view* text) {
        if (!std::isfinite(time)) {
            return std::numeric_limits<double>::quiet_NaN();
        }
        if (text != nullptr) {
            next_text_ = stream::read_time(*text).value;
            is_number_ = text->find_first_of("T:") == std::string_view::npos;
            return stream::Decimal::difference(next_text_, last_text_, power_);
        }
        next_ = time;
        return (next_ - last_) / per_second_;
    }
    /// @param seconds since the time before
    void accept(double seconds, std::size_t line) {
        if (++times_ == 2 && is_number_) {
            first_step_ = {seconds, line};
        }
        std::swap(last_text_, next_text_);
        last_ = next_;
    }
    [[nodiscard]] const auto& first_step() const noexcept { return first_step_; }

private:
    int power_;
    double per_second_;
    stream::Decimal last_text_;
    stream::Decimal next_text_;
    double last_ = 0.0;
    double next_ = 0.0;
    std::size_t times_ = 0;                       ///< that are accepted
    bool is_number_ = true;                       ///< the last one, not ISO 8601
    std::pair<double, std::size_t> first_step_{}; ///< see RowOperation
};

} // namespace rotconv::operations
