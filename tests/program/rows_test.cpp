#include <catch.hpp>

#include <cstdint>

#include "process.hpp"

using namespace program;
using namespace std::string_literals;

namespace {

constexpr std::size_t mebi = std::size_t{1} << 20U;

} // namespace

// Catches a line buffer that is too small, and a limit that is lower than promised.
TEST_CASE("a line just below 4 MiB passes") {
    const auto field = repeated("x", 4 * mebi - 16);
    const auto result = run(reorder + "--columns 2-5", "a,1,0,0,0\n" + field + ",1,0,0,0\nb,0,1,0,0\n");
    CHECK(result.exit_code == 0);
    CHECK(result.err == "");
    CHECK((result.out == "a,0,0,0,1\n" + field + ",0,0,0,1\nb,1,0,0,0\n"));
}

// Catches memory that grows with a line, and rows that are lost when the run ends.
TEST_CASE("a line over 4 MiB ends the run with its number and the rows before") {
    for (const auto& line : {repeated("x", 4 * mebi + 16) + "\n", repeated("x", 9 * mebi)}) {
        const auto result = run(reorder + "--on-error skip", "1,0,0,0\n0,1,0,0\n" + line + "0,0,1,0\n");
        CHECK(result.exit_code == 2);
        CHECK(result.out == "0,0,0,1\n1,0,0,0\n");
        CHECK(missing(result.err, {"rotconv: -:3: "}) == "");
        CHECK(result.err.size() < 1000);
    }
}

// Catches a program that waits for the newline.
TEST_CASE("a line without end is given up before it ends") {
    Process process(words_of(reorder));
    process.write("1 0 0 0\n" + repeated("x", 6 * mebi));
    const auto result = process.wait(); // stdin is still open
    CHECK(result.exit_code == 2);
    CHECK(result.out == "0 0 0 1\n");
    CHECK(missing(result.err, {"rotconv: -:2: "}) == "");
}

// Catches text that ends at a NUL.
TEST_CASE("a NUL byte is a byte like any other") {
    CHECK(run(reorder + "--columns 2-5", "a\0b,1,0,0,0,c\0\n\0,0,1,0,0,\0\n"s) ==
          done("a\0b,0,0,0,1,c\0\n\0,1,0,0,0,\0\n"s));
    CHECK(run(reorder, "# \0 note\n1,0,0,0\n"s) == done("# \0 note\n0,0,0,1\n"s));
    const auto result = run(reorder, "1,0,0,0\n1\0,0,0,0\n"s);
    CHECK(result.exit_code == 2);
    CHECK(result.out == "0,0,0,1\n");
    CHECK(missing(result.err, {"rotconv: -:2: "}) == "");
    CHECK(result.err.find('\0') == std::string::npos);
}

// Catches other fields that are decoded.
TEST_CASE("bytes that are not UTF-8 pass") {
    CHECK(run(reorder + "--columns 2-5", "\xE9\xFF,1,0,0,0,\x80\n") == done("\xE9\xFF,0,0,0,1,\x80\n"));
}

// Catches crashes, rows that run together, and raw bytes sent to a terminal.
TEST_CASE("binary junk gives one row out for every row in") {
    std::uint32_t state = 12345;
    std::string junk = "1 0 0 0\n";
    for (int i = 0; i < 200'000; ++i) {
        state = state * 1664525U + 1013904223U;
        junk.push_back(static_cast<char>(state >> 24U));
    }
    junk.push_back('\n');
    const auto result = run(reorder + "--on-error nan", junk);
    CHECK(result.exit_code == 1);
    CHECK(count_rows(result.out) == count_rows(junk));
    CHECK(result.err.find_first_of("\0\x1B\x07\r"s) == std::string::npos);
    CHECK(run(reorder, junk).exit_code == 2);
}

// Catches a field or a line end that is lost around them. The numbers of the second row of each pair have a blank,
// or quotes, so that its fields are split.
TEST_CASE("numbers that are scanned where they stand come out as those whose fields are split") {
    struct Case {
        const char* options;
        const char* row;
        const char* split;
        const char* out;
    };
    for (const Case& c :
         {Case{"--columns 2-5", "a,1,0,0,0,b c", "a,1, 0,0,0,b c", "a,0,0,0,1,b c"},
          Case{"--columns 2-5", "a b , 1,0,0,0", "a b , 1,0,0,0 ", "a b ,0,0,0,1"},
          Case{"--columns 2-5", ",1,0,0,0,,", ",\"1\",0,0,0,,", ",0,0,0,1,,"},
          Case{"--columns 4,3,2,1", "0,0,0,1,\t", "0,0,0,1 ,\t", "0,0,0,1,\t"},
          Case{"--columns 2-5", "a\t1\t0\t0\t0\tb ", "a\t1\t0 \t0\t0\tb ", "a\t0\t0\t0\t1\tb "},
          Case{"--columns 2-5", "a 1 0 0 0", " a  1 0 0 0 ", "a 0 0 0 1"},
          Case{"--columns 2-5", "a 1 0 0 0 b", "a  1 0 0 0 b ", "a 0 0 0 1 b"},
          Case{"--append", "1,0,0,0", "1,0,0,\"0\"", nullptr}, Case{"--append", "1 0 0 0", "1  0 0 0", nullptr}}) {
        INFO(c.options << ' ' << c.row);
        for (const std::string end : {"\n", "\r\n", ""}) {
            for (const std::string row : {c.row, c.split}) {
                const std::string appended = row + (row.find(',') == std::string::npos ? " 0 0 0 1" : ",0,0,0,1");
                CHECK(run(reorder + c.options, row + end).out ==
                      (c.out == nullptr ? appended : c.out) + (end.empty() ? "\n" : end));
            }
        }
    }
}
