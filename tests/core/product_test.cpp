// Products of two attitudes and vectors in other axes: bits are compared with the oracle.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <rotconv/product.hpp>

#include "accuracy.hpp"
#include "catch.hpp"
#include "oracle.hpp"
#include "strata.hpp"

using namespace rotconv;
using accuracy::joined;
using accuracy::spec;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Made {
    std::vector<double> numbers;
    std::vector<RowReport> reports;
};

Made composed(const std::string& first, const std::string& second, const std::string& to,
              const std::vector<double>& row, ConversionSettings settings = {}) {
    settings.tolerance = infinite;
    Made made;
    made.numbers.resize(spec(to).size());
    Composition(spec(first), spec(second), spec(to), settings).run(row, made.numbers, made.reports);
    return made;
}

Made rotated(const std::string& from, const std::vector<double>& row, ConversionSettings settings = {}) {
    settings.tolerance = infinite;
    Made made;
    made.numbers.resize(3);
    VectorRotation(spec(from), settings).run(row, made.numbers, made.reports);
    return made;
}

double largest_of(std::span<const double> numbers) {
    double largest = 0.0;
    for (const double number : numbers) {
        largest = std::max(largest, std::fabs(number));
    }
    return largest;
}

/// Numbers of an attitude in a SPEC, from quaternions; angles that are random where the oracle chooses none.
std::vector<double> numbers_of(const Spec& written, strata::Source& source) {
    if (representation(written.name).has_gimbal_lock) {
        const double unit = written.unit == AngleUnit::degrees ? 57.29577951308232 : 1.0;
        return {unit * source.uniform(-3, 3), unit * source.uniform(-1.5, 1.5), unit * source.uniform(-3, 3)};
    }
    return oracle::numbers(written, source.attitude());
}

/// Rotates by the matrix of the oracle's quaternion, not by rotconv's formula.
oracle::Vector3 exactly_rotated(const oracle::Quaternion& q, std::span<const double> vector) {
    return q.toRotationMatrix() * oracle::Vector3(vector[0], vector[1], vector[2]);
}

/// How many of the numbers are not the nearest doubles, of those that are not tiny beside the measure.
int wrong_of(std::span<const double> numbers, std::span<const oracle::Real> exact, double measure, int& held) {
    int wrong = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (std::fabs(numbers[i]) > 1e-6 * measure) {
            ++held;
            wrong += numbers[i] == exact[i].convert_to<double>() ? 0 : 1;
        }
    }
    return wrong;
}

} // namespace

// Catches the inverse, the wrong order, a sign, -0, a conjugate on one side only.
TEST_CASE("the product is the first attitude times the second") {
    // R turns x to y and y to z, S by 90 degrees about z: R S takes x to z, y to -y turned on.
    const std::vector<double> row{0.5, 0.5, 0.5, 0.5, 1, 0, 0, 1};
    const std::vector<double> other{1, 0, 0, 1, 0.5, 0.5, 0.5, 0.5};
    // conj(s) q = (1 - k)/sqrt(2) (1 + i + j + k)/2 = (1 + i)/sqrt(2); q conj(s) = (1 + j)/sqrt(2)
    CHECK(composed("quat:passive", "quat", "rotvec:deg", other).numbers == std::vector<double>{90, 0, 0});
    CHECK(composed("quat", "quat:passive", "rotvec:deg", row).numbers == std::vector<double>{0, 90, 0});
    CHECK(composed("quat:passive", "quat", "rotvec:deg:passive", other).numbers == std::vector<double>{-90, 0, 0});
    CHECK(composed("quat:passive", "quat", "dcm:col", other).numbers ==
          std::vector<double>{1, 0, 0, 0, 0, 1, 0, -1, 0});
    // q s = (1 + i + j + k)(1 + k)/(2 sqrt(2)) = (i + k)/sqrt(2)
    CHECK(composed("quat", "quat", "dcm", row).numbers == std::vector<double>{0, 0, 1, 0, -1, 0, 1, 0, 0});
    CHECK(composed("quat", "quat", "mrp", {2, 0, 0, 0, -3, 0, 0, 0}).numbers == std::vector<double>{0, 0, 0});
    for (int angle = 1; angle < 180; ++angle) { // rounded once
        const std::vector<double> yaws{0, 0, 200, 0, 0, 200.0 + angle};
        CHECK(composed("rpy:deg:passive", "rpy:deg", "rotvec:deg", yaws).numbers[2] == angle);
    }
}

// Catches a factor that is rounded before it is multiplied, a modifier that counts on one side only.
TEST_CASE("products of any two representations are rounded once") {
    strata::Source source(91);
    int held = 0;
    int wrong = 0;
    for (const char* first : {"quat", "quat:xyzw:passive", "dcm:col", "rotvec:deg", "euler:ZXZ:deg", "mrp", "5d"}) {
        for (const char* second : {"quat", "dcm:passive", "axis-angle", "rpy:deg", "cayley", "6d"}) {
            for (const char* to : {"quat:passive", "dcm", "rpy:deg", "rotvec:passive", "mrp", "euler:zxz:passive"}) {
                for (int i = 0; i < 12; ++i) {
                    const auto a = numbers_of(spec(first), source);
                    const auto b = numbers_of(spec(second), source);
                    const auto made = composed(first, second, to, joined(a, b));
                    oracle::Quaternion product = oracle::attitude(spec(first), a) * oracle::attitude(spec(second), b);
                    product.coeffs() *= oracle::Real(product.w() < 0 ? -1 : 1);
                    const auto exact = oracle::exact_numbers(spec(to), product);
                    wrong += wrong_of(made.numbers, exact, 1.0, held);
                }
            }
        }
    }
    CHECK(wrong == 0);
    CHECK(held > 10'000);
}

// Catches an attitude between two that is rounded before it is multiplied, the long way around, a part of the way that
// is rounded, 0 that is not known.
TEST_CASE("products with an attitude between two are rounded once") {
    strata::Source source(95);
    int held = 0;
    int wrong = 0;
    for (const char* second : {"quat", "dcm:passive", "axis-angle", "rpy:deg", "rotvec", "mrp", "6d"}) {
        for (const char* to : {"quat", "dcm", "rpy:deg", "rotvec", "euler:zxz:passive"}) {
            for (int i = 0; i < 60; ++i) {
                const auto a = numbers_of(spec("quat"), source);
                const auto c = numbers_of(spec(second), source);
                auto d = numbers_of(spec(second), source);
                if (i % 3 == 0) { // near to it
                    const double size = std::pow(10, -source.uniform(0, 20));
                    std::ranges::transform(c, d.begin(), [&](double x) { return x + size * source.normal(); });
                }
                const std::vector<double> way{0x1p90, 12345 * 0x1p43, source.uniform(0, 1), 0x1p91, 0, 0};
                oracle::Quaternion p = oracle::attitude(spec(second), c);
                oracle::Quaternion turn = p.conjugate() * oracle::attitude(spec(second), d);
                turn.coeffs() *= oracle::Real(turn.w() < 0 ? -1 : 1);
                const oracle::Real part = (oracle::Real(way[0]) + way[1] + way[2]) / way[3];
                p = p * oracle::about(turn.vec(), 2 * part * atan2(turn.vec().norm(), turn.w()));
                oracle::Quaternion product = oracle::attitude(spec("quat"), a) * p;
                product.coeffs() *= oracle::Real(product.w() < 0 ? -1 : 1);
                std::vector<double> numbers(spec(to).size());
                std::vector<RowReport> reports;
                const Composition composition(spec("quat"), spec(second), spec(to), {.tolerance = infinite});
                composition.interpolating().run(joined(joined(a, c), joined(d, way)), numbers, reports);
                const auto exact = oracle::exact_numbers(spec(to), product);
                wrong += wrong_of(numbers, exact, 1.0, held);
            }
        }
    }
    CHECK(wrong == 0);
    CHECK(held > 5'000);
    // planar turns: 0 stays 0; halfway between two doubles, and from one side of 0 to the other
    std::vector<double> angles(3);
    std::vector<RowReport> reports;
    const Composition sum = Composition(spec("rpy:deg"), spec("rpy:deg"), spec("rpy:deg")).interpolating();
    sum.run(std::vector<double>{0, 0, 0, 0, 0, 1, 0, 0, 1 + 0x1p-52, 1, 0, 0, 2, 0, 0}, angles, reports);
    CHECK(angles == std::vector<double>{0, 0, 1});
    sum.run(std::vector<double>{0, 0, 0, 0, 0, -30, 0, 0, 30, 1, 0, 0, 2, 0, 0}, angles, reports);
    CHECK(angles == std::vector<double>{0, 0, 0});
    sum.run(std::vector<double>{0, 0, 1e-200, 0, 0, 0, 0, 0, 360, 1, 0, 0, 2, 0, 0}, angles, reports);
    CHECK(angles == std::vector<double>{0, 0, 1e-200});
}

// Catches products that underflow, a power of two that is lost, components that are not plain and stay so.
TEST_CASE("products of extremely small turns and extremely scaled quaternions keep their digits") {
    strata::Source source(92);
    for (int i = 0; i < 300; ++i) {
        const double small = std::pow(10, -source.uniform(100, 290));
        const std::vector<double> tilt{small * source.normal(), small * source.normal(), small * source.normal()};
        const auto twice = composed("rotvec", "rotvec", "rotvec", joined(tilt, tilt)).numbers;
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(twice[k] == 2 * tilt[k]);
        }
        auto q = oracle::numbers(spec("quat"), source.attitude());
        auto scaled = q;
        const int power = i % 2 == 0 ? 900 : -900;
        std::ranges::for_each(scaled, [power](double& x) { x = std::ldexp(x, power); });
        const auto plain = composed("quat", "quat", "dcm", joined(q, q)).numbers;
        CHECK(composed("quat", "quat", "dcm", joined(scaled, q)).numbers == plain);
    }
}

// Catches an error of the wrong attitude, one that is not told, a product of an attitude that is none.
TEST_CASE("what there is to tell of a product") {
    const auto first = composed("quat", "quat", "dcm", {0, 0, 0, 0, 1, 0, 0, 0});
    REQUIRE(first.reports.size() == 1);
    CHECK((first.reports[0].error == Error::zero_quaternion && first.reports[0].at_fault == 0));
    const auto second = composed("quat", "dcm", "quat", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1});
    REQUIRE(second.reports.size() == 1);
    CHECK((second.reports[0].error == Error::not_proper && second.reports[0].at_fault == 1));
    CHECK(std::isnan(second.numbers[0]));
    const auto locked = composed("rpy:deg", "rpy:deg", "rpy:deg", {0, 40, 0, 0, 50, 0});
    REQUIRE(locked.reports.size() == 1);
    CHECK(locked.reports[0].diagnostics.has(DiagnosticKind::gimbal_lock));
    CHECK(locked.numbers == std::vector<double>{0, 90, 0});
}

// Catches the inverse, columns for rows, a vector that is rounded with the quaternion's norm.
TEST_CASE("vectors are rotated as by the matrix, each number rounded once") {
    CHECK(rotated("rpy:deg", {0, 0, 90, 1, 2, 3}).numbers == std::vector<double>{-2, 1, 3});
    CHECK(rotated("rpy:deg:passive", {0, 0, 90, 1, 2, 3}).numbers == std::vector<double>{2, -1, 3});
    CHECK(rotated("quat:xyzw", {0, 0, 0, 7, 0.1, 0.2, 0.3}).numbers == std::vector<double>{0.1, 0.2, 0.3});
    strata::Source source(93);
    int held = 0;
    int wrong = 0;
    for (const char* from : {"quat", "quat:xyzw:passive", "dcm", "dcm:col:passive", "6d", "5d", "axis-angle", "rotvec",
                             "euler:ZXZ:deg", "rpy", "cayley", "mrp:passive"}) {
        for (int i = 0; i < 200; ++i) {
            const auto attitude = numbers_of(spec(from), source);
            const double size = std::pow(10, source.uniform(-6, 6));
            const std::vector<double> vector{size * source.normal(), source.normal(), source.normal() / size};
            const auto made = rotated(from, joined(attitude, vector)).numbers;
            const auto exact = exactly_rotated(oracle::attitude(spec(from), attitude), vector);
            wrong += wrong_of(made, std::span(exact.data(), 3), largest_of(vector), held);
        }
    }
    CHECK(wrong == 0);
    CHECK(held > 5'000);
}

// Catches squares of numbers that leave the range, a subnormal result that is rounded twice, an infinite one that
// is printed, nan that passes.
TEST_CASE("vectors of any size are rotated") {
    strata::Source source(94);
    for (const double size : {1e308, 1e200, 1e-200, 1e-300, 1e-310, 5e-324}) {
        for (int i = 0; i < 200; ++i) {
            const auto q = oracle::numbers(spec("quat"), source.attitude());
            const std::vector<double> vector{size * source.uniform(0, 1), size * source.uniform(-1, 1), 0};
            const auto made = rotated("quat", joined(q, vector));
            const auto exact = exactly_rotated(oracle::attitude(spec("quat"), q), vector);
            for (Eigen::Index k = 0; k < 3; ++k) {
                const auto expected = exact[k].convert_to<double>();
                if (std::isfinite(made.numbers[0])) {
                    CHECK(made.numbers[static_cast<std::size_t>(k)] == expected);
                } else {
                    CHECK(made.reports.at(0).error == Error::overflow);
                }
            }
        }
    }
    const double most = std::numeric_limits<double>::max();
    CHECK(rotated("rpy:deg", {0, 0, 45, most, -most, 0}).reports.at(0).error == Error::overflow);
    CHECK(rotated("rpy:deg", {0, 0, 90, most, -most, 0}).numbers == std::vector<double>{most, most, 0});
    for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), infinite}) {
        const auto made = rotated("quat", {1, 0, 0, 0, 1, wrong, 2});
        CHECK(made.reports.at(0).error == Error::not_finite);
        CHECK(std::ranges::all_of(made.numbers, [](double x) { return std::isnan(x); }));
    }
    CHECK(rotated("quat", {0, 0, 0, 0, 1, 2, 3}).reports.at(0).error == Error::zero_quaternion);
    CHECK(rotated("quat", {1, 0, 0, 0, 1, 2, 3}).reports.empty());
}

// Catches a margin of the result, which has none, or of the inverse.
TEST_CASE("the sensitivity of a rotated vector is that of its attitude as it was read") {
    const auto made = rotated("rpy:deg:passive", {0, 60, 0, 1, 0, 0}, {.sensitivity = true});
    REQUIRE(made.reports.size() == 1);
    CHECK(made.reports[0].sensitivity.margin == Approx(std::numbers::pi / 6).epsilon(1e-14));
}
