// bench_numbers: libraries that print and read doubles, on numbers of attitudes: components of unit quaternions, all of
// their digits. double-conversion takes part where it is installed.

#include <charconv>
#include <cstddef>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/compile.h>
#include <fmt/format.h>

#include "processes.hpp"
#include "stream/numbers/number_text.hpp"
#include "stream/numbers/scan_number.hpp"

#ifdef HAS_DOUBLE_CONVERSION
#include <double-conversion/double-conversion.h>
#endif

namespace {

/// So many that the processor cannot learn their digits.
const std::vector<double>& numbers() {
    static const auto made = [] {
        std::vector<double> all;
        Attitudes attitudes;
        for (int i = 0; i < 100'000; ++i) {
            const auto q = attitudes.next();
            all.insert(all.end(), {q.w, q.x, q.y, q.z});
        }
        return all;
    }();
    return made;
}

/// One text, with a comma after each number.
const std::string& text() {
    static const auto made = [] {
        std::string all;
        for (const double number : numbers()) {
            all += fmt::format("{:.17g},", number);
        }
        return all;
    }();
    return made;
}

template <class Print> void time_printing(benchmark::State& state, const Print& print) {
    char text[64];
    for (auto _ : state) {
        for (const double number : numbers()) {
            benchmark::DoNotOptimize(print(text, number));
            benchmark::ClobberMemory();
        }
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(numbers().size()));
}

/// `read` returns the place after the number.
template <class Read> void time_reading(benchmark::State& state, const Read& read) {
    double number = 0.0;
    for (auto _ : state) {
        const char* const end = text().data() + text().size();
        for (const char* at = text().data(); at != end; ++at) {
            at = read(at, end, number);
            benchmark::DoNotOptimize(number);
        }
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(numbers().size()));
}

void print_fmt(benchmark::State& state) {
    time_printing(state, [](char* text, double number) { return fmt::format_to(text, FMT_COMPILE("{}"), number); });
}

void print_std(benchmark::State& state) {
    time_printing(state, [](char* text, double number) { return std::to_chars(text, text + 64, number).ptr; });
}

/// As the program prints.
void print_dragonbox(benchmark::State& state) {
    rotconv::stream::Buffer buffer;
    time_printing(state, [&buffer](char* /*text*/, double number) {
        buffer.clear();
        rotconv::stream::append_number(buffer, number, {});
        return buffer.size();
    });
}

void read_std(benchmark::State& state) {
    time_reading(state, [](const char* begin, const char* end, double& number) {
        return std::from_chars(begin, end, number).ptr;
    });
}

void read_fast_float(benchmark::State& state) {
    time_reading(state, [](const char* begin, const char* end, double& number) {
        return fast_float::from_chars(begin, end, number).ptr;
    });
}

/// As the program reads.
void read_rotconv(benchmark::State& state) { time_reading(state, rotconv::stream::scan_number); }

BENCHMARK(print_fmt);
BENCHMARK(print_std);
BENCHMARK(print_dragonbox);
BENCHMARK(read_std);
BENCHMARK(read_fast_float);
BENCHMARK(read_rotconv);

#ifdef HAS_DOUBLE_CONVERSION
void print_double_conversion(benchmark::State& state) {
    time_printing(state, [](char* text, double number) {
        double_conversion::StringBuilder builder(text, 64);
        double_conversion::DoubleToStringConverter::EcmaScriptConverter().ToShortest(number, &builder);
        const int size = builder.position();
        builder.Finalize();
        return size;
    });
}
BENCHMARK(print_double_conversion);

void read_double_conversion(benchmark::State& state) {
    using Converter = double_conversion::StringToDoubleConverter;
    const Converter converter(Converter::ALLOW_TRAILING_JUNK, 0.0, 0.0, "inf", "nan");
    time_reading(state, [&converter](const char* begin, const char* end, double& number) {
        int used = 0;
        number = converter.StringToDouble(begin, static_cast<int>(end - begin), &used);
        return begin + used;
    });
}
BENCHMARK(read_double_conversion);
#endif

} // namespace

BENCHMARK_MAIN();
