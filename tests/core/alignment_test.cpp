// Alignment and MeanRotation against the sum of squared sines, worked out pair by pair.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Core>

#include <rotconv/alignment.hpp>

#include "catch.hpp"
#include "dominant.hpp"
#include "oracle.hpp"
#include "strata.hpp"

using namespace rotconv;

namespace {

using Quaternion = Eigen::Quaterniond;
using Vector = Eigen::Vector3d;

constexpr std::array sides{AlignedSide::body, AlignedSide::reference, AlignedSide::both, AlignedSide::yaw,
                           AlignedSide::first};

struct Pair {
    Quaternion attitude;
    Quaternion known;
};

struct Turns {
    Quaternion left = Quaternion::Identity();
    Quaternion right = Quaternion::Identity();
};

Quaternion double_of(const Rotation& rotation) {
    return Quaternion(rotation.w(), rotation.x(), rotation.y(), rotation.z()).normalized();
}

/// Pairs of random attitudes, turned by random constants, with noise.
class Source {
public:
    explicit Source(std::uint64_t seed) : source_(seed) {}

    Vector vector(double size) { return size * Vector(source_.normal(), source_.normal(), source_.normal()); }
    Quaternion any() {
        return Quaternion(source_.normal(), source_.normal(), source_.normal(), source_.normal()).normalized();
    }
    Quaternion small(double size) {
        const Vector v = vector(size);
        return Quaternion(Eigen::AngleAxisd(v.norm(), v.normalized()));
    }
    int integer(int low, int high) { return source_.integer(low, high); }
    /// Either sign and any norm.
    Rotation scaled(const Quaternion& q) {
        const double factor = std::copysign(std::exp2(source_.uniform(-300.0, 300.0)), source_.normal());
        return Rotation::from_components(factor * q.w(), factor * q.x(), factor * q.y(), factor * q.z());
    }
    Turns turns(AlignedSide side) {
        const Quaternion yaw(Eigen::AngleAxisd(source_.uniform(-3.14, 3.14), Vector::UnitZ()));
        return {side == AlignedSide::body  ? Quaternion::Identity()
                : side == AlignedSide::yaw ? yaw
                                           : any(),
                side == AlignedSide::body || side == AlignedSide::both ? any() : Quaternion::Identity()};
    }
    /// @param spread of the attitudes, radians on each axis; 0 for any attitude
    std::vector<Pair> pairs(const Turns& turns, int count, double noise, double spread = 0.0) {
        std::vector<Pair> pairs;
        const Quaternion first = any();
        for (int i = 0; i < count; ++i) {
            const Quaternion attitude = spread > 0.0 ? first * small(spread) : any();
            const Quaternion error = noise > 0.0 ? small(noise) : Quaternion::Identity();
            pairs.push_back({attitude, turns.left * attitude * turns.right * error});
        }
        return pairs;
    }
    Alignment alignment(AlignedSide side, const std::vector<Pair>& pairs) {
        Alignment alignment(side);
        for (const Pair& pair : pairs) {
            alignment.add(scaled(pair.attitude), scaled(pair.known));
        }
        return alignment;
    }

private:
    strata::Source source_;
};

double angle_in_eps(const Quaternion& a, const Quaternion& b) {
    return 2.0 * std::asin(std::min(1.0, (a.conjugate() * b).vec().norm())) / oracle::eps;
}

double cost(const std::vector<Pair>& pairs, const Turns& turns) {
    double sum = 0.0;
    for (const Pair& pair : pairs) {
        sum += (turns.left * pair.attitude * turns.right * pair.known.conjugate()).vec().squaredNorm();
    }
    return sum;
}

/// Other turns that the side allows, near these.
Turns neighbour(AlignedSide side, const Turns& turns, Source& source, double size) {
    const Quaternion yaw(Eigen::AngleAxisd(source.vector(size)[0], Vector::UnitZ()));
    const bool has_left = side == AlignedSide::reference || side == AlignedSide::both;
    const bool has_right = side == AlignedSide::body || side == AlignedSide::both;
    return {(side == AlignedSide::yaw ? yaw
             : has_left               ? source.small(size)
                                      : Quaternion::Identity()) *
                turns.left,
            turns.right * (has_right ? source.small(size) : Quaternion::Identity())};
}

/// The best turn on the left after one on the right.
Quaternion best_left(const std::vector<Pair>& pairs, const Quaternion& right) {
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    for (const Pair& pair : pairs) {
        const Eigen::Vector4d q = (pair.known * (pair.attitude * right).conjugate()).coeffs();
        sum += q * q.transpose();
    }
    const Eigen::Matrix4d best = dominant_projector(sum);
    Eigen::Index longest = 0;
    best.diagonal().maxCoeff(&longest);
    return Quaternion(Eigen::Vector4d(best.col(longest).normalized()));
}

/// The least cost to which turns on either side by turns lead from a rotation.
double alternated(const std::vector<Pair>& pairs, Quaternion right) {
    std::vector<Pair> inverse;
    for (const Pair& pair : pairs) {
        inverse.push_back({pair.attitude.conjugate(), pair.known.conjugate()});
    }
    Turns turns;
    for (int step = 0; step < 300; ++step) {
        turns.left = best_left(pairs, right);
        right = best_left(inverse, turns.left.conjugate()).conjugate();
        turns.right = right;
    }
    return cost(pairs, turns);
}

} // namespace

// Catches a turn on the wrong side or the wrong way round, a sum that depends on the sign or the norm of a row,
// and digits lost in sums.
TEST_CASE("exact constant turns are found to a few eps") {
    Source source(1);
    std::array<double, sides.size()> worst{};
    for (int run = 0; run < 1000; ++run) {
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const int least = sides.at(i) == AlignedSide::both ? 4 : 1;
            const Turns turns = source.turns(sides.at(i));
            const auto pairs = source.pairs(turns, source.integer(least, 12), 0.0);
            const auto found = source.alignment(sides.at(i), pairs).rotations();
            REQUIRE(found);
            worst.at(i) = std::max({worst.at(i), angle_in_eps(double_of(found->left), turns.left),
                                    angle_in_eps(double_of(found->right), turns.right)});
        }
    }
    for (std::size_t i = 0; i < sides.size(); ++i) {
        CAPTURE(i);
        CHECK(worst.at(i) <= (sides.at(i) == AlignedSide::both ? 8.0 : 4.0));
    }
}

// Catches sums whose differences tell the turn, and steps that a sum of cosines is to judge.
TEST_CASE("small motions keep the digits of turns on both sides that they have") {
    Source source(2);
    for (const double spread : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
        double worst = 0.0;
        for (int run = 0; run < 100; ++run) {
            const Turns turns = source.turns(AlignedSide::both);
            const auto found = source.alignment(AlignedSide::both, source.pairs(turns, 8, 0.0, spread)).rotations();
            REQUIRE(found);
            worst = std::max(worst, spread * angle_in_eps(double_of(found->right), turns.right));
        }
        CAPTURE(spread);
        CHECK(worst <= 2.0);
    }
}

// Catches sums that drift.
TEST_CASE("a hundred thousand pairs lose no digits") {
    Source source(3);
    for (const AlignedSide side : sides) {
        const Turns turns = source.turns(side);
        const auto found = source.alignment(side, source.pairs(turns, 100'000, 0.0)).rotations();
        REQUIRE(found);
        const double limit = side == AlignedSide::both ? 16.0 : 8.0;
        CHECK(angle_in_eps(double_of(found->left), turns.left) <= limit);
        CHECK(angle_in_eps(double_of(found->right), turns.right) <= limit);
    }
}

// Catches a step that stops early, and a maximum that is not the highest.
TEST_CASE("no other turns leave less than those that are found") {
    Source source(4);
    for (int run = 0; run < tried(1000); ++run) {
        const AlignedSide side = sides.at(static_cast<std::size_t>(run) % 4);
        const double noise = std::array{1e-6, 1e-3, 0.1, 0.5}.at(static_cast<std::size_t>(source.integer(0, 3)));
        const auto pairs = source.pairs(source.turns(side), source.integer(5, 12), noise, source.integer(0, 1) * 0.3);
        const auto found = source.alignment(side, pairs).some_rotations();
        const Turns turns{double_of(found.left), double_of(found.right)};
        const double least = cost(pairs, turns);
        const double rounding = 1e-14 * (1.0 + least);
        for (int i = 0; i < 200; ++i) {
            const double size = std::pow(10.0, -source.integer(0, 6));
            const double other = cost(pairs, neighbour(side, turns, source, size));
            CAPTURE(run, size, noise);
            REQUIRE(other >= least - rounding);
        }
        if (side == AlignedSide::both) {
            for (int i = 0; i < 20; ++i) {
                const double other = alternated(pairs, source.any());
                CAPTURE(run, noise);
                REQUIRE(other >= least - rounding);
            }
        }
    }
}

// Catches later pairs that have a part in it, and the inverse of the turn.
TEST_CASE("the first pair alone tells its turn") {
    Source source(5);
    for (int run = 0; run < 100; ++run) {
        const auto pairs = source.pairs({source.any(), source.any()}, 5, 0.1);
        const auto found = source.alignment(AlignedSide::first, pairs).rotations();
        REQUIRE(found);
        CHECK(angle_in_eps(double_of(found->left), pairs[0].known * pairs[0].attitude.conjugate()) <= 8.0);
        CHECK(double_of(found->right).vec().norm() == 0.0);
    }
}

// Catches an answer from rounding alone.
TEST_CASE("pairs that do not determine turns are told") {
    Source source(6);
    for (const AlignedSide side : sides) {
        CHECK_FALSE(Alignment(side).rotations());
        CHECK(double_of(Alignment(side).some_rotations().left).vec().norm() == 0.0);
    }
    for (int run = 0; run < 1000; ++run) {
        const Turns turns = source.turns(AlignedSide::both);
        for (const double noise : {0.0, 1e-9, 1e-3}) {
            auto pairs = source.pairs(turns, source.integer(1, 2), noise);
            CHECK_FALSE(source.alignment(AlignedSide::both, pairs).rotations());
            // all about one axis
            const Vector axis = source.vector(1.0).normalized();
            const Quaternion first = source.any();
            pairs.clear();
            for (int i = 0; i < (noise > 0.0 ? 100 : 10); ++i) {
                const Quaternion attitude = first * Quaternion(Eigen::AngleAxisd(source.vector(1.0)[0], axis));
                const Quaternion known = turns.left * attitude * turns.right;
                pairs.push_back({attitude, noise > 0.0 ? Quaternion(known * source.small(noise)) : known});
            }
            CAPTURE(run, noise);
            CHECK_FALSE(source.alignment(AlignedSide::both, pairs).rotations());
        }
        // opposite half-turns
        const Quaternion attitude = source.any();
        const Quaternion left = source.any();
        const Vector axis = source.vector(1.0).normalized();
        const Quaternion half_turn(0.0, axis.x(), axis.y(), axis.z());
        const std::vector<Pair> opposite{{attitude, left * attitude}, {attitude, left * half_turn * attitude}};
        CHECK_FALSE(source.alignment(AlignedSide::reference, opposite).rotations());
        CHECK_FALSE(source.alignment(AlignedSide::body, opposite).rotations());
        const Vector level = Vector(axis.x(), axis.y(), 0.0).normalized();
        const std::vector<Pair> upside_down{{attitude, Quaternion(0.0, level.x(), level.y(), 0.0) * attitude}};
        CHECK_FALSE(source.alignment(AlignedSide::yaw, upside_down).rotations());
    }
}

// Catches a spread that drowns in the sums of the turns themselves.
TEST_CASE("the spread of turns about their mean keeps its digits") {
    Source source(7);
    for (const double size : {1e-12, 1e-9, 1e-6, 1e-3, 0.1}) {
        for (int run = 0; run < 100; ++run) {
            const Quaternion turn = source.any();
            MeanRotation mean;
            CHECK(mean.rms() == 0.0);
            std::vector<Vector> vectors;
            Vector middle = Vector::Zero();
            for (int i = 0; i < 1000; ++i) {
                vectors.push_back(source.vector(size));
                middle += vectors.back() / 1000.0;
                mean.add(source.scaled(
                    turn * Quaternion(Eigen::AngleAxisd(vectors.back().norm(), vectors.back().normalized()))));
            }
            double square = 0.0;
            for (const Vector& vector : vectors) {
                square += (vector - middle).squaredNorm() / 1000.0;
            }
            CAPTURE(size);
            CHECK(std::fabs(mean.rms() / std::sqrt(square) - 1.0) <= std::max(1e-3, size * size));
        }
    }
}
