// What the two source documents work out in numbers.

#include <cmath>
#include <numbers>

#include "accuracy.hpp"
#include "catch.hpp"

using accuracy::own;
using accuracy::spec;

namespace {

void check(const std::vector<double>& result, const std::vector<double>& printed, double margin) {
    REQUIRE(result.size() == printed.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        CHECK(result[i] == Approx(printed[i]).margin(margin));
    }
}

constexpr double last_digit = 1.1e-6; // six decimals, as rounded there

} // namespace

// Baruh, Example 1: the parameters of 350 degrees come back from the printed matrix with the other sign.
TEST_CASE("Baruh's first example") {
    const std::vector<double> matrix{0.986048,  -0.150702, -0.070700, 0.146981, 0.987598,
                                     -0.055195, 0.078141,  0.044033,  0.995969};
    check(own(spec("dcm:baruh"), spec("quat:baruh"))(matrix), {-0.024902, 0.037352, -0.074705, 0.996195}, last_digit);
    check(own(spec("dcm:baruh"), spec("axis-angle:deg:baruh"))(matrix), {-0.285714, 0.428571, -0.857143, 10}, 1e-4);
}

// Baruh, Example 2: -250 degrees; e3 is the largest of the four.
TEST_CASE("Baruh's second example") {
    const std::vector<double> turn{2, -3, 6, -250};
    check(own(spec("axis-angle:deg:baruh"), spec("quat:baruh"))(turn), {0.234043, -0.351065, 0.702130, 0.573576},
          last_digit);
    const std::vector<double> matrix{-0.232467, 0.641122,  0.731383,  -0.969780, -0.095527,
                                     -0.224503, -0.074067, -0.761471, 0.643954};
    check(own(spec("axis-angle:deg:baruh"), spec("dcm:baruh"))(turn), matrix, last_digit);
    check(own(spec("dcm:baruh"), spec("axis-angle:deg:baruh"))(matrix), {0.285714, -0.428571, 0.857143, 110}, 1e-4);
}

// Stuelpnagel, section 6: at lock cos(x7 phi + psi) = x5 and sin(x7 phi + psi) = -x2; psi = 0 is a choice.
TEST_CASE("Stuelpnagel's rule at gimbal lock") {
    for (const double x7 : {1.0, -1.0}) {
        const double alpha = 0.8;
        const double x5 = std::cos(alpha);
        const double x2 = -std::sin(alpha);
        // X = (x1 x4 x7; x2 x5 x8; x3 x6 x9) with x1 = x4 = x8 = x9 = 0 and third column (x7, 0, 0): x3, x6 from the
        // cross product
        const std::vector<double> matrix{0, 0, x7, x2, x5, 0, -x7 * x5, x7 * x2, 0};
        const auto angles = own(spec("dcm:stuelpnagel"), spec("rpy:stuelpnagel"))(matrix);
        INFO(x7);
        CHECK(angles[1] == Approx(-x7 * std::numbers::pi / 2).epsilon(1e-15));
        CHECK(angles[2] == 0.0);
        CHECK(std::cos(x7 * angles[0] + angles[2]) == Approx(x5).epsilon(1e-15));
        CHECK(std::sin(x7 * angles[0] + angles[2]) == Approx(-x2).epsilon(1e-15));
    }
}

// Stuelpnagel, section 6: a half-turn has the two vectors +-S; no finite Cayley vector.
TEST_CASE("Stuelpnagel's half-turn") {
    const std::vector<double> matrix{-1, 0, 0, 0, -1, 0, 0, 0, 1};
    const auto turn = own(spec("dcm:stuelpnagel"), spec("rotvec:stuelpnagel"))(matrix);
    CHECK(turn == std::vector<double>{0, 0, std::numbers::pi});
    for (const double sign : {1.0, -1.0}) {
        check(own(spec("rotvec:stuelpnagel"), spec("dcm:stuelpnagel"))(std::vector<double>{0, 0, sign * turn[2]}),
              matrix, 2.5e-16);
    }
    CHECK(std::isinf(own(spec("dcm:stuelpnagel"), spec("cayley:stuelpnagel"))(matrix)[2]));
}
