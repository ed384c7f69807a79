// Integration against motions whose attitude is known in closed form, to 36 digits.

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <rotconv/rotconv.hpp>

#include "../../src/core/representations/codec.hpp"
#include "accuracy.hpp"
#include "catch.hpp"
#include "motions.hpp"
#include "oracle.hpp"
#include "strata.hpp"

using namespace rotconv;
using accuracy::spec;
using Eigen::Vector3d;
using motions::Motion;

namespace {

double error_of(const Motion& motion, const oracle::Real& time, const Rotation& rotation) {
    return oracle::eps * oracle::error_in_eps(motion.attitude(time), oracle::attitude(rotation));
}

struct Result {
    double worst = 0.0; ///< largest, radians
    double defect = 0.0;
    double norm = 0.0; ///< largest of the numbers
    Error error = Error::none;
    double until = 0.0; ///< time of the last step that held
};

/// 20 s, looked at twenty times a second.
Result integrated(const Motion& motion, const std::string& set, Integrator integrator, double h,
                  bool renormalise = false) {
    Stepper stepper(spec(set), integrator, renormalise);
    Result result;
    result.error = stepper.start(oracle::rotation(motion.attitude(0)));
    const auto steps = static_cast<std::size_t>(std::lround(20.0 / h));
    const auto look = std::max<std::size_t>(1, steps / 400);
    for (std::size_t i = 0; i < steps && result.error == Error::none; i += look) {
        const double start = static_cast<double>(i) * h;
        const auto omega = [&](double t) { return motion.omega(t); };
        result.error = integrate(stepper, omega, start, h, look);
        const Reading reading = stepper.attitude();
        CHECK(reading.error() == result.error);
        if (result.error == Error::none) {
            result.until = static_cast<double>(i + look) * h;
            result.worst =
                std::max(result.worst, error_of(motion, oracle::Real(h) * static_cast<double>(i + look), *reading));
            result.defect = std::max(result.defect, reading.defect());
            double square = 0.0;
            for (const double v : stepper.numbers()) {
                square += v * v;
            }
            result.norm = std::max(result.norm, std::sqrt(square));
        }
    }
    return result;
}

void check_order(const Motion& motion, const std::string& set, Integrator integrator, double h) {
    const double coarse = integrated(motion, set, integrator, h).worst;
    const double fine = integrated(motion, set, integrator, 0.5 * h).worst;
    INFO(set << " " << entry_of(integrator).text << ": " << coarse << ", " << fine);
    CHECK(std::log2(coarse / fine) == Approx(entry_of(integrator).order).margin(0.15));
}

struct Row : Propagated {
    double time;
};
using Rows = std::vector<Row>;

/// A stream of samples at a steady rate.
Rows propagated(const PropagationSettings& settings, const Motion& motion, double frequency, double seconds) {
    Propagator propagator(settings);
    Rows rows;
    const auto count = static_cast<int>(std::lround(seconds * frequency));
    for (int i = 0; i <= count; ++i) {
        const double time = i / frequency;
        const PushResult pushed = propagator.push(time - (i - 1) / frequency, motion.omega(time));
        REQUIRE(pushed.refused == Error::none);
        if (pushed.answer) {
            rows.push_back({*pushed.answer, static_cast<double>(rows.size()) / frequency});
        }
    }
    if (const auto last = propagator.flush()) {
        rows.push_back({*last, static_cast<double>(rows.size()) / frequency});
    }
    REQUIRE(rows.size() == static_cast<std::size_t>(count) + 1);
    return rows;
}

/// Of a turn about z.
double angle_of(const Propagated& row) { return 2.0 * std::atan2(row.attitude->z(), row.attitude->w()); }

double worst_error(const Rows& rows, const Motion& motion) {
    double worst = 0.0;
    for (std::size_t i = 0; i < rows.size(); i += std::max<std::size_t>(1, rows.size() / 200)) {
        REQUIRE(rows[i].attitude.error() == Error::none);
        worst = std::max(worst, error_of(motion, rows[i].time, *rows[i].attitude));
    }
    return worst;
}

double sampled_error(const Motion& motion, double frequency, Interpolation interpolation,
                     Integrator integrator = PropagationSettings{}.integrator) {
    return worst_error(
        propagated(
            {.integrator = integrator, .interpolation = interpolation, .initial = oracle::rotation(motion.attitude(0))},
            motion, frequency, 20.0),
        motion);
}

} // namespace

// Catches a wrong coefficient, node or sign of a commutator: each costs an order at least.
TEST_CASE("every integrator has its order") {
    const Motion motion = motions::tumbling();
    for (const char* set : {"dcm", "6d:passive", "5d", "5d:passive", "quat", "quat:passive", "mrp", "rotvec"}) {
        check_order(motion, set, Integrator::rk4, 0.01);
    }
    check_order(motion, "6d", Integrator::rk4, 0.005);
    check_order(motion, "euler:ZYX", Integrator::rk4, 0.001);
    check_order(motion, "euler:zxz", Integrator::rk4, 0.0025);
    check_order(motions::gentle(), "cayley", Integrator::rk4, 0.01);
    check_order(motion, "quat", Integrator::magnus4, 0.02);
    check_order(motion, "quat", Integrator::magnus6, 0.04);
}

// The figures are those of 20 s of the tumbling motion at h = 0.01, measured, with a margin of a fifth.
TEST_CASE("the sets and integrators rank as measured") {
    const Motion motion = motions::tumbling();
    const auto error = [&](const char* set, Integrator integrator) {
        return integrated(motion, set, integrator, 0.01).worst;
    };
    const double euler = error("euler:ZYX", Integrator::rk4);
    const double five = error("5d", Integrator::rk4);
    const double dcm = error("dcm", Integrator::rk4);
    const double quat = error("quat", Integrator::rk4);
    const double mrp = error("mrp", Integrator::rk4);
    const double rotvec = error("rotvec", Integrator::rk4);
    const double magnus4 = error("quat", Integrator::magnus4);
    const double magnus6 = error("quat", Integrator::magnus6);
    INFO(euler << " " << five << " " << dcm << " " << quat << " " << mrp << " " << rotvec << " " << magnus4 << " "
               << magnus6);
    CHECK(euler > 100 * five);
    CHECK(five > 5 * quat);
    CHECK(five < 1e-7);
    CHECK(dcm > 10 * quat);
    CHECK(quat > 2 * mrp);
    CHECK(mrp > magnus4);
    CHECK(magnus4 > rotvec);
    CHECK(rotvec > 1000 * magnus6);
    CHECK(dcm < 1.4e-7);
    CHECK(quat < 8e-9);
    CHECK(magnus4 < 2.2e-9);
    CHECK(magnus6 < 1e-13);
    // In reference axes the columns of a matrix move each by itself, so that two of them are as good as three.
    CHECK(error("6d:passive", Integrator::rk4) == Approx(dcm).epsilon(0.02));
    CHECK(error("6d", Integrator::rk4) < 1.5 * dcm);
}

// Catches a shadow or a whole turn that is never changed to, and numbers that grow past their range.
TEST_CASE("charts that have another one change to it, and keep their bounds") {
    for (const Motion& motion : {motions::tumbling(), motions::spin()}) {
        const Result mrp = integrated(motion, "mrp", Integrator::rk4, 0.01);
        CHECK(mrp.error == Error::none);
        CHECK(mrp.norm <= 1.0);
        CHECK(mrp.norm > 0.9);
        const Result rotvec = integrated(motion, "rotvec", Integrator::rk4, 0.01);
        CHECK(rotvec.error == Error::none);
        CHECK(rotvec.norm <= std::numbers::pi);
        CHECK(rotvec.norm > 3.0);
    }
    // Angles stay small, so that a long spin keeps its digits.
    const Motion spin{"spin", {{2, 0.0, 40.0}}};
    const Result euler = integrated(spin, "euler:ZYX", Integrator::rk4, 0.01);
    CHECK(euler.norm <= std::numbers::pi);
    CHECK(euler.worst < 1e-12);
}

// Catches a chart that is left without a word, at any step and whichever side of the lock the step would have ended.
TEST_CASE("charts that have no other fail, before the singularity is reached") {
    for (const double h : {0.1, 0.01, 0.001}) {
        const Result lock = integrated(motions::through_lock(), "euler:ZYX", Integrator::rk4, h);
        CHECK(lock.error == Error::singular);
        CHECK(lock.until < std::numbers::pi / 2);
        CHECK(lock.until > std::numbers::pi / 2 - 0.06 - 2 * h);
        const Result half_turn = integrated(motions::spin(), "cayley", Integrator::rk4, h);
        CHECK(half_turn.error == Error::singular);
        CHECK(half_turn.until < std::numbers::pi / 1.5);
        CHECK(half_turn.until > std::numbers::pi / 1.5 - 0.06 - 2 * h);
    }
    // too fast for the step, and an attitude that the set has no numbers for
    CHECK(integrated(motions::tumbling(), "euler:ZYX", Integrator::rk4, 0.05).error == Error::singular);
    Stepper cayley(spec("cayley"), Integrator::rk4);
    CHECK(cayley.start(Rotation::from_components(0, 1, 0, 0)) == Error::singular);
    CHECK(cayley.attitude().error() == Error::singular);
}

// Catches a chart that is not switched, or to numbers of another attitude or past the range again.
TEST_CASE("numbers past their range become those of the same attitude in it") {
    strata::Source source(31);
    for (const auto id : rotconv::all_representations) {
        const rotconv::Codec& codec = rotconv::codec_of(id);
        if (codec.switch_chart == nullptr) {
            continue;
        }
        const auto& entry = rotconv::representation(id);
        INFO(entry.text);
        const rotconv::Spec set =
            spec(std::string(entry.text) + (id == rotconv::RepresentationId::euler ? ":ZYX" : ""));
        const auto in_range = accuracy::own(set, set);
        int switched = 0;
        for (int row = 0; row < 200; ++row) {
            auto numbers = oracle::numbers(set, source.attitude());
            for (std::size_t i = 0; i < numbers.size(); ++i) {
                numbers[i] *= entry.has_gimbal_lock && i == 1 ? 1.0 : 1.6; // the middle angle has no other turns
            }
            const auto given = numbers;
            codec.switch_chart(numbers.data());
            switched += numbers != given ? 1 : 0;
            REQUIRE(oracle::error_in_eps(oracle::attitude(set, given), oracle::attitude(set, numbers)) < 8.0);
            const auto expected = in_range(given);
            for (std::size_t i = 0; i < numbers.size(); ++i) {
                REQUIRE(numbers[i] == Approx(expected[i]).margin(1e-14));
            }
        }
        CHECK(switched > 20);
    }
}

// Catches a step that no start could bear, blamed on an attitude that is nowhere near.
TEST_CASE("a step that turns by more than the set can follow is called coarse") {
    const auto error = [](const char* set, double h, double rate) {
        Stepper stepper(spec(set), Integrator::rk4);
        REQUIRE(stepper.start({}) == Error::none);
        const std::vector<Vector3d> rates(3, Vector3d(0, 0, rate));
        const Error found = stepper.step(h, rates);
        CHECK(stepper.attitude().error() == found);
        return found;
    };
    for (const char* set : {"mrp", "rotvec", "cayley"}) {
        CHECK(error(set, 1.0, 3.2) == Error::coarse_step);
        CHECK(error(set, -1.0, 3.2) == Error::coarse_step);
        CHECK(error(set, 1.0, 1e200) == Error::coarse_step);
        CHECK(error(set, 1.0, 3.0) == Error::none);
    }
    for (const char* set : {"quat", "dcm", "6d", "5d"}) {
        CHECK(error(set, 1.0, 3.2) == Error::coarse_step);
        CHECK(error(set, 1.0, 1e200) == Error::coarse_step);
        CHECK(error(set, -1.0, std::numbers::pi) == Error::none);
    }
    CHECK(error("euler:ZYX", 1.0, 1.6) == Error::coarse_step);
    CHECK(error("euler:ZYX", 1.0, 1.5) == Error::none);
}

// Catches rates that are looked at only where the integrator needs them: those of Gauss and Legendre lie inside.
TEST_CASE("the greatest rate of a step counts wherever it is") {
    for (const auto interpolation : {Interpolation::linear, Interpolation::cubic}) {
        for (const IntegratorEntry& entry : integrators()) {
            const auto error = [&](double first, double last) {
                Propagator propagator({.integrator = entry.integrator, .interpolation = interpolation});
                propagator.push(0, {0, first, 0});
                auto answer = propagator.push(1, {last, 0, 0}).answer;
                answer = answer && interpolation == Interpolation::linear ? answer : propagator.flush();
                REQUIRE(answer);
                return answer->attitude.error();
            };
            INFO(entry.text);
            CHECK(error(3.13, 0) == Error::none);
            CHECK(error(0, 3.13) == Error::none);
            CHECK(error(3.15, 0) == Error::coarse_step);
            CHECK(error(0, 3.15) == Error::coarse_step);
        }
    }
    // the ends of a parabola, which rk4 has among its nodes
    Propagator propagator({.integrator = Integrator::magnus6, .interpolation = Interpolation::cubic});
    propagator.push(0, {0, 0, 0});
    propagator.push(1, {0, 0, 0.5});
    propagator.push(1, {0, 0, 3.15});
    CHECK(propagator.flush()->attitude.error() == Error::coarse_step);
}

namespace {

struct Way {
    const char* set;
    Integrator integrator;
};
constexpr std::array<Way, 12> ways{{{"quat", Integrator::magnus4},
                                    {"quat", Integrator::magnus6},
                                    {"quat", Integrator::rk4},
                                    {"dcm", Integrator::rk4},
                                    {"6d", Integrator::rk4},
                                    {"5d", Integrator::rk4},
                                    {"5d:passive", Integrator::rk4},
                                    {"rotvec", Integrator::rk4},
                                    {"mrp", Integrator::rk4},
                                    {"cayley", Integrator::rk4},
                                    {"euler:ZYX", Integrator::rk4},
                                    {"euler:zxz", Integrator::rk4}}};

/// What came of the last interval: the error of its one step, against many of the best integrator, and its estimate.
struct Step {
    double worst = 0.0;
    double estimate = 0.0;
    Error error = Error::none;
};

Step last_step(const Way& way, Interpolation interpolation, const Rotation& initial, double interval,
               const std::vector<Vector3d>& samples) {
    const auto last = [&](const Way& by, std::size_t substeps) {
        Propagator propagator({.representation = spec(by.set),
                               .integrator = by.integrator,
                               .substeps = substeps,
                               .interpolation = interpolation,
                               .initial = initial});
        std::optional<Propagated> answer;
        for (const Vector3d& omega : samples) {
            const PushResult pushed = propagator.push(interval, omega);
            answer = pushed.answer ? pushed.answer : answer;
        }
        return *answer;
    };
    const Propagated found = last(way, 1);
    const Propagated exact = last({"quat", Integrator::magnus6}, 16);
    const auto numbers = [](const Rotation& r) { return Eigen::Quaterniond(r.w(), r.x(), r.y(), r.z()); };
    if (!found.attitude) {
        return {0.0, found.step_error, found.attitude.error()};
    }
    return {numbers(*found.attitude).angularDistance(numbers(*exact.attitude)), found.step_error,
            found.attitude.defect() > 1e-3 ? Error::defect : Error::none};
}

} // namespace

// Catches an integrator or a set whose estimate is of something else, and steps that are wrongly passed over.
TEST_CASE("the estimate of a step's own error is of the order of that error") {
    const Motion motion = motions::tumbling();
    for (const Way& way : ways) {
        int reported = 0;
        for (const auto interpolation : {Interpolation::linear, Interpolation::cubic}) {
            for (const double interval : {0.1, 0.3, 0.6, 0.9}) {
                for (int i = 0; i < 40; ++i) {
                    const double start = 0.37 * i;
                    std::vector<Vector3d> samples;
                    for (int k = 0; k < (interpolation == Interpolation::linear ? 2 : 3); ++k) {
                        samples.push_back(motion.omega(start + k * interval));
                    }
                    const Step step =
                        last_step(way, interpolation, oracle::rotation(motion.attitude(start)), interval, samples);
                    if (step.error != Error::none) {
                        continue;
                    }
                    INFO(way.set << " " << entry_of(way.integrator).text << " " << interval << " " << start << ": "
                                 << step.estimate << " for " << step.worst);
                    reported += step.estimate > reported_step_error ? 1 : 0;
                    CHECK(std::max(step.worst, step.estimate) < (step.worst > 5e-4 ? 2 * step.estimate : 1e-3));
                    CHECK(step.estimate < std::max(2 * step.worst, 1e-3));
                }
            }
        }
        INFO(way.set << " " << entry_of(way.integrator).text);
        CHECK(reported > 0);
    }
}

// Catches a bound that is drawn too wide: rates of any shape, at any attitude.
TEST_CASE("steps of which nothing is estimated are far from being reported") {
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    const auto vector = [&] { return Vector3d(normal(random), normal(random), normal(random)); };
    for (const Way& way : ways) {
        double worst = 0.0;
        for (int i = 0; i < 2000; ++i) {
            const Vector3d v = vector();
            const auto initial = Rotation::from_components(normal(random), v.x(), v.y(), v.z());
            const double rate = 0.2 * std::fabs(normal(random));
            const Step step =
                last_step(way, Interpolation::cubic, initial, 1.0, {rate * vector(), rate * vector(), rate * vector()});
            worst = step.error == Error::none && step.estimate == 0.0 ? std::max(worst, step.worst) : worst;
        }
        INFO(way.set << " " << entry_of(way.integrator).text << " " << worst);
        CHECK(worst < 0.5 * reported_step_error);
        CHECK(worst > 0.0);
    }
}

// Catches a sum over substeps, and an estimate that stays.
TEST_CASE("a sample's estimate is the greatest of its steps, and that of no other sample") {
    const auto estimate = [](double interval, std::size_t substeps) {
        Propagator propagator({.representation = spec("dcm"), .integrator = Integrator::rk4, .substeps = substeps});
        propagator.push(0, {0, 0, 1});
        const double error = propagator.push(interval, {0, 0, 1}).answer->step_error;
        CHECK(propagator.push(0.01, {0, 0, 1}).answer->step_error == 0.0);
        return error;
    };
    CHECK(estimate(1, 1) > 1e-3);
    CHECK(estimate(1, 2) == Approx(estimate(0.5, 1)));
    CHECK(estimate(1, 20) == 0.0);
}

// Catches a guard that a negative step passes by.
TEST_CASE("a step backwards is refused before the singularity as one forwards is") {
    for (const double h : {0.5, -0.5}) {
        for (const char* set : {"euler:ZYX", "cayley"}) {
            Stepper stepper(spec(set), Integrator::rk4);
            const double lock = set[0] == 'c' ? std::numbers::pi : std::numbers::pi / 2;
            const double half = 0.5 * std::copysign(lock - 0.1, h);
            REQUIRE(stepper.start(Rotation::near_unit(std::cos(half), 0, std::sin(half), 0)) == Error::none);
            const std::vector<Vector3d> rates(3, Vector3d(0, 1, 0));
            CHECK(stepper.step(h, rates) == Error::singular);
        }
    }
}

// Catches a drift off the set that stays, and a projection that turns the attitude.
TEST_CASE("renormalising takes the defect away, and changes the attitude little") {
    const Motion motion = motions::tumbling();
    for (const char* set : {"dcm", "6d", "5d", "quat"}) {
        const Result plain = integrated(motion, set, Integrator::rk4, 0.01);
        const Result renormalised = integrated(motion, set, Integrator::rk4, 0.01, true);
        INFO(set << " " << plain.defect << " " << renormalised.defect << " " << plain.worst << " "
                 << renormalised.worst);
        CHECK(plain.defect > 1e-11);
        CHECK(renormalised.defect < 1e-15);
        CHECK(renormalised.worst < 1.1 * plain.worst);
    }
    CHECK(integrated(motion, "quat", Integrator::magnus4, 0.01).defect < 1e-13);
}

// The propagator is the stepper: with a rate that the interpolation knows exactly the error is that of rounding.
TEST_CASE("a rate that is a polynomial is interpolated exactly") {
    const auto attitude_error = [](Interpolation interpolation, int degree) {
        Propagator propagator({.interpolation = interpolation});
        const std::vector<double> times{0.0, 0.1, 0.15, 0.3, 0.35, 0.6, 0.7, 0.95}; // not evenly
        double worst = 0.0;
        std::size_t answered = 0;
        const auto look = [&](const std::optional<Propagated>& row) {
            if (row) {
                const double angle = std::pow(times[answered++], degree + 1) / (degree + 1);
                const Motion motion{"", {{0, angle}}};
                worst = std::max(worst, error_of(motion, 0, *row->attitude));
            }
        };
        double last = 0.0;
        for (const double t : times) {
            look(propagator.push(t - std::exchange(last, t), {std::pow(t, degree), 0, 0}).answer);
        }
        look(propagator.flush());
        return worst;
    };
    for (int degree = 0; degree <= 2; ++degree) {
        CHECK((attitude_error(Interpolation::linear, degree) < 1e-15) == (degree <= 1));
        CHECK(attitude_error(Interpolation::cubic, degree) < 2e-15);
    }
    // of the third degree all but the ends
    CHECK(attitude_error(Interpolation::cubic, 3) < 0.1 * attitude_error(Interpolation::linear, 3));
}

// Catches an answer that waits for nothing, comes before its time, or is lost at the end.
TEST_CASE("linear answers each sample at once, cubic one late") {
    const PropagationSettings settings{.interpolation = Interpolation::cubic};
    Propagator linear({});
    Propagator cubic(settings);
    CHECK_FALSE(Propagator(settings).flush());
    for (int i = 0; i < 6; ++i) {
        const double angle = 0.2 * i;
        const auto now = linear.push(1, {0, 0, 0.2}).answer;
        REQUIRE(now);
        CHECK(angle_of(*now) == Approx(angle));
        const auto late = cubic.push(1, {0, 0, 0.2}).answer;
        REQUIRE(late.has_value() == (i > 0));
        if (late) {
            CHECK(angle_of(*late) == Approx(angle - 0.2));
        }
    }
    CHECK_FALSE(linear.flush());
    const auto last = cubic.flush();
    REQUIRE(last);
    CHECK(angle_of(*last) == Approx(1.0));
    // one sample alone
    Propagator one(settings);
    CHECK_FALSE(one.push(7, {1, 2, 3}).answer);
    CHECK(angle_of(*one.flush()) == 0.0);
}

// Catches an interval that is integrated twice or left out.
TEST_CASE("a sample that is settled early is not answered again, and the next ones follow") {
    for (const int early : {0, 1, 2, 5}) {
        Propagator propagator({.interpolation = Interpolation::cubic});
        int answered = 0;
        const auto take = [&](const std::optional<Propagated>& row) {
            if (row) {
                CHECK(angle_of(*row) == Approx(0.1 * answered++).margin(1e-15));
            }
        };
        for (int i = 0; i < 8; ++i) {
            take(propagator.push(1, {0, 0, 0.1}).answer);
            if (i == early) {
                take(propagator.flush());
                CHECK_FALSE(propagator.flush());
            }
        }
        take(propagator.flush());
        CHECK(answered == 8);
    }
}

// Catches a refused sample that is integrated all the same.
TEST_CASE("a sample that is not later, or not finite, is refused and changes nothing") {
    for (const auto interpolation : {Interpolation::linear, Interpolation::cubic}) {
        Propagator clean({.interpolation = interpolation});
        Propagator disturbed({.interpolation = interpolation});
        for (int i = 0; i < 6; ++i) {
            const Vector3d omega{0.1 * i, 0.3, -0.02 * i * i};
            const auto expected = clean.push(1, omega);
            const auto found = disturbed.push(1, omega);
            REQUIRE(expected.answer.has_value() == found.answer.has_value());
            if (expected.answer) {
                CHECK(expected.answer->attitude->w() == found.answer->attitude->w());
                CHECK(expected.answer->attitude->z() == found.answer->attitude->z());
            }
            CHECK(disturbed.push(0, omega).refused == Error::time_order);
            CHECK(disturbed.push(-0.5, omega).refused == Error::time_order);
            CHECK(disturbed.push(NAN, omega).refused == Error::not_finite);
            CHECK(disturbed.push(0.5, {0, INFINITY, 0}).refused == Error::not_finite);
            CHECK_FALSE(disturbed.push(NAN, omega).answer);
        }
    }
}

// Catches differences that overflow: every later attitude is then lost.
TEST_CASE("samples too close for their differences are refused and change nothing") {
    for (const auto interpolation : {Interpolation::linear, Interpolation::cubic}) {
        for (const double interval : {5e-324, 1e-310, 1e-200, 1e-110}) {
            Propagator propagator({.interpolation = interpolation});
            CHECK(propagator.push(0, {0, 0, 1}).refused == Error::none);
            CHECK(propagator.push(interval, {0, 0, 1.5}).refused == Error::time_order);
            for (int i = 0; i < 3; ++i) {
                const PushResult pushed = propagator.push(1, {0, 0, 1});
                CHECK(pushed.refused == Error::none);
                REQUIRE(pushed.answer);
                CHECK(pushed.answer->attitude.error() == Error::none);
            }
        }
        // the closest that are not refused
        Propagator propagator({.interpolation = interpolation});
        for (const double interval : {0.0, 1e-100, 1e-100, 1e-100, 1e-100, 1.0, 1.0}) {
            const PushResult pushed = propagator.push(interval, {0, 0, 1});
            CHECK(pushed.refused == Error::none);
            CHECK((!pushed.answer || pushed.answer->attitude.error() == Error::none));
        }
    }
}

// Catches an attitude that comes back after the lock.
TEST_CASE("a propagator whose chart is left says so from there on") {
    const PropagationSettings settings{.representation = spec("euler:ZYX"),
                                       .integrator = Integrator::rk4,
                                       .initial = oracle::rotation(motions::through_lock().attitude(0))};
    const Rows rows = propagated(settings, motions::through_lock(), 100, 3);
    for (const Row& row : rows) {
        CHECK((row.attitude.error() == Error::singular) == (row.time > 1.565));
        CHECK((row.attitude.error() == Error::none) == (row.time < 1.565));
    }
}

// The bounds are the measured errors, which propagation.hpp gives, with a margin of a fifth.
TEST_CASE("the error of sampled rates is that of the interpolation") {
    struct Bound {
        Motion motion;
        double frequency;
        double linear;
        double cubic;
    };
    for (const Bound& bound :
         {Bound{motions::coning(), 1000, 2.5e-6, 1.2e-11}, Bound{motions::tumbling(), 1000, 3.5e-6, 2e-12},
          Bound{motions::coning(), 100, 2.5e-4, 1.2e-7}, Bound{motions::tumbling(), 100, 3.5e-4, 2e-8}}) {
        const double linear = sampled_error(bound.motion, bound.frequency, Interpolation::linear);
        const double cubic = sampled_error(bound.motion, bound.frequency, Interpolation::cubic);
        INFO(bound.motion.name << " " << linear << " " << cubic);
        CHECK(linear < bound.linear);
        CHECK(cubic < bound.cubic);
        if (bound.frequency > 100) {
            continue;
        }
        // four times the samples: linear gains 16, cubic 256
        CHECK(linear / sampled_error(bound.motion, 4 * bound.frequency, Interpolation::linear) ==
              Approx(16).epsilon(0.05));
        CHECK(cubic / sampled_error(bound.motion, 4 * bound.frequency, Interpolation::cubic) ==
              Approx(256).epsilon(0.2));
        // no integrator does much better
        for (const IntegratorEntry& entry : integrators()) {
            const double other = sampled_error(bound.motion, bound.frequency, Interpolation::linear, entry.integrator);
            CHECK(other == Approx(linear).epsilon(0.01));
        }
    }
}

// Catches a table that is no longer true: a minute of coning by 10 degrees, once a second.
TEST_CASE("sampled coning is off by what the manual says") {
    const double rate = 2.0 * std::numbers::pi;
    const Motion motion{"", {{2, 0.0, rate}, {0, std::numbers::pi / 18}, {2, 0.0, -rate}}};
    for (const auto& [frequency, linear, cubic] : {std::array{100.0, 3.7e-3, 2.8e-6}, {1000.0, 3.7e-5, 2.8e-10}}) {
        const auto error = [&, frequency = frequency](Interpolation interpolation) {
            const PropagationSettings settings{.interpolation = interpolation,
                                               .initial = oracle::rotation(motion.attitude(0))};
            return worst_error(propagated(settings, motion, frequency, 60.0), motion);
        };
        CHECK(error(Interpolation::linear) == Approx(linear).epsilon(0.02));
        CHECK(error(Interpolation::cubic) == Approx(cubic).epsilon(0.02));
    }
}

// Substeps: of the interpolated rate, each as good as a step of its own.
TEST_CASE("substeps bring a coarse integrator to the interpolated motion") {
    const Motion motion = motions::tumbling();
    const auto last = [&](Integrator integrator, std::size_t substeps) {
        const PropagationSettings settings{.integrator = integrator,
                                           .substeps = substeps,
                                           .interpolation = Interpolation::cubic,
                                           .initial = oracle::rotation(motion.attitude(0))};
        return oracle::attitude(*propagated(settings, motion, 10, 5).back().attitude);
    };
    const auto distance = [&](Integrator integrator, std::size_t substeps) {
        return oracle::error_in_eps(last(Integrator::magnus6, 8), last(integrator, substeps));
    };
    CHECK(distance(Integrator::magnus4, 1) / distance(Integrator::magnus4, 4) == Approx(256).epsilon(0.2));
    CHECK(distance(Integrator::rk4, 1) / distance(Integrator::rk4, 4) == Approx(256).epsilon(0.3));
}

// Catches a representation whose numbers are not those that its own equation carries on, or a singular attitude seen
// where there is none.
TEST_CASE("a steady turn carries every representation that has rates along") {
    const auto start = oracle::about({1, 1, 0.3}, 1);
    const oracle::Vector3 axis = oracle::Vector3(3, -2, 4).normalized();
    const auto omega = [&](double /*time*/) -> Vector3d { return 0.5 * axis.cast<double>(); };
    for (const std::string& text : accuracy::all_specs()) {
        const Spec set = spec(text);
        if (!has_rates(set.name)) {
            continue;
        }
        INFO(text);
        Stepper stepper(set, Integrator::rk4);
        REQUIRE(stepper.start(oracle::rotation(start)) == Error::none);
        REQUIRE(integrate(stepper, omega, 0, 0.01, 100) == Error::none);
        const Reading end = stepper.attitude();
        REQUIRE(end);
        CHECK(oracle::eps * oracle::error_in_eps(start * oracle::about(axis, 0.5), oracle::attitude(*end)) < 1e-8);
    }
}

// Catches an exponential step of another set, and a set with rates that rk4 refuses.
TEST_CASE("what can be integrated with what") {
    for (const IntegratorEntry& entry : integrators()) {
        CHECK(&entry_of(entry.integrator) == &entry);
        for (const RepresentationId id : all_representations) {
            const bool expected = entry.exponential ? id == RepresentationId::quat : has_rates(id);
            CHECK(can_integrate(id, entry.integrator) == expected);
        }
    }
    CHECK(can_integrate(PropagationSettings{}.representation.name, PropagationSettings{}.integrator));
}
