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

} // namespace

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
