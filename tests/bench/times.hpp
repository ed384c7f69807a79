#pragma once

#include <map>
#include <string>
#include <vector>

#include "ways.hpp"

namespace bench {

/// Nanoseconds a row.
class Times {
public:
    /// Times every way of every pair, on a block that stays in cache and on a million rows, clean and hostile.
    explicit Times(const std::vector<Pair>& pairs);

    /// nan where the pair has no such way.
    [[nodiscard]] double of(const Pair& pair, const std::string& way, bool hostile, bool all) const;

private:
    std::map<std::string, double> times_;
};

} // namespace bench
