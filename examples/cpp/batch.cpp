// Rows of an Eigen matrix, converted at once: each column is a rotation matrix, stored as Eigen does, by columns.

#include <iostream>
#include <vector>

#include <rotconv/rotconv.hpp>

using namespace rotconv;

int main() {
    Eigen::Matrix<double, 9, Eigen::Dynamic> matrices(9, 3);
    for (int i = 0; i < 3; ++i) {
        const Eigen::Matrix3d turned(Eigen::AngleAxisd(0.5 * i, Eigen::Vector3d::UnitZ()));
        matrices.col(i) = turned.reshaped();
    }
    matrices(0, 2) = 7; // no rotation

    const Conversion conversion(eigen_matrix, {.name = RepresentationId::rotvec});
    Eigen::Matrix3Xd vectors(3, matrices.cols());
    std::vector<RowReport> reports; // only of the rows that have something to say
    conversion.run(numbers_of(matrices), numbers_of(vectors), reports);
    std::cout << vectors.transpose() << '\n';
    for (const RowReport& report : reports) {
        std::cout << "row " << report.row << ": " << message(report.error) << ", " << report.defect << '\n';
    }
}
