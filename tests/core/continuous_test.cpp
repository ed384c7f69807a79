// Numbers that follow a motion: of all that mean the attitude those nearest to the last.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include <rotconv/rotconv.hpp>

#include "accuracy.hpp"
#include "catch.hpp"
#include "motions.hpp"
#include "oracle.hpp"
#include "strata.hpp"

using namespace rotconv;

namespace {

using std::numbers::pi;
using Numbers = std::vector<double>;

/// Every representation that has a choice, with all modifiers and sequences.
std::vector<Spec> specs_with_choice() {
    std::vector<Spec> specs;
    std::ranges::transform(accuracy::combined_specs(), std::back_inserter(specs), accuracy::spec);
    std::erase_if(specs, [](const Spec& spec) { return !ContinuousNumbers(spec).have_choice(); });
    return specs;
}

Numbers converted(const Spec& from, const Spec& to, const Numbers& rows, std::vector<RowReport>& reports) {
    Numbers result(rows.size() / from.size() * to.size());
    Conversion(from, to).run(rows, result, reports);
    return result;
}

Numbers continuous(const Spec& from, const Spec& to, const Numbers& rows) {
    std::vector<RowReport> reports;
    Numbers result = converted(from, to, rows, reports);
    ContinuousNumbers(to).run(result, reports);
    return result;
}

/// Radians where they are angles.
Numbers in_radians(const Spec& spec, Numbers row) {
    if (spec.unit == AngleUnit::degrees) {
        for (std::size_t i = spec.name == RepresentationId::axis_angle ? 3 : 0; i < row.size(); ++i) {
            row[i] *= pi / 180.0;
        }
    }
    return row;
}

double distance(const Spec& spec, const Numbers& a, const Numbers& b) {
    const auto p = in_radians(spec, a);
    const auto q = in_radians(spec, b);
    double square = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        square += (p[i] - q[i]) * (p[i] - q[i]);
    }
    return std::sqrt(square);
}

Numbers row_of(const Spec& spec, const Numbers& rows, std::size_t i) {
    const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(i * spec.size());
    return {begin, begin + static_cast<std::ptrdiff_t>(spec.size())};
}

/// The largest singular value of the map from a small rotation to these numbers, from the definitions.
double condition(const Spec& spec, const Numbers& row) {
    const auto v = in_radians(spec, row);
    switch (spec.name) {
    case RepresentationId::quat: return 0.5;
    case RepresentationId::axis_angle: return std::max(1.0, 0.5 / std::fabs(std::sin(0.5 * v[3])));
    case RepresentationId::rotvec: {
        const double half = 0.5 * std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        return half < 1e-9 ? 1.0 : std::max(1.0, half / std::fabs(std::sin(half)));
    }
    case RepresentationId::mrp: return 0.25 * (1.0 + v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    default: {
        const double across = spec.sequence.proper() ? std::cos(v[1]) : std::sin(v[1]);
        return 1.0 / std::sqrt(1.0 - std::fabs(across));
    }
    }
}

/// Quaternions of a motion, of either sign.
Numbers rows_of(const motions::Motion& motion, double step, std::size_t count) {
    Numbers rows;
    for (std::size_t i = 0; i < count; ++i) {
        const auto row = oracle::numbers(Spec{}, motion.attitude(0.1 + step * static_cast<double>(i)));
        rows.insert(rows.end(), row.begin(), row.end());
    }
    return rows;
}

/// Calls `take` with all other numbers of an attitude, up to `most` whole turns away, in radians.
void for_each_alternative(const Spec& spec, const Numbers& canonical, int most,
                          const std::function<void(const Numbers&)>& take) {
    const auto v = in_radians(spec, canonical);
    switch (spec.name) {
    case RepresentationId::quat:
        take(v);
        take({-v[0], -v[1], -v[2], -v[3]});
        break;
    case RepresentationId::axis_angle:
        for (int k = -most; k <= most; ++k) {
            take({v[0], v[1], v[2], v[3] + 2 * pi * k});
            take({-v[0], -v[1], -v[2], -v[3] + 2 * pi * k});
        }
        break;
    case RepresentationId::rotvec:
        for (int k = -most; k <= most; ++k) {
            const double theta = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
            const double factor = (theta + 2 * pi * k) / theta;
            take({v[0] * factor, v[1] * factor, v[2] * factor});
        }
        break;
    case RepresentationId::mrp: {
        const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        take(v);
        take({-v[0] / square, -v[1] / square, -v[2] / square});
        break;
    }
    default:
        for (int a = -most; a <= most; ++a) {
            for (int b = -most; b <= most; ++b) {
                for (int c = -most; c <= most; ++c) {
                    take({v[0] + 2 * pi * a, v[1] + 2 * pi * b, v[2] + 2 * pi * c});
                    take({v[0] + pi + 2 * pi * a, (spec.sequence.proper() ? 0 : pi) - v[1] + 2 * pi * b,
                          v[2] + pi + 2 * pi * c});
                }
            }
        }
    }
}

Numbers degrees_rows(std::size_t count, const std::function<Numbers(double)>& row) {
    Numbers rows;
    for (std::size_t i = 0; i < count; ++i) {
        const auto one = row(30.0 * static_cast<double>(i));
        rows.insert(rows.end(), one.begin(), one.end());
    }
    return rows;
}

} // namespace

// Catches a wrong alternative, a turn too few, a choice that is not the nearest, and one between the wrong numbers
// (passive, degrees, the order of a quaternion).
TEST_CASE("continuous numbers mean the attitude, and step no further than the motion allows") {
    constexpr double step = 0.005;
    for (const auto& motion :
         {motions::tumbling(), motions::spin(), motions::symmetric_body(), motions::coning(), motions::gentle()}) {
        const auto rows = rows_of(motion, step, 4000);
        for (const auto& to : specs_with_choice()) {
            const auto result = continuous(Spec{}, to, rows);
            int checked = 0;
            int too_long = 0;
            double worst_error = 0.0;
            for (std::size_t i = 0; i < 4000; ++i) {
                const auto row = row_of(to, result, i);
                if (i % 100 == 0) {
                    const auto exact = oracle::attitude(Spec{}, row_of(Spec{}, rows, i));
                    double size = 0.0;
                    for (const double number : in_radians(to, row)) {
                        size += std::fabs(number);
                    }
                    worst_error = std::max(worst_error, oracle::error_in_eps(exact, oracle::attitude(to, row)) -
                                                            accuracy::limit_to(to) - size);
                }
                if (i == 0) {
                    continue;
                }
                const auto before = row_of(to, result, i - 1);
                const double largest = std::max(condition(to, before), condition(to, row));
                const auto p = row_of(Spec{}, rows, i - 1);
                const auto q = row_of(Spec{}, rows, i);
                const double dot = p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3];
                const double turn = 2 * std::acos(std::min(1.0, std::fabs(dot)));
                if (largest * turn < 0.1) {
                    ++checked;
                    too_long += distance(to, before, row) <= 1.2 * largest * turn + 1e-12 ? 0 : 1;
                }
            }
            INFO(motion.name << " " << to.text());
            CHECK(checked > 2000);
            CHECK(too_long == 0);
            CHECK(worst_error <= 0.0);
        }
    }
}

// Catches a search that leaves out the other triple, a sign, or turns of one angle.
TEST_CASE("no other numbers of an attitude are nearer to the last") {
    strata::Source source(1310);
    for (const auto& to : specs_with_choice()) {
        const double unit = to.unit == AngleUnit::degrees ? 180.0 / pi : 1.0;
        for (int i = 0; i < tried(40); ++i) {
            Numbers last(to.size());
            std::ranges::generate(last, [&] { return source.uniform(-12.0, 12.0) * unit; });
            if (to.name == RepresentationId::axis_angle || to.name == RepresentationId::quat) {
                std::generate_n(last.begin(), 3, [&] { return source.uniform(-1.0, 1.0); });
            }
            std::vector<RowReport> reports;
            const auto canonical = converted(Spec{}, to, oracle::numbers(Spec{}, source.attitude()), reports);
            auto chosen = canonical;
            ContinuousNumbers numbers(to);
            numbers.run(last, {});
            numbers.run(chosen, reports);
            double least = std::numeric_limits<double>::infinity();
            double own = std::numeric_limits<double>::infinity();
            const Spec plain{.name = to.name, .sequence = to.sequence};
            for_each_alternative(to, canonical, 3, [&](const Numbers& other) {
                least = std::min(least, distance(plain, in_radians(to, last), other));
                own = std::min(own, distance(plain, in_radians(to, chosen), other));
            });
            INFO(to.text());
            CHECK(distance(to, last, chosen) <= least + 1e-12);
            CHECK(own <= 1e-13);
        }
    }
}

// Catches a loop that jumps at lock, and turns that are lost after many.
TEST_CASE("Euler angles that run through lock are those of the motion") {
    const auto radians = accuracy::spec("euler:ZYX");
    const auto motion = motions::through_lock();
    const auto rows = rows_of(motion, 0.01, 3000);
    for (const auto* text : {"euler:ZYX", "euler:ZYX:deg"}) {
        const auto to = accuracy::spec(text);
        const auto result = continuous(Spec{}, to, rows);
        double worst = 0.0;
        for (std::size_t i = 0; i < 3000; ++i) {
            const double t = 0.1 + 0.01 * static_cast<double>(i);
            const Numbers expected{0.3 * t, t, 0.5 * std::sin(1.3 * t)};
            const auto row = in_radians(to, row_of(to, result, i));
            worst = std::max(worst, distance(radians, row, expected) / condition(radians, row));
        }
        CHECK(worst < 3e-14);
    }
}

// Catches the wrong one of sum and difference, in any sequence, at either lock.
TEST_CASE("at lock the third angle keeps its last value and the first takes the rest") {
    for (const std::string& sequence : accuracy::signed_sequences()) {
        const Spec spec = accuracy::spec("euler:" + sequence + ":deg");
        for (const double direction : {1.0, -1.0}) {
            // past every quarter turn twice, so that both locks are met exactly
            const auto rows = degrees_rows(30, [direction](double angle) {
                return Numbers{20.0, direction * (angle + (direction > 0 ? 30.0 : -30.0)), 10.0};
            });
            const auto first = row_of(spec, rows, 0);
            const auto result = continuous(spec, spec, rows);
            std::vector<RowReport> reports;
            converted(spec, spec, rows, reports);
            CHECK(reports.size() >= 4);
            const auto canonical = row_of(spec, result, 0);
            double worst = 0.0;
            for (std::size_t i = 0; i < 30; ++i) {
                const auto row = row_of(spec, result, i);
                const auto given = row_of(spec, rows, i);
                for (std::size_t k = 0; k < 3; ++k) { // the same but for what the first row was moved by
                    const double sign = k == 1 && (canonical[1] > 0) != (first[1] > 0) ? -1.0 : 1.0;
                    const double moved = canonical[k] - sign * first[k];
                    worst = std::max(worst, std::fabs(row[k] - sign * given[k] - moved));
                }
            }
            INFO(spec.text() << " " << direction);
            CHECK(worst < 1e-10);
        }
    }
    const auto to = accuracy::spec("rpy:deg");
    const auto result = continuous(to, to, {10, 80, 20, 0, 90, 10, 10, 100, 20});
    CHECK(distance(to, row_of(to, result, 1), {10, 90, 20}) < 1e-14);
}

// Catches an axis that falls back to (1, 0, 0) or turns round, -0, and turns of degrees that are not exact.
TEST_CASE("whole turns are counted, through the identity and half-turns") {
    const auto vector = accuracy::spec("rotvec:deg");
    const auto axis_angle = accuracy::spec("axis-angle:deg");
    const auto degrees = accuracy::spec("rpy:deg");
    const auto check = [](const Spec& spec, const Numbers& rows, const Numbers& expected) {
        const auto result = continuous(spec, spec, rows);
        double worst = 0.0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            worst = std::max(worst, std::fabs(result[i] - expected[i]) / std::max(1.0, std::fabs(expected[i])));
        }
        INFO(spec.text());
        CHECK(worst < 1e-15);
        CHECK(std::ranges::none_of(result, [](double v) { return v == 0.0 && std::signbit(v); }));
    };
    for (const double direction : {1.0, -1.0}) {
        const auto along_z = degrees_rows(60, [&](double angle) { return Numbers{0, 0, direction * angle}; });
        check(vector, along_z, along_z);
        check(degrees, along_z, along_z);
        const auto about_y = degrees_rows(60, [&](double angle) { return Numbers{0, direction, 0, angle + 30.0}; });
        check(axis_angle, about_y, about_y);
    }
    // back through the identity onto the other side, and at rest on it
    check(axis_angle, {0, 1, 0, 20, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, -20},
          {0, 1, 0, 20, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, -20});
    check(vector, {0, 350, 0, 0, 360, 0, 0, 0, 0}, {0, -10, 0, 0, 0, 0, 0, 0, 0});
    check(vector, {0, 170, 0, 0, 340, 0, 0, 360, 0, 0, 0, 0, 0, 2e-9, 0},
          {0, 170, 0, 0, 340, 0, 0, 360, 0, 0, 360, 0, 0, 360 + 2e-9, 0});
}

// Catches a choice by rounding, or one that leaves the canonical numbers without need.
TEST_CASE("of equally near numbers the canonical ones stay") {
    const auto degrees = accuracy::spec("rpy:deg");
    CHECK(continuous(Spec{}, Spec{}, {0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1}) ==
          Numbers{0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    CHECK(continuous(degrees, degrees, {0, 0, 180, 0, 0, 0, 0, 0, 180}) == Numbers{0, 0, 180, 0, 0, 0, 0, 0, 180});
    const auto vector = accuracy::spec("rotvec:deg");
    CHECK(continuous(vector, vector, {0, 0, 90, 0, 0, -90}) == Numbers{0, 0, 90, 0, 0, -90});
}

// Catches a number that is rounded from 106 bits where its whole turn takes it next to the midpoint of two doubles: a
// third of these rows. h/k is a convergent of the tangent of half the angle that is the midpoint less a turn.
TEST_CASE("numbers that whole turns move are rounded once, next to midpoints too") {
    using Real = oracle::Digits<70>;
    strata::Source source(106);
    const Real turn = 2 * boost::math::constants::pi<Real>();
    for (const char* to_text : {"rpy", "rpy:deg", "rotvec", "rotvec:deg", "axis-angle", "euler:ZXY:deg"}) {
        const Spec to = accuracy::spec(to_text);
        const Conversion conversion(Spec{}, to, {.tolerance = any_defect});
        const bool degrees = to.unit == AngleUnit::degrees;
        const double half_turn = degrees ? 180.0 : pi;
        const std::size_t at = to.name == RepresentationId::euler ? 0 : to.size() - 1;
        int asked = 0;
        for (int i = 0; i < tried(60); ++i) {
            const double low = source.uniform(1.05, 1.9) * half_turn;
            const Real unit = degrees ? Real(turn / 360) : Real(1);
            const Real middle = (Real(low) + Real(std::nextafter(low, 1e9))) / 2;
            Real rest = tan((turn - middle * unit) / 2);
            double h[] = {0, 1};
            double k[] = {1, 0};
            while (rest * k[1] + k[0] < 0x1p53 && rest * h[1] + h[0] < 0x1p53) {
                const auto whole = floor(rest).convert_to<double>();
                h[0] = std::exchange(h[1], whole * h[1] + h[0]);
                k[0] = std::exchange(k[1], whole * k[1] + k[0]);
                rest = 1 / (rest - whole);
            }
            const Numbers row{k[1], 0, 0, -h[1]};
            Numbers before(to.size(), 0.0);
            before[to.size() == 4 ? 2 : at] = 1.0;
            before[at] = 0.99 * half_turn;
            ContinuousNumbers numbers(to);
            numbers.run(before, {});
            Numbers result(to.size());
            Numbers left(to.size());
            std::vector<RowReport> reports;
            conversion.run(row, result, reports, left);
            numbers.run(result, reports, left, [&](std::size_t, std::span<double> again, std::span<double> more) {
                ++asked;
                conversion.again(row, again, more);
            });
            INFO(to_text << " of " << row[0] << " " << row[3]);
            CHECK(result[at] == Real((turn - 2 * atan(Real(h[1]) / k[1])) / unit).convert_to<double>());
        }
        CHECK(asked > 0);
    }
}

// Catches a shadow of the rounded vector, and products that underflow or overflow on the way.
TEST_CASE("the shadow is rounded once, whatever its size") {
    strata::Source source(1311);
    for (int i = 0; i < tried(300); ++i) {
        auto q = oracle::numbers(Spec{}, source.attitude());
        const double size = std::pow(10.0, i % 3 == 0 ? -source.uniform(0.0, 290.0) : 0.0);
        std::for_each(q.begin() + 1, q.end(), [size](double& component) { component *= size; });
        const Spec to = accuracy::spec("mrp");
        Numbers m(3);
        Numbers rest(3);
        std::vector<RowReport> reports;
        Conversion(Spec{}, to, {.tolerance = any_defect}).run(q, m, reports, rest);
        std::array<oracle::Real, 4> exact{};
        std::ranges::copy(q, exact.begin());
        const oracle::Real square = exact[1] * exact[1] + exact[2] * exact[2] + exact[3] * exact[3];
        const oracle::Real sum = sqrt(exact[0] * exact[0] + square) + abs(exact[0]);
        Numbers shadow;
        for (std::size_t k = 1; k < 4; ++k) { // -m/|m|^2 of m = v/(|q| + |w|), with the sign of w
            shadow.push_back(static_cast<double>(oracle::Real((q[0] < 0.0 ? 1 : -1) * exact.at(k) * sum / square)));
        }
        ContinuousNumbers numbers(to);
        Numbers last = shadow;
        numbers.run(last, {});
        numbers.run(m, reports, rest);
        CHECK(m == shadow);
    }
}

// Catches a product that underflows, to other bytes where multiplication and addition are not fused.
TEST_CASE("a tiny component beside a large one keeps its digits through whole turns") {
    const auto vector = accuracy::spec("rotvec");
    const Numbers row{-4.241285179436e-310, -3.3287369127795e-310, 3.580244628935314};
    Numbers rows{0, 0, 3};
    rows.insert(rows.end(), row.begin(), row.end());
    CHECK(row_of(vector, continuous(vector, vector, rows), 1) == row);
}

// Catches the low part of 2 pi left out.
TEST_CASE("numbers of many turns are rounded once") {
    const auto to = accuracy::spec("rpy");
    const auto vector = accuracy::spec("rotvec");
    Numbers yaws;
    Numbers vectors;
    for (int i = 0; i <= 40'000; ++i) {
        yaws.insert(yaws.end(), {0, 0, 2.5 * i});
        vectors.insert(vectors.end(), {0, 0.6 * 2.5 * i, 0.8 * 2.5 * i});
    }
    const auto result = continuous(to, to, yaws);
    const auto long_result = continuous(vector, vector, vectors);
    const double half_ulp = std::ldexp(1.0, -37);
    CHECK(std::fabs(result.back() - 1e5) <= half_ulp + 4e-16);
    // the direction is known to eps
    CHECK(std::fabs(long_result[long_result.size() - 2] - 0.6e5) <= 1e5 * oracle::eps + half_ulp);
    CHECK(std::fabs(long_result.back() - 0.8e5) <= 1e5 * oracle::eps + half_ulp);
}

// Catches numbers that are changed where there is one way to write them.
TEST_CASE("what has no choice stays") {
    for (const auto* text : {"dcm", "6d", "5d", "cayley"}) {
        CHECK(!ContinuousNumbers(accuracy::spec(text)).have_choice());
    }
    Numbers numbers{1, 2, 3, -1, -2, -3};
    ContinuousNumbers(accuracy::spec("cayley")).run(numbers, {});
    CHECK(numbers == Numbers{1, 2, 3, -1, -2, -3});
}
