#pragma once

#include <cstddef>

#include <rotconv/reading.hpp>
#include <rotconv/spec.hpp>

namespace rotconv {

/// A room's two doors for blocks of rows, numbers in the representation's own order and the attitude not yet inverted:
/// what is left of the conventions is the sequence and the unit.
struct Door {
    void (*read)(const Spec& spec, const double* numbers, std::size_t rows, Reading* readings) noexcept;
    /// The defect in full, where `read` returns a bound only; null elsewhere.
    double (*exact_defect)(const double* numbers) noexcept;
    void (*write)(const Spec& spec, double lock_margin, const Reading* readings, std::size_t rows,
                  double* numbers) noexcept;
    /// Null where a representation has none.
    Notes (*notes)(const Spec& spec, double lock_margin, const Rotation& rotation) noexcept;
    Figures (*figures)(const Spec& spec, const Rotation& rotation) noexcept;
};

[[nodiscard]] const Door& door_of(Name name) noexcept;

} // namespace rotconv
