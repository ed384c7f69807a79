// A million quaternions of 17 digits to matrices: the whole stream, against a bare loop that parses and prints the same
// numbers with the same libraries and knows of nothing else.

#include <charconv>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <fmt/compile.h>
#include <fmt/format.h>
#include <unistd.h>

#include <rotconv/spec.hpp>

#include "stream/run.hpp"

namespace {

using namespace rotconv;

constexpr int rows = 1'000'000;

const std::string& input() {
    static const std::string text = [] {
        std::mt19937_64 engine(1);
        std::normal_distribution<double> normal;
        std::string made;
        for (int i = 0; i < rows; ++i) {
            double q[4] = {normal(engine), normal(engine), normal(engine), normal(engine)};
            const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
            made +=
                fmt::format("{:.17g},{:.17g},{:.17g},{:.17g}\n", q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm);
        }
        return made;
    }();
    return text;
}

/// Nothing but the libraries: no check, no field that passes, no line counted.
void bare_loop(stream::Sink& sink) {
    fmt::memory_buffer out;
    const char* at = input().data();
    const char* const end = at + input().size();
    while (at < end) {
        double q[4];
        for (double& component : q) {
            at = std::from_chars(at, end, component).ptr + 1;
        }
        const auto [w, x, y, z] = q;
        const double m[9] = {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
                             2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                             2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
        for (int i = 0; i < 9; ++i) {
            fmt::format_to(std::back_inserter(out), FMT_COMPILE("{}"), m[i]);
            out.push_back(i < 8 ? ',' : '\n');
        }
        if (out.size() > 65536) {
            sink.write({out.data(), out.size()});
            out.clear();
        }
    }
    sink.write({out.data(), out.size()});
}

void bench_bare_loop(benchmark::State& state) {
    stream::File sink("/dev/null", stream::File::Mode::write);
    for (auto _ : state) {
        bare_loop(sink);
    }
    state.SetItemsProcessed(state.iterations() * rows);
}

void bench_stream(benchmark::State& state) {
    stream::File sink("/dev/null", stream::File::Mode::write);
    const stream::Options options(Conversion(std::get<Spec>(parse_spec("quat")), std::get<Spec>(parse_spec("dcm"))));
    for (auto _ : state) {
        stream::TextSource source(input());
        const auto ending = stream::run(source, sink, options, [](const stream::Event&) {});
        if (ending.stopped || ending.fault) {
            state.SkipWithError("the stream ended early");
        }
    }
    state.SetItemsProcessed(state.iterations() * rows);
}

} // namespace

BENCHMARK(bench_bare_loop)->Unit(benchmark::kMillisecond);
BENCHMARK(bench_stream)->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
