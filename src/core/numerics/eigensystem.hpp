#pragma once

#include <cmath>
#include <cstddef>

#include <Eigen/Core>

namespace rotconv {

/// The rotation in a plane that makes the matrix ((a, c), (c, b)) diagonal, by at most 45 degrees.
struct PlaneRotation {
    PlaneRotation(double a, double b, double c) noexcept
        : tangent(tangent_of((b - a) / (2.0 * c))), cosine(1.0 / std::sqrt(1.0 + tangent * tangent)) {}

    /// Turns two lines of so many numbers, each `step` after the one before.
    void operator()(double* first, double* second, std::ptrdiff_t size, std::ptrdiff_t step = 1) const noexcept {
        for (std::ptrdiff_t i = 0; i < size; ++i, first += step, second += step) {
            const double old = *first;
            *first = cosine * (old - tangent * *second);
            *second = cosine * (*second + tangent * old);
        }
    }

    /// The tangent of the smaller angle of which twice has this cotangent.
    static double tangent_of(double cotangent) noexcept {
        return std::copysign(1.0, cotangent) / (std::fabs(cotangent) + std::sqrt(1.0 + cotangent * cotangent));
    }

    double tangent;
    double cosine;
};

/// The eigenvalues of a symmetric matrix of size x size numbers, increasing, with their vectors one after another:
/// plane rotations until it is diagonal (Jacobi 1846). Each entry is held against its own two of the diagonal, so that
/// a positive matrix keeps the digits of its small eigenvalues.
/// @param matrix is overwritten
/// @param vectors the identity
void diagonalize(double* matrix, std::ptrdiff_t size, double* values, double* vectors) noexcept;

/// The same for Eigen's matrices. All sizes share one function, since this took seconds to compile for each.
template <int size> struct Eigensystem {
    explicit Eigensystem(Eigen::Matrix<double, size, size> matrix) noexcept {
        diagonalize(matrix.data(), size, values.data(), vectors.data());
    }

    Eigen::Matrix<double, size, 1> values;
    Eigen::Matrix<double, size, size> vectors = Eigen::Matrix<double, size, size>::Identity();
};

} // namespace rotconv
