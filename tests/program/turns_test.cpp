// --left and --right: attitudes turned by constant ones.

#include <string>

#include <catch.hpp>

#include "process.hpp"

using namespace program;

namespace {

const std::string to_enu = "quat: 0 0.7071067811865476 0.7071067811865476 0"; // north, east, down to east, north, up
const std::string to_flu = "rpy:deg: 180 0 0";                                // forward, right, down to left and up

/// Rows of roll, pitch and yaw in degrees of a body with axes forward, right, down over north, east, down.
Result from_ned(const std::string& to, const std::string& rows, Words more = {}) {
    Words words{"-f", "rpy:deg", "-t", to, "--left", to_enu, "--right", to_flu};
    words.insert(words.end(), more.begin(), more.end());
    return run(words, rows);
}

} // namespace

TEST_CASE("north, east, down becomes east, north, up") {
    // Catches the two sides exchanged, and a turn that is inverted. By hand: yaw counts from east and the other way,
    // pitch about the axis to the left, roll is the same.
    CHECK(from_ned("rpy:deg", "0 0 0\n0 0 90\n0 0 180\n0 0 -90\n") == done("0 0 90\n0 0 0\n0 0 -90\n0 0 180\n"));
    CHECK(from_ned("rpy:deg", "10 20 30\n-10 -20 30\n", {"-p", "12"}) == done("10 -20 60\n-10 20 60\n"));
    // level to the north: forward is north, left is west, up is up
    CHECK(from_ned("dcm", "0 0 0\n") == done("0 -1 0 1 0 0 0 0 1\n"));
    CHECK(from_ned("dcm:passive", "0 0 0\n") == done("0 1 0 -1 0 0 0 0 1\n"));
    CHECK(from_ned("quat:xyzw", "0 0 90\n") == done("0 0 0 1\n"));
}

TEST_CASE("propagate and published methods turn attitudes too") {
    // Catches an option that one of them ignores.
    CHECK(run(Words{"propagate", "-t", "rpy", "-d", "-p", "12", "--left", to_enu, "--right", to_flu},
              "0 0 0 30\n1 0 0 30\n") == done("0 0 0 90\n1 0 0 60\n"));
    for (const std::string from : {"quat", "quat:passive", "quat:xyzw"}) {
        for (const std::string to : {"dcm", "dcm:passive", "dcm:col"}) {
            const Words words{"-f", from, "-t", to, "-p", "12", "--left", to_enu, "--right", "rotvec: 0.1 0.2 0.3"};
            Words method = words;
            method.insert(method.end(), {"--method", "unit"});
            const std::string rows = "0.5 0.5 0.5 0.5\n0.8 0 0.6 0\n0 0.6 0 -0.8\n";
            INFO(from << " " << to);
            CHECK(run(method, rows) == run(words, rows));
        }
    }
}

TEST_CASE("a turn that is none is a usage error that names its option") {
    // Catches a message of --initial, and a turn of a wrong attitude.
    for (const std::string option : {"--left", "--right"}) {
        for (const std::string wrong : {"1 0 0 0", "quat", "quat: 1 0 0", "quat: 1 0 0 x", "quat: 0 0 0 0",
                                        "quat: 2 0 0 0", "kwat: 1 0 0 0", "quat: 1e999 0 0 0", "euler: 1 0 0"}) {
            INFO(wrong);
            CHECK(run(Words{"-f", "quat", "-t", "rpy", option, wrong, "1", "0", "0", "0"}) ==
                  stopped("", {"rotconv: " + option}));
        }
    }
    CHECK(run(Words{"-f", "quat", "-t", "rpy:deg", "--left", "quat: 2 0 0 0", "--tolerance", "inf", "1", "0", "0",
                    "0"}) == done("0 0 0\n"));
    for (const std::string command : {"rates", "survey"}) {
        CHECK(run(Words{command, "-f", "quat", "--left", "quat: 1 0 0 0"}, "1 0 0 0 0 0 1\n") ==
              stopped(any_output, {"'--left' is not a known option"}));
    }
}
