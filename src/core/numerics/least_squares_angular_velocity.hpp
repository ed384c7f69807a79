#pragma once

#include <array>

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
    // L D L' x = b, written out: a call of Eigen's could be bound to a user's copy of it, with other flags.
    const Eigen::Matrix3d square = map.transpose() * map;
    const Eigen::Vector3d b = map.transpose() * rates.reshaped();
    const double l10 = square(1, 0) / square(0, 0);
    const double l20 = square(2, 0) / square(0, 0);
    const double d1 = square(1, 1) - l10 * square(1, 0);
    const double product = square(2, 1) - l20 * square(1, 0);
    const double l21 = product / d1;
    const double d2 = square(2, 2) - l20 * square(2, 0) - l21 * product;
    const double y1 = b[1] - l10 * b[0];
    const double z = (b[2] - l20 * b[0] - l21 * y1) / d2;
    const double y = y1 / d1 - l21 * z;
    const double x = b[0] / square(0, 0) - l10 * y - l20 * z;
    return {scales[0](x), scales[1](y), scales[2](z)};
}

} // namespace rotconv
