#include <tuple>

#include <catch.hpp>

#include "process.hpp"

using namespace program;

namespace {

/// A bad row between two good ones, and the part of it that the message has to quote.
struct BadRow {
    const char* from;
    const char* good;
    const char* bad;
    const char* quoted;
};

const BadRow bad_rows[] = {
    {"quat", "1,0,0,0", "1,zero,0,0", "zero"},
    {"quat", "1,0,0,0", "1,0x0,0,0", "0x0"},
    {"quat", "1,0,0,0", "1,1e400,0,0", "1e400"},
    {"quat", "1,0,0,0", "nan,0,0,0", "nan"},
    {"quat", "1,0,0,0", "1,-inf,0,0", "-inf"},
    {"quat", "1,0,0,0", "0,0,0,0", "0,0,0,0"},
    {"quat", "1,0,0,0", "1.002,0,0,0", "1.002"},
    {"quat", "1,0,0,0", "0.998,0,0,0", "0.998"},
    {"quat", "1,0,0,0", "1,0,0", "1,0,0"},
    {"quat", "1,0,0,0", "1,0,0,0,5", "1,0,0,0,5"},
    {"quat", "1,0,0,0", "1,,0,0", ""},
    {"quat", "1,0,0,0", "1,0,\"0,0", "1,0,\"0,0"},
    {"dcm", "1,0,0,0,1,0,0,0,1", "-1,0,0,0,-1,0,0,0,-1", "-1"},
    {"dcm", "1,0,0,0,1,0,0,0,1", "1,0,0,0,1,0,0,0,-1", "-1"},
    {"dcm", "1,0,0,0,1,0,0,0,1", "0,0,0,0,0,0,0,0,0", "0,0,0,0,0,0,0,0,0"},
    {"dcm", "1,0,0,0,1,0,0,0,1", "1.002,0,0,0,1,0,0,0,1", "1.002"},
    {"6d", "1,0,0,0,1,0", "1,0,0,1,0,0", "1,0,0,1,0,0"},
    {"6d", "1,0,0,0,1,0", "0,0,0,0,1,0", "0,0,0,0,1,0"},
    {"axis-angle", "1,0,0,0", "0,0,0,1", "0,0,0,1"},
    {"rotvec", "0,0,0", "0,inf,0", "inf"},
    {"cayley", "0,0,0", "inf,0,0", "inf"},
    {"mrp", "0,0,0", "0,0,nan", "nan"},
    {"rpy", "0,0,0", "0,-inf,0", "-inf"},
};

} // namespace

// Catches lost rows, rows after the error, rows that shift against their input, a wrong line number, and messages
// that do not show the text at fault.
TEST_CASE("a row that fails ends the run, is written as nan or is left out") {
    for (const BadRow& row : bad_rows) {
        INFO(row.from << ": " << row.bad);
        const auto rows = std::string(row.good) + "\n" + row.bad + "\n" + row.good + "\n";
        for (const auto& [policy, exit_code, out] : {std::tuple{"stop", 2, "1,0,0,0\n"},
                                                     {"nan", 1, "1,0,0,0\nnan,nan,nan,nan\n1,0,0,0\n"},
                                                     {"skip", 1, "1,0,0,0\n1,0,0,0\n"}}) {
            CHECK(run(std::string("-t quat --header no -f ") + row.from + " --on-error " + policy, rows) ==
                  Failure{exit_code, out, {"rotconv: -:2: ", row.quoted}, 1});
        }
    }
    CHECK(run("-f quat -t quat", "1,0,0,0\n1,0,0,x\n") == stopped("1,0,0,0\n")); // the default
}

// Catches thousands of lines that bury what matters, and rows that vanish without a word.
TEST_CASE("of bad rows twenty are told of, and the rest counted") {
    const std::string rows = "1 0 0 0\n" + repeated("0 0 0 0\n", 2400);
    const auto result = run("-f quat -t quat --on-error nan", rows);
    CHECK(result.exit_code == 1);
    CHECK(result.out == "1 0 0 0\n" + repeated("nan nan nan nan\n", 2400));
    CHECK(count_rows(result.err) == 21);
    CHECK(missing(result.err, {"rotconv: -:2: ", "rotconv: -:21: "}) == "");
    CHECK(result.err.ends_with("\nrotconv: -: 2380 more rows without a result\n"));
    CHECK(count_rows(run("-f quat -t quat --on-error nan", rows.substr(0, 8 + 20 * 8)).err) == 20);
    CHECK(run("-f quat -t quat --on-error nan", rows.substr(0, 8 + 21 * 8))
              .err.ends_with(": 1 more row without a result\n"));
    // The same in every command, and of all inputs together.
    CHECK(run("-f quat -t quat --on-error skip", rows).err == result.err);
    CHECK(run("survey -f quat --on-error skip", rows).err == result.err);
    const auto twice = run("compare -f quat --on-error nan --columns 1-8", repeated("0 0 0 0 1 0 0 0\n", 30));
    CHECK(missing(twice.err, {"rotconv: -:20: ", "rotconv: -: 10 more rows without a result\n"}) == "");
    CHECK(twice.err.find("-:21: ") == std::string::npos);
    Files files;
    files.add("own", "1 0 0 0\n" + repeated("0 0 0 0\n1 0 0 0\n", 15));
    files.add("other", "1 0 0 0\n" + repeated("1 0 0 0\n0 0 0 0\n", 15));
    const auto both = files("compare -f quat --on-error skip @own @other");
    CHECK(count_rows(both.err) == 21);
    CHECK(missing(both.err, {"own:2: ", "other:3: ", "other: 10 more rows without a result\n"}) == "");
    CHECK(run("-f quat -t quat --on-error nan --threads 8", rows) == result);
}

// Catches advice on the part of the input that came with the first read.
TEST_CASE("advice does not depend on the pieces in which the input comes") {
    struct Case {
        std::string arguments;
        std::string input;
        const char* advice;
    };
    const std::string remarks = repeated("written by a program\n", 2000); // 42 KB
    const Case cases[] = {
        {"-f quat -t rpy --header no", "w,x,y,z\n1,0,0,0\n", "tail -n +2"},
        {"-f quat -t rpy", "a 1 2 3\nb 1 0 0 0\nb 0 1 0 0\na 4 5 6\n", "grep '^b[[:blank:]]'"},
        {"-f quat -t rpy", "{\"w\": 1, \"x\": 0, \"y\": 0, \"z\": 0}\n{\"w\": 1, \"x\": 0, \"y\": 0, \"z\": 0}\n",
         "[.w, .x, .y, .z]"},
        {"-f quat -t rpy", "t a b c d\n1 1 0 0 0\n2 0 1 0 0\n", "--columns 2-5"},
        {"-f quat -t rpy --header no --threads 16", remarks + "1 0 0 0\n", "tail -n +2001"},
    };
    for (const auto& [arguments, input, advice] : cases) {
        INFO(arguments);
        INFO(advice);
        const Result result = run(arguments, input);
        CHECK(result == stopped("", {advice}));
        CHECK(run_in_pieces(arguments, input, input.size() < 1000 ? 1 : 997) == result);
    }
}
