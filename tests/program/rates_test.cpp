#include <cmath>
#include <numbers>

#include "usage.hpp"

using namespace program;

namespace {

/// The numbers of one row.
std::vector<double> numbers_of(const std::string& row) {
    std::vector<double> numbers;
    for (const auto& word : words_of(row)) {
        numbers.push_back(std::stod(word));
    }
    return numbers;
}

void check_near(const std::string& row, const std::vector<double>& expected) {
    const auto numbers = numbers_of(row);
    INFO(row);
    REQUIRE(numbers.size() == expected.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        CHECK(numbers[i] == Approx(expected[i]).epsilon(4e-16).margin(1e-16));
    }
}

} // namespace

TEST_CASE("rates of each set at an attitude where they are simple") {
    // Catches a factor, an order of numbers, and a frame.
    CHECK(run("rates -f quat 1 0 0 0 2 -4 6") == done("0 1 -2 3\n"));
    CHECK(run("rates -f quat:xyzw 0 0 0 1 2 -4 6") == done("1 -2 3 0\n"));
    CHECK(run("rates -f rotvec 0 0 0 2 -4 6") == done("2 -4 6\n"));
    CHECK(run("rates -f cayley 0 0 0 2 -4 6") == done("1 -2 3\n"));
    CHECK(run("rates -f mrp 0 0 0 2 -4 6") == done("0.5 -1 1.5\n"));
    CHECK(run("rates -f dcm 1 0 0 0 1 0 0 0 1 2 -4 6") == done("0 -6 -4 6 0 -2 4 2 0\n"));
    CHECK(run("rates -f dcm:col 1 0 0 0 1 0 0 0 1 2 -4 6") == done("0 6 4 -6 0 2 -4 -2 0\n"));
    CHECK(run("rates -f dcm:passive 1 0 0 0 1 0 0 0 1 2 -4 6") == done("0 6 4 -6 0 2 -4 -2 0\n"));
    CHECK(run("rates -f 6d 1 0 0 0 1 0 2 -4 6") == done("0 6 4 -6 0 2\n"));
    CHECK(run("rates -f euler:ZYX 0 0 0 2 -4 6") == done("6 -4 2\n"));
    CHECK(run("rates -f rpy 0 0 0 2 -4 6") == done("2 -4 6\n"));
}

TEST_CASE("rates know the frame of the angular velocity") {
    // Catches axes that are taken for each other: after a yaw of 90 degrees the body's x axis is the reference's y.
    check_near(run("rates -f rpy:deg --frame body 0 0 90 1 0 0").out, {180 / std::numbers::pi, 0, 0});
    check_near(run("rates -f rpy:deg --frame reference 0 0 90 0 1 0").out, {180 / std::numbers::pi, 0, 0});
    CHECK(run("rates -f rpy --frame other 0 0 0 0 0 0").exit_code == 2);
}

TEST_CASE("degrees hold for the angles and the angular velocity") {
    // Catches a unit that is changed on one side only.
    CHECK(run("rates -f rpy -d 0 0 30 0 0 90") == done("0 0 90\n"));
    CHECK(run("rates -f rpy -d --inverse 0 0 30 0 0 90") == done("0 0 90\n"));
    check_near(run("rates -f quat -d 1 0 0 0 0 0 180").out, {0, 0, 0, std::numbers::pi / 2});
    check_near(run("rates -f rpy:deg 0 0 30 0 0 1").out, {0, 0, 180 / std::numbers::pi});
}

TEST_CASE("the inverse of the rates is the angular velocity") {
    // Catches an inverse of another map, for each set.
    const std::string attitude = "0.5 0.1 -0.7 0.2";
    for (const std::string set : {"dcm", "6d", "5d", "quat", "rotvec", "euler:ZYX", "euler:zxz", "rpy", "cayley", "mrp",
                                  "quat:xyzw:passive", "rotvec:deg", "dcm:col:passive"}) {
        INFO(set);
        for (const std::string frame : {"body", "reference"}) {
            const auto numbers = run("-f quat --diagnostics off --tolerance 1 -t " + set + " " + attitude).out;
            const auto forward = run("rates -f " + set + " --frame " + frame + " " + numbers + " 0.3 -0.2 0.9");
            REQUIRE(forward.exit_code == 0);
            const auto back =
                run("rates --inverse -f " + set + " --frame " + frame + " " + numbers + " " + forward.out);
            const auto velocity = numbers_of(back.out);
            REQUIRE(velocity.size() == 3);
            CHECK(velocity[0] == Approx(0.3).epsilon(1e-14));
            CHECK(velocity[1] == Approx(-0.2).epsilon(1e-14));
            CHECK(velocity[2] == Approx(0.9).epsilon(1e-14));
        }
    }
}

TEST_CASE("rates at a singularity are a row error that names it") {
    // Catches numbers where there are none.
    const std::string rows = "0,0,0,0,0,1\n0,90,0,0,0,1\n0,0,0,0,0,1\n";
    CHECK(run("rates -f rpy -d", rows) == stopped("0,0,1\n", {"rotconv: -:2: ", "gimbal lock", "'0,90,0,0,0,1'"}));
    CHECK(run("rates -f rpy -d --on-error nan", rows) == went_on("0,0,1\nnan,nan,nan\n0,0,1\n"));
    CHECK(run("rates -f rpy -d --on-error skip", rows) == went_on("0,0,1\n0,0,1\n"));
    CHECK(run("rates -f euler:ZXZ 0 0 0 0 0 1").exit_code == 2);
}

TEST_CASE("rows of rates that are none are row errors") {
    // Catches messages that count the numbers of an attitude.
    CHECK(run("rates -f quat", "1,0,0,0,0,0\n") ==
          stopped(any_output, {"rotconv: -:1: 6 fields where quat with wx wy wz has 7"}));
    CHECK(run("rates -f quat", "1,0,0,0,0,0,x\n").exit_code == 2);
    CHECK(run("rates -f quat", "1,0,0,0,0,0,nan\n").exit_code == 2);
    CHECK(run("rates -f quat", "0,0,0,0,0,0,1\n").exit_code == 2);
    CHECK(run("rates -f quat", "1.01,0,0,0,0,0,1\n").exit_code == 2);
    CHECK(run("rates -f quat --tolerance 1", "1.01,0,0,0,0,0,2\n").exit_code == 0);
}

TEST_CASE("wrong uses of rates are usage errors") {
    // Catches a set without rates, and options of other commands.
    check_usage_errors({"rates", "rates -f axis-angle", "rates -f quat -t dcm", "rates -f quat --columns 1-4",
                        "rates -f quat x", "rates -f quat --lock-margin 1", "rates -f nothing"},
                       "1 0 0 0 0 0 1\n");
    CHECK(missing(run("rates -f axis-angle").err, {"axis-angle", "rotvec"}) == "");
    CHECK(missing(run("rates --help").out, {"rotconv rates -f SPEC", "--inverse", "--frame", "--columns"}) == "");
}

TEST_CASE("a rotation vector has no rates at a full turn, and is told so") {
    // Catches a full turn that is called a half-turn, and one that is passed over.
    for (const std::string degrees : {"360", "1800", "36000"}) {
        CHECK(run("rates -f rotvec:deg 0 0 " + degrees + " 0 1 0") == stopped(any_output, {"rotvec", "full turn"}));
    }
}
