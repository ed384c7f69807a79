// Rows of little-endian doubles, in and out.

#include <algorithm>
#include <cmath>
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
