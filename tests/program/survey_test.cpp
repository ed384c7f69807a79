#include <catch.hpp>

#include "process.hpp"

using namespace program;

namespace {

/// Yaw, pitch and roll in degrees, a row each: yaw from `first` in steps.
std::string yawing(int first, int step, int count) {
    std::string rows;
    for (int i = 0; i < count; ++i) {
        rows += std::to_string(first + i * step) + " 10 5\n";
    }
    return rows;
}

/// The line of a set in the table.
Words line_of(const std::string& table, const std::string& set) {
    for (const auto& line : fields_of(table, '\n')) {
        if (line.starts_with(set + " ")) {
            return words_of(line);
        }
    }
    return {};
}

} // namespace

// Catches a last line that is no SPEC.
TEST_CASE("survey names a set of three numbers for a gentle motion") {
    const auto result = run("survey -f euler:ZYX:deg", yawing(0, 1, 60));
    CHECK(result.exit_code == 0);
    CHECK(result.err == "");
    CHECK(last_line(result.out) == "mrp");
    CHECK(run("-f quat -t " + last_line(result.out) + " 1 0 0 0").exit_code == 0);
}

// Catches lines that are counted without comments, and sets that are left out.
TEST_CASE("survey has a line for each set with what was met and where") {
    const auto result = run("survey -f euler:ZYX -d", "# yaw pitch roll\n\n" + yawing(90, 1, 720));
    CHECK(result.exit_code == 0);
    CHECK(last_line(result.out) == "quat");
    // yaw 180 is line 93, and is printed as 180; the wrap is the line after; pitch 10 is 80 degrees off lock
    const auto zyx = line_of(result.out, "euler:ZYX");
    REQUIRE(zyx.size() == 9);
    CHECK(zyx[1] == "3");
    CHECK(zyx[2] == "1.39626");
    CHECK(zyx[6] == "2");
    CHECK(zyx[7] == "94");
    CHECK(zyx[8] == "no");
    CHECK(line_of(result.out, "dcm") == Words{"dcm", "9", "inf", "3", "1.41421", "3", "0", "-", "yes"});
    CHECK(missing(result.out, {"6d", "5d", "axis-angle", "rotvec", "cayley", "mrp", "euler:XYX", "720 attitudes"}) ==
          "");
    CHECK(line_of(result.out, "rotvec").back() == "no");
    CHECK(line_of(result.out, "5d").back() == "yes");
}

// Catches a limit that changes nothing.
TEST_CASE("the condition that serves is an option") {
    const std::string rows = yawing(0, 1, 170);
    CHECK(line_of(run("survey -f euler:ZYX:deg", rows).out, "cayley").back() == "yes");
    CHECK(line_of(run("survey -f euler:ZYX:deg --condition 10", rows).out, "cayley").back() == "no");
    const auto none = run("survey -f euler:ZYX:deg --condition 0.1", rows);
    CHECK(none.exit_code == 1);
    CHECK(last_line(none.out) == "none");
    CHECK(run("survey -f quat --condition x", "1 0 0 0\n").exit_code == 2);
    CHECK(run("survey -f quat --condition -1", "1 0 0 0\n").exit_code == 2);
}

// Catches a limit of inf that lets numbers through that are infinite or not determined.
TEST_CASE("a set of infinite condition serves under no limit") {
    for (const std::string limit : {"inf", "1e308"}) {
        const auto half_turn = run("survey -f quat --condition " + limit, "0 1 0 0\n");
        CHECK(half_turn.exit_code == 0);
        CHECK(last_line(half_turn.out) == "mrp");
        for (const std::string set : {"cayley", "euler:XYX", "euler:ZXZ"}) {
            CHECK(line_of(half_turn.out, set).at(4) == "inf");
            CHECK(line_of(half_turn.out, set).back() == "no");
        }
        CHECK(line_of(half_turn.out, "axis-angle").back() == "yes");
        CHECK(line_of(run("survey -f quat --condition " + limit, "1 0 0 0\n").out, "axis-angle").back() == "no");
        const auto json = run("survey -f quat --format json --condition " + limit, "0 1 0 0\n").out;
        for (const auto& line : fields_of(json, '\n')) {
            CHECK((line.find("\"condition\": \"inf\"") == std::string::npos || line.ends_with("\"serves\": false}")));
        }
    }
}

// Catches numbers that no JSON reader takes, and a last line that is none.
TEST_CASE("survey speaks JSON") {
    const auto result = run("survey -f quat --format json", "1 0 0 0\n1 0 0 0\n");
    CHECK(result.exit_code == 0);
    CHECK(result.err == "");
    auto lines = fields_of(result.out, '\n');
    lines.pop_back(); // the answer
    CHECK(lines.size() >= 20);
    for (const auto& line : lines) {
        CHECK((line.starts_with("{\"set\": ") && line.ends_with("}")));
    }
    CHECK(last_line(result.out) == R"({"rows": 2, "smallest": "mrp"})");
    CHECK(
        missing(result.out, {R"({"set": "quat", "parameters": 4, "margin": "inf", "margin_line": 1, "condition": 0.5, )"
                             R"("condition_line": 1, "jumps": 0, "jump_line": null, "serves": true})"}) == "");
    CHECK(missing(result.out, {R"({"set": "axis-angle", "parameters": 4, "margin": 0, )", R"("condition": "inf")"}) ==
          "");
}

// Catches an input of its own.
TEST_CASE("survey takes columns, headers and bad rows as a conversion does") {
    const std::string good = "t,qx,qy,qz,qw\n0,0,0,0,1\n1,0,0,0.6,0.8\n";
    CHECK(last_line(run("survey -f quat:xyzw --columns qx,qy,qz,qw", good).out) == "mrp");
    const std::string bad = good + "2,0,0,zero,1\n3,0,0,0,0\n4,0,0,0.8,0.6\n";
    CHECK(run("survey -f quat:xyzw --columns 2-5", bad) == stopped("", {"rotconv: -:4: not a number: 'zero'"}));
    for (const std::string policy : {"skip", "nan"}) {
        const auto skipped = run("survey -f quat:xyzw --columns 2-5 --on-error " + policy, bad);
        CHECK(skipped.exit_code == 1);
        CHECK(last_line(skipped.out) == "mrp");
        CHECK(missing(skipped.out, {"3 attitudes"}) == "");
        CHECK(missing(skipped.err, {"-:4: ", "-:5: "}) == "");
        CHECK(line_of(skipped.out, "rotvec")[3] == "6");
    }
}

// Catches a set that serves no attitude at all.
TEST_CASE("survey of nothing names no set") {
    for (const char* input : {"", "# comment\n", "\n"}) {
        CHECK(run("survey -f quat", input) == went_on("none\n", {"there was no row with an attitude"}));
        CHECK(run("survey -f quat --format json", input).out == "{\"rows\": 0, \"smallest\": \"none\"}\n");
    }
}
