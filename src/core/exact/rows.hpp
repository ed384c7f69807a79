#pragma once

#include <cstddef>

#include "rotations.hpp"
#include "wide.hpp"

namespace rotconv::ROTCONV_EXACT {

inline bool is_ordinary_row(const Rotations& q, std::size_t row) noexcept {
    return is_ordinary(q.w.hi[row]) && is_ordinary(q.x.hi[row]) && is_ordinary(q.y.hi[row]) && is_ordinary(q.z.hi[row]);
}

/// Writes rows by a formula over a scalar: Formula::apply(const T (&q)[4], T (&numbers)[Formula::size]).
template <class Formula> void write_rows(const Rotations& q, std::size_t rows, double* numbers) noexcept {
    constexpr std::size_t size = Formula::size;
    double columns[size][batch_rows];
    for (std::size_t i = 0; i < rows; ++i) {
        const Real own[4] = {q.w[i], q.x[i], q.y[i], q.z[i]};
        Real result[size];
        Formula::apply(own, result);
        for (std::size_t k = 0; k < size; ++k) {
            columns[k][i] = result[k].hi;
        }
    }
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t k = 0; k < size; ++k) {
            numbers[size * i + k] = columns[k][i];
        }
        if (!is_ordinary_row(q, i)) [[unlikely]] {
            const Wide own[4] = {q.w[i], q.x[i], q.y[i], q.z[i]};
            Wide result[size];
            Formula::apply(own, result);
            for (std::size_t k = 0; k < size; ++k) {
                numbers[size * i + k] = result[k].rounded();
            }
        }
    }
}

} // namespace rotconv::ROTCONV_EXACT
