// The angle between two attitudes of a row, against the oracle.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <rotconv/comparison.hpp>
#include <rotconv/product.hpp>

#include "accuracy.hpp"
#include "catch.hpp"
#include "oracle.hpp"
#include "strata.hpp"

using namespace rotconv;
using accuracy::joined;

namespace {

struct Compared {
    std::vector<double> numbers;
    std::vector<RowReport> reports;
};

Compared compare(const std::string& from, const std::string& reference, const std::vector<double>& row,
                 ComparisonSettings settings = {}) {
    settings.reading.tolerance = std::numeric_limits<double>::infinity();
    const Comparison comparison(accuracy::spec(from), accuracy::spec(reference), settings);
    Compared compared;
    compared.numbers.resize(comparison.outputs());
    comparison.run(row, compared.numbers, compared.reports);
    return compared;
}

double angle(const std::string& from, const std::string& reference, const std::vector<double>& row) {
    return compare(from, reference, row).numbers.front();
}

double exact_angle(const oracle::Quaternion& a, const oracle::Quaternion& b) {
    return oracle::error_in_eps(a, b) * oracle::eps;
}

const std::vector<std::string>& specs() {
    static const std::vector<std::string> specs{"quat",       "quat:xyzw:passive", "dcm",        "dcm:col", "6d",
                                                "5d:passive", "axis-angle",        "rotvec:deg", "cayley",  "mrp",
                                                "euler:ZYX",  "euler:zxz:deg",     "rpy:passive"};
    return specs;
}

} // namespace

// Catches an arc cosine (wrong by 1e-8 near 0 and pi), a product in plain double, a convention of one side only.
TEST_CASE("the angle between any two representations is right near 0, near pi and between") {
    strata::Source source(41);
    for (const auto& from : specs()) {
        for (const auto& reference : specs()) {
            double worst = 0.0;
            for (int i = 0; i < 150; ++i) {
                const oracle::Quaternion attitude = source.attitude();
                const double apart = std::array{
                    source.uniform(0, 3.14), std::pow(10, -source.uniform(0, 17)),
                    3.14159265358979 - std::pow(10, -source.uniform(0, 17))}[static_cast<std::size_t>(i % 3)];
                const auto numbers_of = [&](const std::string& text, const oracle::Quaternion& q) {
                    const Spec spec = accuracy::spec(text);
                    const bool chosen = spec.name == RepresentationId::euler || spec.name == RepresentationId::rpy;
                    return chosen
                               ? accuracy::own(accuracy::spec("quat"), spec)(oracle::numbers(accuracy::spec("quat"), q))
                               : oracle::numbers(spec, q);
                };
                const auto a = numbers_of(from, attitude);
                const auto b = numbers_of(reference, oracle::about(source.axis(), apart) * attitude);
                if (!std::ranges::all_of(joined(a, b), [](double x) { return std::isfinite(x); })) {
                    continue;
                }
                const double exact = exact_angle(oracle::attitude(accuracy::spec(from), a),
                                                 oracle::attitude(accuracy::spec(reference), b));
                worst = std::max(worst, std::fabs(angle(from, reference, joined(a, b)) - exact) / oracle::eps);
            }
            INFO(from << " and " << reference);
            CHECK(worst <= 4.0);
            CHECK(worst > 0.01);
        }
    }
}

// Catches a turn of the reference too, sides exchanged, a turn of numbers that are the inverse, and one that the
// product or extraordinary rows miss.
TEST_CASE("constant rotations turn the first attitude of a comparison") {
    strata::Source source(44);
    const Spec quat = accuracy::spec("quat");
    for (int i = 0; i < 400; ++i) {
        const auto row = oracle::numbers(quat, source.attitude());
        auto left = oracle::numbers(quat, source.attitude());
        const auto right = oracle::numbers(quat, source.attitude());
        auto other = oracle::numbers(quat, source.attitude());
        const bool is_tiny = i % 4 == 0;
        if (is_tiny) { // nearly the identity
            left = {1.0, 1e-300 * source.normal(), 0.0, 1e-200};
            other = {1.0, 0.0, 0.0, 0.0};
        }
        const std::string from = i % 2 == 0 ? "quat" : "quat:passive";
        const auto exact =
            oracle::attitude(quat, left) * oracle::attitude(accuracy::spec(from), row) * oracle::attitude(quat, right);
        const auto exact_other = oracle::attitude(quat, other);
        ComparisonSettings settings;
        settings.reading.left = FixedRotation::of_numbers(quat, left);
        settings.reading.right = FixedRotation::of_numbers(quat, right);
        const double apart = compare(from, "quat", joined(row, other), settings).numbers.front();
        CHECK(std::fabs(apart - exact_angle(exact, exact_other)) <= 4.0 * oracle::eps);
        const Composition product(accuracy::spec(from), quat, quat, settings.reading);
        std::vector<double> found(4);
        std::vector<RowReport> reports;
        product.run(joined(row, other), found, reports);
        CHECK(oracle::error_in_eps(exact * exact_other, oracle::attitude(quat, found)) <= 1.0);
    }
}

// Catches quotients, norms or roots that are rounded for one of two equal attitudes.
TEST_CASE("the same numbers, of either sign, are 0 apart") {
    strata::Source source(42);
    for (const auto& text : specs()) {
        const Spec spec = accuracy::spec(text);
        for (const auto& row : accuracy::inputs(accuracy::spec("quat"), spec, 20)) {
            const auto numbers = accuracy::own(accuracy::spec("quat"), spec)(row);
            if (std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); })) {
                INFO(text << ' ' << row[0] << ' ' << row[1] << ' ' << row[2] << ' ' << row[3]);
                CHECK(angle(text, text, joined(numbers, numbers)) == 0.0);
            }
        }
    }
    for (int i = 0; i < 1000; ++i) {
        std::vector<double> q;
        for (int k = 0; k < 4; ++k) {
            q.push_back(source.normal() * std::pow(2, source.integer(-1070, 1000)));
        }
        std::vector<double> minus = q;
        std::ranges::for_each(minus, [](double& x) { x = -x; });
        CHECK(angle("quat", "quat", joined(q, q)) == 0.0);
        CHECK(angle("quat", "quat", joined(q, minus)) == 0.0);
    }
}

// Catches a small angle that a square loses, or that a component near 1 swallows.
TEST_CASE("quaternions near the identity give their angle in its own digits") {
    for (const double tiny : {1e-8, 1e-17, 1e-100, 1e-150, 1e-160}) {
        // 2 atan(|tiny - 3 tiny|), and across two axes
        CHECK(angle("quat", "quat", {1, tiny, 0, 0, 1, 3 * tiny, 0, 0}) == Approx(4 * tiny).epsilon(1e-15).margin(0));
        CHECK(angle("quat", "quat", {1, 3 * tiny, 0, 0, -1, 0, 0, 4 * tiny}) ==
              Approx(10 * tiny).epsilon(1e-15).margin(0));
        CHECK(angle("quat", "rotvec", {1, 0, 0, 0, 0, tiny, 0}) == Approx(tiny).epsilon(1e-15).margin(0));
    }
}

// Catches two triples of one locked attitude that are told apart, a quaternion and its matrix.
TEST_CASE("one attitude in other numbers is at most 4 eps apart") {
    strata::Source source(43);
    for (int i = 0; i < 500; ++i) {
        const double first = source.uniform(-180, 180);
        const double third = source.uniform(-180, 180);
        const double given = std::round(first) - std::round(third);
        CHECK(angle("euler:ZYX:deg", "euler:ZYX:deg", {std::round(first), 90, std::round(third), given, 90, 0}) <=
              4 * oracle::eps);
        const auto q = oracle::numbers(accuracy::spec("quat"), source.attitude());
        const auto m = oracle::numbers(accuracy::spec("dcm"), oracle::attitude(accuracy::spec("quat"), q));
        CHECK(angle("quat", "dcm", joined(q, m)) <= 4 * oracle::eps);
    }
}

// Catches an angle at the limit that is told, one above that is not, an error of the wrong attitude.
TEST_CASE("what there is to tell of a comparison") {
    const auto within = [](double limit) {
        return compare("rotvec", "rotvec", {0, 0, 0.25, 0, 0, 0}, {.within = limit}).reports;
    };
    CHECK(within(0.25).empty());
    REQUIRE(within(0.2499).size() == 1);
    CHECK(within(0.2499)[0].diagnostics.has(DiagnosticKind::beyond));
    CHECK(within(0.2499)[0].deviation == 0.25);
    const auto first = compare("quat", "dcm", {0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    REQUIRE(first.reports.size() == 1);
    CHECK((first.reports[0].error == Error::zero_quaternion && first.reports[0].at_fault == 0));
    const auto second = compare("quat", "dcm", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1});
    REQUIRE(second.reports.size() == 1);
    CHECK((second.reports[0].error == Error::not_proper && second.reports[0].at_fault == 1));
    CHECK(std::isnan(second.numbers[0]));
    const Comparison strict(accuracy::spec("quat"), accuracy::spec("quat"));
    std::vector<RowReport> reports;
    std::array<double, 1> out{};
    strict.run(std::vector<double>{1, 0, 0, 0, 1.0005, 0, 0, 0}, out, reports);
    REQUIRE(reports.size() == 1);
    CHECK(reports[0].diagnostics.has(DiagnosticKind::normalized));
    CHECK(reports[0].references[0].defect == Approx(0.0005));
}

// Catches readings in plain double, which are 3 eps off at worst. Found by a search against 100 digits.
TEST_CASE("the worst pairs that are known") {
    const auto off = [](const std::string& from, const std::string& reference, const std::vector<double>& row,
                        const char* exact) {
        return std::fabs(static_cast<double>(oracle::Real(angle(from, reference, row)) - oracle::Real(exact))) /
               oracle::eps;
    };
    CHECK(off("euler:ZXZ:deg", "euler:zxy:deg",
              {-115.97181282900598, 84.51266649599391, 56.81278270258725, 79.10026189600794, -60.15714879681814,
               71.33506731015248},
              "2.204655493634867914649") <= 2.0);
    CHECK(off("dcm", "dcm",
              {0.05967861064548287, -0.9203638981063897, 0.38683430498968696, 0.8810760833574959, 0.23033706991598452,
               0.41241762633185935, -0.4689718290299471, 0.3165536185595954, 0.8248275691408398, 0.7013792019178384,
               0.6584704827508465, 0.2729172733121113, -0.7125743917636419, 0.6571167789514122, 0.24583587214221572,
               -0.017462908837396974, -0.3668980175084839, 0.9300972459397382},
              "2.198473003591359054873") <= 2.0);
}
