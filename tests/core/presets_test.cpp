// Each preset against what its library, paper or file format publishes.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "accuracy.hpp"
#include "catch.hpp"

namespace {

using accuracy::spec;
using Numbers = std::vector<double>;
using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;

/// Converts and compares to the digits that were published.
void check(const std::string& from, const Numbers& row, const std::string& to, const Numbers& expected, double margin) {
    const auto result = accuracy::own(spec(from), spec(to))(row);
    INFO(from << " to " << to);
    REQUIRE(result.size() == expected.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        CHECK(result[i] == Approx(expected[i]).margin(margin));
    }
}

Numbers rows_of(const Matrix& m) {
    return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}

Matrix cross(const Vector& v) {
    Matrix m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

/// [1 0 0; 0 c -s; 0 s c], and likewise about y and z.
Matrix turn(int axis, double angle) {
    Matrix m = Matrix::Identity();
    const int next = (axis + 1) % 3;
    const int last = (axis + 2) % 3;
    m(next, next) = m(last, last) = std::cos(angle);
    m(last, next) = std::sin(angle);
    m(next, last) = -m(last, next);
    return m;
}

const Vector v(2.0 / 9, 4.0 / 9, 5.0 / 9); // with the scalar 6/9 a unit quaternion
constexpr double w = 6.0 / 9;
const double half = std::sqrt(0.5);

} // namespace

// SciPy's documentation of scipy.spatial.transform.Rotation, class examples: from_quat([0, 0, sin(pi/4), cos(pi/4)]).
TEST_CASE("preset scipy") {
    const Numbers q{0, 0, half, half};
    check("quat:scipy", q, "dcm:scipy", {0, -1, 0, 1, 0, 0, 0, 0, 1}, 1e-15);
    check("quat:scipy", q, "rotvec:scipy", {0, 0, 1.57079633}, 5e-9);
    check("quat:scipy", q, "euler:zyx:deg:scipy", {90, 0, 0}, 1e-13);
    check("mrp:scipy", {0, 0, 1}, "euler:xyz:deg:scipy", {0, 0, 180}, 1e-13); // from_mrp([0, 0, 1])
}

// Gohlke's transformations.py, which ROS ships as tf.transformations: quaternion_from_euler(1, 2, 3, 'ryxz').
TEST_CASE("preset ros") {
    check("euler:YXZ:ros", {1, 2, 3}, "quat:ros", {0.310622, -0.718287, 0.444435, 0.435953}, 5e-7);
}

// TUM RGB-D benchmark, file formats: "timestamp tx ty tz qx qy qz qw".
TEST_CASE("preset tum") {
    check("quat:tum", {0.1, 0.3, 0.3, 0.9}, "quat", {0.9, 0.1, 0.3, 0.3}, 1e-15);
    CHECK(spec("quat:tum").columns()[0] == "qx");
    CHECK(spec("quat:tum").columns()[3] == "qw");
}

// MathWorks, Aerospace Toolbox, angle2dcm, both examples.
TEST_CASE("preset matlab") {
    check("euler:ZYX:matlab", {0.7854, 0.1, 0}, "dcm:matlab",
          {0.7036, 0.7036, -0.0998, -0.7071, 0.7071, 0, 0.0706, 0.0706, 0.9950}, 6e-5);
    check("euler:YXZ:matlab", {0.3, 0.1, 0.5}, "dcm:matlab",
          {0.8525, 0.4770, -0.2136, -0.4321, 0.8732, 0.2254, 0.2940, -0.0998, 0.9506}, 6e-5);
}

// Schaub and Junkins, Analytical Mechanics of Space Systems, the MRP and EP forms of [BN]:
// [BN] = I + (8[s]^2 - 4(1 - s^2)[s])/(1 + s^2)^2; [BN] = (b0^2 - b'b)I + 2bb' - 2 b0 [b].
TEST_CASE("preset basilisk") {
    const Vector s(0.1, 0.2, 0.3);
    const double square = s.squaredNorm();
    const Matrix from_mrp =
        Matrix::Identity() + (8 * cross(s) * cross(s) - 4 * (1 - square) * cross(s)) / ((1 + square) * (1 + square));
    check("mrp:basilisk", {0.1, 0.2, 0.3}, "dcm:basilisk", rows_of(from_mrp), 1e-15);
    const Matrix from_ep = (w * w - v.squaredNorm()) * Matrix::Identity() + 2 * v * v.transpose() - 2 * w * cross(v);
    check("quat:basilisk", {w, v.x(), v.y(), v.z()}, "dcm:basilisk", rows_of(from_ep), 1e-15);
}

// NAIF, SPICE toolkit test F_Q2M: the quaternion (sqrt 2/2, 0, 0, sqrt 2/2) is the matrix with M(1,2) = -1, M(2,1) = 1.
// A C-matrix takes reference to body, so that the body axes are its rows.
TEST_CASE("preset spice") {
    check("quat:spice", {half, 0, 0, half}, "dcm:spice", {0, -1, 0, 1, 0, 0, 0, 0, 1}, 1e-15);
    check("quat:spice", {half, 0, 0, half}, "dcm", {0, 1, 0, -1, 0, 0, 0, 0, 1}, 1e-15);
    check("euler:ZYX:spice", {0.25, 0, 0}, "euler:ZYX", {0.25, 0, 0}, 1e-15);
}

// Bunge, Texture Analysis in Materials Science, Eq 2.50, and Rowenhorst et al. 2015, eu2qu with P = +1:
// q = (c cos s, -s cos d, -s sin d, -c sin s), s and d half the sum and difference of phi1 and phi2.
TEST_CASE("preset bunge") {
    const auto [a, b, c] = std::array{0.7, 0.4, -1.1};
    const Numbers g{std::cos(a) * std::cos(c) - std::sin(a) * std::sin(c) * std::cos(b),
                    std::sin(a) * std::cos(c) + std::cos(a) * std::sin(c) * std::cos(b),
                    std::sin(c) * std::sin(b),
                    -std::cos(a) * std::sin(c) - std::sin(a) * std::cos(c) * std::cos(b),
                    -std::sin(a) * std::sin(c) + std::cos(a) * std::cos(c) * std::cos(b),
                    std::cos(c) * std::sin(b),
                    std::sin(a) * std::sin(b),
                    -std::cos(a) * std::sin(b),
                    std::cos(b)};
    check("euler:ZXZ:bunge", {a, b, c}, "dcm:bunge", g, 1e-15);
    const double sum = 0.5 * (a + c);
    const double difference = 0.5 * (a - c);
    check("euler:ZXZ:bunge", {a, b, c}, "quat:bunge",
          {std::cos(b / 2) * std::cos(sum), -std::sin(b / 2) * std::cos(difference),
           -std::sin(b / 2) * std::sin(difference), -std::cos(b / 2) * std::sin(sum)},
          1e-15);
}

// Baruh, Analytical Dynamics 1999, Example 1: 350 degrees about (2, -3, 6)/7; the parameters are (x, y, z, scalar).
TEST_CASE("preset baruh") {
    const Numbers turn{2, -3, 6, 350};
    check("axis-angle:deg:baruh", turn, "quat:baruh", {-0.024902, 0.037352, -0.074705, 0.996195}, 6e-7);
    check("axis-angle:deg:baruh", turn, "dcm:baruh",
          {0.986048, -0.150702, -0.070700, 0.146981, 0.987598, -0.055195, 0.078141, 0.044033, 0.995969}, 6e-7);
}

// Trawny and Roumeliotis 2005, the JPL quaternion (x, y, z, scalar): C = (2 w^2 - 1)I - 2w[q] + 2qq'.
TEST_CASE("presets trawny and jpl") {
    const Matrix c = (2 * w * w - 1) * Matrix::Identity() - 2 * w * cross(v) + 2 * v * v.transpose();
    for (const std::string preset : {"trawny", "jpl"}) {
        check("quat:" + preset, {v.x(), v.y(), v.z(), w}, "dcm:" + preset, rows_of(c), 1e-15);
    }
}

// Stuelpnagel 1964: gamma(u) of section 3, the factors of section 6, exp and Cayley of section 6.
TEST_CASE("preset stuelpnagel") {
    const auto [u1, u2, u3, u4] = std::array{w, v.x(), v.y(), v.z()};
    check("quat:stuelpnagel", {u1, u2, u3, u4}, "dcm:stuelpnagel",
          {u1 * u1 + u2 * u2 - u3 * u3 - u4 * u4, 2 * (-u1 * u4 + u2 * u3), 2 * (u1 * u3 + u2 * u4),
           2 * (u1 * u4 + u2 * u3), u1 * u1 - u2 * u2 + u3 * u3 - u4 * u4, 2 * (-u1 * u2 + u3 * u4),
           2 * (-u1 * u3 + u2 * u4), 2 * (u1 * u2 + u3 * u4), u1 * u1 - u2 * u2 - u3 * u3 + u4 * u4},
          1e-15);

    // his factors are the inverse turns
    const Matrix factors = turn(0, -0.3) * turn(1, 0.4) * turn(2, -1.2);
    check("rpy:stuelpnagel", {0.3, -0.4, 1.2}, "dcm:stuelpnagel", rows_of(factors), 1e-15);

    const Vector s(0.3, -0.5, 0.7);
    Matrix skew; // S of s as printed: the negative of [s]
    skew << 0, s.z(), -s.y(), -s.z(), 0, s.x(), s.y(), -s.x(), 0;
    const double sigma = s.norm();
    const Matrix exponential =
        Matrix::Identity() + std::sin(sigma) / sigma * skew + (1 - std::cos(sigma)) / (sigma * sigma) * skew * skew;
    check("rotvec:stuelpnagel", {0.3, -0.5, 0.7}, "dcm:stuelpnagel", rows_of(exponential), 1e-15);

    const Matrix cayley = Matrix::Identity() - 2 / (1 + sigma * sigma) * skew + 2 / (1 + sigma * sigma) * skew * skew;
    check("cayley:stuelpnagel", {0.3, -0.5, 0.7}, "dcm:stuelpnagel", rows_of(cayley), 1e-15);

    // Section 4 with the pole (1, 0, 0, 0, 0, 0): y = Vx/(1 - a'x), x the first two columns of X over sqrt 2.
    const Matrix x = cayley;
    const double scale = 1 / (1 - x(0, 0) / std::sqrt(2.0)) / std::sqrt(2.0);
    check("cayley:stuelpnagel", {0.3, -0.5, 0.7}, "5d:stuelpnagel",
          {x(1, 0) * scale, x(2, 0) * scale, x(0, 1) * scale, x(1, 1) * scale, x(2, 1) * scale}, 2e-15);
    check("cayley:stuelpnagel", {0.3, -0.5, 0.7}, "6d:stuelpnagel",
          {x(0, 0), x(1, 0), x(2, 0), x(0, 1), x(1, 1), x(2, 1)}, 1e-15);
}

// Projects whose numbers need no preset of their own, against what their sources and documentation publish; the manual
// has the table. They catch a line of it that is wrong.

// MathWorks, Aerospace Toolbox, quat2dcm, both examples.
TEST_CASE("MATLAB's Aerospace Toolbox has passive matrices") {
    check("quat", {1, 0, 1, 0}, "dcm:matlab", {0, 0, -1, 0, 1, 0, 1, 0, 0}, 1e-15);
    check("quat", {1, 0.5, 0.3, 0.1}, "dcm:matlab",
          {0.8519, 0.3704, -0.3704, 0.0741, 0.6148, 0.7852, 0.5185, -0.6963, 0.4963}, 6e-5);
}

// MathWorks, Robotics System Toolbox, se3.eul, the example of an so3 made of pi/4, pi/3, pi/8.
TEST_CASE("MATLAB's Robotics System Toolbox has active ones") {
    check("euler:ZYX:deg", {45, 60, 22.5}, "dcm",
          {0.3536, -0.4189, 0.8364, 0.3536, 0.8876, 0.2952, -0.8660, 0.1913, 0.4619}, 6e-5);
}

// Drake, math/roll_pitch_yaw.h: R = Rz(y) Ry(p) Rx(r). GTSAM's RzRyRx and Ceres' Euler angles are the same product.
TEST_CASE("roll, pitch and yaw of Drake, GTSAM, Ceres and ROS") {
    const auto [r, p, y] = std::array{0.3, -0.4, 1.2};
    const Matrix product = turn(2, y) * turn(1, p) * turn(0, r);
    check("rpy", {r, p, y}, "dcm", rows_of(product), 1e-15);
    check("euler:ZYX", {y, p, r}, "dcm", rows_of(product), 1e-15);           // GTSAM's ypr
    check("rpy", {r, p, y}, "dcm:col", rows_of(product.transpose()), 1e-15); // Ceres' column-major matrices
    // ROS, tf2/LinearMath/Quaternion.h, setRPY; Blender's eulO_to_quat for the order XYZ has the same products.
    const auto [cr, cp, cy] = std::array{std::cos(r / 2), std::cos(p / 2), std::cos(y / 2)};
    const auto [sr, sp, sy] = std::array{std::sin(r / 2), std::sin(p / 2), std::sin(y / 2)};
    check("rpy", {r, p, y}, "quat:ros",
          {sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy,
           cr * cp * cy + sr * sp * sy},
          1e-15);
}

// OpenCV, calib3d.hpp, Rodrigues: R = cos(theta) I + (1 - cos(theta)) rr' + sin(theta) [r].
TEST_CASE("the vector of OpenCV's Rodrigues is a rotation vector") {
    const Vector n(2.0 / 7, -3.0 / 7, 6.0 / 7);
    const double theta = 1.1;
    const Matrix m =
        std::cos(theta) * Matrix::Identity() + (1 - std::cos(theta)) * n * n.transpose() + std::sin(theta) * cross(n);
    check("rotvec", {theta * n.x(), theta * n.y(), theta * n.z()}, "dcm", rows_of(m), 1e-15);
}

// three.js, src/math/Euler.js, setFromRotationMatrix: XYZ has y = asin m13, x = atan2(-m23, m33), z = atan2(-m12, m11),
// ZXY x = asin m32, y = atan2(-m31, m33), z = atan2(-m12, m22).
TEST_CASE("Euler angles of three.js turn about the body's axes") {
    const Numbers m = accuracy::own(spec("quat"), spec("dcm"))(Numbers{w, v.x(), v.y(), v.z()});
    check("dcm", m, "euler:XYZ", {std::atan2(-m[5], m[8]), std::asin(m[2]), std::atan2(-m[1], m[0])}, 1e-15);
    check("dcm", m, "euler:ZXY", {std::atan2(-m[1], m[4]), std::asin(m[7]), std::atan2(-m[6], m[8])}, 1e-15);
}

// Unity's Quaternion.cs turns vectors by the usual formula in its left-handed axes right, up, forward; the axes
// forward, left, up are those by M.
TEST_CASE("a Unity quaternion in right-handed axes") {
    const Eigen::Quaterniond unity(w, v.x(), v.y(), v.z());
    Matrix axes;
    axes << 0, 0, 1, -1, 0, 0, 0, 1, 0;
    check("quat:xyzw", {-v.z(), v.x(), -v.y(), w}, "dcm", rows_of(axes * unity.toRotationMatrix() * axes.transpose()),
          1e-15);
}
