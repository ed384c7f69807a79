// Attitudes between two others.

#include <cmath>
#include <random>

#include <rotconv/rotation.hpp>

#include "catch.hpp"
#include "oracle.hpp"

using namespace rotconv;

namespace {

/// a exp(fraction log(a^-1 b)), by the rotation vector.
oracle::Quaternion between(const Rotation& a, const Rotation& b, double fraction) {
    const oracle::Quaternion first = oracle::attitude(a);
    oracle::Quaternion turn = first.conjugate() * oracle::attitude(b);
    turn.coeffs() *= oracle::Real(turn.w() < 0 ? -1 : 1);
    const oracle::Real length = turn.vec().norm();
    return length > 0 ? first * oracle::about(turn.vec(), 2 * fraction * atan2(length, turn.w())) : first;
}

double error(const Rotation& found, const oracle::Quaternion& expected) {
    return oracle::error_in_eps(expected, oracle::attitude(found));
}

Rotation random_rotation(std::mt19937_64& engine) {
    std::normal_distribution<double> number;
    return Rotation::from_components(number(engine), number(engine), number(engine), number(engine));
}

} // namespace

// Catches a turn the long way, weights that are not those of the angle, and digits lost for small turns.
TEST_CASE("an attitude between two is that of the turn by its rotation vector") {
    std::mt19937_64 engine(20261123);
    double worst = 0.0;
    for (int i = 0; i < 4000; ++i) {
        const Rotation a = random_rotation(engine);
        Rotation b = random_rotation(engine);
        if (i % 4 == 1) { // near to it, with either sign
            const double sign = i % 8 == 1 ? 1.0 : -1.0;
            const double small = std::pow(10.0, -(i % 17));
            b = Rotation::from_components(sign * (a.w() + small * b.w()), sign * (a.x() + small * b.x()),
                                          sign * (a.y() + small * b.y()), sign * (a.z() + small * b.z()));
        } else if (i % 4 == 2) { // nearly half a turn away
            b = a * Rotation::from_components(std::pow(10.0, -(i % 9)), b.x(), b.y(), b.z());
        }
        const double fraction = std::uniform_real_distribution<double>()(engine);
        const auto found = interpolate(a, b, fraction);
        REQUIRE(found);
        const double allowed = i % 4 == 2 ? std::pow(10.0, i % 9) : 1.0; // a turn not well defined by its ends
        const double off = error(*found, between(a, b, fraction));
        worst = i % 4 == 2 ? worst : std::max(worst, off);
        CHECK(off <= 4 * allowed);
        CHECK(error(*interpolate(a, b, 0.0), oracle::attitude(a)) <= 4);
        CHECK(error(*interpolate(a, b, 1.0), oracle::attitude(b)) <= 4);
    }
    CHECK(worst > 0.1);
    INFO("worst error: " << worst << " eps");
    CHECK(worst <= 4);
}

// Catches weights that are rounded where there is nothing to weigh.
TEST_CASE("between an attitude and itself is that attitude, to the last bit") {
    std::mt19937_64 engine(1);
    for (int i = 0; i < 1000; ++i) {
        const Rotation a = random_rotation(engine);
        const double sign = i % 2 == 0 ? 1.0 : -1.0;
        const auto found = interpolate(a, Rotation::near_unit(sign * a.w(), sign * a.x(), sign * a.y(), sign * a.z()),
                                       std::uniform_real_distribution<double>()(engine));
        REQUIRE(found);
        CHECK((found->w() == a.w() && found->x() == a.x() && found->y() == a.y() && found->z() == a.z()));
    }
}

// Catches squares that underflow, and an axis made of rounding.
TEST_CASE("turns of any size are interpolated, except half turns") {
    const Rotation none;
    for (const double size : {1e-20, 1e-150, 1e-170, 1e-300}) {
        const auto found = interpolate(none, Rotation::from_components(1.0, size, 0.0, 0.0), 0.25);
        REQUIRE(found);
        CHECK(std::abs(found->x() - 0.25 * size) <= 1e-15 * size);
    }
    std::mt19937_64 engine(2);
    for (int i = 0; i < 1000; ++i) {
        const Rotation a = random_rotation(engine);
        const Rotation turn = random_rotation(engine);
        CHECK_FALSE(interpolate(a, a * Rotation::from_components(0.0, turn.x(), turn.y(), turn.z()), 0.5));
        CHECK(interpolate(a, a * Rotation::from_components(1e-13, turn.x(), turn.y(), turn.z()), 0.5));
    }
}
