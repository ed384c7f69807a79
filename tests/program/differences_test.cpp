// Angular velocity from attitudes, rates --differences.

#include <array>
#include <cmath>
#include <fstream>
#include <numbers>

#include <fmt/format.h>

#include "usage.hpp"

using namespace program;

namespace {

const std::string differences = "rates --differences ";
const std::string rounded = "rates --differences -p 12 ";

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

TEST_CASE("differences of a constant rate are that rate, at every row") {
    // Catches a chord in the place of the angle, a sign of the quaternion that counts, and a first row that is lost.
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

TEST_CASE("a step that may be past half a turn is a row error") {
    // Catches the shorter way round, taken in silence; and a gap after which nothing is known any more.
    const auto gap = run(rounded + "-f rpy -d --on-error nan", "0 0 0 0\n1 0 0 100\n2 0 0 200\n4 0 0 40\n5 0 0 50\n");
    CHECK(gap.exit_code == 1);
    CHECK(gap.out == "0 0 0 100\n1 0 0 100\n2 0 0 100\n4 nan nan nan\n5 0 0 10\n");
    CHECK(gap.err == "rotconv: -:4: the body may have turned by half a turn or more since the row before (a gap?): "
                     "'4 0 0 40'\n");
    CHECK(run(differences + "-f quat --on-error skip", "0 1 0 0 0\n1 1 0 0 0\n2 0 0 1 0\n3 0 0 1 0\n") ==
          went_on("0 0 0 0\n1 0 0 0\n3 0 0 0\n"));
    CHECK(run(differences + "-f quat", "0 1 0 0 0\n1 0 0 1 0\n").exit_code == 2);
}

TEST_CASE("differences go on over bad rows") {
    // Catches the attitude of one row over the time of another.
    const std::string rows = "0 0 0 0\n1 0 0 10\n1 0 0 20\n0.5 0 0 30\nnan 0 0 30\n2 0 inf 20\n2.5 x 0 20\n3 0 0 30\n";
    const auto result = run(rounded + "-f rpy -d --on-error skip", rows);
    CHECK(result.exit_code == 1);
    CHECK(result.out == "0 0 0 10\n1 0 0 10\n3 0 0 10\n");
    CHECK(missing(result.err, {"-:3: time does not increase", "-:4: time does not increase", "-:5: not finite",
                               "-:6: not finite", "-:7: not a number: 'x'"}) == "");
    CHECK(count_rows(result.err) == 5);
    CHECK(run(rounded + "-f rpy -d", rows) == stopped("0 0 0 10\n1 0 0 10\n"));
    CHECK(missing(run(differences + "-f quat:tum", "0 0 0 0 2\n").err, {"-:1: defect 1", "its norm is 2"}) == "");
    // A first row that has no second says so, and no more.
    CHECK(run(differences + "-f rpy", "0 0 0 1\n") == done("0 nan nan nan\n"));
    CHECK(run(differences + "-f rpy", "") == done(""));
}

TEST_CASE("differences answer each row as it comes, whatever the threads and the blocks") {
    // Catches a row that waits for more than the second, and a state that is lost between batches.
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

TEST_CASE("differences and propagate are inverse to each other at a constant rate") {
    // Catches a velocity that belongs to the step after.
    const std::string attitudes = "0 0 0 0\n0.5 0 0 0.25\n1 0 0 0.5\n1.5 0 0 0.75\n";
    const auto rates = run(differences + "-f rotvec", attitudes);
    CHECK(run("propagate -t rotvec -p 12", rates.out) == done(attitudes));
}

TEST_CASE("differences refuse what has no meaning with them") {
    // Catches options that are ignored.
    check_usage_error(differences + "--inverse -f quat", {"--inverse", "--differences"});
    check_usage_error(differences + "-f quat 0 1 0 0 0", {"rates --differences reads rows, not arguments"});
    check_usage_error(differences + "-f quat --time-unit min", {"'min'", "ns"});
    check_usage_error(differences + "-f quat --frame world", {"'world'", "body", "reference"});
    check_usage_error(differences + "-f quat --columns t,qx,qy,qz,qw", {"quat:xyzw"});
    check_usage_error(differences + "-f quat --columns 1-4", {"5 numbers"});
    check_usage_error(differences + "-f quat --differences=2", {"--differences takes no argument"});
    CHECK(run(differences + "-f axis-angle", "0 0 0 1 0\n1 0 0 1 1\n") == done("0 0 0 1\n1 0 0 1\n"));
}
