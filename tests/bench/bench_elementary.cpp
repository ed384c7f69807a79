// bench_elementary_TARGET: the sine and cosine, and the arc tangent of two arguments, of the C library, of this project
// and, where it is installed, of SLEEF, which has functions of the same bits on every processor (cinz) and on those
// with fused multiply-add (finz).

#include <cmath>
#include <cstdint>
#include <random>

#include <benchmark/benchmark.h>

#include "core/numerics/elementary.hpp"

#ifdef HAS_SLEEF
#include <immintrin.h>
#include <sleef.h>
#endif

namespace {

using rotconv::AngleUnit;
using rotconv::batch_rows;
using rotconv::Column;
using rotconv::DoubleDouble;

/// A batch of angles in radians, and of vectors.
struct Inputs {
    Inputs() {
        std::mt19937_64 engine(1);
        std::uniform_real_distribution<double> angle(-3.14, 3.14);
        std::normal_distribution<double> component;
        for (std::size_t i = 0; i < batch_rows; ++i) {
            angles.set(i, angle(engine));
            x.set(i, component(engine));
            y.set(i, component(engine));
        }
    }

    alignas(32) Column<DoubleDouble> angles;
    alignas(32) Column<DoubleDouble> x;
    alignas(32) Column<DoubleDouble> y;
};

const Inputs inputs;
alignas(32) Column<DoubleDouble> first;
alignas(32) Column<DoubleDouble> second;

/// `work` is done to the rows from 0, `lanes` at a time.
template <std::size_t lanes, class Work> void time(benchmark::State& state, const Work& work) {
    for (auto _ : state) {
        for (std::size_t i = 0; i < batch_rows; i += lanes) {
            work(i);
        }
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(batch_rows));
}

void sine_cosine_libm(benchmark::State& state) {
    time<1>(state, [](std::size_t i) {
        first.hi[i] = std::sin(inputs.angles.hi[i]);
        second.hi[i] = std::cos(inputs.angles.hi[i]);
    });
}

void arc_tangent_libm(benchmark::State& state) {
    time<1>(state, [](std::size_t i) { first.hi[i] = std::atan2(inputs.y.hi[i], inputs.x.hi[i]); });
}

template <class T> void sine_cosine_own(benchmark::State& state) {
    Column<T> cosines;
    Column<T> sines;
    time<batch_rows>(state, [&](std::size_t /*first*/) {
        rotconv::sine_cosine<T>(inputs.angles, batch_rows, AngleUnit::radians, cosines, sines);
        benchmark::DoNotOptimize(cosines);
        benchmark::DoNotOptimize(sines);
    });
}

template <class T> void arc_tangent_own(benchmark::State& state) {
    Column<T> x;
    Column<T> y;
    for (std::size_t i = 0; i < batch_rows; ++i) {
        x.set(i, inputs.x.hi[i]);
        y.set(i, inputs.y.hi[i]);
    }
    time<batch_rows>(
        state, [&](std::size_t /*first*/) { rotconv::angles_of<T>(x, y, batch_rows, AngleUnit::radians, first); });
}

BENCHMARK(sine_cosine_libm);
BENCHMARK(sine_cosine_own<double>);
BENCHMARK(sine_cosine_own<DoubleDouble>);
BENCHMARK(arc_tangent_libm);
BENCHMARK(arc_tangent_own<double>);
BENCHMARK(arc_tangent_own<DoubleDouble>);

#ifdef HAS_SLEEF
template <auto function> void sine_cosine_1(benchmark::State& state) {
    time<1>(state, [](std::size_t i) {
        const auto both = function(inputs.angles.hi[i]);
        first.hi[i] = both.x;
        second.hi[i] = both.y;
    });
}

template <auto function> void arc_tangent_1(benchmark::State& state) {
    time<1>(state, [](std::size_t i) { first.hi[i] = function(inputs.y.hi[i], inputs.x.hi[i]); });
}

BENCHMARK(sine_cosine_1<Sleef_cinz_sincosd1_u10purec>)->Name("sine_cosine_sleef_cinz/lanes:1");
BENCHMARK(arc_tangent_1<Sleef_cinz_atan2d1_u10purec>)->Name("arc_tangent_sleef_cinz/lanes:1");

#ifdef __AVX2__
template <auto function> void sine_cosine_4(benchmark::State& state) {
    time<4>(state, [](std::size_t i) {
        const auto both = function(_mm256_load_pd(inputs.angles.hi + i));
        _mm256_store_pd(first.hi + i, both.x);
        _mm256_store_pd(second.hi + i, both.y);
    });
}

template <auto function> void arc_tangent_4(benchmark::State& state) {
    time<4>(state, [](std::size_t i) {
        _mm256_store_pd(first.hi + i, function(_mm256_load_pd(inputs.y.hi + i), _mm256_load_pd(inputs.x.hi + i)));
    });
}

BENCHMARK(sine_cosine_1<Sleef_finz_sincosd1_u10purecfma>)->Name("sine_cosine_sleef_finz/lanes:1");
BENCHMARK(arc_tangent_1<Sleef_finz_atan2d1_u10purecfma>)->Name("arc_tangent_sleef_finz/lanes:1");
BENCHMARK(sine_cosine_4<Sleef_cinz_sincosd4_u10avx>)->Name("sine_cosine_sleef_cinz/lanes:4");
BENCHMARK(arc_tangent_4<Sleef_cinz_atan2d4_u10avx>)->Name("arc_tangent_sleef_cinz/lanes:4");
BENCHMARK(sine_cosine_4<Sleef_finz_sincosd4_u10avx2>)->Name("sine_cosine_sleef_finz/lanes:4");
BENCHMARK(arc_tangent_4<Sleef_finz_atan2d4_u10avx2>)->Name("arc_tangent_sleef_finz/lanes:4");
#else
template <auto function> void sine_cosine_2(benchmark::State& state) {
    time<2>(state, [](std::size_t i) {
        const auto both = function(_mm_load_pd(inputs.angles.hi + i));
        _mm_store_pd(first.hi + i, both.x);
        _mm_store_pd(second.hi + i, both.y);
    });
}

template <auto function> void arc_tangent_2(benchmark::State& state) {
    time<2>(state, [](std::size_t i) {
        _mm_store_pd(first.hi + i, function(_mm_load_pd(inputs.y.hi + i), _mm_load_pd(inputs.x.hi + i)));
    });
}

BENCHMARK(sine_cosine_2<Sleef_cinz_sincosd2_u10sse2>)->Name("sine_cosine_sleef_cinz/lanes:2");
BENCHMARK(arc_tangent_2<Sleef_cinz_atan2d2_u10sse2>)->Name("arc_tangent_sleef_cinz/lanes:2");
#endif
#endif

} // namespace

BENCHMARK_MAIN();
