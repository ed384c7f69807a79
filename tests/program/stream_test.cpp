#include <clocale>
#include <functional>

#include <catch.hpp>

#include "process.hpp"

using namespace program;

// Catches output that waits in a buffer, and a reader that waits for more than a line.
TEST_CASE("a row is answered before the next one is sent") {
    Process process(words_of(reorder));
    for (int i = 0; i < 100; ++i) {
        process.write("1 0 0 0\n");
        REQUIRE(process.read_rows(1) == "0 0 0 1\n");
        process.write("0 0 1 0\n");
        REQUIRE(process.read_rows(1) == "0 1 0 0\n");
    }
    CHECK(process.finish() == done(""));
}

// Catches half a row that is converted.
TEST_CASE("a row that comes in pieces is answered when it is whole") {
    Process process(words_of(reorder));
    for (const char* piece : {"0.", "5 -0.5 0", ".5 0.", "5"}) {
        process.write(piece);
        process.wait_until_read();
    }
    process.write("\n0 1 0");
    CHECK(process.read_rows(1) == "-0.5 0.5 0.5 0.5\n");
    process.wait_until_read();
    process.write(" 0\n");
    CHECK(process.read_rows(1) == "1 0 0 0\n");
    CHECK(process.finish() == done(""));
}

// Catches a first block that is held back, in every format and policy.
TEST_CASE("header and comments and failed rows are answered at once") {
    Process process(words_of(reorder + "--on-error nan --columns qw,qx,qy,qz"));
    process.write("# t,qw,qx,qy,qz\n7,1,0,0,0\n"); // whether that is the header, the row after it tells
    CHECK(process.read_rows(2) == "# t,qx,qy,qz,qw\n7,0,0,0,1\n");
    process.write("# note\n");
    CHECK(process.read_rows(1) == "# note\n");
    process.write("8,1,bad,0,0\n");
    CHECK(process.read_rows(1) == "8,nan,nan,nan,nan\n");
    CHECK(process.finish() == went_on(any_output, {"rotconv: -:4: ", "bad"}));

    Process json(words_of("-f rotvec -t mrp --format json"));
    json.write("0 0 0\n");
    CHECK(missing(json.read_rows(1), {"{", "mx", "}"}) == "");
    CHECK(json.finish() == done(""));
}

// Catches a program that reads on for nothing.
TEST_CASE("a row error under stop ends the run while the input is open") {
    Process process(words_of(reorder));
    process.write("1 0 0 0\nbad 0 0 0\n");
    CHECK(process.wait() == stopped("0 0 0 1\n"));
}

// Catches rows that are kept, beyond those that constant turns are looked for in.
TEST_CASE("memory does not grow with the stream of a command that remembers rows") {
    const auto times = [](const std::string& rest) {
        return [rest](int part) {
            std::string rows;
            for (int i = 20'000 * part; i < 20'000 * (part + 1); ++i) {
                rows += std::to_string(i) + rest;
            }
            return rows;
        };
    };
    const std::string matrix = run("-f rpy:deg -t dcm --append", "10 20 30\n-50 60 100\n120 -30 5\n").out;
    struct Case {
        const char* arguments;
        std::function<std::string(int)> rows; ///< of a part of the stream
        int parts;                            ///< that come first
        const char* last;                     ///< the beginning of the last line
    };
    for (const Case& c :
         {Case{"survey -f quat", [](int) { return repeated("1 0 0 0\n0.8 0 0 0.6\n", 8000); }, 4, "mrp"},
          Case{"identify -t dcm", [&](int) { return repeated(matrix, 3000); }, 13, "-f rpy:deg --columns 1-3"},
          Case{"propagate -t quat --interpolation linear", times(" 0 0 1e-3\n"), 1, "59999 "},
          Case{"propagate -t quat --interpolation cubic", times(" 0 0 1e-3\n"), 1, "59999 "}}) {
        INFO(c.arguments);
        Process process(words_of(c.arguments));
        process.write("# a");
        process.write(" remark\n");
        for (int part = 1; part < c.parts; ++part) {
            process.write(c.rows(0));
        }
        const long before = process.peak_memory_after(c.rows(0));
        process.write(c.rows(1));
        CHECK((process.peak_memory_after(c.rows(2)) <= before + 256 || is_sanitized));
        CHECK(last_line(process.finish().out).starts_with(c.last));
    }
}

// Catches rows that are lost or change places at the borders of blocks.
TEST_CASE("many rows come out as many and in order") {
    std::string rows;
    for (std::size_t i = 0; i < 200'000; ++i) {
        std::string attitude = "0,0,0,0";
        attitude[i * 2654435761U % 4 * 2] = '1';
        rows += std::to_string(i) + "," + attitude + ",x" + repeated("y", i % 7) + "\n";
    }
    const auto turned = run(reorder + "--columns 2-5", rows);
    CHECK((turned == done(turned.out)));
    CHECK((turned.out != rows));
    CHECK((run("-f quat:xyzw -t quat --columns 2-5", turned.out) == done(rows)));
}

// Catches lines, line ends, marks and headers that are torn by the border of a read.
TEST_CASE("every split of the input gives the same bytes") {
    const std::string input =
        "\xEF\xBB\xBF# note\r\n\r\n# t,qw [],qx,qy,qz\r\n\"a,b\",1,0,0,0\r\n#\r\n7,.5,-0.5,0.5,0.5";
    const std::string output = "# note\r\n\r\n# t,qx,qy,qz,qw\r\n\"a,b\",0,0,0,1\r\n#\r\n7,-0.5,0.5,0.5,0.5";
    const auto arguments = words_of(reorder + "--columns qw,qx,qy,qz");
    const auto whole = run(arguments, input);
    CHECK(whole.exit_code == 0);
    CHECK(whole.out.substr(0, output.size()) == output); // the last line may get a line end
    for (std::size_t split = 1; split < input.size(); ++split) {
        INFO("split after " << split << " bytes");
        Process process(arguments);
        process.write(std::string_view(input).substr(0, split));
        process.wait_until_read();
        process.write(std::string_view(input).substr(split));
        CHECK(process.finish() == whole);
    }
}

// Catches decimal commas in numbers, in options and in messages.
TEST_CASE("nothing depends on the locale") {
    const Surroundings german{.environment = {"LC_ALL=de_DE.UTF-8", "LANG=de_DE.UTF-8", "LC_NUMERIC=de_DE.UTF-8"}};
    INFO("localedef (package locales) makes the German locale when the tests are configured");
    REQUIRE(std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr);
    std::setlocale(LC_ALL, "C");
    CHECK(run(reorder + "-p 3", "0.5;-0.5;0.5;0.5\n", german) == done("-0.5;0.5;0.5;0.5\n"));
    CHECK(run(reorder, "0.5,-0.5,0.5,0.5\n", german) == done("-0.5,0.5,0.5,0.5\n"));
    CHECK(run(reorder + "--tolerance 0.5 --diagnostics off", "1.25 0 0 0\n", german) == done("0 0 0 1\n"));
    const auto comma = run(reorder + "0,5 0,5 0,5 0,5", {}, german);
    CHECK(comma.exit_code == 2);
    for (const char* arguments : {"-f quat -t rotvec --diagnostics rows", "-f quat -t dcm --diagnostics columns",
                                  "-f quat -t quat --format pretty", "-f quat -t quat --format json"}) {
        const std::string rows = "0 1.0001 0 0\n1.5 0 0 0\n";
        const Surroundings plain{.environment = {"LC_ALL=C"}};
        CHECK(run(arguments, rows, german) == run(arguments, rows, plain));
    }
}
