// The typed conversions, as a C++ user meets them.

#include <cmath>
#include <numbers>

#include <rotconv/rotconv.hpp>

#include "catch.hpp"

using namespace rotconv;

// Catches a typed conversion that means something else than its SPEC.
TEST_CASE("typed codecs convert a quarter turn about z") {
    const Reading reading = euler::to_rotation({{90, 0, 0}, "ZYX", AngleUnit::degrees});
    REQUIRE(reading);
    const Rotation& turn = *reading;
    const Dcm expected{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
    CHECK(dcm::from_rotation(turn) == expected);
    CHECK(two_column::from_rotation(turn) == expected.leftCols<2>());
    CHECK(dcm::to_rotation(expected)->z() == dcm::to_rotation(expected)->w());
    CHECK(rotation_vector::from_rotation(turn, AngleUnit::degrees).vector == Eigen::Vector3d(0, 0, 90));
    CHECK(axis_angle::from_rotation(turn).axis == Eigen::Vector3d(0, 0, 1));
    CHECK(axis_angle::from_rotation(turn).angle == Approx(std::numbers::pi / 2));
    CHECK(cayley::from_rotation(turn) == Eigen::Vector3d(0, 0, 1));
    CHECK(mrp::from_rotation(turn).z() == Approx(std::numbers::sqrt2 - 1));
    CHECK(quaternion::from_rotation(turn.inverse()).z() == Approx(-std::numbers::sqrt2 / 2));
    const Rotation back = *five_d::to_rotation(five_d::from_rotation(turn));
    CHECK(back.z() / back.w() == Approx(1).epsilon(1e-15));
    CHECK(euler::from_rotation(turn, roll_pitch_yaw).angles[2] == Approx(std::numbers::pi / 2));
}

// Catches a hub that scales by anything but powers of two, or prints the wrong one of its two signs.
TEST_CASE("the hub keeps a quaternion exactly up to a power of two") {
    const auto rotation = Rotation::from_components(-3e150, 0, 1.1e150, -7e140).canonical();
    CHECK(rotation.w() > 0);
    CHECK(rotation.w() / rotation.y() == 3e150 / -1.1e150);
    CHECK(rotation.z() / rotation.w() == 7e140 / 3e150);
    const auto smallest = Rotation::from_components(0, -5e-324, 0, 5e-324).canonical();
    CHECK(smallest.x() == 0.5);
    CHECK(smallest.z() == -0.5);
    const auto largest = Rotation::from_components(1.7976931348623157e308, 1e308, 0, 0);
    CHECK(largest.w() < 1.0);
    CHECK(largest.w() >= 0.5);
}
