#pragma once

/// The projector on the eigenvectors of the largest eigenvalue of a positive matrix, over its trace: by squaring, which
/// compiles in a tenth of the time of Eigen's solvers.
template <class Matrix> Matrix dominant_projector(Matrix m) {
    m /= m.trace();
    for (int i = 0; i < 60 && m.squaredNorm() < 1.0 - 1e-15; ++i) { // 1: of one eigenvector
        m = (m * m).eval();
        m /= m.trace();
    }
    return m;
}
