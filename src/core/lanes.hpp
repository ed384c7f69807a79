#pragma once

#include <array>
#include <cstddef>

#include <rotconv/reading.hpp>

/// For a function that loops over lanes: it is compiled twice, for every x86-64 processor and for those with AVX2, and
/// the program's start chooses. Nothing is contracted, so that both give the same bytes.
#ifndef ROTCONV_FOR_EACH_PROCESSOR
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) &&                           \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ROTCONV_FOR_EACH_PROCESSOR __attribute__((target_clones("avx2", "default")))
#else
#define ROTCONV_FOR_EACH_PROCESSOR
#endif
#endif

namespace rotconv {

/// Rows that are worked on together: loops over them vectorise, and what they hold stays in the first cache.
inline constexpr std::size_t block = 128;

/// One number of each row of a block.
using Lane = std::array<double, block>;

/// Takes rows of N numbers apart, since compilers do not gather numbers that stand far from each other.
template <std::size_t N> [[nodiscard]] std::array<Lane, N> to_lanes(const double* numbers, std::size_t rows) noexcept {
    std::array<Lane, N> lanes; // NOLINT(*-member-init): as many rows as there are
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t k = 0; k < N; ++k) {
            lanes[k][i] = numbers[N * i + k];
        }
    }
    return lanes;
}

/// The attitudes of a block; not set at first.
struct Rotations {
    Lane w, x, y, z;

    [[nodiscard]] Rotation at(std::size_t row) const noexcept {
        return Rotation::near_unit(w[row], x[row], y[row], z[row]);
    }

    void set(std::size_t row, const Rotation& rotation) noexcept {
        w[row] = rotation.w();
        x[row] = rotation.x();
        y[row] = rotation.y();
        z[row] = rotation.z();
    }
};

/// A block of one row.
struct OneRotation : Rotations {
    // NOLINTNEXTLINE(*-member-init): the other rows
    explicit OneRotation(const Rotation& rotation) noexcept { set(0, rotation); }
};

/// A block of what numbers describe; see Reading.
struct Readings : Rotations {
    Lane defect;
    std::array<Fault, block> fault;

    void set(std::size_t row, const Reading& reading) noexcept {
        Rotations::set(row, reading.rotation);
        defect[row] = reading.defect;
        fault[row] = reading.fault;
    }

    [[nodiscard]] Reading reading(std::size_t row) const noexcept {
        return {.rotation = at(row), .defect = defect[row], .fault = fault[row]};
    }
};

} // namespace rotconv
