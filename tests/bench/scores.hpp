#pragma once

#include <cstddef>
#include <string>

#include "samples.hpp"

namespace bench {

/// What a method did to a sample, or to several.
struct Score {
    std::size_t rows = 0;
    std::size_t not_finite = 0;
    double worst = none; ///< eps; of the finite rows
    double squares = 0.0;
    double relative = none;
    double defect = none;
    std::string where; ///< the first row that is not finite, else the worst

    /// Both together.
    void add(const Score& other);
    [[nodiscard]] double rms() const;
};

Score score(const Sample& sample, const Way& way);

} // namespace bench
