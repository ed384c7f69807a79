// The last phase: its numbers against MPFR's, with which it shares nothing, the bounds on their errors, and rows that
// 106 bits do not decide.

#include <cmath>
#include <cstddef>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <boost/math/constants/constants.hpp>

#include <rotconv/conversion.hpp>

#include "../../src/core/numerics/elementary.hpp"
#include "accuracy.hpp"
#include "catch.hpp"
#include "oracle.hpp"

namespace {

using rotconv::Wide;
using Real = oracle::Digits<1700>;

Real real(const Wide& number) {
    Real sum = 0;
    Wide rest = number;
    for (int exponent = rest.exponent(); exponent > -100'000; exponent = rest.exponent()) {
        const double part = rest.shifted(-exponent).rounded();
        sum += ldexp(Real(part), exponent);
        rest = rest - Wide(part).shifted(exponent);
    }
    return sum;
}

/// The exponent of a power of two above the bound on its error.
int exponent_of_bound(const Wide& number) {
    const Wide error = number - number.middle();
    int low = -20'000;
    int high = 2'000;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        (error.is_below(middle) ? high : low) = middle;
    }
    return high;
}

/// The number is within its bound, and this below 2^-digits of the number.
void check(const char* what, const Wide& found, const Real& right, int digits) {
    const int bound = exponent_of_bound(found);
    INFO(what << " with " << Wide::Bits::bits() << " bits, bound 2^" << bound);
    CHECK(abs(real(found.middle()) - right) <= ldexp(Real(1), bound));
    CHECK(ldexp(Real(1), bound + digits) <= abs(right));
}

} // namespace

// Catches a bound that is below the error, or so far above it that nothing is decided; a series that ends early.
TEST_CASE("what Wide computes is within its bounds, which are small") {
    const Real pi = boost::math::constants::pi<Real>();
    std::mt19937_64 engine(95);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    };
    for (const int bits : {256, 1280, 5120}) {
        const Wide::Bits some(bits);
        for (int i = 0; i < tried(60); ++i) {
            const double a = uniform(-3, 3) * (i % 3 == 0 ? std::exp2(uniform(-60, 60)) : 1.0);
            const double b = uniform(-3, 3) * (i % 4 == 0 ? std::exp2(uniform(-60, 20)) : 1.0);
            INFO(a << ' ' << b);
            check("product", Wide(a) * root(Wide(2.0)), a * sqrt(Real(2)), bits - 4);
            check("quotient", Wide(a) / Wide(b), Real(a) / b, bits - 4);
            check("root", root(square(Wide(a)) + square(Wide(b))), sqrt(Real(a) * a + Real(b) * b), bits - 4);
            for (const auto unit : {rotconv::AngleUnit::radians, rotconv::AngleUnit::degrees}) {
                const Real unit_size = unit == rotconv::AngleUnit::degrees ? Real(pi / 180) : Real(1);
                const auto found = rotconv::sine_cosine(Wide(a), unit);
                check("sine", found.sine, sin(a * unit_size), bits - 70);
                check("cosine", found.cosine, cos(a * unit_size), bits - 70);
                check("angle", rotconv::angle_of(Wide(a), Wide(b), unit), atan2(Real(b), Real(a)) / unit_size,
                      bits - 10);
            }
        }
    }
}

// Catches a difference that is rounded before it cancels, a bound that is lost where a number is 0.
TEST_CASE("Wide tells 0 from what may be 0") {
    const Wide::Bits some(256);
    const Wide third = Wide(1.0) / Wide(3.0);
    const Wide nothing = third + third + third - Wide(1.0);
    CHECK(nothing.may_be_zero());
    CHECK(!Wide::Bits::doubted());
    CHECK(nothing.sign() == 0);
    CHECK(Wide::Bits::doubted());
    CHECK(!(Wide(1.0) - Wide(1.0)).may_be_zero());
    CHECK((Wide(1.0) + Wide(0x1p-200) - Wide(1.0)).sign() == 1);
    double nearest = 1.0;
    CHECK(!nothing.round(nearest));
    CHECK(nearest == 0.0);
}

// Catches a tie that is rounded away from the even one, or past it by what is beside it; a subnormal rounded twice.
TEST_CASE("Wide rounds once, of ties to the even one") {
    const Wide::Bits some(1280);
    const auto rounded = [](const Wide& number) {
        double nearest = 0.0;
        CHECK(number.round(nearest));
        return nearest;
    };
    CHECK(rounded(Wide(1.0) + Wide(0x1p-53)) == 1.0);
    CHECK(rounded(Wide(1.0) + Wide(0x3p-53)) == 1.0 + 0x1p-51);
    CHECK(rounded(Wide(1.0) + Wide(0x1p-53) + Wide(0x1p-1000)) == 1.0 + 0x1p-52);
    CHECK(rounded(Wide(-1.0) - Wide(0x1p-53) - Wide(0x1p-1000)) == -1.0 - 0x1p-52);
    CHECK(rounded(Wide(0x1p-1074).shifted(-1)) == 0.0);
    CHECK(rounded(Wide(0x3p-1074).shifted(-1)) == 0x2p-1074);
    CHECK(rounded(Wide(0x1p-1074).shifted(-1) + Wide(0x1p-1074).shifted(-300)) == 0x1p-1074);
    CHECK(rounded(Wide(0x1.fffffffffffffp1023) + Wide(0x1p970)) == std::numeric_limits<double>::infinity());
    double even = 0.0;
    const Wide doubtful = Wide(1.0) + Wide(0x1p-53) + (root(Wide(2.0)) - root(Wide(2.0)));
    CHECK(!doubtful.round(even));
    CHECK(even == 1.0);
}

// Catches numbers so near to the midpoint of two doubles that 106 bits take the wrong one of them. The rows are of the
// worst cases of CORE-MATH (https://core-math.gitlabpages.inria.fr), of its atan2, sine and cosine.
TEST_CASE("the worst cases of CORE-MATH are rounded once") {
    std::ifstream file(ROTCONV_TEST_DATA "/hard_rows.csv");
    std::string line;
    std::getline(file, line); // from,to,a,b,c,d,expected
    std::size_t rows = 0;
    while (std::getline(file, line)) {
        std::vector<std::string> fields;
        std::istringstream text(line);
        for (std::string field; std::getline(text, field, ',');) {
            fields.push_back(field);
        }
        const auto from = accuracy::spec(fields.at(0));
        const auto to = accuracy::spec(fields.at(1));
        std::vector<double> row;
        for (std::size_t k = 0; k < from.size(); ++k) {
            row.push_back(std::stod(fields.at(2 + k)));
        }
        const auto found =
            accuracy::converted(from, to, row, {.tolerance = std::numeric_limits<double>::infinity()}).numbers;
        std::istringstream expected(fields.at(6));
        std::vector<double> numbers;
        for (double number = 0.0; expected >> number;) {
            numbers.push_back(number);
        }
        INFO(line);
        CHECK((numbers.size() == 1 ? std::vector{found.at(3)} : std::vector{found.at(0), found.at(3)}) == numbers);
        ++rows;
    }
    CHECK(rows == 3000);
}
