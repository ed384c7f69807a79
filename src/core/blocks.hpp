#pragma once

#include <cstddef>

#include <rotconv/angle.hpp>
#include <rotconv/euler.hpp>
#include <rotconv/reading.hpp>

// Doors that work on a block of rows at a time, at most `block` of them: where an angle is taken, the arithmetic before
// and after it vectorises. Numbers are in the representation's own order.

namespace rotconv {

namespace dcm {
void read(const double* numbers, std::size_t rows, Reading* readings) noexcept;
}

namespace axis_angle {
void write(const Rotation* rotations, std::size_t rows, AngleUnit unit, double* numbers, Notes* notes) noexcept;
}

namespace rotation_vector {
void read(const double* numbers, std::size_t rows, AngleUnit unit, Reading* readings) noexcept;
void write(const Rotation* rotations, std::size_t rows, AngleUnit unit, double* numbers, Notes* notes) noexcept;
} // namespace rotation_vector

namespace euler {
void write(const Rotation* rotations, std::size_t rows, EulerSequence sequence, AngleUnit unit, double lock_margin,
           double* numbers, Notes* notes) noexcept;
}

} // namespace rotconv
