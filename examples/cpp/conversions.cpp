// The commonest conversions, a line each. What is read may describe no rotation: a reading tests as bool, and gives its
// rotation only where there is one.

#include <cstdio>

#include <rotconv/rotconv.hpp>

using namespace rotconv;

int main() {
    const Eigen::Quaterniond q(0.5, 0.5, 0.5, 0.5);
    const Eigen::Vector3d r(0, 0, 1.5707963267948966);

    const Eigen::Matrix3d R = dcm::from_rotation(*quaternion::to_rotation(q));
    const Eigen::Quaterniond p = quaternion::from_rotation(*dcm::to_rotation(R));
    const Eigen::Matrix3d A = dcm::from_rotation(*euler::to_rotation({{90, 0, 90}, "ZYX", AngleUnit::degrees}));
    const Eigen::Vector3d angles = euler::from_rotation(*quaternion::to_rotation(q), "ZXY", AngleUnit::degrees).angles;
    const Eigen::Matrix3d B = dcm::from_rotation(*rotation_vector::to_rotation({r}));
    const Rotation R_ref_body = *dcm::to_rotation(A) * rotation_vector::to_rotation({r})->inverse();
    const Eigen::Vector3d v_ref = R_ref_body * Eigen::Vector3d(1, 0, 0);
    const Reading none = dcm::to_rotation(-R); // a reflection
    std::printf("%g %g %g %g\n", p.w(), p.x(), p.y(), p.z());
    std::printf("%g %g %g\n", angles[0], angles[1], angles[2]);
    std::printf("%9.6f %9.6f %9.6f\n", v_ref.x(), v_ref.y(), v_ref.z());
    std::printf("%s\n", none ? "a rotation" : "no rotation");
}
