#pragma once

#include <cstddef>

#include "double_double.hpp"

/// For a function that loops over columns of numbers: it is compiled twice, for every x86-64 processor and for those
/// with AVX2, and the program's start chooses. Nothing is contracted, so that both give the same bytes.
#ifndef ROTCONV_TARGET_CLONES
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) &&                           \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ROTCONV_TARGET_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define ROTCONV_TARGET_CLONES
#endif
#endif

namespace rotconv {

// NOLINTBEGIN(*-avoid-c-arrays): nothing inline of the standard library goes into sources of several targets

/// Rows that are worked on together: loops over them vectorise, and what they hold stays in the first cache.
inline constexpr std::size_t batch_rows = 128;

/// One number of each row of a batch; not set at first.
template <class T> struct Column;

template <> struct Column<double> {
    double hi[batch_rows];

    ROTCONV_INLINE double operator[](std::size_t row) const noexcept { return hi[row]; }
    ROTCONV_INLINE double& operator[](std::size_t row) noexcept { return hi[row]; }
    ROTCONV_INLINE void set(std::size_t row, double value) noexcept { hi[row] = value; }
};

template <> struct Column<DoubleDouble> {
    double hi[batch_rows];
    double lo[batch_rows];

    ROTCONV_INLINE DoubleDouble operator[](std::size_t row) const noexcept { return {hi[row], lo[row]}; }
    ROTCONV_INLINE void set(std::size_t row, DoubleDouble value) noexcept {
        hi[row] = value.hi;
        lo[row] = value.lo;
    }
};

using BatchColumn = Column<double>;

/// Takes rows of N numbers apart, since compilers do not gather numbers that stand far from each other.
template <std::size_t N>
ROTCONV_INLINE void to_columns(const double* numbers, std::size_t rows, double (&columns)[N][batch_rows]) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t k = 0; k < N; ++k) {
            columns[k][i] = numbers[N * i + k];
        }
    }
}

// NOLINTEND(*-avoid-c-arrays)

} // namespace rotconv
