#pragma once

#include <array>
#include <cstddef>

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

/// Rows that are worked on together: loops over them vectorise, and what they hold stays in the first cache.
inline constexpr std::size_t batch_rows = 128;

/// One number of each row of a batch.
using BatchColumn = std::array<double, batch_rows>;

/// Takes rows of N numbers apart, since compilers do not gather numbers that stand far from each other.
template <std::size_t N>
[[nodiscard]] std::array<BatchColumn, N> to_columns(const double* numbers, std::size_t rows) noexcept {
    std::array<BatchColumn, N> columns; // NOLINT(*-member-init): as many rows as there are
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t k = 0; k < N; ++k) {
            columns[k][i] = numbers[N * i + k];
        }
    }
    return columns;
}

} // namespace rotconv
