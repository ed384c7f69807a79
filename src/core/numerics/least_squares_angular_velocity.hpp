#pragma once

#include <array>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "power_of_two.hpp"

namespace rotconv {

/// The w that brings `rate(w)`, linear in w, nearest to `rates`. The three columns of that map are nearly orthogonal,
/// so that the normal equations lose nothing; each is brought to a size near 1, whose square is a double.
template <class Numbers, class Rate>
Eigen::Vector3d least_squares_angular_velocity(const Rate& rate, const Numbers& rates) noexcept {
    Eigen::Matrix<double, Numbers::SizeAtCompileTime, 3> map;
    for (Eigen::Index i = 0; i < 3; ++i) {
        map.col(i) = rate(Eigen::Vector3d::Unit(i)).reshaped();
    }
    const auto scale_of = [&map](Eigen::Index i) { return PowerOfTwo::to_unit(map.col(i).cwiseAbs().maxCoeff()); };
    const std::array scales{scale_of(0), scale_of(1), scale_of(2)};
    for (std::size_t i = 0; i < 3; ++i) {
        auto column = map.col(static_cast<Eigen::Index>(i));
        column = column.unaryExpr(scales[i]).eval();
    }
    const Eigen::Matrix3d square = map.transpose() * map;
    const Eigen::Vector3d scaled = square.ldlt().solve(map.transpose() * rates.reshaped());
    return {scales[0](scaled[0]), scales[1](scaled[1]), scales[2](scaled[2])};
}

} // namespace rotconv
