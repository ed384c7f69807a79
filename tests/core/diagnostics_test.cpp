// Diagnostics by kind, margin and condition by their definitions, errors.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <rotconv/comparison.hpp>
#include <rotconv/conversion.hpp>

#include "accuracy.hpp"
#include "catch.hpp"
#include "dominant.hpp"
#include "oracle.hpp"
#include "strata.hpp"

using accuracy::spec;
using rotconv::DiagnosticKind;
using rotconv::Error;
using rotconv::RowReport;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

RowReport report_of(const std::string& from, const std::string& to, const std::vector<double>& row,
                    rotconv::ConversionSettings settings = {}) {
    const auto [numbers, report] = accuracy::converted(spec(from), spec(to), row, settings);
    const bool all_nan = std::ranges::all_of(numbers, [](double v) { return std::isnan(v); });
    CHECK(all_nan == (report.error != Error::none));
    return report;
}

std::vector<DiagnosticKind> kinds_of(const RowReport& report) {
    std::vector<DiagnosticKind> kinds;
    for (std::size_t i = 0; i < rotconv::diagnostic_kind_count; ++i) {
        if (report.diagnostics.has(static_cast<DiagnosticKind>(i))) {
            kinds.push_back(static_cast<DiagnosticKind>(i));
        }
    }
    return kinds;
}

const rotconv::ConversionSettings with_figures{.tolerance = infinity, .lock_margin = 0.0, .sensitivity = true};

/// The numbers of an attitude in high precision, in radians: for differentiation by small rotations.
Eigen::VectorXd numbers_in_detail(const std::string& to, const oracle::Quaternion& q) {
    const auto out = accuracy::own(spec("quat"), spec(to))(oracle::numbers(spec("quat"), q));
    return Eigen::Map<const Eigen::VectorXd>(out.data(), static_cast<Eigen::Index>(out.size()));
}

/// The largest singular value of the derivative of the numbers by a small rotation, by central differences.
double condition_by_differences(const std::string& to, const oracle::Quaternion& q) {
    constexpr double step = 1e-5;
    Eigen::Matrix<double, Eigen::Dynamic, 3> jacobian(spec(to).size(), 3);
    for (int axis = 0; axis < 3; ++axis) {
        const auto up = oracle::about(oracle::Vector3::Unit(axis), oracle::Real(step)) * q;
        const auto down = oracle::about(oracle::Vector3::Unit(axis), oracle::Real(-step)) * q;
        jacobian.col(axis) = (numbers_in_detail(to, up) - numbers_in_detail(to, down)) / (2 * step);
    }
    const Eigen::Matrix3d squared = jacobian.transpose() * jacobian;
    return std::sqrt((squared * dominant_projector(squared)).trace());
}

} // namespace

// Catches a kind that is not noticed, or noticed where it is not there.
TEST_CASE("each kind is reported where it holds and nowhere else") {
    const double s = std::sqrt(0.5);
    CHECK(kinds_of(report_of("quat", "dcm", {1, 0, 0, 2e-6})).empty());
    CHECK(kinds_of(report_of("quat", "dcm", {1.0003, 0, 0, 0})) == std::vector{DiagnosticKind::normalized});
    CHECK(kinds_of(report_of("quat", "euler:ZYX", {s, 0, s, 0})) == std::vector{DiagnosticKind::gimbal_lock});
    CHECK(kinds_of(report_of("quat", "euler:ZXZ", {1, 0, 0, 0.5}, {.tolerance = 1})) ==
          std::vector{DiagnosticKind::normalized, DiagnosticKind::gimbal_lock});
    CHECK(kinds_of(report_of("euler:ZYX", "euler:ZYX", {0.1, pi / 2 - 1e-7, 0.2})) ==
          std::vector{DiagnosticKind::near_gimbal_lock});
    CHECK(kinds_of(report_of("euler:ZYX", "euler:ZYX", {0.1, pi / 2 - 1e-5, 0.2})).empty());
    CHECK(kinds_of(report_of("euler:ZXZ", "euler:ZXZ", {0.1, 1e-7, 0.2})) ==
          std::vector{DiagnosticKind::near_gimbal_lock});
    for (const std::string to : {"rotvec", "axis-angle", "mrp"}) {
        CHECK(kinds_of(report_of("quat", to, {0, 0, 1, 0})) == std::vector{DiagnosticKind::half_turn});
        CHECK(kinds_of(report_of("quat", to, {4.9e-16, 0, 1, 0})) == std::vector{DiagnosticKind::half_turn});
        CHECK(kinds_of(report_of("quat", to, {5.1e-16, 0, 1, 0})).empty());
    }
    CHECK(kinds_of(report_of("quat", "axis-angle", {1, 0, 0, 0})) == std::vector{DiagnosticKind::identity_axis});
    CHECK(kinds_of(report_of("quat", "axis-angle", {1, 0, 1e-300, 0})).empty());
    CHECK(kinds_of(report_of("quat", "rotvec", {1, 0, 0, 0})).empty());
    CHECK(kinds_of(report_of("quat", "cayley", {0, 0, 1, 0})) == std::vector{DiagnosticKind::infinite});
    CHECK(kinds_of(report_of("quat", "cayley", {1e-309, 0, 1, 0})) == std::vector{DiagnosticKind::infinite});
    CHECK(kinds_of(report_of("quat", "cayley", {1e-300, 0, 1, 0})).empty());
}

// Catches a locked answer that is not the promised one, or a lock margin that is read in other units.
TEST_CASE("locked angles have a zero third and a middle at its limit") {
    for (const auto sequence : rotconv::EulerSequence::all()) {
        const std::string text = "euler:" + sequence.text();
        for (const auto& row : strata::near_lock(spec("quat"), sequence, 60)) {
            const auto [angles, report] = accuracy::converted(spec("quat"), spec(text), row, {.lock_margin = 1e-3});
            const double margin = report_of("quat", text, row, with_figures).sensitivity.margin;
            INFO(text << " margin " << margin);
            CHECK(report.diagnostics.has(DiagnosticKind::gimbal_lock) == (margin <= 1e-3));
            if (margin <= 1e-3) {
                CHECK(angles[2] == 0.0);
                const double low = sequence.proper() ? 0.0 : -pi / 2;
                CHECK((angles[1] == low || angles[1] == (sequence.proper() ? pi : pi / 2)));
                const double off =
                    oracle::error_in_eps(oracle::attitude(spec("quat"), row), oracle::attitude(spec(text), angles));
                CHECK(off * oracle::eps <= margin + 8 * oracle::eps);
            }
        }
    }
}

// Catches a figure that is not the defined one.
TEST_CASE("condition is the largest singular value of the map from small rotations") {
    strata::Source source(51);
    for (const std::string& to : accuracy::all_specs()) {
        if (spec(to).unit == rotconv::AngleUnit::degrees) {
            continue; // the condition is that of the same angles in radians
        }
        for (int i = 0; i < 20; ++i) {
            const auto q = oracle::about(source.axis(), oracle::Real(source.uniform(0.3, 2.8)));
            const auto report = report_of("quat", to, oracle::numbers(spec("quat"), q), with_figures);
            INFO(to);
            if (report.sensitivity.margin > 0.2) {
                // the sign of a quaternion flips at a half-turn, past which the differences would reach
                CHECK(report.sensitivity.condition == Approx(condition_by_differences(to, q)).epsilon(1e-5));
            }
        }
    }
}

// Catches a margin measured to the wrong set, or with the digits of pi - theta lost.
TEST_CASE("margin is the angle to the nearest singular attitude") {
    const auto about_z = [](double angle) { return std::vector<double>{0, 0, 1, angle}; };
    for (const std::string to : {"quat", "dcm", "6d", "5d"}) {
        CHECK(report_of("axis-angle", to, about_z(1), with_figures).sensitivity.margin == infinity);
    }
    CHECK(report_of("axis-angle", "cayley", about_z(1), with_figures).sensitivity.margin == Approx(pi - 1));
    CHECK(report_of("axis-angle", "mrp", about_z(2), with_figures).sensitivity.margin == Approx(pi - 2));
    CHECK(report_of("axis-angle", "axis-angle", about_z(1), with_figures).sensitivity.margin == Approx(1));
    CHECK(report_of("axis-angle", "axis-angle", about_z(3), with_figures).sensitivity.margin == Approx(pi - 3));
    CHECK(report_of("euler:ZYX", "rpy", {0.3, -1.2, 0.1}, with_figures).sensitivity.margin == Approx(pi / 2 - 1.2));
    CHECK(report_of("euler:ZXZ", "euler:ZXZ", {0.3, 3.0, 0.1}, with_figures).sensitivity.margin == Approx(pi - 3));
    CHECK(report_of("euler:ZXZ", "euler:ZXZ", {0.3, 1e-200, 0.1}, with_figures).sensitivity.margin ==
          Approx(1e-200).margin(0).epsilon(1e-14));
    CHECK(report_of("quat", "rotvec", {1e-30, 0, 1, 0}, with_figures).sensitivity.margin ==
          Approx(2e-30).margin(0).epsilon(1e-14));
    CHECK(report_of("quat", "rotvec", {1, 0, 0, 0}, with_figures).sensitivity.condition == 1.0);
    CHECK(report_of("quat", "rotvec", {0, 0, 1, 0}, with_figures).sensitivity.condition == Approx(pi / 2));
    CHECK(report_of("quat", "axis-angle", {1, 0, 0, 0}, with_figures).sensitivity.condition == infinity);
}

// Catches a defect in another norm, or one that is only a bound where it decides.
TEST_CASE("the defect is the largest deviation of a singular value") {
    strata::Source source(61);
    for (const std::string from : {"dcm", "6d", "5d", "quat"}) {
        for (int i = 0; i < 200; ++i) {
            auto row = oracle::numbers(spec(from), source.attitude());
            const double noise = std::pow(10.0, source.uniform(-10, -0.7));
            for (double& v : row) {
                v += noise * source.uniform(-1, 1);
            }
            const double exact = static_cast<double>(oracle::defect(spec(from), row));
            INFO(from << ' ' << noise);
            CHECK(report_of(from, "quat", row, with_figures).defect == Approx(exact).epsilon(1e-5).margin(1e-15));
            CHECK((report_of(from, "quat", row, {.tolerance = 1.001 * exact + 1e-15}).error == Error::none));
            CHECK((report_of(from, "quat", row, {.tolerance = 0.999 * exact - 1e-15}).error == Error::defect));
        }
    }
    CHECK(report_of("dcm", "quat", {1e200, 0, 0, 0, 1e200, 0, 0, 0, 1e200}, with_figures).defect == Approx(1e200));
    CHECK(report_of("quat", "quat", {1e-300, 0, 0, 0}, with_figures).defect == Approx(1));
    CHECK(report_of("rotvec", "quat", {1, 2, 3}, with_figures).defect == 0.0);
}

// Catches a crash, or an answer, where there is no attitude.
TEST_CASE("numbers without an attitude are errors") {
    const rotconv::ConversionSettings any{.tolerance = infinity};
    CHECK(report_of("quat", "dcm", {0, 0, 0, 0}, any).error == Error::zero_quaternion);
    CHECK(report_of("axis-angle", "dcm", {0, 0, 0, 1}, any).error == Error::zero_axis);
    CHECK(report_of("axis-angle", "dcm", {0, 0, 0, 0}, any).error == Error::none);
    CHECK(report_of("axis-angle:deg", "dcm", {0, 0, 0, 720}, any).error == Error::none);
    CHECK(report_of("dcm", "quat", {1, 0, 0, 0, 1, 0, 0, 0, -1}, any).error == Error::not_proper);
    CHECK(report_of("dcm", "quat", {1, 2, 3, 4, 5, 6, 7, 8, 9}, any).error == Error::not_proper);
    CHECK(report_of("dcm", "quat", {0, 0, 0, 0, 0, 0, 0, 0, 0}, any).error == Error::not_proper);
    CHECK(report_of("dcm", "quat", {1e-9, 0, 0, 0, 1, 0, 0, 0, 1}, any).error == Error::none);
    CHECK(report_of("6d", "quat", {1, 2, 3, 2, 4, 6}, any).error == Error::rank_deficient);
    CHECK(report_of("6d", "quat", {0, 0, 0, 0, 1, 0}, any).error == Error::rank_deficient);
    CHECK(report_of("6d", "quat", {1, 0, 0, 1, 1e-9, 0}, any).error == Error::none);
    CHECK(report_of("5d", "quat", {0, 0, 0, 0, 0}, any).error == Error::rank_deficient);
    for (const auto id : rotconv::all_representations) {
        const auto& entry = rotconv::representation(id);
        const std::string name = entry.name == rotconv::RepresentationId::euler ? "euler:ZYX" : std::string(entry.text);
        for (std::size_t i = 0; i < entry.size; ++i) {
            for (const double bad : {infinity, -infinity, std::nan("")}) {
                std::vector<double> row(entry.size, 0.5);
                row[i] = bad;
                CHECK(report_of(name, "quat", row, any).error == Error::not_finite);
            }
        }
    }
}

// Catches a limit that rounding to four decimals exceeds, one for text alone or for quaternions alone, and a sum of
// both sides of a pair.
TEST_CASE("a defect is reported above 2e-4") {
    const auto is_normalized = [](const std::string& from, const std::vector<double>& row) {
        return report_of(from, "dcm", row).diagnostics.has(rotconv::DiagnosticKind::normalized);
    };
    CHECK_FALSE(is_normalized("quat", {0.70715, 0.70705, 0.00005, 0.00005}));
    for (const double sign : {1.0, -1.0}) {
        for (const double factor : {0.999, 1.001}) {
            const double s = 1 + sign * factor * 2e-4;
            INFO(s);
            CHECK(is_normalized("quat", {0.6 * s, 0, 0.8 * s, 0}) == (factor > 1));
            CHECK(is_normalized("dcm", {s, 0, 0, 0, 1, 0, 0, 0, 1}) == (factor > 1));
            CHECK(is_normalized("6d", {1, 0, 0, 0, s, 0}) == (factor > 1));
        }
    }
    const rotconv::Comparison pair(spec("quat"), spec("quat"));
    const std::vector<double> numbers{1, 0.0175, 0, 0, 1, 0.0225, 0, 0}; // |q| - 1 is 1.53e-4 and 2.53e-4
    std::vector<double> angle(1);
    std::vector<rotconv::RowReport> reports;
    pair.run(numbers, angle, reports);
    REQUIRE(reports.size() == 1);
    CHECK(reports[0].unusual.defect == 0.0);
    CHECK(reports[0].references[0].unusual.defect == reports[0].references[0].defect);
}

// Catches a bound on the defect that is below it, so that a decision depends on whether figures are asked for.
TEST_CASE("the defect decides the same with and without figures") {
    for (const double off : {1e-6, 2e-4, 1e-3, 0.04}) {
        for (const double sign : {1.0, -1.0}) {
            for (const double nudge : {-1e-9, 1e-9}) {
                const double s = 1 + sign * off * (1 + nudge);
                for (const double tolerance : {off, 1.0}) {
                    const std::vector<double> row{s, 0, 0, 0, 1, 0, 0, 0, 1};
                    const auto plain = report_of("dcm", "quat", row, {.tolerance = tolerance});
                    const auto figures = report_of("dcm", "quat", row, {.tolerance = tolerance, .sensitivity = true});
                    INFO(off << ' ' << sign << ' ' << nudge);
                    CHECK(plain.error == figures.error);
                    CHECK((plain.error == Error::defect) == (tolerance == off && nudge > 0));
                    CHECK(plain.diagnostics.has(DiagnosticKind::normalized) ==
                          figures.diagnostics.has(DiagnosticKind::normalized));
                }
            }
        }
    }
}

// Catches a reflection in the place of the polar factor, a sign that is lost where the matrix is scaled.
TEST_CASE("nearly singular matrices have the polar factor of their sign") {
    const rotconv::ConversionSettings any{.tolerance = infinity};
    for (const auto& row : std::vector<std::vector<double>>{{1, 0, 0, 0, 1, 0, 0, 0, 1e-40},
                                                            {1, 0, 0, 0, 1e-11, 0, 0, 0, 1e-15},
                                                            {1e-300, 0, 0, 0, 1e-300, 0, 0, 0, 1e-310},
                                                            {1e300, 0, 0, 0, 1e305, 0, 0, 0, 1e308}}) {
        CHECK(report_of("dcm", "quat", row, any).error == Error::none);
        CHECK(accuracy::own(spec("dcm"), spec("quat"))(row) == std::vector<double>{1, 0, 0, 0});
        auto mirrored = row;
        mirrored[8] = -mirrored[8];
        CHECK(report_of("dcm", "quat", mirrored, any).error == Error::not_proper);
    }
}

// Catches digits of the plane lost in a difference of products.
TEST_CASE("nearly parallel columns keep their accuracy") {
    strata::Source source(72);
    for (int i = 0; i < 400; ++i) {
        std::vector<double> row(6);
        const double apart = std::pow(10.0, source.uniform(-15, 0));
        for (std::size_t k = 0; k < 3; ++k) {
            row[k] = source.normal();
            row[k + 3] = 1.7 * row[k] + apart * source.normal();
        }
        const auto exact = oracle::attitude(spec("6d"), row);
        const auto got = oracle::attitude(spec("quat"), accuracy::own(spec("6d"), spec("quat"))(row));
        INFO(apart);
        CHECK(oracle::error_in_eps(exact, got) <= accuracy::limit_from(spec("6d")));
    }
    // far out on the stereographic plane only the direction of the second column is left
    const auto far = accuracy::own(spec("5d"), spec("quat"))(std::vector<double>{1e200, 0, 0, 0.6, 0.8});
    CHECK(far[0] == Approx(std::sqrt(0.8)).epsilon(1e-15));
    CHECK(far[1] == Approx(std::sqrt(0.2)).epsilon(1e-15));
}

// Catches a report of another row, one that is left over from the run before, and one of a row without anything.
TEST_CASE("reports are of the remarkable rows alone, in their order") {
    std::vector<double> rows;
    for (int i = 0; i < 400; ++i) {
        rows.insert(rows.end(), {0.8, 0.0, 0.6, 0.0});
    }
    const auto set_w = [&rows](std::size_t row, double w) { rows[4 * row] = w; };
    set_w(5, std::numeric_limits<double>::quiet_NaN());
    set_w(127, 0.8001); // a defect of 0.8e-4
    set_w(128, 0.8004); // of 3.2e-4
    set_w(300, 0.9);    // of 0.08
    const rotconv::Conversion conversion(spec("quat"), spec("dcm"));
    std::vector<double> out(400 * 9);
    std::vector<RowReport> reports(7);
    for (int again = 0; again < 2; ++again) {
        conversion.run(rows, out, reports);
        REQUIRE(reports.size() == 3);
        CHECK(reports[0].row == 5);
        CHECK(reports[0].error == Error::not_finite);
        CHECK(reports[1].row == 128);
        CHECK(kinds_of(reports[1]) == std::vector{DiagnosticKind::normalized});
        CHECK(reports[1].defect == Approx(3.2e-4).epsilon(1e-3));
        CHECK(reports[2].row == 300);
        CHECK(reports[2].error == Error::defect);
    }
    for (std::size_t i = 0; i < out.size(); ++i) {
        CHECK(std::isnan(out[i]) == (i / 9 == 5 || i / 9 == 300));
    }
    rotconv::Conversion(spec("quat"), spec("dcm"), {.sensitivity = true}).run(rows, out, reports);
    REQUIRE(reports.size() == 400);
    for (std::size_t i = 0; i < reports.size(); ++i) {
        CHECK(reports[i].row == i);
    }
    CHECK(reports[127].defect == Approx(0.8e-4).epsilon(1e-3));
    conversion.run(std::span(rows).first(4), out, reports);
    CHECK(reports.empty());
}
