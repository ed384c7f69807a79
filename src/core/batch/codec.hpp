#pragma once

#include <cstddef>

#include <rotconv/reading.hpp>
#include <rotconv/spec.hpp>

#include "../representations/rotation_batch.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// How a representation's rows are read and written in a scalar, double or Real; see BatchFunctions.
template <class T> struct ScalarCodec {
    /// Null: reading rounds nothing, or little; by Codec::read.
    void (*read)(const Spec& spec, const double* numbers, std::size_t rows, BasicReadings<T>& readings) noexcept;
    /// Each number is the result in T, rounded once.
    void (*write)(const Spec& spec, double lock_margin, const BasicRotations<T>& rotations, std::size_t rows,
                  double* numbers, DiagnosticSet* diagnostics) noexcept;
};

/// One row in double, for programs that have no more; null: as a batch. `q` is the quaternion w, x, y, z.
struct RowCodec {
    Error (*read)(const Spec& spec, const double* numbers, double* q) noexcept = nullptr;
    DiagnosticSet (*write)(const Spec& spec, double lock_margin, const double* q, double* numbers) noexcept = nullptr;
};

struct BatchCodec {
    ScalarCodec<double> fast;
    ScalarCodec<Real> exact;
    RowCodec one{};
};

#define ROTCONV_LINE(id) extern const BatchCodec id;
/// One for each line of the table of representations, defined at the end of its source.
namespace batch_codecs {
ROTCONV_REPRESENTATIONS(ROTCONV_LINE)
} // namespace batch_codecs
#undef ROTCONV_LINE

/// By Codec::read: attitudes right to rounding, errors and defects.
template <class T>
void read_plain(const Spec& spec, const double* numbers, std::size_t rows, BasicReadings<T>& readings) noexcept;

} // namespace ROTCONV_TARGET
} // namespace rotconv
