// Rates of every set, both ways, against differences of the oracle in 36 digits.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/LU>

#include <rotconv/rotconv.hpp>

#include "accuracy.hpp"
#include "catch.hpp"
#include "oracle.hpp"
#include "strata.hpp"

using namespace rotconv;
using accuracy::joined;
using accuracy::spec;
using oracle::Real;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

namespace {

const Real step("1e-12"); // differences are then exact to 24 digits

/// The small rotation from p to q, as a vector in the frame's axes.
oracle::Vector3 small_turn(const oracle::Quaternion& p, const oracle::Quaternion& q, Frame frame) {
    const oracle::Quaternion d = frame == Frame::body ? p.conjugate() * q : q * p.conjugate();
    return (d.w() < 0 ? -2 : 2) * d.vec();
}

/// The matrix that takes the rates of the numbers to the angular velocity.
Matrix velocity_map(const Spec& s, const std::vector<double>& numbers, Frame frame) {
    const auto here = oracle::attitude(s, numbers);
    Matrix map(3, static_cast<Eigen::Index>(numbers.size()));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::vector<Real> moved(numbers.begin(), numbers.end());
        moved[i] += step;
        const auto after = oracle::attitude(s, std::span<const Real>(moved));
        moved[i] -= 2 * step;
        const auto before = oracle::attitude(s, std::span<const Real>(moved));
        map.col(static_cast<Eigen::Index>(i)) =
            (small_turn(here, after, frame) - small_turn(here, before, frame)) / (2 * step);
    }
    return map;
}

/// The rates of the numbers of an attitude: those of sets without a singularity, whose numbers are not independent.
Vector rates_by_motion(const Spec& s, const oracle::Quaternion& here, const oracle::Vector3& w, Frame frame) {
    const auto numbers_at = [&](const Real& t) {
        const auto turn = oracle::about(w, w.norm() * t);
        auto moved = frame == Frame::body ? here * turn : turn * here;
        moved.normalize();
        return oracle::exact_numbers(s, moved);
    };
    const auto after = numbers_at(step);
    const auto before = numbers_at(-step);
    Vector rates(static_cast<Eigen::Index>(after.size()));
    for (std::size_t i = 0; i < after.size(); ++i) {
        rates[static_cast<Eigen::Index>(i)] = (after[i] - before[i]) / (2 * step);
    }
    return rates;
}

Vector exact_rates(const Spec& s, const std::vector<double>& numbers, const oracle::Vector3& w, Frame frame) {
    if (numbers.size() > 3) {
        return rates_by_motion(s, oracle::attitude(s, numbers), w, frame);
    }
    return oracle::Matrix3(velocity_map(s, numbers, frame)).inverse() * w;
}

double relative_error(const std::vector<double>& found, const Vector& exact) {
    Vector difference = exact;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (!std::isfinite(found[i])) {
            return INFINITY;
        }
        difference[static_cast<Eigen::Index>(i)] -= found[i];
    }
    return static_cast<double>(difference.norm() / exact.norm()) / oracle::eps;
}

std::vector<double> run(const Rates& way, const std::vector<double>& in, RowReport& report) {
    std::vector<double> out(way.out_size());
    std::vector<RowReport> reports;
    way.run(in, out, reports);
    report = reports.empty() ? RowReport() : reports.front();
    return out;
}

std::vector<std::vector<double>> rows_of(const Spec& s, int size) {
    std::vector<std::vector<double>> rows;
    const bool angles = s.name == RepresentationId::euler;
    for (auto& stratum : strata::strata_of(s, s, size)) {
        if (!stratum.hostile || angles) {
            std::ranges::move(stratum.rows, std::back_inserter(rows));
        }
    }
    // Of larger angles the differences have too few digits, and past 1e12 cayley is at a half-turn.
    const double most = angles ? 1e7 : 1e12;
    std::erase_if(rows, [most](const auto& row) {
        return std::ranges::any_of(row, [most](double v) { return std::fabs(v) > most; });
    });
    return rows;
}

/// Rotation vectors past a half-turn: of any length up to five turns, and near to each of the turns.
std::vector<std::vector<double>> beyond_half_turn(const Spec& s, int size) {
    strata::Source source(22);
    const double pi = s.unit == AngleUnit::degrees ? 180.0 : std::numbers::pi;
    std::vector<std::vector<double>> rows;
    const auto add = [&](double length) {
        Eigen::Vector3d v(source.normal(), source.normal(), source.normal());
        v *= length / v.norm();
        rows.push_back({v[0], v[1], v[2]});
    };
    for (int i = 0; i < size; ++i) {
        add(pi * source.uniform(1.0, 2.0));
        add(pi * source.uniform(2.0, 10.0));
        for (int turns = 1; turns <= 5; ++turns) { // nearer, the differences have too few digits
            const double distance = std::pow(10.0, source.uniform(-5, 0));
            add(pi * (2 * turns - distance));
            add(pi * (2 * turns + distance));
        }
    }
    return rows;
}

/// Worst errors in eps, of rows with a condition up to 10 and, divided by the condition, of all.
struct Worst {
    double forward = 0.0;
    double forward_by_condition = 0.0;
    double inverse = 0.0;
    double inverse_by_condition = 0.0;
};

Worst worst_of(const Spec& s, Frame frame, const std::vector<std::vector<double>>& rows) {
    strata::Source source(21);
    const Rates forward(s, {.frame = frame, .sensitivity = true});
    const Rates inverse(s, {.inverse = true, .frame = frame});
    Worst worst;
    for (const auto& numbers : rows) {
        const double scale = std::pow(10.0, source.uniform(-3, 3));
        const std::vector<double> w{scale * source.normal(), scale * source.normal(), scale * source.normal()};
        const oracle::Vector3 exact_w(w[0], w[1], w[2]);
        RowReport report;
        const auto rates = run(forward, joined(numbers, w), report);
        if (report.error == Error::singular) {
            CHECK(report.sensitivity.margin <= 1e-15);
            CHECK(std::isnan(rates[0]));
            continue;
        }
        REQUIRE(report.error == Error::none);
        const double condition = std::max(1.0, report.sensitivity.condition);
        const double error = relative_error(rates, exact_rates(s, numbers, exact_w, frame));
        const auto back = run(inverse, joined(numbers, rates), report);
        Vector exact_rate(static_cast<Eigen::Index>(rates.size()));
        for (std::size_t i = 0; i < rates.size(); ++i) {
            exact_rate[static_cast<Eigen::Index>(i)] = rates[i];
        }
        const double back_error = relative_error(back, velocity_map(s, numbers, frame) * exact_rate);
        if (condition <= 10) {
            worst.forward = std::max(worst.forward, error);
            worst.inverse = std::max(worst.inverse, back_error);
        }
        worst.forward_by_condition = std::max(worst.forward_by_condition, error / condition);
        worst.inverse_by_condition = std::max(worst.inverse_by_condition, back_error / condition);
    }
    return worst;
}

void check(const std::string& text, const std::vector<std::vector<double>>& rows, double bound = 3) {
    for (const Frame frame : {Frame::body, Frame::reference}) {
        const Worst worst = worst_of(spec(text), frame, rows);
        INFO(text << (frame == Frame::body ? " body" : " reference"));
        UNSCOPED_INFO("forward " << worst.forward << " / condition " << worst.forward_by_condition << ", inverse "
                                 << worst.inverse << " / condition " << worst.inverse_by_condition);
        CHECK(worst.forward <= bound);
        CHECK(worst.forward_by_condition <= 3);
        CHECK(worst.inverse <= bound);
        CHECK(worst.inverse_by_condition <= 3);
    }
}

void check(const std::string& text, int size) { check(text, rows_of(spec(text), size)); }

} // namespace

// Catches a formula that loses digits anywhere; a wrong sign, frame, transposition, order of numbers or unit in any
// representation, and one that has rates in one direction only.
TEST_CASE("rates are those of the oracle, wherever a representation has them") {
    for (const std::string& text : accuracy::all_specs()) {
        const Spec s = spec(text);
        if (!has_rates(s.name)) {
            CHECK_THROWS_AS(Rates(s), std::invalid_argument);
            CHECK_THROWS_AS(Rates(s, {.inverse = true}), std::invalid_argument);
        } else if (!representation(s.name).has_gimbal_lock) { // whose sequences have a test of their own
            check(text, text == representation(s.name).text ? 60 : 12);
        }
    }
}

// Catches a half angle that is rounded before its whole turns are taken off, and figures of the attitude where those of
// the numbers are meant.
TEST_CASE("rates of rotation vectors past a half-turn are those of the oracle") {
    for (const char* text : {"rotvec", "rotvec:deg", "rotvec:passive"}) {
        check(text, beyond_half_turn(spec(text), 60), 5.6);
    }
}

// By hand: about z, past a half-turn, the margin is the distance to the full turn and the condition (a/2)/|sin(a/2)|.
TEST_CASE("margin and condition of a rotation vector are those of its numbers") {
    const auto report = [](const char* text, double length) {
        RowReport result;
        const auto out = run(Rates(spec(text), {.sensitivity = true}), {0, 0, length, 0, 1, 0}, result);
        CHECK(std::isnan(out[0]) == (result.error != Error::none));
        return result;
    };
    CHECK(report("rotvec:deg", 270).sensitivity.margin == Approx(std::numbers::pi / 2).epsilon(1e-15));
    CHECK(report("rotvec:deg", 270).sensitivity.condition ==
          Approx(1.5 * std::numbers::pi / std::sqrt(2)).epsilon(1e-15));
    CHECK(report("rotvec:deg", 540).sensitivity.margin == Approx(std::numbers::pi).epsilon(1e-15));
    CHECK(report("rotvec:deg", 90).sensitivity.margin == Approx(std::numbers::pi / 2).epsilon(1e-15));
    CHECK(report("rotvec", 6).sensitivity.margin == Approx(2 * std::numbers::pi - 6).epsilon(1e-14));
    for (const int turns : {1, 2, 3, 5, 10, 100, 1000, 123456}) {
        INFO(turns);
        const double radians = 2 * std::numbers::pi * turns; // the double, which is not quite the turn
        CHECK(report("rotvec:deg", 360.0 * turns).error == Error::singular);
        CHECK(report("rotvec", radians).error == Error::singular);
        CHECK(report("rotvec:deg", 360.0 * turns - 1e-6).error == Error::none);
        CHECK(report("rotvec", radians - 1e-6).error == Error::none);
    }
}

// Catches an axis or a sign that one sequence alone gets wrong.
TEST_CASE("rates of all Euler angles are those of the oracle") {
    for (const std::string& sequence : accuracy::signed_sequences()) {
        const std::string text = "euler:" + sequence;
        check(text, 2);
        check(text + ":deg", 1);
        check(text + ":passive", 1);
    }
}

// Catches limits in rates.hpp below what is known. The rows are of a search that changes the numbers of a row as
// long as the error grows; random rows stay below 3 eps.
TEST_CASE("the worst rates that are known stay within the limits") {
    struct KnownRow {
        std::string text;
        bool inverse;
        Frame frame;
        std::vector<double> numbers, given;
        double worst; ///< eps; over the condition where that is above 10, and past a half-turn
    };
    for (const auto& row : std::vector<KnownRow>{
             {"mrp",
              true,
              Frame::reference,
              {-0.06234666214334348, 16.046403856227901, -0.50145011303495568},
              {-0.0039671934617094553, 0.99950040043580612, -0.031349510735469752},
              10.1},
             {"euler:yzx:deg",
              false,
              Frame::body,
              {-133.69694812460784, 81.848846435546875, -201.02683303939193},
              {0.023184532082624481, 0.0040977826959500132, -0.021860536836647845},
              8.44},
             {"euler:zyz:deg",
              false,
              Frame::reference,
              {-128, -188.06273980537375, 135.00000022076532},
              {-1.4251951604271675, -1.4252473281779536, -0.08522054864757074},
              0.845},
             {"rotvec",
              false,
              Frame::reference,
              {0.67735858398116577, 4.1138619131270433, 0.015707286338142473},
              {0.14246707912696455, 0.98763846869451699, 0.0034640189608567363},
              4.46},
         }) {
        const Spec s = spec(row.text);
        RowReport report;
        const auto found = run(Rates(s, {.inverse = row.inverse, .frame = row.frame, .sensitivity = true}),
                               joined(row.numbers, row.given), report);
        const oracle::Vector3 given(row.given[0], row.given[1], row.given[2]);
        const Vector exact = row.inverse ? Vector(velocity_map(s, row.numbers, row.frame) * given)
                                         : exact_rates(s, row.numbers, given, row.frame);
        const double error = relative_error(found, exact);
        const double condition = std::max(1.0, report.sensitivity.condition);
        const double length = Eigen::Map<const Eigen::Vector3d>(row.numbers.data()).norm();
        INFO(row.text << (row.inverse ? " inverse " : " forward ") << condition);
        if (s.name == RepresentationId::rotvec && length > (s.unit == AngleUnit::degrees ? 180.0 : std::numbers::pi)) {
            CHECK(error / condition == Approx(row.worst).margin(0.006));
            CHECK(error <= 5.25 * condition);
        } else {
            CHECK(error / (condition > 10 ? condition : 1.0) == Approx(row.worst).margin(0.006));
            CHECK(error <= std::max(11.75, condition));
        }
    }
}

// Catches numbers where there are none.
TEST_CASE("at a singularity there are no rates, and the report says so") {
    const auto error = [](const char* text, const std::vector<double>& numbers, const RateSettings& settings = {}) {
        const Spec s = spec(text);
        const Rates way(s, settings);
        RowReport report;
        std::vector<double> row = numbers;
        row.resize(way.in_size(), 0.5);
        const auto out = run(way, row, report);
        for (const double v : out) {
            CHECK(std::isnan(v) == (report.error != Error::none));
        }
        return report.error;
    };
    constexpr double half_turn = std::numbers::pi;
    for (const bool inverse : {false, true}) {
        const RateSettings settings{.inverse = inverse};
        CHECK(error("euler:ZYX", {1, half_turn / 2, 2}, settings) == Error::singular);
        CHECK(error("euler:ZYX:deg", {10, -90, 20}, settings) == Error::singular);
        CHECK(error("euler:zxz:deg", {10, 180, 20}, settings) == Error::singular);
        CHECK(error("euler:ZYX:deg", {10, 90 - 1e-12, 20}, settings) == Error::none);
        CHECK(error("rotvec", {half_turn, 0, 0}, settings) == Error::none);
        CHECK(error("rotvec:deg", {0, 360, 0}, settings) == Error::singular);
        CHECK(error("mrp", {0, 1, 0}, settings) == Error::none);
        CHECK(error("cayley", {0, 1e16, 0}, settings) == Error::singular);
        CHECK(error("cayley", {0, 1e14, 0}, settings) == Error::none);
        CHECK(error("quat", {0, 0, 0, 0}, settings) == Error::zero_quaternion);
        CHECK(error("quat", {1.1, 0, 0, 0}, settings) == Error::defect);
        CHECK(error("dcm", {1, 0, 0, 0, 1, 0, 0, 0, -1}, settings) == Error::not_proper);
        CHECK(error("rotvec", {NAN, 0, 0}, settings) == Error::not_finite);
        CHECK(error("rotvec", {0, 0, 0, INFINITY}, settings) == Error::not_finite);
        // too fast for a double
        CHECK(error("mrp", {0.5, 0.5, 0.4, 1.5e308, 1.5e308, 1.5e308}, settings) == Error::overflow);
    }
    CHECK(error("quat", {1.1, 0, 0, 0}, {.tolerance = 0.2}) == Error::none);
    CHECK(error("mrp", {1e308, 1e308, 0}, {}) == Error::overflow); // the rate is of the size of |m|^2
    CHECK_FALSE(has_rates(RepresentationId::axis_angle));
}

// Catches normal equations that underflow: the turn is then 0 without a word.
TEST_CASE("a matrix of any size gives the angular velocity of its rates") {
    for (const double size : {1e-300, 1e-170, 1e-155, 1e-20, 1e150, 1e200, 1e300}) {
        INFO(size);
        RowReport report;
        const double inf = INFINITY;
        const Rates dcm(spec("dcm"), {.inverse = true, .tolerance = inf});
        const auto w = run(dcm, {size, 0, 0, 0, size, 0, 0, 0, size, 0, -size, 0, size, 0, 0, 0, 0, 0}, report);
        CHECK(report.error == Error::none);
        CHECK(w == std::vector<double>{0, 0, 1});
    }
}

// By hand: a yaw of 90 degrees, then the body turns about its own x, which is the reference's y.
TEST_CASE("units, frames and orders of rates are those of the numbers") {
    using List = std::vector<double>;
    const auto rates = [](const char* text, const List& row, const RateSettings& settings = {}) {
        RowReport report;
        return run(Rates(spec(text), settings), row, report);
    };
    CHECK(rates("euler:ZYX:deg", {90, 0, 0, 1, 0, 0})[2] == Approx(180 / std::numbers::pi).epsilon(1e-15));
    CHECK(rates("euler:ZYX:deg", {90, 0, 0, 30, 0, 0}, {.degrees = true})[2] == Approx(30).epsilon(1e-15));
    CHECK(rates("euler:ZYX:deg", {90, 0, 0, 0, 30, 0}, {.degrees = true, .frame = Frame::reference})[2] ==
          Approx(30).epsilon(1e-15));
    CHECK(rates("euler:ZYX", {0, 0, 0, 90, 0, 0}, {.degrees = true})[2] == Approx(std::numbers::pi / 2).epsilon(1e-15));
    CHECK(rates("rpy", {0, 0, 0, 1, 2, 3}) == List{1, 2, 3});
    CHECK(rates("quat", {1, 0, 0, 0, 2, 4, 6}) == List{0, 1, 2, 3});
    CHECK(rates("quat:xyzw", {0, 0, 0, 1, 2, 4, 6}) == List{1, 2, 3, 0});
    CHECK(rates("quat:passive", {1, 0, 0, 0, 2, 4, 6}) == List{0, -1, -2, -3});
    CHECK(rates("dcm", {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 2, 3}) == List{0, -3, 2, 3, 0, -1, -2, 1, 0});
    CHECK(rates("dcm:col", {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 2, 3}) == List{0, 3, -2, -3, 0, 1, 2, -1, 0});
    const List w = rates("quat:xyzw", {0, 0, 0, 1, 1, 2, 3, 0}, {.inverse = true, .degrees = true});
    CHECK(w[2] == Approx(6 * 180 / std::numbers::pi).epsilon(1e-15));
    CHECK_FALSE(std::signbit(rates("cayley", {0, 0, 0, -0.0, 1, 1})[0]));
}
