#pragma once

#include <cstddef>

#include <rotconv/euler.hpp>

#include "../numerics/double_double.hpp"

namespace rotconv {

/// The axes i, j, k of a sequence read as turns about fixed axes, the first turn about i. Intrinsic turns are the same
/// turns about fixed axes in reverse order. For a proper sequence k is the axis that does not occur.
struct FixedAxes {
    ROTCONV_INLINE explicit FixedAxes(EulerSequence sequence) noexcept
        : proper(sequence.proper()), first_place(sequence.intrinsic() ? 2 : 0), i(sequence.axis(first_place)),
          j(sequence.axis(1)), k(proper ? 3 - i - j : sequence.axis(2 - first_place)),
          sign((j - i + 3) % 3 == 1 ? 1.0 : -1.0) {}

    bool proper;
    std::size_t first_place; ///< where the angle of the first turn stands among the numbers
    int i, j, k;
    double sign; ///< +1 where (i, j, k) is an even permutation of (x, y, z)
};

} // namespace rotconv
