// Angular velocity from attitudes, rates --differences.

#include <array>
#include <cmath>

#include <catch.hpp>
#include <fmt/format.h>

#include "process.hpp"

using namespace program;

namespace {

const std::string differences = "rates --differences ";

/// Rows t,qx,qy,qz,qw of a body that turns at a constant rate about (2, -3, 6)/7; every other one has the other sign.
std::string constant_rate(double rate, double step, int rows) {
    std::string text = "t,qx,qy,qz,qw,id\n";
    for (int i = 0; i < rows; ++i) {
        const double half = 0.5 * rate * step * i;
        const double sign = i % 2 == 0 ? 1.0 : -1.0;
        const double s = sign * std::sin(half) / 7;
        text += fmt::format("{},{},{},{},{},r{}\n", step * i, 2 * s, -3 * s, 6 * s, sign * std::cos(half), i);
    }
    return text;
}

} // namespace

// Catches a chord in the place of the angle, a sign of the quaternion that counts, and a first row that is lost.
TEST_CASE("differences of a constant rate are that rate, at every row") {
    constexpr int count = 500;
    const std::string rows = constant_rate(1.75, 0.125, count); // times that are exact
    const auto result = run(differences + "-f quat:tum --columns t,qx,qy,qz,qw", rows);
    CHECK(result.exit_code == 0);
    CHECK(result.err == "");
    std::string_view rest = result.out;
    const auto next = [&rest] {
        const auto line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(line.size() + 1);
        return fields_of(line, ',');
    };
    CHECK(next() == Words{"t", "wx", "wy", "wz", "id"});
    for (int i = 0; i < count; ++i) {
        const auto fields = next();
        INFO(i);
        REQUIRE(fields.size() == 5);
        CHECK(std::stod(fields[0]) == 0.125 * i);
        CHECK(fields[4] == fmt::format("r{}", i));
        const std::array<double, 3> expected{0.5, -0.75, 1.5};
        for (std::size_t k = 0; k < 3; ++k) { // quaternions are rounded
            CHECK(std::stod(fields[k + 1]) == Approx(expected.at(k)).epsilon(0).margin(1e-14));
        }
    }
    CHECK(rest.empty());
}

// Catches a row that waits for more than the second, and a state that is lost between batches.
TEST_CASE("differences answer each row as it comes, whatever the threads and the blocks") {
    Process process({"rates", "--differences", "-f", "rpy", "-p", "12"});
    process.write("0 0 0 0\n1 0 0 1\n");
    CHECK(process.read_rows(2) == "0 0 0 1\n1 0 0 1\n");
    process.write("2 0 0 1.5\n");
    CHECK(process.read_rows(1) == "2 0 0 0.5\n");
    CHECK(process.finish().exit_code == 0);
    const std::string rows = constant_rate(0.3, 0.5, 20'000);
    const std::string options = differences + "-f quat:tum --columns t,qx,qy,qz,qw --diagnostics columns --threads ";
    const auto one = run(options + "1", rows);
    CHECK(one.exit_code == 0);
    CHECK(count_rows(one.out) == 20'001);
    CHECK(run(options + "8", rows) == one);
}
