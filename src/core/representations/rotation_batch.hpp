#pragma once

#include <array>
#include <cstddef>

#include <rotconv/reading.hpp>

#include "../numerics/row_batch.hpp"

namespace rotconv {

/// The attitudes of a batch; not set at first.
struct Rotations {
    BatchColumn w, x, y, z;

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

/// A batch of one row.
struct OneRotation : Rotations {
    // NOLINTNEXTLINE(*-member-init): the other rows
    explicit OneRotation(const Rotation& rotation) noexcept { set(0, rotation); }
};

/// A batch of what numbers describe; see Reading.
struct Readings : Rotations {
    BatchColumn defect;
    std::array<Error, batch_rows> error;

    void set(std::size_t row, const Reading& reading) noexcept {
        Rotations::set(row, reading ? *reading : Rotation()); // something finite in any case
        defect[row] = reading.defect();
        error[row] = reading.error();
    }

    [[nodiscard]] Reading reading(std::size_t row) const noexcept {
        return error[row] == Error::none ? Reading(at(row), defect[row]) : Reading(error[row]);
    }
};

} // namespace rotconv
