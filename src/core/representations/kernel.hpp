#pragma once

#include <cstddef>

#include <rotconv/reading.hpp>
#include <rotconv/spec.hpp>

#include "../numerics/quaternion_algebra.hpp"
#include "../numerics/scaled_double_double.hpp"
#include "attitude_batch.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

// Numbers are in the representation's own order, attitudes not yet inverted: of a Spec's conventions the sequence and
// the unit are left to kernels.

/// How rows of a representation, at most `batch_rows`, are read and written in a scalar, double or DoubleDouble. What
/// comes of rows that are not plain, see is_plain_number(), is replaced by what CarefulKernel makes of them; their
/// errors and defects count.
template <class T> struct BatchKernel {
    void (*read)(const Spec& spec, const double* numbers, std::size_t rows, AttitudeBatch<T>& attitudes) noexcept;
    /// Each number is the result in T, rounded once. `rest`: what the results have beside those numbers; may be null.
    /// Diagnostics are what there is to report of each row; the sets are empty at first.
    void (*write)(const Spec& spec, double lock_margin, const AttitudeBatch<T>& attitudes, std::size_t rows,
                  double* numbers, double* rest, DiagnosticSet* diagnostics) noexcept;
};

/// One plain row in double. q is w, x, y, z.
struct RowKernel {
    Error (*read)(const Spec& spec, const double* numbers, double* q, double& defect) noexcept;
    DiagnosticSet (*write)(const Spec& spec, double lock_margin, const double* q, double* numbers) noexcept;
};

/// One row of numbers of any size.
struct CarefulKernel {
    /// Of a row that the other kernels find no error in; a quaternion of any length.
    void (*read)(const Spec& spec, const double* numbers, ScaledDoubleDouble* q) noexcept;
    DiagnosticSet (*write)(const Spec& spec, double lock_margin, const ScaledDoubleDouble* q,
                           ScaledDoubleDouble* numbers) noexcept;
};

/// A quaternion that was given as such, and is unit to 4 eps, is written with its bits; unless something else than a
/// quarter turn has turned it.
template <class T>
[[nodiscard]] ROTCONV_INLINE bool keeps_bits(const AttitudeBatch<T>& attitudes, std::size_t row) noexcept {
    T own[4];
    attitudes.get(row, own);
    const DoubleDouble q[4] = {own[0], own[1], own[2], own[3]};
    const DoubleDouble excess = squared_norm(q) - 1.0;
    constexpr double rounding = 4 * 0x1p-52;
    return attitudes.are_quaternions && attitudes.is_as_given[row] && q[0].lo == 0.0 && q[1].lo == 0.0 &&
           q[2].lo == 0.0 && q[3].lo == 0.0 &&
           __builtin_fabs(excess.hi - rounding * rounding) <= 2.0 * rounding; // | |q| - 1 | <= 4 eps
}

struct Kernel {
    BatchKernel<double> fast;
    BatchKernel<DoubleDouble> exact;
    RowKernel one;
    CarefulKernel careful;
    bool reading_is_exact = false; ///< numbers of any size, but for a power of two
};

#define ROTCONV_LINE(id) extern const Kernel id;
/// One for each line of the table of representations, defined at the end of its source.
namespace kernels {
ROTCONV_REPRESENTATIONS(ROTCONV_LINE)
} // namespace kernels
#undef ROTCONV_LINE

} // namespace ROTCONV_TARGET
} // namespace rotconv
