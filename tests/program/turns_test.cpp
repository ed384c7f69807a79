// --left and --right: attitudes turned by constant ones.

#include <string>

#include <catch.hpp>

#include "process.hpp"

using namespace program;

namespace {

const std::string to_enu = "quat: 0 0.7071067811865476 0.7071067811865476 0"; // north, east, down to east, north, up

} // namespace

TEST_CASE("published methods turn attitudes too") {
    // Catches an option that a method ignores, on either side.
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
