#pragma once

#include <cstddef>

#include <rotconv/reading.hpp>
#include <rotconv/spec.hpp>

#include "lanes.hpp"

namespace rotconv {

/// A room's two doors for blocks of rows, at most `block` of them, numbers in the representation's own order and the
/// attitude not yet inverted: what is left of the conventions is the sequence and the unit.
struct Door {
    void (*read)(const Spec& spec, const double* numbers, std::size_t rows, Readings& readings) noexcept;
    /// The defect in full, where `read` returns a bound only; null elsewhere.
    double (*exact_defect)(const double* numbers) noexcept;
    /// Also notes what there is to note of each row.
    void (*write)(const Spec& spec, double lock_margin, const Rotations& rotations, std::size_t rows, double* numbers,
                  Notes* notes) noexcept;
    Figures (*figures)(const Spec& spec, const Rotation& rotation) noexcept;

    /// One row.
    [[nodiscard]] Reading read_row(const Spec& spec, const double* numbers) const noexcept {
        Readings one; // NOLINT(*-member-init)
        read(spec, numbers, 1, one);
        return one.reading(0);
    }

    /// One row, with nothing given up to lock.
    void write_row(const Spec& spec, const Rotation& rotation, double* numbers) const noexcept {
        Notes notes;
        write(spec, 0.0, OneRotation(rotation), 1, numbers, &notes);
    }
};

[[nodiscard]] const Door& door_of(Name name) noexcept;

} // namespace rotconv
