#pragma once

#include <cstddef>

#include <rotconv/angle.hpp>
#include <rotconv/euler.hpp>
#include <rotconv/reading.hpp>

#include "../numerics/row_batch.hpp"

// Reading and writing of a batch of rows at a time, at most `batch_rows` of them, so that arithmetic vectorises.
// Numbers are in the representation's own order.

namespace rotconv {

namespace dcm {
void read(const double* numbers, std::size_t rows, Readings& readings) noexcept;
}

namespace quaternion {
void write(const Rotations& rotations, std::size_t rows, double* numbers, DiagnosticSet* diagnostics) noexcept;
}

namespace two_column {
void read(const double* numbers, std::size_t rows, Readings& readings) noexcept;
}

namespace five_d {
void read(const double* numbers, std::size_t rows, Readings& readings) noexcept;
}

namespace axis_angle {
void write(const Rotations& rotations, std::size_t rows, AngleUnit unit, double* numbers,
           DiagnosticSet* diagnostics) noexcept;
}

namespace rotation_vector {
void read(const double* numbers, std::size_t rows, AngleUnit unit, Readings& readings) noexcept;
void write(const Rotations& rotations, std::size_t rows, AngleUnit unit, double* numbers,
           DiagnosticSet* diagnostics) noexcept;
} // namespace rotation_vector

namespace cayley {
void write(const Rotations& rotations, std::size_t rows, double* numbers, DiagnosticSet* diagnostics) noexcept;
}

namespace mrp {
void write(const Rotations& rotations, std::size_t rows, double* numbers, DiagnosticSet* diagnostics) noexcept;
}

namespace euler {
void write(const Rotations& rotations, std::size_t rows, EulerSequence sequence, AngleUnit unit, double lock_margin,
           double* numbers, DiagnosticSet* diagnostics) noexcept;
}

} // namespace rotconv
