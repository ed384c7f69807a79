// The most common conversions, one line each. Not every set of numbers describes a rotation: the result of
// to_rotation() tests as a bool, and throws if you take a rotation from it when there is none.

#include <cstdio>

#include <rotconv/rotconv.hpp>

using namespace rotconv;

int main() {
    const Eigen::Quaterniond q(0.5, 0.5, 0.5, 0.5);
    const Eigen::Vector3d r(0, 0, 1.5707963267948966);

    const Eigen::Matrix3d R = dcm::from_rotation(*quaternion::to_rotation(q));
    const Eigen::Quaterniond p = quaternion::from_rotation(Rotation(R)); // throws if no rotation is nearest to R
    const Eigen::Matrix3d A = dcm::from_rotation(*euler::to_rotation({{90, 0, 90}, "ZYX", AngleUnit::degrees}));
    const Eigen::Vector3d angles = euler::from_rotation(*quaternion::to_rotation(q), "ZXY", AngleUnit::degrees).angles;
    const Eigen::Matrix3d B = dcm::from_rotation(*rotation_vector::to_rotation(r));
    const Rotation R_ref_body = Rotation(A) * rotation_vector::to_rotation(r)->inverse();
    const Eigen::Vector3d v_ref = R_ref_body * Eigen::Vector3d(1, 0, 0);
    const Reading none = dcm::to_rotation(-R);         // a reflection
    const Reading scaled = dcm::to_rotation(1.01 * R); // refused: scaled.defect() is 0.01
    std::printf("%g %g %g %g\n", p.w(), p.x(), p.y(), p.z());
    std::printf("%g %g %g\n", angles[0], angles[1], angles[2]);
    std::printf("%9.6f %9.6f %9.6f\n", v_ref.x(), v_ref.y(), v_ref.z());
    std::printf("%s\n", none ? "a rotation" : "no rotation");
    std::printf("%s, %.2g off\n", scaled ? "a rotation" : "no rotation", scaled.defect());
}
