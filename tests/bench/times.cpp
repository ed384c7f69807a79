#include "times.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <random>

#include <Eigen/Core>
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <rotconv/conversion.hpp>

#include "strata.hpp"

namespace bench {

using rotconv::RepresentationId;
using rotconv::Spec;

namespace {

constexpr std::size_t million = 1'000'000;
constexpr std::array near_kinds{rotconv::SampleKind::small, rotconv::SampleKind::half_turn, rotconv::SampleKind::lock};

/// A million uniform attitudes.
std::vector<double> timed_rows(const Spec& spec, bool hostile) {
    std::mt19937_64 engine(7);
    std::normal_distribution<double> normal;
    std::vector<double> quaternions(million * 4);
    for (std::size_t i = 0; i < million; ++i) {
        Eigen::Map<Eigen::Vector4d>{&quaternions[4 * i]} =
            Eigen::Vector4d(normal(engine), normal(engine), normal(engine), normal(engine)).normalized();
    }
    std::vector<double> rows(million * spec.size());
    std::vector<rotconv::RowReport> reports;
    rotconv::Conversion(Spec{}, spec).run(quaternions, rows, reports);
    if (hostile) {
        strata::Source source(8);
        for (std::size_t i = 0; i < rows.size(); i += spec.size()) {
            strata::make_hostile(spec, {&rows[i], spec.size()}, source);
        }
    }
    return rows;
}

/// Where formulas take their branches.
std::vector<double> rows_near(const Pair& pair, rotconv::SampleKind kind) {
    const Spec spec = pair.source();
    const auto rows = kind == rotconv::SampleKind::lock && spec.name != RepresentationId::euler
                          ? strata::near_lock(spec, pair.target().sequence, block)
                          : strata::sampled(spec, kind, block);
    std::vector<double> all;
    for (const auto& row : rows) {
        all.insert(all.end(), row.begin(), row.end());
    }
    return all;
}

std::string name_of(const Pair& pair, const std::string& way, const std::string& rows, bool all) {
    return fmt::format("{}-{}-{}-{}{}", text_of(pair.from), text_of(pair.to), way, rows, all ? "/million" : "");
}

/// Keeps the least time of each benchmark: the processor's, which other processes disturb least.
class Least : public benchmark::BenchmarkReporter {
public:
    explicit Least(std::map<std::string, double>& times) : times_(times) {}
    bool ReportContext(const Context& /*context*/) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type == Run::RT_Iteration && run.iterations > 0) {
                const std::string& name = run.run_name.function_name;
                const double rows = name.ends_with("/million") ? double(million) : double(block);
                const double time = run.GetAdjustedCPUTime() / rows;
                const auto place = times_.try_emplace(name, time).first;
                place->second = std::min(place->second, time);
            }
        }
    }

private:
    std::map<std::string, double>& times_;
};

void add_benchmark(const std::string& name, const Convert& convert, const std::vector<double>& in,
                   std::vector<double>& out, bool all) {
    auto* const made = benchmark::RegisterBenchmark(name.c_str(), [&in, &out, convert, all](benchmark::State& state) {
        for (auto _ : state) {
            convert(in.data(), all ? million : block, out.data());
            benchmark::ClobberMemory();
        }
    });
    made->Unit(benchmark::kNanosecond)->Repetitions(all ? 3 : 15);
    if (all) {
        made->Iterations(1);
    } else {
        made->MinTime(0.005);
    }
}

/// In random order, so that no way profits from its place.
void initialize() {
    std::string program = "bench_methods";
    std::string interleaving = "--benchmark_enable_random_interleaving=true";
    std::array<char*, 3> arguments{program.data(), interleaving.data(), nullptr};
    int count = 2;
    benchmark::Initialize(&count, arguments.data());
}

} // namespace

Times::Times(const std::vector<Pair>& pairs) {
    initialize();
    Least least(times_);
    std::vector<double> out(million * 9);
    for (const RepresentationId from : rotconv::all_representations) {
        benchmark::ClearRegisteredBenchmarks();
        std::deque<std::vector<double>> kept; // the benchmarks refer to them
        for (const Pair& pair : pairs) {
            if (pair.from != from) {
                continue;
            }
            if (kept.empty()) {
                kept.push_back(timed_rows(pair.source(), false));
                kept.push_back(timed_rows(pair.source(), true));
            }
            const std::size_t first_near = kept.size();
            for (const auto kind : near_kinds) {
                kept.push_back(rows_near(pair, kind));
            }
            for (const Way& way : pair.ways) {
                const Convert clean = way.between(pair.source(), pair.target(), false);
                const Convert hostile = way.between(pair.source(), pair.target(), true);
                for (const bool all : {false, true}) {
                    add_benchmark(name_of(pair, way.name, "clean", all), clean, kept[0], out, all);
                    add_benchmark(name_of(pair, way.name, "hostile", all), hostile, kept[1], out, all);
                }
                for (std::size_t i = 0; i < near_kinds.size(); ++i) {
                    const std::string rows(rotconv::name_of(near_kinds.at(i)));
                    add_benchmark(name_of(pair, way.name, rows, false), clean, kept[first_near + i], out, false);
                }
            }
        }
        if (!kept.empty()) {
            benchmark::RunSpecifiedBenchmarks(&least);
        }
    }
}

double Times::of(const Pair& pair, const std::string& way, const std::string& rows, bool all) const {
    const auto found = times_.find(name_of(pair, way, rows, all));
    return found == times_.end() ? none : found->second;
}

} // namespace bench
