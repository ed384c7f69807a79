// bench_identify: a million rows of small motions identified by the program, beside its conversion of the same rows in
// the same run, in processor time. The counter is how many conversions an identification takes; more than a few are an
// error.

#include <cmath>
#include <fstream>
#include <random>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "processes.hpp"

namespace {

constexpr int rows = 1'000'000;
constexpr double most_conversions = 5.0;

/// Rotation vectors, normally distributed, and the quaternions beside them.
struct Motions {
    explicit Motions(double deviation) {
        std::mt19937_64 engine{1};
        std::normal_distribution<double> normal(0.0, deviation);
        std::ofstream file(folder / "rotvec");
        for (int i = 0; i < rows; ++i) {
            file << fmt::format("{:.17g},{:.17g},{:.17g}\n", normal(engine), normal(engine), normal(engine));
        }
        file.close();
        static_cast<void>(time_of(fmt::format(ROTCONV_PROGRAM " -f rotvec -t quat {} > {}", folder / "rotvec", known)));
    }

    Folder folder;
    std::string known = folder / "quat";
    std::string conversion = "exec " ROTCONV_PROGRAM " -f quat -t rpy --threads 1 " + known + " > /dev/null";
    /// The exit status is 1 where the answer is ambiguous.
    std::string identification =
        fmt::format(ROTCONV_PROGRAM " identify -t quat {} {} > /dev/null; [ $? -le 1 ]", folder / "rotvec", known);
};

void convert(benchmark::State& state, double deviation) {
    const Motions motions(deviation);
    for (auto _ : state) {
        state.SetIterationTime(time_of(motions.conversion).processor);
    }
}

void identify(benchmark::State& state, double deviation) {
    const Motions motions(deviation);
    double least = HUGE_VAL;
    for (auto _ : state) {
        const double identification = time_of(motions.identification).processor;
        state.SetIterationTime(identification);
        least = std::min(least, identification / time_of(motions.conversion).processor);
    }
    state.counters["conversions"] = least;
    if (least > most_conversions) {
        state.SkipWithError("an identification takes more than a few conversions");
    }
}

constexpr int rounds = 5;
BENCHMARK_CAPTURE(convert, of_3_degrees, 0.03)->UseManualTime()->Iterations(rounds)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identify, of_3_degrees, 0.03)->UseManualTime()->Iterations(rounds)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identify, where_many_fit, 1e-4)->UseManualTime()->Iterations(rounds)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
