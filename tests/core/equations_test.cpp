// The kinematic equations as they stand in the documents, against the representations' own.

#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include <rotconv/rotconv.hpp>

#include "catch.hpp"
#include "strata.hpp"

using namespace rotconv;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

/// An attitude R, its inverse X = R' in Stuelpnagel's words, and the body's angular velocity, with Xdot = Omega X.
struct Case {
    Rotation rotation;
    Vector3d w;

    [[nodiscard]] Rotation x() const { return rotation.inverse(); }
};

Matrix3d skew(const Vector3d& v) {
    Matrix3d m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

Vector3d axial(const Matrix3d& m) { return {m(2, 1), m(0, 2), m(1, 0)}; }

/// Omega v = v x w.
Matrix3d omega(const Case& c) { return -skew(c.w); }

std::vector<Case> cases() {
    strata::Source source(31);
    std::vector<Case> made;
    for (int i = 0; i < 200; ++i) {
        const Rotation rotation = oracle::rotation(source.attitude());
        made.push_back({rotation, {source.normal(), source.normal(), source.normal()}});
    }
    return made;
}

template <class A, class B> double distance(const A& a, const B& b) { return (a - b).norm() / (1.0 + b.norm()); }

constexpr double rounding = 20 * 0x1p-52;

/// Section 6, the exponential set; in print the sign of the second term is -1.
Matrix3d exponential_rate(const Matrix3d& s, const Matrix3d& omega, double sign_of_second_term) {
    const double sigma = std::sqrt(-0.5 * (s * s).trace());
    const double factor = (2.0 - sigma / std::tan(sigma / 2.0)) / (2.0 * sigma * sigma);
    return omega + sign_of_second_term * 0.5 * (omega * s - s * omega) +
           factor * (s * s * omega + omega * s * s - 2.0 * s * omega * s);
}

} // namespace

// Stuelpnagel, section 1 and 3: Xdot = Omega X.
TEST_CASE("Stuelpnagel's matrix equation") {
    for (const Case& c : cases()) {
        const Matrix3d x = dcm::from_rotation(c.x());
        CHECK(distance(dcm::rate(x, -c.w, Frame::reference), omega(c) * x) < rounding);
        const Matrix3d of_inverse = dcm::rate(dcm::from_rotation(c.rotation), c.w).transpose();
        CHECK(distance(of_inverse, omega(c) * x) < rounding);
    }
}

// Section 4: X0dot = Omega X0, and of the five numbers ydot = (1/2 (y'y - 1) I - y y') V A a + V A V' y.
TEST_CASE("Stuelpnagel's equations of six and of five numbers") {
    using Matrix56 = Eigen::Matrix<double, 5, 6>;
    using Matrix6 = Eigen::Matrix<double, 6, 6>;
    using Vector6 = Eigen::Matrix<double, 6, 1>;
    const Vector6 a = Vector6::Unit(0);
    Matrix56 v = Matrix56::Zero();
    v.rightCols<5>().setIdentity();
    for (const Case& c : cases()) {
        const TwoColumns x0 = two_column::from_rotation(c.x());
        CHECK(distance(two_column::rate(x0, -c.w, Frame::reference), omega(c) * x0) < rounding);

        const five_d::Vector5 y = five_d::from_rotation(c.x());
        Matrix6 big = Matrix6::Zero();
        big.topLeftCorner<3, 3>() = omega(c);
        big.bottomRightCorner<3, 3>() = omega(c);
        const five_d::Vector5 linear = v * big * a;
        const five_d::Vector5 printed =
            0.5 * (y.squaredNorm() - 1.0) * linear - y * y.dot(linear) + v * big * v.transpose() * y;
        CHECK(distance(five_d::rate(y, -c.w, Frame::reference), printed) < rounding);
    }
}

// Section 5: the 4x4 equation of u = conj(q).
TEST_CASE("Stuelpnagel's quaternion equation") {
    for (const Case& c : cases()) {
        Eigen::Matrix4d printed;
        printed << 0, c.w.x(), c.w.y(), c.w.z(), //
            -c.w.x(), 0, c.w.z(), -c.w.y(),      //
            -c.w.y(), -c.w.z(), 0, c.w.x(),      //
            -c.w.z(), c.w.y(), -c.w.x(), 0;
        const Eigen::Quaterniond u = quaternion::from_rotation(c.x());
        const Eigen::Quaterniond rates = quaternion::rate(u, -c.w, Frame::reference);
        CHECK(distance(Eigen::Vector4d(rates.w(), rates.x(), rates.y(), rates.z()),
                       0.5 * printed * Eigen::Vector4d(u.w(), u.x(), u.y(), u.z())) < rounding);
    }
}

// Section 6: the 3x3 system of roll, pitch and yaw, whose determinant is cos(pitch).
TEST_CASE("Stuelpnagel's equation of roll, pitch and yaw") {
    for (const Case& c : cases()) {
        const EulerAngles value = euler::from_rotation(c.rotation, roll_pitch_yaw);
        const double phi = value.angles[0];
        const double theta = value.angles[1];
        Matrix3d printed;
        printed << 1, 0, -std::sin(theta),                     //
            0, std::cos(phi), std::sin(phi) * std::cos(theta), //
            0, -std::sin(phi), std::cos(phi) * std::cos(theta);
        const auto rates = euler::rate(value, c.w);
        const double condition = euler::sensitivity(c.rotation, roll_pitch_yaw).condition;
        CHECK(distance(printed * Vector3d(rates[0], rates[1], rates[2]), c.w) < rounding * condition);
        CHECK(printed.determinant() == Approx(std::cos(theta)));
    }
}

// Section 6: with the sign of its second term mended the equation is that of X = exp S; as printed it is off, and
// solves Xdot = X Omega instead.
TEST_CASE("Stuelpnagel's equation of the exponential set, mended and as misprinted") {
    for (const Case& c : cases()) {
        // X = exp S has S v = v x r for the rotation vector r of R
        const RotationVector r = rotation_vector::from_rotation(c.rotation);
        const Matrix3d s = -skew(r.vector);
        const Vector3d own = rotation_vector::rate(r, c.w);
        const Vector3d mended = -axial(exponential_rate(s, omega(c), 1.0));
        const Vector3d misprinted = -axial(exponential_rate(s, omega(c), -1.0));
        CHECK(distance(own, mended) < rounding);
        CHECK((own - misprinted).norm() == Approx(r.vector.cross(c.w).norm()));
        CHECK(distance(rotation_vector::rate(r, c.w, Frame::reference), misprinted) < rounding);

        // The motion itself decides: exp of the moved S against exp(Omega h) X.
        const double h = 1e-6;
        const Matrix3d x = dcm::from_rotation(c.x());
        const auto moved = [&](const Vector3d& rate) {
            const RotationVector next(r.vector + h * rate);
            return Matrix3d(dcm::from_rotation(rotation_vector::to_rotation(next)->inverse()));
        };
        const Matrix3d slope = omega(c) * x;
        CHECK(((moved(mended) - x) / h - slope).norm() < 1e-4);
        CHECK(((moved(misprinted) - x) / h - slope).norm() > 0.1 * r.vector.cross(c.w).norm());
    }
}

// Section 6: Sdot = (S Omega S - S Omega + Omega S - Omega)/2 for X = (I - S)(I + S)^-1.
TEST_CASE("Stuelpnagel's Riccati equation of the Cayley set") {
    for (const Case& c : cases()) {
        const Vector3d vector = cayley::from_rotation(c.rotation);
        const Matrix3d s = skew(vector); // (I - S)(I + S)^-1 is then the transpose of R
        const Matrix3d printed = 0.5 * (s * omega(c) * s - s * omega(c) + omega(c) * s - omega(c));
        CHECK(distance(cayley::rate(vector, c.w), axial(printed)) < rounding);
    }
}

// Schaub and Junkins 1996: a set and its shadow have the same equation.
TEST_CASE("modified Rodrigues parameters and their shadow move alike") {
    for (const Case& c : cases()) {
        const Vector3d m = mrp::from_rotation(c.rotation);
        const Vector3d shadow = -m / m.squaredNorm();
        const Vector3d rate = mrp::rate(m, c.w);
        const Vector3d shadow_rate =
            -rate / m.squaredNorm() + (2.0 * m.dot(rate) / (m.squaredNorm() * m.squaredNorm())) * m;
        CHECK(distance(mrp::rate(shadow, c.w), shadow_rate) < rounding * (1.0 + shadow.squaredNorm()));
    }
}

// A rate of the norm, and what else is not tangent to the rotations, has no part in the angular velocity.
TEST_CASE("the angular velocity is that of the tangent part of the rates") {
    for (const Case& c : cases()) {
        const Dcm r = dcm::from_rotation(c.rotation);
        const Matrix3d symmetric = skew(c.w) * skew(c.w);
        CHECK(distance(dcm::angular_velocity(r, dcm::rate(r, c.w) + r * symmetric), c.w) < rounding);
        CHECK(distance(dcm::angular_velocity(r, dcm::rate(r, c.w, Frame::reference) + symmetric * r, Frame::reference),
                       c.w) < rounding);
        Eigen::Quaterniond q = quaternion::from_rotation(c.rotation);
        q = {1e-170 * q.w(), 1e-170 * q.x(), 1e-170 * q.y(), 1e-170 * q.z()};
        Eigen::Quaterniond rates = quaternion::rate(q, c.w);
        rates = {rates.w() + 3 * q.w(), rates.x() + 3 * q.x(), rates.y() + 3 * q.y(), rates.z() + 3 * q.z()};
        CHECK(distance(quaternion::angular_velocity(q, rates), c.w) < rounding);
    }
}

// Catches an equation whose drift off the set becomes an error of the attitude.
TEST_CASE("columns that are not orthonormal turn as the attitude that they stand for") {
    for (const Case& c : cases()) {
        Eigen::Matrix2d shear;
        shear << 1.3, 0.2, 0.0, 0.8;
        const TwoColumns exact = two_column::from_rotation(c.rotation);
        const TwoColumns off = exact * shear;
        CHECK(distance(two_column::rate(off, c.w), two_column::rate(exact, c.w) * shear) < rounding);
        CHECK(distance(two_column::angular_velocity(off, two_column::rate(off, c.w)), c.w) < rounding);
    }
}
