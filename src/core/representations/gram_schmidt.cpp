#include "gram_schmidt.hpp"

#include <Eigen/Geometry>

#include "../numerics/products.hpp"
#include "../numerics/scaling.hpp"

namespace rotconv {

Reading gram_schmidt(Eigen::Vector3d first, Eigen::Vector3d second) noexcept {
    const double first_size = first.cwiseAbs().maxCoeff();
    const double second_size = second.cwiseAbs().maxCoeff();
    if (first_size == 0.0 || second_size == 0.0) {
        return Error::rank_deficient;
    }
    first = first.unaryExpr(PowerOfTwo::to_unit(first_size)).eval();
    second = second.unaryExpr(PowerOfTwo::to_unit(second_size)).eval();
    // The normal of the plane, with the digits that nearly parallel columns have; the second column follows from it.
    Eigen::Vector3d normal{difference_of_products(first[1], second[2], first[2], second[1]),
                           difference_of_products(first[2], second[0], first[0], second[2]),
                           difference_of_products(first[0], second[1], first[1], second[0])};
    const double normal_size = normal.cwiseAbs().maxCoeff();
    if (normal_size == 0.0) {
        return Error::rank_deficient;
    }
    normal = normal.unaryExpr(PowerOfTwo::to_unit(normal_size)).eval();
    RowMajor m;
    m.col(0) = first.normalized();
    m.col(2) = normal.normalized();
    m.col(1) = m.col(2).cross(m.col(0));
    const auto q = quaternion_of_rotation(m.data());
    return Rotation::from_components(q[0], q[1], q[2], q[3]);
}

ROTCONV_TARGET_CLONES
void gram_schmidt(const TwoColumns& m, std::size_t rows, Readings& readings, BatchColumn& square) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        const double a0 = m[0][i];
        const double a1 = m[1][i];
        const double a2 = m[2][i];
        const double along = (a0 * m[3][i] + a1 * m[4][i]) + a2 * m[5][i];
        const double a_excess = ((a0 * a0 + a1 * a1) + a2 * a2) - 1.0;
        const double share = along - along * a_excess; // along/|a|^2
        const double b0 = m[3][i] - share * a0;
        const double b1 = m[4][i] - share * a1;
        const double b2 = m[5][i] - share * a2;
        const double b_excess = ((b0 * b0 + b1 * b1) + b2 * b2) - 1.0;
        const std::array matrix{a0, b0, a1 * b2 - a2 * b1, a1, b1, a2 * b0 - a0 * b2, a2, b2, a0 * b1 - a1 * b0};
        const Davenport k(matrix.data());
        const auto q = k.power_step(k.pivot_column());
        readings.w[i] = q[0];
        readings.x[i] = q[1];
        readings.y[i] = q[2];
        readings.z[i] = q[3];
        readings.defect[i] = clean_defect;
        square[i] = (a_excess * a_excess + b_excess * b_excess) + along * along;
    }
}

} // namespace rotconv
