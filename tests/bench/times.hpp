#pragma once

#include <map>
#include <string>
#include <vector>

#include "ways.hpp"

namespace bench {

/// Nanoseconds a row.
class Times {
public:
    /// Times every way of every pair on a block that stays in cache: uniform attitudes, clean and hostile, small
    /// angles, near half-turns and near gimbal lock. The uniform ones also by the million.
    explicit Times(const std::vector<Pair>& pairs);

    /// On "clean" or "hostile" rows or on those of a kind; nan where it was not timed.
    [[nodiscard]] double of(const Pair& pair, const std::string& way, const std::string& rows, bool all) const;

private:
    std::map<std::string, double> times_;
};

} // namespace bench
