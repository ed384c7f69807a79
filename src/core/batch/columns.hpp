#pragma once

#include <cstddef>

#include "../numerics/wide.hpp"
#include "codec.hpp"
#include "matrix.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// Whether the squares of products of such numbers keep their low parts: 0, or from 2^-100 to 2^100.
ROTCONV_INLINE bool is_middling(double value) noexcept {
    const double size = __builtin_fabs(value);
    return size == 0.0 || (size >= 0x1p-100 && size <= 0x1p100);
}

/// Reads rows that stand for two columns, by Gram-Schmidt: Formula::directions(const T (&numbers)[Formula::size],
/// T (&first)[3], T (&second)[3]). Errors and defects are those of the plain codec.
template <class Formula>
void read_columns(const Spec& spec, const double* numbers, std::size_t rows, BasicReadings<Real>& readings) noexcept {
    constexpr std::size_t size = Formula::size;
    read_plain(spec, numbers, rows, readings);
    double columns[size][batch_rows];
    to_columns(numbers, rows, columns);
    BasicRotations<Real> exact;
    for (std::size_t i = 0; i < rows; ++i) {
        Real own[size];
        for (std::size_t k = 0; k < size; ++k) {
            own[k] = columns[k][i];
        }
        Real first[3];
        Real second[3];
        Real q[4];
        Formula::directions(own, first, second);
        gram_schmidt(first, second, q);
        exact.set(i, q);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        if (readings.error[i] != Error::none) {
            continue;
        }
        Real q[4];
        exact.get(i, q);
        bool middling = true;
        for (std::size_t k = 0; k < size; ++k) {
            middling = middling && is_middling(numbers[size * i + k]);
        }
        if (!middling) [[unlikely]] {
            Wide own[size];
            for (std::size_t k = 0; k < size; ++k) {
                own[k] = numbers[size * i + k];
            }
            Wide first[3];
            Wide second[3];
            Wide result[4];
            Formula::directions(own, first, second);
            gram_schmidt(first, second, result);
            for (std::size_t k = 0; k < 4; ++k) {
                q[k] = result[k].real();
            }
        }
        const double length = nearly(squared_norm(q));
        if (length >= 0.2 && length <= 2.0) [[likely]] { // else the columns are parallel as far as can be told
            readings.set(i, q);
        }
    }
}

} // namespace ROTCONV_TARGET
} // namespace rotconv
