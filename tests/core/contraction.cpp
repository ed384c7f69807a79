// As a user's own flags may compile the headers: with multiplications and additions contracted. What the headers hold
// inline must keep its promises then too.

#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include <Eigen/Geometry>

#include <rotconv/rotconv.hpp>

namespace {

using namespace rotconv;
using Exact = Eigen::Quaternion<long double>; // contraction has no part in its arithmetic
using ExactVector = Eigen::Matrix<long double, 3, 1>;

constexpr double eps = 0x1p-52;
constexpr int samples = 200'000;

int failures = 0;
void check(bool holds, const char* promise) {
    if (!holds && ++failures <= 20) {
        std::printf("does not hold: %s\n", promise);
    }
}

class Source {
public:
    double normal() { return normal_(engine_); }
    Eigen::Vector3d vector() { return {normal(), normal(), normal()}; }
    /// Of any attitude, and a norm from 1e-150 to 1e150; one in four is unit to rounding.
    Eigen::Quaterniond quaternion() {
        const Eigen::Quaterniond q = Eigen::Quaterniond(normal(), normal(), normal(), normal()).normalized();
        const double size = ++count_ % 4 == 0 ? 1.0 : std::pow(10.0, exponent_(engine_));
        return {size * q.w(), size * q.x(), size * q.y(), size * q.z()};
    }
    Rotation rotation() {
        const Eigen::Quaterniond q = quaternion();
        return Rotation::from_components(q.w(), q.x(), q.y(), q.z());
    }

private:
    std::mt19937_64 engine_{41};
    std::normal_distribution<double> normal_;
    std::uniform_real_distribution<double> exponent_{-150, 150};
    int count_ = 0;
};

Exact exact(const Rotation& r) { return Exact(r.w(), r.x(), r.y(), r.z()).normalized(); }

long double angle_between(const Exact& p, const Exact& q) { return 2 * (p.conjugate() * q).vec().norm(); }

/// The quarter turn about an axis, forwards where s is c, and backwards where it is -c.
Rotation quarter_turn(std::size_t axis, double c, double s) {
    std::array<double, 3> v{};
    v.at(axis) = s;
    return Rotation::from_components(c, v[0], v[1], v[2]);
}

/// The matrix of a quarter turn is exact, and so are its two columns. Two of them are a half-turn, to the product's 2
/// eps.
void quarter_turns() {
    for (const double c : {0.7071067811865476, 0.3, 1e-5}) {
        for (const double s : {c, -c}) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const Rotation turn = quarter_turn(axis, c, s);
                const Dcm matrix = dcm::from_rotation(turn);
                check((matrix.array().abs() == 1.0).count() == 3 && (matrix.array() == 0.0).count() == 6,
                      "the matrix of a quarter turn is exact");
                check(two_column::from_rotation(turn) == matrix.leftCols<2>(), "two columns are those of the matrix");
                std::array<long double, 3> v{};
                v.at(axis) = 1;
                check(angle_between(Exact(0, v[0], v[1], v[2]), exact(turn * turn)) <= 2 * eps,
                      "a quarter turn twice is a half-turn to 2 eps");
            }
        }
    }
}

/// A half-turn keeps w = 0, the rule of signs and a symmetric matrix, and turns a vector to 5 eps.
void half_turns() {
    Source source;
    for (int i = 0; i < 1000; ++i) {
        const Eigen::Vector3d n = source.vector();
        const Rotation turn = Rotation::from_components(0.0, n.x(), n.y(), n.z());
        const Eigen::Quaterniond q = quaternion::from_rotation(turn);
        check(q.w() == 0.0 && q.x() > 0.0, "a half-turn is written with w = 0 and x > 0");
        const Dcm matrix = dcm::from_rotation(turn);
        check(matrix == matrix.transpose(), "the matrix of a half-turn is symmetric");
    }
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d n = 0.9 * Eigen::Vector3d::Unit(axis);
        const Rotation turn = Rotation::from_components(0.0, n.x(), n.y(), n.z());
        for (Eigen::Index i = 0; i < 3; ++i) {
            const Eigen::Vector3d v = 0.3 * Eigen::Vector3d::Unit(i);
            check((turn * v - (i == axis ? v : Eigen::Vector3d(-v))).norm() <= 5 * eps * v.norm(),
                  "a half-turn turns a vector to 5 eps");
        }
    }
}

/// from_components() and cayley::to_rotation() scale by a power of two and round nothing, to |q|^2 in [1/4, 4); the
/// inverse and the canonical sign are exact.
void components() {
    Source source;
    for (int i = 0; i < samples; ++i) {
        const Eigen::Quaterniond q = source.quaternion();
        const Rotation r = Rotation::from_components(q.w(), q.x(), q.y(), q.z());
        int exponent = 0;
        check(std::frexp(r.w() / q.w(), &exponent) == 0.5, "components are scaled by a power of two");
        const double scale = r.w() / q.w();
        check(r.x() == scale * q.x() && r.y() == scale * q.y() && r.z() == scale * q.z(), "components are exact");
        const long double square = Exact(r.w(), r.x(), r.y(), r.z()).squaredNorm();
        check(square >= 0.25L && square < 4.0L * (1 + eps), "|q|^2 is in [1/4, 4), to rounding");
        const Rotation back = r.inverse();
        check(back.w() == r.w() && back.x() == -r.x() && back.y() == -r.y() && back.z() == -r.z(),
              "the inverse is exact");
        const Rotation canonical = r.canonical();
        check(canonical.w() == std::fabs(r.w()) && canonical.x() == std::copysign(1.0, r.w()) * r.x(),
              "the canonical sign is exact");
        const Eigen::Vector3d c = source.vector();
        const Rotation of_cayley = *cayley::to_rotation(c);
        check(Eigen::Vector3d(of_cayley.x(), of_cayley.y(), of_cayley.z()) / of_cayley.w() == c,
              "a Cayley vector is read exactly");
    }
}

/// Quaternions are read exactly, with a bound on the defect, and written to 1 eps; what is unit keeps its bits.
void quaternions() {
    Source source;
    for (int i = 0; i < samples; ++i) {
        const Eigen::Quaterniond q = source.quaternion();
        const Reading reading = quaternion::to_rotation(q, any_defect);
        const Eigen::Quaterniond written = quaternion::from_rotation(*reading);
        const Exact of_q(q.w(), q.x(), q.y(), q.z());
        check(angle_between(of_q.normalized(), exact(*reading)) <= 0.01 * eps, "a quaternion is read exactly");
        const double defect = std::fabs(static_cast<double>(of_q.norm() - 1));
        check(reading.defect() + 2 * eps >= (1 - 1e-6) * defect, // beside the rounding of |q|^2
              "the defect of a quaternion is a bound");
        const Exact of_written(written.w(), written.x(), written.y(), written.z());
        check(written.w() >= 0 && angle_between(of_q.normalized(), of_written.normalized()) <= eps,
              "a quaternion is written to 1 eps");
        check(quaternion::from_rotation(*quaternion::to_rotation(written)).coeffs() == written.coeffs(),
              "a unit quaternion keeps its bits");
    }
}

/// The product errs by 2 eps at most, of a rotation and its inverse too, and turns a vector to 5 eps of its length.
void products() {
    Source source;
    for (int i = 0; i < samples; ++i) {
        const Rotation a = source.rotation();
        const Rotation b = source.rotation();
        check(angle_between(exact(a) * exact(b), exact(a * b)) <= 2 * eps, "a product errs by at most 2 eps");
        check(angle_between(Exact::Identity(), exact(a * a.inverse())) <= 2 * eps,
              "a rotation and its inverse are the identity to 2 eps");
        const Eigen::Vector3d v = source.vector();
        const ExactVector turned = exact(a) * v.cast<long double>();
        check(((a * v).cast<long double>() - turned).norm() <= 5 * eps * turned.norm(), "a vector is turned to 5 eps");
    }
}

} // namespace

int main() {
    constexpr int skipped = 77;
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
        return skipped;
    }
    quarter_turns();
    half_turns();
    components();
    quaternions();
    products();
    return failures == 0 ? 0 : 1;
}
