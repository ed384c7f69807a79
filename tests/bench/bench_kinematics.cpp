// Every set and integrator on motions in closed form: error, cost and drift. bench_kinematics OUT.csv

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <rotconv/integration.hpp>

#include "figures.hpp"
#include "motions.hpp"

namespace {

using namespace rotconv;
using Eigen::Vector3d;
using motions::Motion;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Way {
    std::string set;
    Integrator integrator;
    bool renormalised;

    [[nodiscard]] Stepper stepper() const { return {std::get<Spec>(parse_spec(set)), integrator, renormalised}; }
};

std::vector<Way> ways() {
    std::vector<Way> made;
    for (const char* set : {"dcm", "6d", "6d:passive", "5d", "5d:passive", "quat"}) {
        made.push_back({set, Integrator::rk4, false});
        made.push_back({set, Integrator::rk4, true});
    }
    for (const char* set : {"rotvec", "mrp", "cayley", "euler:ZYX"}) {
        made.push_back({set, Integrator::rk4, false});
    }
    for (const Integrator integrator : {Integrator::magnus4, Integrator::magnus6}) {
        made.push_back({"quat", integrator, false});
        made.push_back({"quat", integrator, true});
    }
    return made;
}

/// Of 64 bits, which tell an error of 1e-17.
using Exact = Eigen::Quaternion<long double>;

Exact exact_attitude(const Motion& motion, const oracle::Real& time) {
    const oracle::Quaternion q = motion.attitude(time);
    return {static_cast<long double>(q.w()), static_cast<long double>(q.x()), static_cast<long double>(q.y()),
            static_cast<long double>(q.z())};
}

double error_of(const Exact& exact, const Rotation& rotation) {
    const Exact q(rotation.w(), rotation.x(), rotation.y(), rotation.z());
    const Exact difference = exact.conjugate() * q;
    return static_cast<double>(2 * std::atan2(difference.vec().norm(), std::fabs(difference.w())));
}

std::string field(double value) { return std::isnan(value) ? "" : fmt::format("{:.4g}", value); }

/// One row of the file. `time`: how far the figures reach.
void write(std::ostream& csv, const char* kind, const Motion& motion, const Way& way, double h, double time,
           double worst, double defect, double nanoseconds, Error error) {
    csv << fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", kind, motion.name, way.set,
                       entry_of(way.integrator).text, h, way.renormalised ? 1 : 0, field(time), field(worst),
                       field(nanoseconds / h), field(entry_of(way.integrator).evaluations / h), field(defect),
                       error == Error::none ? "ok" : "singular");
}

// --- Work and precision: 20 s at several steps -----------------------------------------------------------------------

constexpr double seconds = 20.0;
constexpr std::size_t fewest_steps = 250; // of 0.08 s
constexpr std::size_t most_steps = 128 * fewest_steps;

/// Nanoseconds of this process on the processor.
double processor_time() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

/// Least time of a step in nanoseconds, without the evaluation of the motion.
double time_of_step(const Way& way, const Rotation& start, double h, const std::vector<Vector3d>& rates) {
    Stepper stepper = way.stepper();
    const std::size_t nodes = stepper.nodes().size();
    const std::size_t steps = rates.size() / nodes;
    double least = std::numeric_limits<double>::infinity();
    const std::size_t repeats = std::max<std::size_t>(7, 20000 / steps);
    for (std::size_t repeat = 0; repeat < repeats; ++repeat) {
        stepper.start(start);
        const double begin = processor_time();
        for (std::size_t i = 0; i < steps; ++i) {
            stepper.step(h, {&rates[i * nodes], nodes});
        }
        least = std::min(least, (processor_time() - begin) / static_cast<double>(steps));
    }
    return least;
}

void work(std::ostream& csv, const Motion& motion) {
    std::vector<Exact> exact;
    for (std::size_t i = 0; i <= most_steps; ++i) {
        exact.push_back(exact_attitude(motion, oracle::Real(seconds) * static_cast<double>(i) / most_steps));
    }
    const Rotation start = oracle::rotation(motion.attitude(0));
    const auto omega = [&](double t) { return motion.omega(t); };
    for (const Way& way : ways()) {
        for (std::size_t steps = fewest_steps; steps <= most_steps; steps *= 2) {
            const double h = seconds / static_cast<double>(steps);
            Stepper stepper = way.stepper();
            Error error = stepper.start(start);
            double worst = 0.0;
            double defect = 0.0;
            double until = 0.0;
            for (std::size_t i = 0; i < steps && error == Error::none; ++i) {
                error = integrate(stepper, omega, until, h, 1);
                if (error == Error::none) {
                    const Reading reading = stepper.attitude();
                    worst = std::max(worst, error_of(exact[(i + 1) * (most_steps / steps)], *reading));
                    defect = std::max(defect, reading.defect());
                    until = static_cast<double>(i + 1) * h;
                }
            }
            if (error != Error::none) {
                write(csv, "work", motion, way, h, until, none, none, none, error);
                continue;
            }
            std::vector<Vector3d> rates;
            for (std::size_t i = 0; i < steps; ++i) {
                for (const double node : stepper.nodes()) {
                    rates.push_back(motion.omega((static_cast<double>(i) + node) * h));
                }
            }
            write(csv, "work", motion, way, h, seconds, worst, defect, time_of_step(way, start, h, rates), error);
        }
    }
}

// --- Error and drift against time: a million steps -------------------------------------------------------------------

void drift(std::ostream& csv, const Motion& motion) {
    constexpr double h = 0.01;
    const auto omega = [&](double t) { return motion.omega(t); };
    for (const Way& way : ways()) {
        Stepper stepper = way.stepper();
        Error error = stepper.start(oracle::rotation(motion.attitude(0)));
        std::size_t done = 0;
        double worst = 0.0;
        for (int point = 0; point <= 60; ++point) { // fifteen a decade, from 1 s on
            const auto goal = static_cast<std::size_t>(std::lround(std::pow(10.0, 2.0 + point / 15.0)));
            for (; done < goal; ++done) { // step by step, which says where it ended
                error = integrate(stepper, omega, static_cast<double>(done) * h, h, 1);
                if (error != Error::none) {
                    break;
                }
            }
            const double time = static_cast<double>(done) * h;
            if (error != Error::none) {
                write(csv, "drift", motion, way, h, time, none, none, none, error);
                break;
            }
            const Reading reading = stepper.attitude();
            const Exact exact = exact_attitude(motion, oracle::Real(h) * static_cast<double>(done));
            worst = std::max(worst, error_of(exact, *reading));
            write(csv, "drift", motion, way, h, time, worst, reading.defect(), none, error);
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    return write_figures(argc, argv, [](std::ostream& csv) {
        csv << "kind,motion,set,integrator,step,renormalised,time,error,ns_per_second,evaluations_per_second,defect,"
               "outcome\n";
        for (const Motion& motion : motions::all()) {
            work(csv, motion);
        }
        for (const Motion& motion : {motions::gentle(), motions::tumbling()}) {
            drift(csv, motion);
        }
    });
}
