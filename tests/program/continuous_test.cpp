// --continuous: numbers that follow the motion, in the order of the stream.

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <string_view>

#include <catch.hpp>
#include <fmt/format.h>

#include "process.hpp"

using namespace program;

namespace {

/// Rows of a quaternion that turns about a moving axis by up to 0.2 a row, with comments and, among them, bad rows.
std::string moving_rows(std::size_t count, bool bad) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        const double a = 0.11 * static_cast<double>(i);
        const double b = 0.037 * static_cast<double>(i) + 0.3;
        // turns about z by 2 a and then about y by 2 b
        const double q[4] = {std::cos(a) * std::cos(b), -std::sin(a) * std::sin(b), std::cos(a) * std::sin(b),
                             std::sin(a) * std::cos(b)};
        const double sign = i % 3 == 0 ? -1.0 : 1.0;
        if (i % 50 == 7) {
            text += "# a comment\n";
        }
        if (bad && i % 40 == 11) {
            text += i % 80 == 11 ? "0 0 0 0\n" : "1 0 zero 0\n";
        }
        for (int k = 0; k < 4; ++k) {
            text += std::to_string(sign * q[k]) + (k < 3 ? ' ' : '\n');
        }
    }
    return text;
}

const std::string past_a_half_turn = "0 0 170\n0 0 -170\n0 0 -100\n0 0 0\n0 0 100\n0 0 -160\n0 0 -70\n0 0 20\n0 0 110\n"
                                     "0 0 -160\n0 0 -80\n";

} // namespace

// Catches a format that writes the numbers before the choice.
TEST_CASE("yaw runs past 180 degrees to 1000, in every format") {
    const std::string yaws[] = {"170", "190", "260", "360", "460", "560", "650", "740", "830", "920", "1000"};
    std::string plain;
    std::string appended;
    std::string json;
    std::string selected;
    std::string in;
    std::vector<double> doubles;
    std::size_t at = 0;
    for (std::size_t i = 0; i < std::size(yaws); ++i) {
        const std::string row = past_a_half_turn.substr(at, past_a_half_turn.find('\n', at) - at);
        at += row.size() + 1;
        plain += "0 0 " + yaws[i] + "\n";
        appended += row + " 0 0 " + yaws[i] + "\n";
        json += R"({"roll": 0, "pitch": 0, "yaw": )" + yaws[i] + "}\n";
        in += "x " + row + " y\n";
        selected += "x 0 0 " + yaws[i] + " y\n";
        doubles.insert(doubles.end(), {0.0, 0.0, std::stod(yaws[i])});
    }
    const std::string command = "-f rpy:deg -t rpy:deg --continuous ";
    CHECK(run(command, past_a_half_turn) == done(plain));
    CHECK(run(command + "-p 6", past_a_half_turn) == done(plain));
    CHECK(run(command + "--append", past_a_half_turn) == done(appended));
    CHECK(run(command + "--format json", past_a_half_turn) == done(json));
    CHECK(run(command + "--columns 2-4", in) == done(selected));
    CHECK(run(command + "--format f64", past_a_half_turn) == done(bytes_of(doubles)));
    CHECK(run(command + "--format f64 --input-format f64", bytes_of(doubles)) == done(bytes_of(doubles)));
    CHECK(run(command + "--input-format f64 --delimiter blank", bytes_of(doubles)) == done(plain));
    CHECK(missing(run(command + "--format pretty", past_a_half_turn).out, {"1000"}) == "");
    CHECK(run("-f rpy:deg -t rpy:deg:passive --continuous -p 12", "0 0 -170\n0 0 170\n0 0 100\n") ==
          done("0 0 170\n0 0 190\n0 0 260\n"));
}

// Catches a result that is rounded, brought near to the last one, and rounded again.
TEST_CASE("numbers of a motion come back as they went in") {
    std::mt19937 engine(63);
    const auto step = [&engine] { return std::uniform_int_distribution(-90, 90)(engine); };
    std::string angles;
    std::string vectors;
    int roll = 0, pitch = 890, yaw = 0, x = 2000, y = -1000, z = 1500;
    for (int i = 0; i < 2000; ++i) {
        angles += fmt::format("{:g} {:g} {:g}\n", roll / 10.0, pitch / 10.0, yaw / 10.0);
        vectors += fmt::format("{:g} {:g} {:g}\n", x / 1000.0, y / 1000.0, z / 1000.0);
        roll = std::clamp(roll + step(), -300, 300);
        pitch = std::clamp(pitch + step(), 910, 1700); // where the canonical numbers are others
        yaw += 60 + step();                            // many turns
        x = std::clamp(x + step(), 1000, 3000);
        y = std::clamp(y + step(), -3000, -1000);
        z = std::clamp(z + step(), 1000, 3000);
    }
    CHECK((run("-f rpy:deg -t rpy:deg --continuous", angles) == done(angles)));
    CHECK((run("-f rotvec -t rotvec --continuous --diagnostics off", vectors) == done(vectors)));
}

// Catches a sign that follows w, and one that is compared in another order.
TEST_CASE("a quaternion does not flip") {
    const std::string rows = "0 0 0.6 0.8\n-0.01 0 0.6 0.8\n0 0 -0.6 -0.8\n0 0 0.6 0.8\n";
    CHECK(run("-f quat -t quat --continuous -p 3 --diagnostics off", rows) ==
          done("0 0 0.6 0.8\n-0.01 0 0.6 0.8\n0 0 0.6 0.8\n0 0 0.6 0.8\n"));
    CHECK(run("-f quat -t quat:xyzw --continuous -p 3 --diagnostics off", rows) ==
          done("0 0.6 0.8 0\n0 0.6 0.8 -0.01\n0 0.6 0.8 0\n0 0.6 0.8 0\n"));
    CHECK(run("-f axis-angle:deg -t axis-angle:deg --continuous", "0 1 0 170\n0 1 0 190\n0 1 0 340\n0 1 0 0\n") ==
          Result{0, "0 1 0 170\n0 1 0 190\n0 1 0 340\n0 1 0 360\n",
                 run("-f axis-angle:deg -t axis-angle:deg", "0 1 0 170\n0 1 0 190\n0 1 0 340\n0 1 0 0\n").err});
}

// Catches numbers that are compared with nan or with those of a row that was left out.
TEST_CASE("a row without a result changes nothing for the next") {
    const std::string command = "-f rpy:deg -t rpy:deg --continuous --on-error ";
    const std::string rows = "0 0 170\nx 0 0\n0 0 -170\nnan 0 0\n0 0 -100\n";
    CHECK(run(command + "nan", rows).out == "0 0 170\nnan nan nan\n0 0 190\nnan nan nan\n0 0 260\n");
    CHECK(run(command + "skip", rows).out == "0 0 170\n0 0 190\n0 0 260\n");
    CHECK(run(command + "stop", "0 0 170\n0 0 -170\nnan 0 0\n0 0 -100\n") ==
          stopped("0 0 170\n0 0 190\n", {"rotconv: -:3: not finite"}));
}

// Catches an option that one of them ignores.
TEST_CASE("propagate and published methods are continuous too") {
    std::string rows;
    std::string expected;
    for (int i = 0; i <= 10; ++i) {
        rows += std::to_string(i) + " 0 0 100\n";
        expected += std::to_string(i) + " 0 0 " + std::to_string(100 * i) + "\n";
    }
    for (const std::string how : {"linear", "cubic"}) {
        CHECK(run("propagate -t rpy -d -p 9 --continuous --interpolation " + how, rows) == done(expected));
    }
    const std::string quaternions = run("-f rpy:deg -t quat", past_a_half_turn).out;
    for (const std::string method : {"default", "classic", "bernardes-atan2"}) {
        CHECK(run("-f quat -t euler:xyz:deg -p 12 --continuous --method " + method, quaternions).out ==
              run("-f rpy:deg -t rpy:deg -p 12 --continuous", past_a_half_turn).out);
    }
    const auto lost = run("-f dcm -t quat --continuous --method trace", "1 0 0 0 1 0 0 0 1\n-1 0 0 0 1 0 0 0 -1\n"
                                                                        "1 0 0 0 1 0 0 0 1\n");
    CHECK(lost.out == "1 0 0 0\n0 nan nan nan\n1 0 0 0\n");
}

// Catches an option that is refused where it has no effect, or has one.
TEST_CASE("representations without a choice stay as they are") {
    const auto rows = moving_rows(300, false);
    for (const std::string to : {"dcm", "6d", "5d", "cayley"}) {
        CHECK(run("-f quat --continuous -t " + to, rows) == run("-f quat -t " + to, rows));
    }
    CHECK(run("survey -f quat --continuous", rows) == stopped(any_output, {"survey has no --continuous"}));
    CHECK(run("rates -f quat --continuous", rows).exit_code == 2);
}

// Catches blocks that choose before it is their turn, and a choice that is lost between two blocks.
TEST_CASE("a continuous stream has the same bytes with any number of threads and however it arrives") {
    const auto rows = moving_rows(15'000, true);
    const Folder folder;
    const auto file = folder / "rows";
    write_file(file, rows);
    const std::string command = "-f quat --tolerance 1 --diagnostics off --continuous --threads ";
    for (const std::string options :
         {" --on-error nan -t quat", " --on-error skip -t euler:ZYX", " --on-error nan -t euler:zxz:deg -p 7",
          " --on-error skip -t rotvec --format json", " --on-error skip -t axis-angle:deg --append",
          " --on-error skip -t rpy --format f64"}) {
        INFO(options);
        const auto expected = run(command + "1" + options, rows);
        CHECK(expected.exit_code == 1);
        CHECK(expected.out.size() > 100'000);
        for (const std::string threads : {"2", "3", "8"}) {
            CHECK((run(command + threads + options, {}, {.input_file = file}) == expected));
        }
        CHECK((run_in_pieces(command + "4" + options, rows, 9'973) == expected));
    }
}

// Catches the fast way of rows of doubles, which has blocks of its own.
TEST_CASE("continuous doubles have the same bytes with any number of threads") {
    const auto rows =
        run("-f quat -t quat --format f64 --tolerance 1 --diagnostics off", moving_rows(20'000, false)).out;
    const std::string command = "-f quat -t rpy --input-format f64 --format f64 --continuous --diagnostics off ";
    const auto expected = run(command + "--threads 1", rows);
    CHECK(expected.out.size() == 20'000 * 24);
    for (const std::string threads : {"2", "3", "8"}) {
        CHECK((run(command + "--threads " + threads, rows) == expected));
    }
    const auto text = run("-f quat -t quat --input-format f64 --diagnostics off", rows).out;
    CHECK((run("-f quat -t rpy --continuous --diagnostics off --format f64", text) == expected));
}

// Catches pairs whose numbers do not follow each other, or do so in their block alone.
TEST_CASE("products with a reference that does not turn are the continuous numbers of the stream") {
    const auto rows = moving_rows(15'000, true);
    const Folder folder;
    const auto same = folder / "same";
    std::string lines;
    for (int i = 0; i < 15'375; ++i) { // the bad ones too
        lines += "1 0 0 0\n";
    }
    write_file(same, lines);
    const std::string options = "-f quat -t rpy --continuous --tolerance 1 --diagnostics off --on-error nan --threads ";
    const auto expected = run(options + "1", rows).out;
    CHECK(expected.size() > 100'000);
    for (const std::string threads : {"1", "3"}) {
        CHECK((run("compose " + options + threads + " - " + same.string(), rows).out == expected));
    }
}

// Catches a thread that waits for its turn while the input is open.
TEST_CASE("a continuous row is answered before the next one is sent") {
    Process process(words_of("-f rpy:deg -t rpy:deg --continuous --threads 4 -p 12"));
    double yaw = 0.0;
    const auto next = [&yaw] {
        yaw += 90.0;
        return "0 0 " + std::to_string(std::lround(std::remainder(yaw, 360.0))) + "\n";
    };
    for (int burst = 0; burst < 3; ++burst) {
        std::string rows;
        for (int i = 0; i < 20'000; ++i) {
            rows += next();
        }
        process.write(rows);
        CHECK(count_rows(process.read_rows(20'000)) == 20'000);
        for (int i = 0; i < 20; ++i) {
            process.write(next());
            CHECK(process.read_rows(1) == "0 0 " + std::to_string(std::lround(yaw)) + "\n");
        }
    }
    CHECK(process.finish() == done(""));
}

// Catches threads that wait for ever for a turn that nobody takes.
TEST_CASE("a continuous stream ends at an error, and when its reader leaves") {
    const auto rows = moving_rows(30'000, false);
    for (int i = 0; i < 5; ++i) {
        Process failing(words_of("-f quat -t rpy --tolerance 1 --continuous --threads 4"));
        failing.write(rows + "bad 0 0 0\n" + rows);
        const auto result = failing.wait();
        CHECK(result.exit_code == 2);
        CHECK(count_rows(result.out) == count_rows(rows));
        Process left(words_of("-f quat -t rpy --tolerance 1 --continuous --diagnostics off --threads 4"));
        left.write(rows);
        left.read_rows(10'000);
        left.close_output();
        left.write(rows);
        CHECK(left.wait().exit_code == 0);
    }
}

// Catches rows that are kept for the choice.
TEST_CASE("memory does not grow with a continuous stream") {
    const Folder folder;
    const auto file = folder / "rows";
    write_file(file, repeated("1 2 3 4\n4 3 2 1\n", 300'000));
    Process process(words_of("-f quat -t rpy --diagnostics off --continuous --tolerance inf --threads 2"),
                    {.input_file = file});
    CHECK(count_rows(process.read_rows(200'000)) == 200'000);
    const long before = process.peak_memory_kib();
    CHECK(count_rows(process.read_rows(300'000)) == 300'000);
    CHECK((is_sanitized || process.peak_memory_kib() - before < 4096));
    CHECK((is_sanitized || process.peak_memory_kib() < 24576));
    CHECK(process.finish().exit_code == 0);
}
