// Rotation as a C++ user meets it: it multiplies, turns vectors, and is not there where numbers describe none.

#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/Geometry>
#include <catch.hpp>
#include <rotconv/rotconv.hpp>

#include "oracle.hpp"
#include "strata.hpp"

using namespace rotconv;

namespace {

oracle::Quaternion exact(const Rotation& r) { return oracle::attitude(r); }

} // namespace

// Catches factors in the wrong order, a sign, a product that leaves the range of a Rotation's norm.
TEST_CASE("the product of rotations is their composition") {
    strata::Source source(31);
    double worst = 0.0;
    for (int i = 0; i < 20'000; ++i) {
        const Rotation a = oracle::rotation(source.attitude());
        const Rotation b = Rotation::from_components(1.7 * a.z(), -0.3, source.normal(), source.normal());
        const Rotation product = a * b;
        CHECK((product.squared_norm() >= 0.25 && product.squared_norm() < 4.0));
        worst = std::max(worst, oracle::error_in_eps(exact(product), exact(a) * exact(b)));
    }
    CHECK(worst <= 2.0);
    CHECK(worst > 0.1);
}

// Catches a vector that is turned the other way, or stretched by the norm of the quaternion.
TEST_CASE("a rotation turns a vector as its matrix does") {
    strata::Source source(32);
    double worst = 0.0;
    for (int i = 0; i < 20'000; ++i) {
        const Rotation r = Rotation::from_components(source.normal(), source.normal(), source.normal(), 0.9);
        const Eigen::Vector3d v{source.normal(), source.normal(), source.normal()};
        const oracle::Vector3 turned = exact(r) * v.cast<oracle::Real>();
        const oracle::Vector3 error = (r * v).cast<oracle::Real>() - turned;
        worst = std::max(worst, static_cast<double>(error.norm() / turned.norm()) / oracle::eps);
    }
    CHECK(worst <= 5.0);
    CHECK(worst > 0.1);
    const Rotation back = Rotation::from_components(1, 2, 3, 4);
    CHECK((back.inverse() * (back * Eigen::Vector3d(1, -2, 5))).isApprox(Eigen::Vector3d(1, -2, 5), 1e-15));
}

// Catches the identity, or anything else, in the place of an answer.
TEST_CASE("a reading without a rotation gives none") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Reading reading = quaternion::to_rotation({0, 0, 0, 0});
    CHECK_FALSE(reading);
    CHECK(reading.error() == Error::zero_quaternion);
    CHECK_THROWS_AS(*reading, std::logic_error);
    CHECK_THROWS_AS(reading->w(), std::logic_error);
    CHECK_THROWS_AS(*dcm::to_rotation(-Eigen::Matrix3d::Identity()), std::logic_error);
    CHECK_THROWS_AS(*euler::to_rotation({{nan, 0, 0}, "ZYX", AngleUnit::radians}), std::logic_error);
    CHECK(quaternion::to_rotation({1, 0, 0, 0}));
}

// Catches literals that are taken at run time only, and a sequence that changes on the way.
TEST_CASE("a sequence literal is a constant") {
    constexpr EulerSequence sequence = "zXy"[0] == 'z' ? EulerSequence("zxy") : EulerSequence("ZXY");
    static_assert(!sequence.intrinsic() && sequence.axis(0) == 2 && sequence.axis(1) == 0 && sequence.axis(2) == 1);
    static_assert(EulerSequence("ZXZ").proper());
    CHECK(sequence == *EulerSequence::parse("zxy"));
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
