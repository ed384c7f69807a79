#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <utility>

#include <catch.hpp>

#include "process.hpp"

using namespace program;

namespace {

/// Yaw of the last row, of rows t,roll,pitch,yaw.
double last_yaw(const std::string& rows) { return std::stod(rows.substr(rows.rfind(',') + 1)); }

} // namespace

// Catches a start that is ignored or of another convention.
TEST_CASE("propagate starts from the initial attitude") {
    CHECK(run(Words{"propagate", "-t", "quat", "--initial", "quat: 0 1 0 0"}, "7,0,0,0\n") == done("7,0,1,0,0\n"));
    CHECK(run(Words{"propagate", "-t", "quat", "--initial", "quat:xyzw: 1,0,0,0"}, "7,0,0,0\n") == done("7,0,1,0,0\n"));
    const auto result =
        run(Words{"propagate", "-t", "rpy", "-d", "-p", "12", "--initial", "rpy: 0 0 10"}, "0,0,0,30\n1,0,0,30\n");
    CHECK(result == done("0,0,0,10\n1,0,0,40\n"));
}

// Catches a set that is integrated wrongly and a chart that is left in silence.
TEST_CASE("every set and every integrator carries a spin") {
    std::string rows;
    for (int i = 0; i <= 400; ++i) {
        rows += std::to_string(i) + "e-2,0,0,1\n"; // 4 radians, through the half-turn
    }
    const double expected = 4.0 - 2.0 * std::numbers::pi;
    for (const std::string with : {"quat", "dcm", "6d", "5d", "rotvec", "mrp", "euler:ZYX", "rpy"}) {
        INFO(with);
        const auto result = run("propagate -t rpy --with " + with, rows);
        CHECK(result.exit_code == 0);
        CHECK(result.err == "");
        CHECK(std::fabs(last_yaw(result.out) - expected) < 1e-8); // of fourth order at least
    }
    for (const std::string integrator : {"rk4", "magnus4", "magnus6"}) {
        INFO(integrator);
        const auto result = run("propagate -t rpy --integrator " + integrator, rows);
        CHECK(result.exit_code == 0);
        CHECK(std::fabs(last_yaw(result.out) - expected) < 1e-9);
    }
    const auto cayley = run("propagate -t rpy --with cayley", rows);
    CHECK(cayley.exit_code == 2);
    CHECK(missing(cayley.err, {"rotconv: -:", "cayley", "half-turn"}) == "");
    CHECK(count_rows(cayley.out) > 290);
    CHECK(count_rows(cayley.out) < 316); // 3.14 seconds
}

// Catches attitudes from rates that say nothing of the motion between them.
TEST_CASE("a step in which the body may turn by more than half a turn is an error with every set") {
    const std::string rows = "0,1,0,0\n4,0,1,0\n8,0,0,1\n";
    for (const std::string more : {"", " --integrator magnus6", " --integrator rk4", " --with dcm", " --with 6d",
                                   " --with 5d", " --with mrp", " --interpolation cubic"}) {
        INFO(more);
        CHECK(run("propagate -t quat --tolerance inf" + more, rows) ==
              stopped("0,1,0,0,0\n", {"rotconv: -:2: ", "turn by more", "--substeps", "--time-unit", "'4,0,1,0'"}));
        CHECK(run("propagate -t quat --tolerance inf --on-error nan" + more, rows) ==
              went_on("0,1,0,0,0\n4,nan,nan,nan,nan\n8,nan,nan,nan,nan\n"));
        CHECK(run("propagate -t quat --substeps 8 --tolerance inf" + more, rows).exit_code == 0);
    }
    // the greatest rate is that at the end; half a turn is not more than half a turn
    CHECK(run("propagate -t quat -d", "0 0 0 0\n1 0 0 181\n").exit_code == 2);
    CHECK(run("propagate -t quat -d", "0 0 0 180\n1 0 0 180\n").exit_code == 0);
    // a step that no double holds, of a body that turns or rests
    for (const std::string rate : {"1", "0"}) {
        CHECK(run("propagate -t quat", "-1e308 0 0 " + rate + "\n1e308 0 0 " + rate + "\n") ==
              stopped(any_output, {"rotconv: -:2: ", "turn by more"}));
    }
}

// Catches an attitude that is off in silence. At 2 rad/s for 1 s the classical method turns a quaternion by
// atan((a - a^3/6)/(1 - a^2/2 + a^4/24)) with a = 1 for each half angle: 1 - 0.99523 = 0.0077 of a radian off.
TEST_CASE("coarse steps are reported with an estimate of their error") {
    const std::string rows = "0,0,0,2\n1,0,0,2\n1.01,0,0,2\n";
    const std::string propagate = "propagate -t rotvec --integrator rk4 --tolerance 0.1";
    const double off = 2.0 * std::fabs(1.0 - std::atan2(5.0 / 6.0, 13.0 / 24.0));
    const auto told = run(propagate + " --diagnostics rows", rows);
    CHECK(told.exit_code == 0);
    const std::string line = "rotconv: -:2: coarse-step: estimate ";
    CHECK(missing(told.err, {line, "--substeps"}) == "");
    CHECK(told.err.find("-:1: coarse") == std::string::npos);
    CHECK(told.err.find("-:3: coarse") == std::string::npos);
    CHECK(std::stod(told.err.substr(told.err.find(line) + line.size())) == Approx(off).epsilon(0.1));
    CHECK(missing(run(propagate, rows).err, {"rotconv: -: coarse-step: 1 row, first at line 2; "}) == "");
    CHECK(missing(run(propagate + " --diagnostics columns", rows).out, {"+coarse-step\n"}) == "");
    CHECK(run(propagate + " --strict --diagnostics off", rows).exit_code == 1);
    CHECK(run(propagate + " --strict --diagnostics off --substeps 2", rows).exit_code == 0);
    // about one axis exponential steps are exact, at any length
    CHECK(run("propagate -t rotvec -p 6 --strict", "0,0,0,3\n1,0,0,3\n") == done("0,0,0,0\n1,0,0,3\n"));
    CHECK(run("propagate -t rotvec --strict", "0,1.5,0,0\n1,0,1.5,0\n").exit_code == 1);
    CHECK(run("propagate -t rotvec --strict", "0,1.5,0,0\n1,0,1.5,0\n").out != "");
}

// Catches times that are rounded to doubles: 200 ns apart they are the same, or off by half.
TEST_CASE("time differences are those of the decimals as they are written") {
    std::string nanoseconds;
    std::string seconds;
    for (int i = 0; i < 5; ++i) {
        nanoseconds += "140371552490714316" + std::to_string(i) + " 0 0 1e8\n";
        seconds += "1403715524.90714316" + std::to_string(i) + "00000000000000000000000001 0 0 1e8\n";
    }
    for (const std::string more : {"", " --interpolation cubic"}) {
        INFO(more);
        const auto fast = run("propagate -t rotvec -p 12 --diagnostics off --time-unit ns" + more, nanoseconds);
        CHECK(fast.exit_code == 0);
        CHECK(fast.err == "");
        CHECK(missing(fast.out, {"1403715524907143160 0 0 0\n", "1403715524907143161 0 0 0.1\n",
                                 "1403715524907143164 0 0 0.4\n"}) == "");
        const auto same = run("propagate -t rotvec -p 12 --diagnostics off" + more, seconds);
        CHECK(same.err == "");
        CHECK(missing(same.out, {"0000001 0 0 0\n", "0000001 0 0 0.1\n", "0000001 0 0 0.4\n"}) == "");
    }
    CHECK(last_yaw(run("propagate -t rotvec", "1305031098.6659,0,0,1\n1305031098.6758,0,0,1\n").out) == 0.0099);
    // as long as it is: the order too
    const std::string zeros(1000, '0');
    CHECK(run("propagate -t quat", "1." + zeros + "1,0,0,1\n1." + zeros + "1,0,0,1\n").exit_code == 2);
    CHECK(run("propagate -t quat", "0.3,0,0,1\n0.29999999999999999999999,0,0,1\n").exit_code == 2);
    // quoted and with blanks; a row that is refused is not the one before
    const auto mixed = run("propagate -t rotvec -p 12 --header no --time-unit ns --on-error skip",
                           "\"1403715524907143160\",0,0,1e8\n +1403715524907143161,0,0,1e8\n1403715524907143160,0,0,"
                           "1e8\n1403715524907143169,0,0,inf\n1.403715524907143162e18,0,0,1e8\n");
    CHECK(mixed.out ==
          "\"1403715524907143160\",0,0,0\n +1403715524907143161,0,0,0.1\n1.403715524907143162e18,0,0,0.2\n");
}

// Catches a unit that is off by a power, and doubles that have none.
TEST_CASE("the unit of the times") {
    for (const auto& [unit, step] : {std::pair{"s", "0.25"}, {"ms", "250"}, {"us", "25e4"}, {"ns", "250000000"}}) {
        INFO(unit);
        const std::string rows = std::string("0 0 0 1\n") + step + " 0 0 1\n";
        CHECK(words_of(run(std::string("propagate -t rotvec -p 15 --time-unit ") + unit, rows).out).back() == "0.25");
    }
    CHECK(run("propagate -t quat --time-unit h", "0,0,0,1\n") ==
          stopped(any_output, {"'h' is not a known time unit (legal: s ms us ns)"}));
    CHECK(missing(run("propagate --help").out, {"--time-unit"}) == "");
}

// Catches nanoseconds that are taken for seconds in silence. The biases are slow rates, each row 5 ms on.
TEST_CASE("nanoseconds of EuRoC") {
    std::ifstream file(std::string(ROTCONV_DATA) + "/euroc.csv");
    std::ostringstream table;
    table << file.rdbuf();
    REQUIRE(table.str().size() > 1000);
    const std::string columns = " --columns 1,12-14 -p 6 --strict";
    CHECK(run("propagate -t rotvec" + columns, table.str()) == stopped(any_output, {"turn by more", "--time-unit"}));
    for (const std::string more : {"", " --interpolation cubic", " --with mrp", " --with dcm", " --with euler:ZYX"}) {
        const auto result = run("propagate -t rotvec --time-unit ns" + columns + more, table.str());
        CHECK(result.exit_code == 0);
        CHECK(result.err == "");
    }
}

// Catches attitudes that nothing bears out.
TEST_CASE("Euler angles fail at lock by name and row") {
    std::string rows;
    for (int i = 0; i <= 300; ++i) {
        rows += std::to_string(i) + "e-2 0 1 0\n";
    }
    CHECK(run("propagate -t quat --with euler:ZYX", rows) ==
          stopped(any_output, {"euler", "gimbal lock", "rotconv: -:15"}));
    const auto kept = run("propagate -t quat --with euler:ZYX --on-error nan", rows);
    CHECK(kept.exit_code == 1);
    CHECK(count_rows(kept.out) == 301);
    CHECK(kept.out.ends_with("\n300e-2 nan nan nan nan\n"));
    CHECK(run("propagate -t quat --with euler:YXZ", rows).exit_code == 0);
}

// Catches a step back that is taken, and a row that loses its place.
TEST_CASE("times must increase") {
    const std::string rows = "0,0,0,1\n1,0,0,1\n1,0,0,1\n0.5,0,0,1\n2,0,0,1\n";
    for (const std::string interpolation : {"linear", "cubic"}) {
        INFO(interpolation);
        const std::string propagate = "propagate -t rotvec -p 6 --interpolation " + interpolation;
        CHECK(run(propagate, rows) == stopped("0,0,0,0\n1,0,0,1\n", {"rotconv: -:3: ", "time", "'1,0,0,1'"}));
        CHECK(run(propagate + " --on-error nan", rows) ==
              went_on("0,0,0,0\n1,0,0,1\n1,nan,nan,nan\n0.5,nan,nan,nan\n2,0,0,2\n", {"-:3: ", "-:4: "}));
        const auto skipped = run(propagate + " --on-error skip", rows);
        CHECK(skipped.out == "0,0,0,0\n1,0,0,1\n2,0,0,2\n");
    }
}

// Catches numbers of a bad row that are integrated.
TEST_CASE("bad rows of propagate") {
    const std::string rows = "0,0,0,1\nx,0,0,1\n1,0,zero,1\n1,0,0\n1,0,0,nan\n2,0,0,1\n";
    for (const std::string interpolation : {"linear", "cubic"}) {
        const std::string propagate = "propagate -t rotvec -p 6 --header no --interpolation " + interpolation;
        CHECK(run(propagate, rows) == stopped("0,0,0,0\n", {"rotconv: -:2: not a number: 'x'"}));
        const auto skipped = run(propagate + " --on-error skip", rows);
        CHECK(skipped.exit_code == 1);
        CHECK(skipped.out == "0,0,0,0\n2,0,0,2\n");
        CHECK(count_rows(skipped.err) == 4);
    }
    CHECK(missing(run("propagate -t quat", "0,0,0\n").err, {"3 fields where t wx wy wz has 4"}) == "");
}

// Catches an answer that waits.
TEST_CASE("with linear interpolation a row is answered before the next one is sent") {
    Process process(words_of("propagate -t rotvec -p 6"));
    process.write("0 0 0 1\n");
    CHECK(process.read_rows(1) == "0 0 0 0\n");
    process.write("1 0 0 1\n");
    CHECK(process.read_rows(1) == "1 0 0 1\n");
    CHECK(process.finish() == done(""));
}

// Catches rows, comments and line numbers that get lost on the way.
TEST_CASE("with cubic interpolation a row is answered when the next one is there") {
    Process process(words_of("propagate -t rotvec -p 6 --interpolation cubic --on-error nan"));
    process.write("0 0 0 1\n# one\n");
    process.wait_until_read();
    process.write("1 0 0 1\n");
    CHECK(process.read_rows(2) == "0 0 0 0\n# one\n");
    process.write("\nbad 0 0 1\n");
    process.wait_until_read();
    process.write("2 0 0 1\n");
    CHECK(process.read_rows(3) == "1 0 0 1\n\nbad nan nan nan\n");
    CHECK(process.finish() == went_on("2 0 0 2\n", {"rotconv: -:5: not a number: 'bad'"}));
}

// Catches a parabola or a line between the rows: w = t^2 gives t^3/3.
TEST_CASE("a cubic follows a rate that is one exactly") {
    std::string rows;
    for (int i = 0; i <= 200; ++i) {
        const double t = i / 100.0;
        rows += std::to_string(t) + ",0,0," + std::to_string(t * t) + "\n";
    }
    CHECK(std::fabs(last_yaw(run("propagate -t rotvec --interpolation cubic", rows).out) - 8.0 / 3.0) < 1e-12);
    const double linear = last_yaw(run("propagate -t rotvec", rows).out) - 8.0 / 3.0;
    CHECK(linear == Approx(200 * 2.0 / 12.0 * 1e-6).epsilon(1e-6)); // h^3 w''/12 a row
}

// Catches state that is lost between reads.
TEST_CASE("propagate in long batches is the same as in pieces") {
    std::string rows;
    for (int i = 0; i < 1000; ++i) {
        rows += std::to_string(i) + "e-2 0.3 " + std::to_string(i % 7) + " -0.2\n" + (i % 50 == 0 ? "# note\n" : "");
    }
    for (const std::string interpolation : {"linear", "cubic"}) {
        const std::string arguments = "propagate -t quat --interpolation " + interpolation;
        const auto whole = run(arguments, rows);
        CHECK(whole.exit_code == 0);
        CHECK(count_rows(whole.out) == 1020);
        CHECK(run_in_pieces(arguments, rows, 997) == whole);
    }
}

// Catches an option without effect: the defect is the third of the diagnostic columns.
TEST_CASE("renormalising keeps a matrix on its set") {
    std::string rows;
    for (int i = 0; i <= 300; ++i) {
        rows += std::to_string(i) + "e-1 1 -2 0.5\n";
    }
    const auto defect = [&rows](const std::string& more) {
        const auto out = run("propagate -t quat --with dcm --diagnostics columns " + more, rows).out;
        const auto words = words_of(out.substr(out.rfind("300e-1")));
        return words.size() == 9 ? std::stod(words[7]) : -1.0;
    };
    CHECK(defect("") > 1e-6);
    CHECK(defect("--renormalise") < 1e-14);
    CHECK(defect("--renormalise") >= 0.0);
    CHECK(missing(run("propagate -t quat --with dcm", rows).err, {"normalized: "}) == "");
}

// Catches an option without effect.
TEST_CASE("substeps make the steps shorter") {
    const std::string rows = "0 0 0 1\n1 0 0 1\n";
    const auto error = [&rows](const std::string& more) {
        return std::fabs(std::stod(words_of(run("propagate -t rotvec --with dcm " + more, rows).out).back()) - 1.0);
    };
    CHECK(error("") > 1e-4);
    CHECK(error("--substeps 10") < 1e-6);
    CHECK(run("propagate -t quat --substeps 0", rows).exit_code == 2);
    CHECK(run("propagate -t quat --substeps 1.5", rows).exit_code == 2);
}

// Catches memory, or time, that grows with a clock that stepped back, or with comments.
TEST_CASE("rows that are refused do not keep the one before them waiting for ever") {
    for (const std::string row : {"0 0 0 1e-3\n", "# nothing\n"}) {
        Process process(words_of("propagate -t quat --interpolation cubic --on-error skip --diagnostics off"));
        const long before = process.peak_memory_after("5 0 0 1e-3\n6 0 0 1e-3\n" + repeated(row, 30000));
        process.write(repeated(row, 60000));
        CHECK((process.peak_memory_after("7 0 0 1e-3\n8 0 0 1e-3\n") <= before + 512 || is_sanitized));
        const auto result = process.finish();
        CHECK(count_rows(result.out) == (row[0] == '#' ? 90004 : 4));
        CHECK(result.out.substr(result.out.find("\n8 ") + 1, 2) == "8 ");
    }
}

// Catches an answer that is given early because of a block's border.
TEST_CASE("cubic answers do not depend on how the rows arrive") {
    const std::string rows = "0 0 0 0.1\n1 0 0 0.2\n" + repeated("0 0 0 9\n", 9000) + // 72 kB that are refused
                             "2 0 0 0.5\n" + repeated("0 0 0 9\n", 2000) + "3 0 0 0.4\n4 0 0 -0.3\n";
    const std::string command = "propagate -t quat --interpolation cubic --on-error skip --diagnostics off";
    const auto at_once = run(command, rows);
    CHECK(count_rows(at_once.out) == 5);
    CHECK(run_in_pieces(command, rows, 5000) == at_once);
}

// Catches an interpolation of lower order, and a table that is no longer true.
TEST_CASE("sampled coning is off by what the manual says") {
    const double theta = 10.0 * std::numbers::pi / 180.0;
    const double turn_rate = 2.0 * std::numbers::pi;
    const auto error = [&](const std::string& interpolation, int frequency) {
        std::ostringstream rows;
        rows.precision(17);
        for (int i = 0; i <= 60 * frequency; ++i) {
            const double t = static_cast<double>(i) / frequency;
            rows << t << ' ' << -turn_rate * std::sin(theta) * std::sin(turn_rate * t) << ' '
                 << turn_rate * std::sin(theta) * std::cos(turn_rate * t) << ' '
                 << -2.0 * turn_rate * std::pow(std::sin(theta / 2), 2) << '\n';
        }
        const auto result = run(Words{"propagate", "-t", "quat", "--diagnostics", "off", "--interpolation",
                                      interpolation, "--initial", "rotvec:deg: 10 0 0"},
                                rows.str());
        std::istringstream answers(result.out);
        double worst = 0.0;
        for (double t = 0, w = 0, x = 0, y = 0, z = 0; answers >> t >> w >> x >> y >> z;) {
            const double c = std::cos(theta / 2);
            const double s = std::sin(theta / 2);
            const double ex = s * std::cos(turn_rate * t);
            const double ey = s * std::sin(turn_rate * t);
            // the vector part of conj(exact) q
            const double dx = c * x - ex * w - ey * z;
            const double dy = c * y - ey * w + ex * z;
            const double dz = c * z - ex * y + ey * x;
            worst = std::max(worst, 2.0 * std::sqrt(dx * dx + dy * dy + dz * dz));
        }
        return worst;
    };
    CHECK(error("linear", 100) == Approx(3.7e-3).epsilon(0.02));
    CHECK(error("linear", 1000) == Approx(3.7e-5).epsilon(0.02));
    CHECK(error("cubic", 100) == Approx(2.8e-6).epsilon(0.02));
    CHECK(error("cubic", 1000) == Approx(2.8e-10).epsilon(0.02));
}
