#include "eigensystem.hpp"

#include <algorithm>
#include <utility>

namespace rotconv {

void diagonalize(double* matrix, std::ptrdiff_t size, double* values, double* vectors) noexcept {
    const auto entry = [&](std::ptrdiff_t i, std::ptrdiff_t k) -> double& { return matrix[i + size * k]; };
    // Makes an entry 0; false where it is as good as 0.
    const auto rotate = [&](std::ptrdiff_t i, std::ptrdiff_t k) {
        const double a = entry(i, i);
        const double b = entry(k, k);
        const double c = entry(i, k);
        if (!(std::fabs(c) > 0x1p-54 * std::sqrt(std::fabs(a * b)))) {
            return false;
        }
        const PlaneRotation rotation(a, b, c);
        rotation(&entry(0, i), &entry(0, k), size);
        rotation(&entry(i, 0), &entry(k, 0), size, size);
        rotation(vectors + size * i, vectors + size * k, size);
        entry(i, i) = a - rotation.tangent * c;
        entry(k, k) = b + rotation.tangent * c;
        entry(i, k) = entry(k, i) = 0.0;
        return true;
    };
    constexpr int most_sweeps = 30;
    bool diagonal = false;
    for (int sweep = 0; sweep < most_sweeps && !diagonal; ++sweep) {
        diagonal = true;
        for (std::ptrdiff_t i = 0; i < size - 1; ++i) {
            for (std::ptrdiff_t k = i + 1; k < size; ++k) {
                diagonal = !rotate(i, k) && diagonal;
            }
        }
    }
    for (std::ptrdiff_t i = 0; i < size; ++i) {
        values[i] = entry(i, i);
    }
    for (std::ptrdiff_t i = 0; i < size - 1; ++i) {
        const auto least = std::min_element(values + i, values + size) - values;
        std::swap(values[i], values[least]);
        if (least != i) {
            std::swap_ranges(vectors + size * i, vectors + size * (i + 1), vectors + size * least);
        }
    }
}

} // namespace rotconv
