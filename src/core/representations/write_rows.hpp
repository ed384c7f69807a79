#pragma once

#include <cstddef>

#include "../numerics/quaternion_algebra.hpp"
#include "attitude_batch.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// Writes rows by a formula over a scalar: Formula::apply(const T (&q)[4], T (&numbers)[Formula::size]).
template <class Formula, class T>
void write_rows(const AttitudeBatch<T>& attitudes, std::size_t rows, double* numbers) noexcept {
    constexpr std::size_t size = Formula::size;
    double columns[size][batch_rows];
    for (std::size_t i = 0; i < rows; ++i) {
        T own[4];
        T result[size];
        attitudes.get(i, own);
        Formula::apply(own, result);
        for (std::size_t k = 0; k < size; ++k) {
            columns[k][i] = to_double(result[k]);
        }
    }
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t k = 0; k < size; ++k) {
            numbers[size * i + k] = columns[k][i];
        }
    }
}

/// One row by the same formula. There is nothing to report of it.
template <class Formula, class T>
DiagnosticSet write_row_by(const Spec& /*spec*/, double /*lock_margin*/, const T* q, T* numbers) noexcept {
    const T own[4] = {q[0], q[1], q[2], q[3]};
    T result[Formula::size];
    Formula::apply(own, result);
    for (std::size_t k = 0; k < Formula::size; ++k) {
        numbers[k] = result[k];
    }
    return {};
}

/// BatchKernel::write of such a formula.
template <class Formula, class T>
void write_rows_by(const Spec& /*spec*/, double /*lock_margin*/, const AttitudeBatch<T>& attitudes, std::size_t rows,
                   double* numbers, double* /*rest*/, DiagnosticSet* /*diagnostics*/) noexcept {
    write_rows<Formula>(attitudes, rows, numbers);
}

} // namespace ROTCONV_TARGET
} // namespace rotconv
