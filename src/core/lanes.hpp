#pragma once

#include <array>
#include <cstddef>

#include <rotconv/reading.hpp>

namespace rotconv {

/// Rows that are worked on together: loops over them vectorise, and what they hold stays in the first cache.
inline constexpr std::size_t block = 128;

/// One number of each row of a block.
using Lane = std::array<double, block>;

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
    explicit OneRotation(const Rotation& rotation) noexcept {
        set(0, rotation);
    } // NOLINT(*-member-init): the other rows
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
