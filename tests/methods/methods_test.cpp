// Published methods: each holds where its table says, and fails where it is known to fail, by as much. A suite that
// cannot tell them from rotconv's own proves nothing.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>

#include <Eigen/Geometry>

#include <rotconv/conversion.hpp>

#include "accuracy.hpp"
#include "catch.hpp"
#include "methods/method_conversion.hpp"
#include "oracle.hpp"
#include "strata.hpp"

namespace {

using accuracy::spec;
using rotconv::Method;
using rotconv::RepresentationId;

constexpr double inf = std::numeric_limits<double>::infinity();

/// What a conversion makes of one row.
struct Answered {
    Answered(const rotconv::MethodConversion& conversion, std::span<const double> row) : out(conversion.to().size()) {
        conversion.run(row, out, angles, reports);
    }

    std::vector<double> out;
    std::vector<double> angles;
    std::vector<rotconv::RowReport> reports;
};

accuracy::Convert by(const Method& method, const rotconv::Spec& from, const rotconv::Spec& to) {
    const rotconv::Conversion own(from, to, {.tolerance = inf, .lock_margin = 0.0});
    return [conversion = rotconv::MethodConversion(own, method)](std::span<const double> row) {
        return Answered(conversion, row).out;
    };
}

/// By a published method of that name, or rotconv's own.
accuracy::Convert by(std::string_view name, const rotconv::Spec& from, const rotconv::Spec& to) {
    if (name == rotconv::default_method) {
        return accuracy::own(from, to);
    }
    const Method* method = rotconv::find_method(from.name, to.name, name);
    INFO(name);
    REQUIRE(method != nullptr);
    return by(*method, from, to);
}

/// Turns of one radian about random axes, away from the lock of ZYX: harmless to every method.
std::vector<std::vector<double>> gentle(const rotconv::Spec& from, std::size_t count = 200) {
    strata::Source source(31);
    std::vector<std::vector<double>> rows;
    while (rows.size() < count) {
        rows.push_back(oracle::numbers(from, oracle::about(source.axis(), oracle::Real(1))));
    }
    return rows;
}

/// What is known of a method. Errors in eps = 2^-52 rad; a half-turn wrong is 1.4e16, a number that is not finite
/// infinite.
struct Known {
    std::string from;
    std::string to;
    std::string name;
    double holds_to;   ///< at most, on gentle turns
    double fails_by;   ///< at least, somewhere on all strata; 0: it does not fail
    double never_past; ///< at most, on all strata
};

const std::vector<Known>& known() {
    // Failures by 1e16 are half-turns and lock; by 1e12 matrices off by 5e-4, whose nearest rotation a pivot alone
    // misses; infinite ones 0/0 at the identity or a half-turn. The largest and smallest are rounding.
    static const std::vector<Known> table{
        {"dcm", "quat", "default", 2.5, 0, 2.5},
        {"dcm", "quat", "trace", 2, 1e16, inf},
        {"dcm", "quat", "baruh", 2, 1e15, inf},
        {"dcm", "quat", "four-roots", 1e4, 1e15, inf},
        {"dcm", "quat", "klumpp", 1e4, 1e13, 1e15},
        {"dcm", "quat", "shepperd", 2.4, 1e11, 1e13},
        {"dcm", "quat", "markley", 2, 1e11, 1e13},
        {"dcm", "quat", "first-order", 2, 1e8, 1e10},
        {"dcm", "quat", "cayley", 2, 1e15, inf},
        {"dcm", "quat", "sarabandi-thomas", 2, 1e15, inf},
        {"dcm", "quat", "sarabandi-2020", 2, 1e11, 1e13},
        {"dcm", "quat", "adjugate", 2, 1e11, 1e13},
        {"dcm", "quat", "bar-itzhack", 6, 0, 6},
        {"dcm", "quat", "svd", 10, 0, 16},
        {"dcm", "quat", "polar", 3, 0, 3},
        {"dcm", "quat", "compensated", 2, 1e3, 1e8},
        {"dcm", "rotvec", "default", 4.5, 0, 4.5},
        {"dcm", "rotvec", "acos", 3, 1e15, inf},
        {"dcm", "rotvec", "atan2", 3, 1e15, inf},
        {"dcm", "rotvec", "polynomial", 3, 1e15, inf},
        {"dcm", "rotvec", "nurlanov", 1e4, 1e11, inf},
        {"dcm", "rotvec", "gtsam", 2, 1e12, 1e15},
        {"dcm", "rotvec", "hertzberg", 3, 1e11, 1e13},
        {"dcm", "rotvec", "quaternion", 4, 1e11, 1e13},
        {"dcm", "rotvec", "compensated", 2, 1e3, 1e8},
        {"dcm", "euler", "default", 4, 0, 4},
        {"dcm", "euler", "asin", 4, 1e15, inf},
        {"dcm", "euler", "slabaugh", 4, 1e15, inf},
        {"dcm", "euler", "shoemake", 4, 1e15, inf},
        {"dcm", "euler", "shuster-markley", 4, 1e15, 1.5e16},
        {"dcm", "euler", "eigen", 4, 1e11, 1e13},
        {"dcm", "cayley", "default", 3, 0, 3.5},
        {"dcm", "cayley", "lu", 4, 1e15, inf},
        {"dcm", "cayley", "polynomial", 3, 1e15, inf},
        {"dcm", "cayley", "quaternion", 3, 1e11, inf},
        {"quat", "dcm", "default", 1, 0, 1},
        {"quat", "dcm", "unit", 1.4, 1e15, inf},
        {"quat", "dcm", "two-over-norm", 1.7, 0, 1.7},
        {"quat", "dcm", "homogeneous", 1, 0, 1},
        {"quat", "dcm", "normalise-first", 2, 0, 2.5},
        {"quat", "rotvec", "default", 3, 0, 3},
        {"quat", "rotvec", "acos", 4, 1e7, inf},
        {"quat", "rotvec", "atan2", 3, 0, 8},
        {"quat", "rotvec", "compensated", 1.6, 0, 1.6},
        {"quat", "euler", "default", 4, 0, 4},
        {"quat", "euler", "classic", 4, 1e7, inf},
        {"quat", "euler", "matrix-threshold", 4, 1e9, 2e10},
        {"quat", "euler", "bernardes-arccos", 6, 1e7, 1e10},
        {"quat", "euler", "bernardes-atan2", 6, 0, 7},
        {"rotvec", "quat", "default", 1, 0, 1.5},
        {"rotvec", "quat", "half-angle", 1.5, 1e15, inf},
        {"rotvec", "quat", "taylor", 1.5, 1e12, 1e15},
        {"rotvec", "quat", "branchless", 1.5, 1e12, 1e15},
        {"rotvec", "dcm", "default", 2, 0, 2.5},
        {"rotvec", "dcm", "rodrigues", 2, 1e15, inf},
        {"rotvec", "dcm", "half-angle", 2, 1e15, inf},
        {"rotvec", "dcm", "quaternion", 2, 1e15, inf},
        {"rotvec", "dcm", "compensated", 2, 0, 2},
        {"cayley", "dcm", "default", 1, 0, 1},
        {"cayley", "dcm", "inverse", 3, 1e15, inf},
        {"cayley", "dcm", "closed", 1.5, 0, 1.5},
        {"6d", "dcm", "default", 1, 0, 1},
        {"6d", "dcm", "gram-schmidt", 1.5, 0, 1.5},
        {"6d", "dcm", "symmetric", 1.5, 1e11, 1e13},
    };
    return table;
}

} // namespace

// Catches a method that is written wrong, or made better than it is; a check that does not notice its failure.
TEST_CASE("methods hold where they are known to hold, and fail where they are known to fail") {
    for (const Known& expected : known()) {
        const auto from = spec(expected.from);
        const auto to = spec(expected.to == "euler" ? "euler:ZYX" : expected.to);
        INFO(expected.from << " to " << expected.to << " by " << expected.name);
        const auto convert = by(expected.name, from, to);
        CHECK(accuracy::worst_error(from, to, convert, gentle(from)).error <= expected.holds_to);
        const auto worst = accuracy::worst_error(from, to, convert, accuracy::inputs(from, to, 200));
        INFO(worst.where);
        CHECK(worst.error >= expected.fails_by);
        CHECK(worst.error <= expected.never_past);
    }
}

// Catches a formula put right on the way, or wrong where noise, which all of these lose digits to, hides it.
TEST_CASE("the weaknesses of formulas for exact matrices, without noise") {
    const std::vector<Known> exact{
        {"dcm", "quat", "first-order", 2, 0, 2},    {"dcm", "quat", "sarabandi-2020", 2, 0, 2},
        {"dcm", "quat", "adjugate", 2, 0, 4},       {"dcm", "rotvec", "nurlanov", 1e4, 1e7, 1e9},
        {"dcm", "rotvec", "gtsam", 2, 1e12, 1e13},  {"dcm", "rotvec", "hertzberg", 3, 0, 5},
        {"dcm", "euler", "asin", 4, 1e15, 1e300},   {"dcm", "euler", "slabaugh", 4, 1e7, 1e9},
        {"dcm", "euler", "shoemake", 4, 1e9, 2e10}, {"dcm", "euler", "shuster-markley", 4, 1e7, 1e10},
        {"dcm", "euler", "eigen", 4, 0, 3},         {"rotvec", "quat", "half-angle", 1.5, 1e15, inf},
        {"rotvec", "quat", "taylor", 1.5, 0, 3},    {"rotvec", "quat", "branchless", 1.5, 0, 3},
        {"6d", "dcm", "symmetric", 1.5, 0, 1},
    };
    for (const Known& expected : exact) {
        const auto from = spec(expected.from);
        const auto to = spec(expected.to == "euler" ? "euler:ZYX" : expected.to);
        const auto convert = by(expected.name, from, to);
        double worst = 0.0;
        for (const auto& rows : strata::strata_of(from, to, 400)) {
            worst = rows.hostile ? worst : std::max(worst, accuracy::worst_error(from, to, convert, rows.rows).error);
        }
        INFO(expected.name);
        CHECK(worst >= expected.fails_by);
        CHECK(worst <= expected.never_past);
    }
}

// Catches a method that is listed and never tried, or never measured.
TEST_CASE("every method of the table is known to the tests and to methods.csv") {
    const std::string measured = accuracy::text_of(ROTCONV_EXAMPLES "/charts/methods.csv");
    const auto defaults = std::ranges::count(known(), rotconv::default_method, &Known::name);
    CHECK(std::ssize(rotconv::methods()) + defaults == std::ssize(known()));
    for (const Method& method : rotconv::methods()) {
        const auto found = std::ranges::find_if(known(), [&](const Known& row) {
            return row.from == rotconv::representation(method.from).text &&
                   row.to == rotconv::representation(method.to).text && row.name == method.name;
        });
        INFO(method.name);
        CHECK(found != known().end());
        std::ostringstream measurement;
        measurement << '\n'
                    << rotconv::representation(method.from).text << ',' << rotconv::representation(method.to).text
                    << ',' << method.name << ',';
        CHECK(measured.find(measurement.str()) != std::string::npos);
        CHECK_FALSE(method.reference.empty());
        CHECK_FALSE(method.domain.empty());
    }
}

// Catches a formula that is right for one sequence only, or a convention that the methods do not see.
TEST_CASE("methods know all sequences, the inverse and degrees") {
    for (const auto& [from_text, near_lock] : {std::pair{"quat:xyzw", "bernardes-arccos"}, {"dcm:col", "asin"}}) {
        for (const auto sequence : rotconv::EulerSequence::all()) {
            const auto from = spec(from_text);
            const std::string name = "euler:" + sequence.text();
            for (const std::string& to_text : {name, name + ":deg:passive"}) {
                const auto to = spec(to_text);
                auto rows = gentle(from, 60);
                if (sequence.proper()) { // a radian about a random axis may be near the lock of a proper sequence
                    const auto convert = by(near_lock, from, to);
                    std::erase_if(rows, [&](const auto& row) {
                        return accuracy::worst_error(from, to, convert, {row}).error > 8;
                    });
                    CHECK(rows.size() > 30);
                }
                for (const Method& method : rotconv::methods_of(from.name, to.name)) {
                    INFO(from_text << " to " << to_text << " by " << method.name);
                    CHECK(accuracy::worst_error(from, to, by(method, from, to), rows).error <= 30);
                }
            }
        }
    }
    for (const auto& [from_text, to_text] :
         std::vector<std::pair<std::string, std::string>>{{"dcm:col:passive", "quat:xyzw"},
                                                          {"rotvec:deg", "dcm:passive"},
                                                          {"quat:passive", "rotvec:deg"},
                                                          {"cayley:passive", "dcm"},
                                                          {"dcm", "cayley:passive"},
                                                          {"dcm:passive", "rotvec"},
                                                          {"rotvec:deg:passive", "quat:xyzw"},
                                                          {"6d:passive", "dcm:col"}}) {
        const auto from = spec(from_text);
        const auto to = spec(to_text);
        for (const Method& method : rotconv::methods_of(from.name, to.name)) {
            INFO(from_text << " to " << to_text << " by " << method.name);
            CHECK(accuracy::worst_error(from, to, by(method, from, to), gentle(from)).error <= 1e4);
        }
    }
}

// Catches the other of the two triples, which Eigen does not give.
TEST_CASE("the angles of the method eigen are those of Eigen") {
    const auto from = spec("dcm");
    for (const auto sequence : rotconv::EulerSequence::all()) {
        if (!sequence.intrinsic()) {
            continue;
        }
        const auto to = spec("euler:" + sequence.text());
        const auto convert = by("eigen", from, to);
        for (const auto& row : gentle(from)) {
            const Eigen::Matrix3d matrix = Eigen::Map<const Eigen::Matrix3d>(row.data()).transpose();
            const auto angles = convert(row);
            const Eigen::Vector3d expected = matrix.eulerAngles(sequence.axis(0), sequence.axis(1), sequence.axis(2));
            CHECK((Eigen::Map<const Eigen::Vector3d>(angles.data()) - expected).norm() <= 1e-13);
        }
    }
}

// Catches one column that is kept at the cost of the other.
TEST_CASE("symmetric orthogonalisation shares between two columns what Gram-Schmidt takes from one") {
    const auto from = spec("6d");
    const auto to = spec("dcm");
    const auto convert = by("symmetric", from, to);
    const auto matrix = convert(std::vector<double>{2, 0.3, 0, 0.3, 1, 0}); // the identity times a symmetric matrix
    const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
    CHECK((Eigen::Map<const Eigen::Matrix3d>(matrix.data()) - identity).norm() <= 1e-15);
}

// Catches a published logarithm mended on the way, or a compensated one that is not.
TEST_CASE("logarithms of a quaternion with w < 0 are longer than pi as published, shorter compensated") {
    const std::vector<double> row{-0.6, 0.0, 0.0, 0.8};
    const double published = 2.0 * std::acos(-0.6);
    for (const auto& [name, z] : {std::pair{"acos", published},
                                  {"atan2", published},
                                  {"compensated", published - 2.0 * std::numbers::pi},
                                  {"default", published - 2.0 * std::numbers::pi}}) {
        INFO(name);
        const auto from = spec("quat");
        const auto to = spec("rotvec");
        const auto convert = by(name, from, to);
        CHECK(convert(row)[2] == Approx(z).epsilon(1e-15));
        CHECK(accuracy::worst_error(from, to, convert, {row}).error <= 3);
    }
}

// Catches a wrong answer that passes as right.
TEST_CASE("a method's error is reported with its angle") {
    const auto report_of = [](const std::string& from_text, const std::string& to_text, std::string_view name,
                              const std::vector<double>& row) {
        const auto from = spec(from_text);
        const auto to = spec(to_text);
        const Method* method = rotconv::find_method(from.name, to.name, name);
        REQUIRE(method != nullptr);
        const rotconv::Conversion own(from, to, {.sensitivity = true}); // a report of every row
        return Answered(rotconv::MethodConversion(own, *method), row).reports.at(0);
    };
    const std::vector<double> half_turn{-1, 0, 0, 0, 1, 0, 0, 0, -1};
    const auto wrong = report_of("dcm", "quat", "baruh", half_turn);
    CHECK(wrong.diagnostics.has(rotconv::DiagnosticKind::method_error));
    CHECK(std::isnan(wrong.deviation));
    CHECK(report_of("dcm", "quat", "shepperd", half_turn).diagnostics.empty());
    // 90 degrees about z, k times too long: the unit formula gives the angle of (1 - k^2, k^2).
    const double k = 1.0001;
    const auto off = report_of("quat", "dcm", "unit", {k * std::sqrt(0.5), 0, 0, k * std::sqrt(0.5)});
    CHECK(off.diagnostics.has(rotconv::DiagnosticKind::method_error));
    CHECK(off.deviation == Approx(std::atan2(k * k - 1.0, k * k)).epsilon(1e-9));
    // By less than is reported, on a row with nothing to report: k^2 below 1 + 1e-7.
    const double close = 1.0 + 4e-8;
    const auto unremarkable = report_of("quat", "dcm", "unit", {close * std::sqrt(0.5), 0, 0, close * std::sqrt(0.5)});
    CHECK(unremarkable.diagnostics.empty());
    CHECK(unremarkable.deviation == Approx(std::atan2(close * close - 1.0, close * close)).epsilon(1e-6));
    // v/0: one component is infinite, as it is to be, the others are none.
    CHECK(report_of("dcm", "cayley", "quaternion", half_turn).diagnostics.has(rotconv::DiagnosticKind::method_error));
    // At 0.03 rad from a half-turn about (1, 2, 3), worked out apart.
    const auto near = oracle::numbers(
        spec("dcm"), oracle::about(oracle::Vector3(1, 2, 3).normalized(), oracle::pi() - oracle::Real(0.03)));
    CHECK(report_of("dcm", "rotvec", "gtsam", near).deviation == Approx(0.000383730846).epsilon(1e-6));
    // A row without an attitude stays a error.
    CHECK(report_of("dcm", "quat", "trace", {0, 0, 0, 0, 0, 0, 0, 0, 0}).error == rotconv::Error::not_proper);
}

/// Finite numbers, and a matrix not far from a rotation: elsewhere rounding decides on the attitude.
bool has_attitude(const rotconv::Spec& to, std::span<const double> answer) {
    const bool is_finite = std::ranges::all_of(answer, [](double v) { return std::isfinite(v); });
    if (!is_finite || to.name != RepresentationId::dcm) {
        return is_finite;
    }
    const Eigen::Map<const Eigen::Matrix3d> m(answer.data());
    return m.determinant() > 0.0 && (m.transpose() * m - Eigen::Matrix3d::Identity()).norm() <= 0.2;
}

// Catches an angle to another attitude, one that stands beside another answer, or one that has its own errors.
TEST_CASE("the angle of every method's answer is that to the attitude, to 5 eps") {
    double worst = 0.0;
    std::size_t checked = 0;
    for (const auto& [from_text, to_text] :
         std::vector<std::pair<std::string, std::string>>{{"dcm", "quat"},
                                                          {"dcm:col:passive", "rotvec:deg"},
                                                          {"quat", "dcm"},
                                                          {"quat:xyzw", "rotvec"},
                                                          {"quat", "euler:ZYX:deg"},
                                                          {"dcm", "rpy:deg"},
                                                          {"rotvec:deg", "quat"},
                                                          {"6d", "dcm:passive"},
                                                          {"quat", "rpy:passive"},
                                                          {"rotvec", "dcm"},
                                                          {"cayley", "dcm:col"},
                                                          {"mrp", "rotvec"}}) {
        const auto from = spec(from_text);
        const auto to = spec(to_text);
        const auto all =
            rotconv::MethodConversion::all(rotconv::Conversion(from, to, {.tolerance = inf, .lock_margin = 0.0}));
        CHECK(all.size() == rotconv::methods_of(from.name, to.name).size() + 2);
        auto rows = accuracy::inputs(from, to, 20);
        std::ranges::copy(gentle(from), std::back_inserter(rows));
        for (const auto& row : rows) {
            const auto attitude = oracle::attitude(from, row);
            for (const rotconv::MethodConversion& each : all) {
                const auto [answer, angles, reports] = Answered(each, row);
                REQUIRE(angles.size() == 1);
                INFO(from_text << " to " << to_text << " by " << each.name());
                const bool is_refused = !reports.empty() && reports.front().error != rotconv::Error::none;
                if (is_refused || !has_attitude(to, answer)) {
                    continue;
                }
                const double exact = oracle::error_in_eps(attitude, oracle::attitude(to, answer));
                CHECK(std::abs(angles[0] / oracle::eps - exact) <= 5.0);
                worst = std::max(worst, std::abs(angles[0] / oracle::eps - exact));
                ++checked;
            }
        }
    }
    CHECK(checked > 10000);
    CHECK(worst > 0.0);
}

// Catches a conversion that is turned for some methods only, or turned twice.
TEST_CASE("methods answer for attitudes that are turned") {
    const auto from = spec("dcm:col");
    const auto to = spec("quat:xyzw");
    const auto turn = [](const oracle::Quaternion& q) {
        const auto numbers = oracle::numbers(spec("quat"), q);
        return rotconv::FixedRotation::of_numbers(spec("quat"), numbers);
    };
    const auto left = oracle::about({1, 2, 3}, oracle::Real(1));
    const auto right = oracle::about({-2, 1, 1}, oracle::Real(2));
    const auto all =
        rotconv::MethodConversion::all(rotconv::Conversion(from, to, {.left = turn(left), .right = turn(right)}));
    for (const auto& row : gentle(from)) {
        const oracle::Quaternion attitude = left * oracle::attitude(from, row) * right;
        for (const rotconv::MethodConversion& each : all) {
            const auto [answer, angles, reports] = Answered(each, row);
            const bool near_zero = std::ranges::any_of(answer, [](double v) { return std::abs(v) < 0.03; });
            if (!near_zero) { // klumpp and four-roots lose digits there, trace and baruh near half-turns
                INFO(each.name());
                CHECK(oracle::error_in_eps(attitude, oracle::attitude(to, answer)) <= 3e4);
                CHECK(angles[0] <= 3e4 * oracle::eps);
            }
        }
    }
}

// Catches rows of nine numbers, written by a method of another pair where there is room for four.
TEST_CASE("a conversion takes no method of another pair") {
    const auto conversion = [](const std::string& from, const std::string& to, const Method& method) {
        return rotconv::MethodConversion(rotconv::Conversion(spec(from), spec(to)), method);
    };
    const Method* unit = rotconv::find_method(RepresentationId::quat, RepresentationId::dcm, "unit");
    REQUIRE(unit != nullptr);
    CHECK_NOTHROW(conversion("quat", "dcm", *unit));
    CHECK_THROWS_AS(conversion("dcm", "quat", *unit), std::invalid_argument);
    CHECK_THROWS_AS(conversion("quat", "quat", *unit), std::invalid_argument);
    const Method* classic = rotconv::find_method(RepresentationId::quat, RepresentationId::euler, "classic");
    REQUIRE(classic != nullptr);
    CHECK_NOTHROW(conversion("quat", "rpy", *classic));
    CHECK_THROWS_AS(conversion("quat", "dcm", *classic), std::invalid_argument);
}

// Catches pages that count other methods than there are.
TEST_CASE("the pages count the methods") {
    const std::string published = std::to_string(rotconv::methods().size());
    const auto pairs = std::ranges::count(known(), rotconv::default_method, &Known::name);
    CHECK(accuracy::text_of(ROTCONV_README).find(published + " published methods") != std::string::npos);
    std::string page = accuracy::text_of(ROTCONV_EXAMPLES "/methods.md");
    std::ranges::replace(page, '\n', ' ');
    const std::string claim = "For " + std::to_string(pairs) + " pairs, `rotconv list methods` lists " + published +
                              " methods besides the default";
    INFO(claim);
    CHECK(page.find(claim) != std::string::npos);
}
