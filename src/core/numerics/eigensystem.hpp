#pragma once

#include <cmath>
#include <type_traits>
#include <utility>

#include <Eigen/Core>

namespace rotconv {

/// The rotation in a plane that makes the matrix ((a, c), (c, b)) diagonal, by at most 45 degrees.
struct PlaneRotation {
    PlaneRotation(double a, double b, double c) noexcept {
        const double cotangent = (b - a) / (2.0 * c); // of twice the angle
        tangent = std::copysign(1.0, cotangent) / (std::fabs(cotangent) + std::sqrt(1.0 + cotangent * cotangent));
        cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
    }

    /// Turns two rows or columns.
    template <class Line> void operator()(Line&& first, Line&& second) const noexcept {
        const typename std::decay_t<Line>::PlainObject old = first;
        first = cosine * (old - tangent * second);
        second = cosine * (second + tangent * old);
    }

    double tangent;
    double cosine;
};

/// The eigenvalues of a symmetric matrix, increasing, with their vectors: plane rotations until it is diagonal (Jacobi
/// 1846). Each entry is held against its own two of the diagonal, so that a positive matrix keeps the digits of its
/// small eigenvalues.
template <int size> struct Eigensystem {
    explicit Eigensystem(Eigen::Matrix<double, size, size> matrix) noexcept {
        constexpr int most_sweeps = 30;
        bool diagonal = false;
        for (int sweep = 0; sweep < most_sweeps && !diagonal; ++sweep) {
            diagonal = true;
            for (Eigen::Index i = 0; i < size - 1; ++i) {
                for (Eigen::Index k = i + 1; k < size; ++k) {
                    diagonal = !rotate(matrix, i, k) && diagonal;
                }
            }
        }
        values = matrix.diagonal();
        for (Eigen::Index i = 0; i < size - 1; ++i) {
            Eigen::Index least = 0;
            values.tail(size - i).minCoeff(&least);
            std::swap(values[i], values[i + least]);
            vectors.col(i).swap(vectors.col(i + least));
        }
    }

    Eigen::Matrix<double, size, 1> values;
    Eigen::Matrix<double, size, size> vectors = Eigen::Matrix<double, size, size>::Identity();

private:
    /// Makes an entry 0; false where it is as good as 0.
    bool rotate(Eigen::Matrix<double, size, size>& matrix, Eigen::Index i, Eigen::Index k) noexcept {
        const double a = matrix(i, i);
        const double b = matrix(k, k);
        const double c = matrix(i, k);
        if (!(std::fabs(c) > 0x1p-54 * std::sqrt(std::fabs(a * b)))) {
            return false;
        }
        const PlaneRotation rotation(a, b, c);
        rotation(matrix.col(i), matrix.col(k));
        rotation(matrix.row(i), matrix.row(k));
        rotation(vectors.col(i), vectors.col(k));
        matrix(i, i) = a - rotation.tangent * c;
        matrix(k, k) = b + rotation.tangent * c;
        matrix(i, k) = matrix(k, i) = 0.0;
        return true;
    }
};

} // namespace rotconv
