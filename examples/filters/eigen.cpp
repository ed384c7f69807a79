// eigen euler:ZYX|quat:xyzw|rotvec|version: matrices of standard input, one a line, to SPEC by Eigen.
#include <Eigen/Geometry>
#include <cstdio>
#include <string>

int main(int, char** arguments) {
    const std::string spec = arguments[1];
    if (spec == "version")
        return std::printf("Eigen %d.%d.%d\n", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION) < 0;
    Eigen::Matrix<double, 3, 3, Eigen::RowMajor> R;
    double* r = R.data();
    while (std::scanf("%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", r, r + 1, r + 2, r + 3, r + 4, r + 5, r + 6, r + 7,
                      r + 8) == 9) {
        const Eigen::AngleAxisd turn(R);
        const Eigen::Vector3d out =
            spec == "rotvec" ? Eigen::Vector3d(turn.angle() * turn.axis()) : R.eulerAngles(2, 1, 0);
        const Eigen::Quaterniond q(R);
        if (spec == "quat:xyzw")
            std::printf("%.17g,%.17g,%.17g,%.17g\n", q.x(), q.y(), q.z(), q.w());
        else
            std::printf("%.17g,%.17g,%.17g\n", out[0], out[1], out[2]);
    }
}
