// Yaw, pitch and roll to a matrix and to roll, pitch and yaw, at an attitude that the library reports as singular.

#include <cstdio>

#include <rotconv/rotconv.hpp>

int main() {
    // Three lines: read, use, write.
    const auto reading = rotconv::euler::to_rotation({{30, 90, 20}, "ZYX", rotconv::AngleUnit::degrees});
    const Eigen::Matrix3d R_ref_body = rotconv::dcm::from_rotation(*reading);
    const auto rpy = rotconv::euler::from_rotation(*reading, rotconv::roll_pitch_yaw, rotconv::AngleUnit::degrees);

    for (int row = 0; row < 3; ++row) {
        std::printf("%9.6f %9.6f %9.6f\n", R_ref_body(row, 0), R_ref_body(row, 1), R_ref_body(row, 2));
    }
    std::printf("roll %.6g pitch %.6g yaw %.6g\n", rpy.angles[0], rpy.angles[1], rpy.angles[2]);
    if (rotconv::euler::diagnostics(*reading, rotconv::roll_pitch_yaw).has(rotconv::DiagnosticKind::gimbal_lock)) {
        std::puts("at gimbal lock: only the difference of roll and yaw is defined");
    }
}
