#pragma once

#include "kernels.hpp"
#include "numerics/approximate.hpp"
#include "numerics/power_of_two.hpp"
#include "numerics/quaternion_algebra.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

// Rows whose small numbers are so small that whatever comes of them is linear in them, and the rest does not depend on
// them: with these numbers scaled by a power of two, all small numbers of the attitude and of the result are. So such
// rows are plain, once scaled. A small number is then in [2^-150, 2^-136), any other 0 or of size 2^-10 to 2^10, and
// the defect is small. Of what comes of them a number of first order is at least 2^-155 if it is taken for one, those
// of second order are below 2^-272 times the curvature of the formulas, which is below 2^10: less than the last digit
// of a DoubleDouble. Numbers that are neither of first order nor as large as the others, and changes of large ones by
// cancellation, lead to other sizes, and the row is left to Careful.

inline bool is_ordinary(double size) noexcept { return size == 0.0 || (size >= 0x1p-10 && size <= 0x1p10); }

/// The power of two that scales them; 0 if the row is not one of these.
inline double linear_scale(const ConversionBatch& batch, const double* numbers, double defect) noexcept {
    const bool mixes = batch.fixed->has_left || batch.fixed->has_right; // which mix small components with large ones
    // Between the sizes before and after, or at the middle between two locks, small numbers decide what is locked.
    const bool locks_clearly = batch.lock_margin == 0.0 || (batch.lock_margin >= 0x1p-100 && batch.lock_margin <= 1.0);
    double largest = 0.0;
    double least = 1.0;
    for (std::size_t k = 0; k < batch.from->size(); ++k) {
        const double size = __builtin_fabs(numbers[k]);
        if (!is_ordinary(size)) {
            largest = larger_of(largest, size);
            least = size < least ? size : least;
        }
    }
    const double scale = unit_scale(largest) * 0x1p-136;
    return !mixes && locks_clearly && defect <= reported_defect && largest > 0.0 && largest < 0x1p-112 &&
                   least * scale >= 0x1p-150
               ? scale
               : 0.0;
}

/// Whether it does not depend on an error of the results to which double they round. Errors are far below this bound,
/// but decide where outer angles have a sum halfway between two doubles, as that of two doubles often has.
inline bool round_clearly(const double* results, const double* lows, std::size_t count) noexcept {
    bool all = true;
    for (std::size_t k = 0; k < count; ++k) {
        all = all && rounds_alike({results[k], lows[k]}, 0x1p-95 * __builtin_fabs(results[k]));
    }
    return all;
}

/// Takes the scale out of an attitude and its results; false if they are not all of the sizes that it can be taken out
/// of, or if large components have cancelled: in the diagonal of the matrix, or to a small result where no component is
/// small.
inline bool unscale(double scale, double (&q)[4], double* results, std::size_t count) noexcept {
    bool has_small = false;
    const auto unscale_one = [&](double& number) {
        const double size = __builtin_fabs(number);
        if (size >= 0x1p-155 && size < 0x1p-120) {
            has_small = true;
            number /= scale;
            return __builtin_fabs(number) >= 0x1p-1022;
        }
        if (size > 0x1p120 && size <= 0x1p155) { // cayley, near a half-turn
            number *= scale;
            return __builtin_fabs(number) < __builtin_inf();
        }
        return size == 0.0 || (size >= 0x1p-20 && size <= 0x1p20);
    };
    bool all = true;
    const double to_unit = unit_scale(largest_magnitude(q[0], q[1], q[2], q[3])); // as read_carefully()
    for (double& component : q) {
        component *= to_unit;
        all = all && unscale_one(component);
    }
    const bool may_be_small = has_small;
    double matrix[9];
    scaled_matrix_of(q, matrix);
    for (std::size_t k = 0; k < 9; k += 4) {
        all = all && __builtin_fabs(matrix[k]) >= 0x1p-20;
    }
    for (std::size_t k = 0; k < count; ++k) {
        all = all && unscale_one(results[k]);
    }
    return all && may_be_small == has_small;
}

} // namespace ROTCONV_TARGET
} // namespace rotconv
