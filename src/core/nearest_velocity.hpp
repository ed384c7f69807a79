#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace rotconv {

/// The w that brings `rate(w)`, linear in w, nearest to `rates`. The three columns of that map are nearly orthogonal,
/// so that the normal equations lose nothing.
template <class Numbers, class Rate> Eigen::Vector3d nearest_velocity(const Rate& rate, const Numbers& rates) noexcept {
    Eigen::Matrix<double, Numbers::SizeAtCompileTime, 3> map;
    for (Eigen::Index i = 0; i < 3; ++i) {
        map.col(i) = rate(Eigen::Vector3d::Unit(i)).reshaped();
    }
    const Eigen::Matrix3d square = map.transpose() * map;
    return square.ldlt().solve(map.transpose() * rates.reshaped());
}

} // namespace rotconv
