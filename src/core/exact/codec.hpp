#pragma once

#include <cstddef>

#include <rotconv/reading.hpp>
#include <rotconv/spec.hpp>

#include "rotations.hpp"

namespace rotconv::ROTCONV_EXACT {

/// How a representation's rows are read and written to the last bit; numbers are in the representation's own order. A
/// function that is null is that of the plain codec.
struct ExactCodec {
    /// Reads a batch of rows, at most `batch_rows` of them.
    void (*read)(const Spec& spec, const double* numbers, std::size_t rows, Readings& readings) noexcept = nullptr;
    /// Writes a batch of rows, each number rounded once, and finds what there is to remark on each; the sets are empty
    /// at first.
    void (*write)(const Spec& spec, double lock_margin, const Rotations& rotations, std::size_t rows, double* numbers,
                  DiagnosticSet* diagnostics) noexcept = nullptr;
};

#define ROTCONV_LINE(id) extern const ExactCodec id;
/// One for each line of the table of representations, defined at the end of its source.
namespace codecs {
ROTCONV_REPRESENTATIONS(ROTCONV_LINE)
} // namespace codecs
#undef ROTCONV_LINE

/// What the plain codec makes of the numbers: attitudes right to rounding, errors and defects.
void read_plain(const Spec& spec, const double* numbers, std::size_t rows, Readings& readings) noexcept;

} // namespace rotconv::ROTCONV_EXACT
