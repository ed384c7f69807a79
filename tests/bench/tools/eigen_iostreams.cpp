// eigen_iostreams: what is written in ten minutes: matrices by >>, Eigen's Euler angles of the matrix as it is, which
// is how they are mostly called, and << with as many digits as a double needs.

#include <iomanip>
#include <iostream>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

int main() {
    std::ios::sync_with_stdio(false);
    std::cin.tie(nullptr);
    std::cout << std::setprecision(std::numeric_limits<double>::max_digits10);
    Eigen::Matrix3d m;
    char comma = 0;
    while (std::cin >> m(0, 0)) {
        for (int i = 1; i < 9; ++i) {
            std::cin >> comma >> m(i / 3, i % 3);
        }
        const Eigen::Vector3d angles = m.eulerAngles(2, 1, 0) * (180 / std::numbers::pi);
        std::cout << angles[2] << ',' << angles[1] << ',' << angles[0] << '\n';
    }
}
