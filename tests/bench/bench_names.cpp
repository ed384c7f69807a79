// bench_names: names of headers, of many columns and long, held against a SPEC and searched for a key. The time of each
// grows with the bytes, as its last lines say.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <rotconv/spec.hpp>

#include "cli/grammar/column_names.hpp"
#include "stream/pairs/likely_key.hpp"

namespace {

using Names = std::vector<std::string>;

constexpr int few_columns = 1000;
constexpr int most_columns = 100'000;
constexpr int short_name = 1 << 12;
constexpr int longest_name = 1 << 20;

/// Columns beside those of a quaternion, which are the last.
Names many_columns(std::size_t count) {
    Names names;
    for (std::size_t i = 0; i < count; ++i) {
        names.push_back(fmt::format("window_{}_x_time", i));
    }
    names.insert(names.end(), {"qw", "qx", "qy", "qz"});
    return names;
}

/// Names of one text repeated, so many bytes in all, that end as those of two quaternions without a z.
Names long_names(std::string_view text, std::size_t size) {
    Names names;
    for (const std::string_view end : {"w", "x", "y", "_s"}) {
        std::string& name = names.emplace_back();
        while (name.size() < size / 4) {
            name += text;
        }
        name += end;
    }
    return names;
}

void find_quaternion(benchmark::State& state, const Names& names) {
    const auto spec = std::get<rotconv::Spec>(rotconv::parse_spec("quat"));
    for (auto _ : state) {
        benchmark::DoNotOptimize(rotconv::cli::find_names(spec, names));
    }
    state.SetComplexityN(state.range(0));
}

void find_in_many_columns(benchmark::State& state) {
    find_quaternion(state, many_columns(static_cast<std::size_t>(state.range(0))));
}
void find_in_names_of_w(benchmark::State& state) {
    find_quaternion(state, long_names("w", static_cast<std::size_t>(state.range(0))));
}
void find_in_names_of_underscores(benchmark::State& state) {
    find_quaternion(state, long_names("_", static_cast<std::size_t>(state.range(0))));
}

void look_for_key(benchmark::State& state) {
    rotconv::stream::Layout layout;
    layout.names = many_columns(static_cast<std::size_t>(state.range(0)));
    layout.positions = {layout.names.size() - 1};
    for (auto _ : state) {
        benchmark::DoNotOptimize(rotconv::stream::LikelyKey({&layout, &layout}));
    }
    state.SetComplexityN(state.range(0));
}

} // namespace

BENCHMARK(find_in_many_columns)->RangeMultiplier(10)->Range(few_columns, most_columns)->Complexity(benchmark::oN);
BENCHMARK(look_for_key)->RangeMultiplier(10)->Range(few_columns, most_columns)->Complexity(benchmark::oN);
BENCHMARK(find_in_names_of_w)->RangeMultiplier(4)->Range(short_name, longest_name)->Complexity(benchmark::oN);
BENCHMARK(find_in_names_of_underscores)->RangeMultiplier(4)->Range(short_name, longest_name)->Complexity(benchmark::oN);

BENCHMARK_MAIN();
