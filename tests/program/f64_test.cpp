// Rows of little-endian doubles, in and out.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "process.hpp"

using namespace program;

namespace {

using Numbers = std::vector<double>;

Numbers numbers_of(std::string_view bytes) {
    REQUIRE(bytes.size() % sizeof(double) == 0);
    Numbers numbers(bytes.size() / sizeof(double));
    std::memcpy(numbers.data(), bytes.data(), bytes.size());
    return numbers;
}

Numbers numbers_in(std::string text) {
    std::ranges::replace(text, ',', ' ');
    Numbers numbers;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        numbers.push_back(std::stod(word));
    }
    return numbers;
}

const std::string binary = " --input-format f64 ";

Numbers made_numbers(std::size_t rows, std::size_t width) {
    std::mt19937_64 engine(211);
    std::normal_distribution<double> normal;
    Numbers numbers(rows * width);
    for (double& number : numbers) {
        number = normal(engine);
    }
    return numbers;
}

} // namespace

// Catches an order of bytes, numbers or rows that is not that of the input.
TEST_CASE("doubles in, doubles out") {
    const auto result =
        run("-f quat -t quat:xyzw --format f64" + binary, bytes_of({0.5, -0.5, 0.5, 0.5, 1, 0, 0, 0, 0, 0, -1, 0}));
    CHECK(result.exit_code == 0);
    CHECK(result.err == "");
    CHECK(numbers_of(result.out) == Numbers{-0.5, 0.5, 0.5, 0.5, 0, 0, 0, 1, 0, 1, 0, 0});
    CHECK(run("-f quat -t dcm --format f64" + binary, "") == done(""));
}

// Catches digits that are lost on one side.
TEST_CASE("doubles in, text out, and the other way round") {
    CHECK(run("-f quat -t quat:xyzw" + binary, bytes_of({0.5, -0.5, 0.5, 0.5})) == done("-0.5,0.5,0.5,0.5\n"));
    CHECK(run("-f quat -t quat:xyzw --delimiter blank --header add" + binary, bytes_of({1, 0, 0, 0})) ==
          done("qx qy qz qw\n0 0 0 1\n"));
    CHECK(run("-f quat -t rotvec --format json" + binary, bytes_of({1, 0, 0, 0})) ==
          done("{\"rx\": 0, \"ry\": 0, \"rz\": 0}\n"));
    const auto out = run("-f quat -t quat:xyzw --format f64 --columns qw,qx,qy,qz",
                         "# note\nt,qw,qx,qy,qz\n\nlabel,.5,-.5,.5,.5\r\nx,1,0,0,0");
    CHECK(out.exit_code == 0);
    CHECK(numbers_of(out.out) == Numbers{-0.5, 0.5, 0.5, 0.5, 0, 0, 0, 1});
    CHECK(numbers_of(run("-f quat -t quat --format f64 1 0 0 0").out) == Numbers{1, 0, 0, 0});
    const auto numbers = made_numbers(500, 4);
    const auto text = run("-f quat -t dcm --tolerance inf --diagnostics off" + binary, bytes_of(numbers));
    const auto doubles =
        run("-f quat -t dcm --tolerance inf --diagnostics off --format f64" + binary, bytes_of(numbers));
    CHECK(run("-f dcm -t dcm --format f64", text.out).out ==
          run("-f dcm -t dcm --format f64" + binary, doubles.out).out);
}

// Catches positions that are off, and numbers that are parsed and printed on their way.
TEST_CASE("columns of doubles are selected by index, and the others pass") {
    const double quiet = std::numeric_limits<double>::quiet_NaN();
    const double tiny = std::numeric_limits<double>::denorm_min();
    const auto input = bytes_of({tiny, 1, 0, 0, 0, -0.0, quiet, 0, 0, 0, 1, 7});
    const std::string arguments = "-f quat -t quat:xyzw --columns 2-5 --width 6" + binary;
    CHECK(run(arguments + "--format f64", input) == done(bytes_of({tiny, 0, 0, 0, 1, -0.0, quiet, 0, 0, 1, 0, 7})));
    CHECK(run(arguments + "--format f64 --append", input) ==
          done(bytes_of({tiny, 1, 0, 0, 0, -0.0, 0, 0, 0, 1, quiet, 0, 0, 0, 1, 7, 0, 0, 1, 0})));
    CHECK(run(arguments + "--header add", input) == done("1,qx,qy,qz,qw,6\n5e-324,0,0,0,1,-0\nnan,0,0,1,0,7\n"));
    CHECK(run(arguments + "--append --delimiter tab", input) ==
          done("5e-324\t1\t0\t0\t0\t-0\t0\t0\t0\t1\nnan\t0\t0\t0\t1\t7\t0\t0\t1\t0\n"));
    CHECK(run(arguments + "--format json", bytes_of({8, 1, 0, 0, 0, 9})) ==
          done(R"({"1": 8, "6": 9, "qx": 0, "qy": 0, "qz": 0, "qw": 1})"
               "\n"));
}

// Catches bytes that are dropped in silence, and rows before them that are.
TEST_CASE("bytes at the end that are no whole row are an error at their place") {
    auto input = bytes_of({1, 0, 0, 0, 0, 1, 0, 0, 0.5});
    input += "abc";
    const auto result = run("-f quat -t quat:xyzw --format f64" + binary, input);
    CHECK(result.exit_code == 2);
    CHECK(numbers_of(result.out) == Numbers{0, 0, 0, 1, 1, 0, 0, 0});
    CHECK(result.err == "rotconv: -:3: the row that begins at byte 64 is not whole\n");
    CHECK(missing(run("-f quat -t dcm" + binary, "1 0 0 0\n").err, {"-:1: ", "byte 0 "}) == "");
}

// Catches policies that binary rows do not know, and raw bytes in messages.
TEST_CASE("rows of doubles without an attitude are errors with their row and numbers") {
    const auto input = bytes_of({9, 1, 0, 0, 0, 8, 0, 0, 0, 0, 7, 0, 0, 0, 1});
    const std::string arguments = "-f quat -t quat:xyzw --format f64 --columns 2-5 --width 5" + binary;
    const auto stopped = run(arguments, input);
    CHECK(stopped ==
          Result{2, bytes_of({9, 0, 0, 0, 1}), "rotconv: -:2: a zero quaternion has no attitude: '0,0,0,0'\n"});
    CHECK(run(arguments + "--on-error skip", input) ==
          Result{1, bytes_of({9, 0, 0, 0, 1, 7, 0, 0, 1, 0}), stopped.err});
    const auto nan = run(arguments + "--on-error nan", input);
    CHECK(nan.exit_code == 1);
    const auto numbers = numbers_of(nan.out);
    REQUIRE(numbers.size() == 15);
    CHECK(numbers[5] == 8);
    CHECK(numbers[6] != numbers[6]);
    CHECK(numbers[9] != numbers[9]);
    CHECK(run("-f quat -t dcm" + binary, bytes_of({std::numeric_limits<double>::infinity(), 0, 0, 0})) ==
          Result{2, "", "rotconv: -:1: not finite: 'inf,0,0,0'\n"});
}

// Catches a row length that depends on the row.
TEST_CASE("diagnostics of doubles have their rows, and columns without the notes") {
    const auto input = bytes_of({1, 0, 0, 0, 0, 1, 0, 0});
    const auto rows = run("-f quat -t rotvec --diagnostics rows" + binary, input);
    CHECK(missing(rows.err, {"rotconv: -:2: half-turn"}) == "");
    const auto columns = run("-f quat -t rotvec --format f64 --diagnostics columns" + binary, input);
    const auto numbers = numbers_of(columns.out);
    REQUIRE(numbers.size() == 12);
    CHECK(numbers[9] == 0.0); // the margin at a half-turn
}

// Catches a format that only the conversion knows.
TEST_CASE("commands read and write doubles") {
    const auto rates = run("rates -f quat --format f64" + binary, bytes_of({1, 0, 0, 0, 0, 0, 2}));
    CHECK(numbers_of(rates.out) == Numbers{0, 0, 0, 1});
    const auto input = bytes_of({0, 0, 0, 30, 0.5, 0, 0, 30, 1, 0, 0, 30});
    CHECK(run("propagate -t rpy -d -p 6 --interpolation cubic" + binary, input) ==
          done("0,0,0,0\n0.5,0,0,15\n1,0,0,30\n"));
    CHECK(run("propagate -t rpy -d -p 6 --time-unit ms" + binary, bytes_of({1e9, 0, 0, 30, 1e9 + 500, 0, 0, 30})) ==
          done("1000000000,0,0,0\n1000000500,0,0,15\n"));
    CHECK(missing(run("survey -f rpy:deg" + binary, bytes_of({0, 80, 0, 0, 89, 0, 0, 91, 0})).out,
                  {"\n3 attitudes", "\nmrp\n"}) == "");
}

// Catches rows that are torn by the border of a block.
TEST_CASE("doubles do not depend on threads, nor on how they arrive") {
    const auto [columns, width] = GENERATE(std::pair(std::string("--columns 3-6 --width 7"), std::size_t{7}),
                                           std::pair(std::string(), std::size_t{4}));
    const std::string arguments = "-f quat -t euler:ZXZ --tolerance inf --on-error nan " + columns + binary;
    auto numbers = made_numbers(30'000, width);
    for (std::size_t i = 0; i < numbers.size(); i += width * 997) {
        numbers[i + 3] = std::numeric_limits<double>::quiet_NaN();
    }
    const auto input = bytes_of(numbers) + "rest";
    for (const std::string format : {"f64", "csv"}) {
        const auto expected = run(arguments + "--threads 1 --format " + format, input);
        CHECK(expected.exit_code == 2);
        for (const std::string threads : {"2", "3", "8"}) {
            CHECK((run(arguments + "--format " + format + " --threads " + threads, input) == expected));
        }
        Process process(words_of(arguments + "--format " + format));
        std::string_view rest = input;
        for (std::size_t size = 1; !rest.empty(); size = size * 7 % 10007) {
            process.write(rest.substr(0, size));
            process.wait_until_read();
            rest.remove_prefix(std::min(rest.size(), size));
        }
        CHECK((process.finish() == expected));
    }
}

// Catches a row with a fault or a diagnostic that is lost, repeated or in another's place.
TEST_CASE("doubles alone have the numbers, errors and diagnostics of text") {
    auto numbers = made_numbers(3000, 4);
    for (std::size_t row = 0; row < 3000; ++row) {
        const std::span q(numbers.data() + 4 * row, 4);
        const double norm = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
        std::ranges::for_each(q, [norm](double& component) { component /= norm; });
    }
    for (std::size_t row = 5; row < 3000; row += 1 + row % 131) {
        double* const q = numbers.data() + 4 * row;
        std::fill_n(q, 4, row % 2 == 0 ? 0.0 : 0.5); // no attitude, or a quarter turn at lock
    }
    for (const std::string policy : {"stop", "nan", "skip"}) {
        const std::string arguments =
            "-f quat -t euler:ZXY --tolerance inf --diagnostics rows --header no --on-error " + policy;
        const auto text = run(arguments + " --format csv" + binary, bytes_of(numbers));
        const auto doubles = run(arguments + " --format f64" + binary, bytes_of(numbers));
        CHECK(doubles.exit_code == text.exit_code);
        CHECK((doubles.err == text.err));
        CHECK(missing(text.err, {"zero quaternion", "gimbal-lock"}) == "");
        CHECK((bytes_of(numbers_in(text.out)) == doubles.out));
    }
}

// Catches rows that wait for a full block.
TEST_CASE("a row of doubles is answered before the next one is sent") {
    Process process(words_of("-f quat -t quat:xyzw" + binary));
    for (int i = 0; i < 20; ++i) {
        process.write(bytes_of({1, 0, 0, 0, 0, 1}));
        CHECK(process.read_rows(1) == "0,0,0,1\n");
        process.write(bytes_of({0, 0}));
        CHECK(process.read_rows(1) == "1,0,0,0\n");
    }
    CHECK(process.finish() == done(""));
}

// Catches a selection that reads past the row.
TEST_CASE("options that do not fit rows of doubles are usage errors") {
    for (const std::string arguments : {"--columns 2-5", "--columns 2-5 --width 4", "--width 5", "--width 0",
                                        "--columns qw,qx,qy,qz", "--width x", "--input-format f32"}) {
        INFO(arguments);
        CHECK(run("-f quat -t dcm" + binary + arguments, bytes_of({1, 0, 0, 0})) == stopped(""));
    }
}
