#include <catch.hpp>

#include <cstdint>

#include "process.hpp"

using namespace program;
using namespace std::string_literals;

namespace {

constexpr std::size_t mebi = std::size_t{1} << 20U;

} // namespace

TEST_CASE("the first data row settles the delimiter") {
    // Catches a delimiter that is guessed anew, or only known as comma.
    CHECK(run(reorder, "1,0,0,0\n0,1,0,0\n") == done("0,0,0,1\n1,0,0,0\n"));
    CHECK(run(reorder, "1\t0\t0\t0\n0\t1\t0\t0\n") == done("0\t0\t0\t1\n1\t0\t0\t0\n"));
    CHECK(run(reorder, "1;0;0;0\n0;1;0;0\n") == done("0;0;0;1\n1;0;0;0\n"));
    CHECK(run(reorder, "1 0 0 0\n0 1 0 0\n") == done("0 0 0 1\n1 0 0 0\n"));
    CHECK(run(reorder, "1,0,0,0\n0;1;0;0\n") == stopped("0,0,0,1\n", {"rotconv: -:2: "}));
}

TEST_CASE("the delimiter option goes before the first data row") {
    // Catches an option that only helps the guess.
    CHECK(run(reorder + "--delimiter semicolon --columns 2-5", "a,b;1;0;0;0\n") == done("a,b;0;0;0;1\n"));
    CHECK(run(reorder + "--delimiter comma --columns 2-5", "a;b,1,0,0,0\n") == done("a;b,0,0,0,1\n"));
    CHECK(run(reorder + "--delimiter tab --columns 2-5", "a,b\t1\t0\t0\t0\n") == done("a,b\t0\t0\t0\t1\n"));
    CHECK(run(reorder + "--delimiter blank --columns 2-5", "a,b 1  0 0 0\n") == done("a,b 0 0 0 1\n"));
    CHECK(run(reorder + "--delimiter | --columns 2-5", "a,b|1|0|0|0\n") == done("a,b|0|0|0|1\n"));
    CHECK(run(reorder + "--delimiter , --columns 2-5", "a;b,1,0,0,0\n") == done("a;b,0,0,0,1\n"));
    CHECK(run(reorder + "--delimiter :", "1:0:0:0\n") == done("0:0:0:1\n"));
}

TEST_CASE("line ends are kept row by row") {
    // Catches CRLF that is lost or taken for part of the last number.
    CHECK(run(reorder, "1,0,0,0\r\n0,1,0,0\r\n") == done("0,0,0,1\r\n1,0,0,0\r\n"));
    CHECK(run(reorder, "1 0 0 0\r\n0 1 0 0\n") == done("0 0 0 1\r\n1 0 0 0\n"));
    CHECK(run(reorder, "# note\r\n\r\n1 0 0 0\r\n") == done("# note\r\n\r\n0 0 0 1\r\n"));
    CHECK(run(reorder + "--append", "1,0,0,0\r\n") == done("1,0,0,0,0,0,0,1\r\n"));
}

TEST_CASE("blank rows and comments pass through as they are") {
    // Catches their loss, or a comment that counts as a row.
    const std::string before = "# a comment, with \"quotes\n\n   \n\t\n#\n";
    const std::string between = "# 1,0,0,0\n\n  \n#x\n";
    CHECK(run(reorder, before + "1,0,0,0\n" + between + "0,1,0,0\n#end") ==
          done(before + "0,0,0,1\n" + between + "1,0,0,0\n#end"));
    CHECK(run(reorder, "# only\n\n").out == "# only\n\n");
}

TEST_CASE("line numbers count every physical line") {
    // Catches numbers that leave out comments, blank rows or the header.
    CHECK(run(reorder, "# one\n\nqw,qx,qy,qz\n1,0,0,0\n\n# six\n1,0,0,bad\n") ==
          stopped(any_output, {"rotconv: -:7: ", "bad"}));
}

TEST_CASE("a row of 10000 columns is converted") {
    // Catches a fixed number of fields.
    const auto others = repeated("x,", 9'996);
    const auto result = run(reorder + "--columns 9997-10000", others + "1,0,0,0\n");
    CHECK(result.exit_code == 0);
    CHECK((result.out == others + "0,0,0,1\n"));
}

TEST_CASE("a field of 1 MiB passes") {
    // Catches a line buffer that is too small.
    const auto field = repeated("x", mebi);
    const auto result = run(reorder + "--columns 2-5", "a,1,0,0,0\n" + field + ",1,0,0,0\nb,0,1,0,0\n");
    CHECK(result.exit_code == 0);
    CHECK(result.err == "");
    CHECK((result.out == "a,0,0,0,1\n" + field + ",0,0,0,1\nb,1,0,0,0\n"));
}

TEST_CASE("a line just below 4 MiB passes") {
    // Catches a limit that is lower than promised.
    const auto field = repeated("x", 4 * mebi - 16);
    const auto result = run(reorder + "--columns 2-5", field + ",1,0,0,0\n0,1,0,0,0\n");
    CHECK(result.exit_code == 0);
    CHECK(result.err == "");
    CHECK((result.out == field + ",0,0,0,1\n0,0,0,0,1\n"));
}

TEST_CASE("a line over 4 MiB ends the run with its number and the rows before") {
    // Catches memory that grows with a line, and rows that are lost when the run ends.
    for (const auto& line : {repeated("x", 4 * mebi + 16) + "\n", repeated("x", 9 * mebi)}) {
        const auto result = run(reorder + "--on-error skip", "1,0,0,0\n0,1,0,0\n" + line + "0,0,1,0\n");
        CHECK(result.exit_code == 2);
        CHECK(result.out == "0,0,0,1\n1,0,0,0\n");
        CHECK(missing(result.err, {"rotconv: -:3: "}) == "");
        CHECK(result.err.size() < 1000);
    }
}

TEST_CASE("a line without end is given up before it ends") {
    // Catches a program that waits for the newline.
    Process process(words_of(reorder));
    process.write("1 0 0 0\n" + repeated("x", 6 * mebi));
    const auto result = process.wait(); // stdin is still open
    CHECK(result.exit_code == 2);
    CHECK(result.out == "0 0 0 1\n");
    CHECK(missing(result.err, {"rotconv: -:2: "}) == "");
}

TEST_CASE("a NUL byte is a byte like any other") {
    // Catches text that ends at a NUL.
    CHECK(run(reorder + "--columns 2-5", "a\0b,1,0,0,0,c\0\n\0,0,1,0,0,\0\n"s) ==
          done("a\0b,0,0,0,1,c\0\n\0,1,0,0,0,\0\n"s));
    CHECK(run(reorder, "# \0 note\n1,0,0,0\n"s) == done("# \0 note\n0,0,0,1\n"s));
    const auto result = run(reorder, "1,0,0,0\n1\0,0,0,0\n"s);
    CHECK(result.exit_code == 2);
    CHECK(result.out == "0,0,0,1\n");
    CHECK(missing(result.err, {"rotconv: -:2: "}) == "");
    CHECK(result.err.find('\0') == std::string::npos);
}

TEST_CASE("bytes that are not UTF-8 pass") {
    // Catches other fields that are decoded.
    CHECK(run(reorder + "--columns 2-5", "\xE9\xFF,1,0,0,0,\x80\n") == done("\xE9\xFF,0,0,0,1,\x80\n"));
}

TEST_CASE("binary junk gives one row out for every row in") {
    // Catches crashes, rows that run together, and raw bytes sent to a terminal.
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
