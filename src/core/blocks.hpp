#pragma once

#include <cstddef>

#include <rotconv/angle.hpp>
#include <rotconv/euler.hpp>
#include <rotconv/reading.hpp>

#include "lanes.hpp"

// Doors that work on a block of rows at a time, at most `block` of them, so that arithmetic vectorises. Numbers are in
// the representation's own order.

namespace rotconv {

namespace dcm {
void read(const double* numbers, std::size_t rows, Readings& readings) noexcept;
}

namespace quaternion {
void write(const Rotations& rotations, std::size_t rows, double* numbers, Notes* notes) noexcept;
}

namespace columns {
void read(const double* numbers, std::size_t rows, Readings& readings) noexcept;
}

namespace hopf {
void read(const double* numbers, std::size_t rows, Readings& readings) noexcept;
}

namespace axis_angle {
void write(const Rotations& rotations, std::size_t rows, AngleUnit unit, double* numbers, Notes* notes) noexcept;
}

namespace rotation_vector {
void read(const double* numbers, std::size_t rows, AngleUnit unit, Readings& readings) noexcept;
void write(const Rotations& rotations, std::size_t rows, AngleUnit unit, double* numbers, Notes* notes) noexcept;
} // namespace rotation_vector

namespace cayley {
void write(const Rotations& rotations, std::size_t rows, double* numbers, Notes* notes) noexcept;
}

namespace mrp {
void write(const Rotations& rotations, std::size_t rows, double* numbers, Notes* notes) noexcept;
}

namespace euler {
void write(const Rotations& rotations, std::size_t rows, EulerSequence sequence, AngleUnit unit, double lock_margin,
           double* numbers, Notes* notes) noexcept;
}

} // namespace rotconv
