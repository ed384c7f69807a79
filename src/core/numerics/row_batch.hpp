#pragma once

#include <cstddef>
#include <cstdint>

#include "double_double.hpp"

namespace rotconv {

// NOLINTBEGIN(*-avoid-c-arrays): nothing inline of the standard library goes into sources of several targets

/// Rows that are worked on together: loops over them vectorise, and what they hold stays in the first cache.
inline constexpr std::size_t batch_rows = 128;

/// One number of each row of a batch, a scalar of two parts; not set at first.
template <class T> struct Column {
    double hi[batch_rows];
    double lo[batch_rows];

    ROTCONV_INLINE T operator[](std::size_t row) const noexcept { return {hi[row], lo[row]}; }
    ROTCONV_INLINE void set(std::size_t row, T value) noexcept {
        hi[row] = value.hi;
        lo[row] = value.lo;
    }
};

template <> struct Column<double> {
    double hi[batch_rows];

    ROTCONV_INLINE double operator[](std::size_t row) const noexcept { return hi[row]; }
    ROTCONV_INLINE void set(std::size_t row, double value) noexcept { hi[row] = value; }
};

/// N numbers of each row.
template <class T, std::size_t N> struct Columns {
    Column<T> columns[N];

    ROTCONV_INLINE Column<T>& operator[](std::size_t k) noexcept { return columns[k]; }
    ROTCONV_INLINE const Column<T>& operator[](std::size_t k) const noexcept { return columns[k]; }
    ROTCONV_INLINE void set(std::size_t row, const T (&numbers)[N]) noexcept {
        for (std::size_t k = 0; k < N; ++k) {
            columns[k].set(row, numbers[k]);
        }
    }
    ROTCONV_INLINE void get(std::size_t row, T (&numbers)[N]) const noexcept {
        for (std::size_t k = 0; k < N; ++k) {
            numbers[k] = columns[k][row];
        }
    }
};

/// Takes rows of N numbers apart, since compilers do not gather numbers that stand far from each other.
template <std::size_t N>
ROTCONV_INLINE void to_columns(const double* numbers, std::size_t rows, Columns<double, N>& columns) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t k = 0; k < N; ++k) {
            columns[k].hi[i] = numbers[N * i + k];
        }
    }
}

/// And puts them together.
template <class T, std::size_t N>
ROTCONV_INLINE void to_rows(const Columns<T, N>& columns, std::size_t rows, double* numbers) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t k = 0; k < N; ++k) {
            numbers[N * i + k] = columns[k].hi[i];
        }
    }
}

/// Whether all numbers are so. No branch, and bits of a double's size: the loop vectorises.
template <class Function>
ROTCONV_INLINE bool all(const double* numbers, std::size_t count, const Function& is_so) noexcept {
    std::uint64_t others = 0;
    for (std::size_t i = 0; i < count; ++i) {
        others |= is_so(numbers[i]) ? 0U : 1U;
    }
    return others == 0;
}

// NOLINTEND(*-avoid-c-arrays)

} // namespace rotconv
