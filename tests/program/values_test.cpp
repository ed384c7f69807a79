#include <catch.hpp>

#include "process.hpp"

using namespace program;

TEST_CASE("nan and inf with any sign are VALUEs and row errors") {
    // Catches -inf taken for an option, and attitudes made of nan.
    for (const char* word : {"nan", "-nan", "inf", "-inf", "+inf", "-NAN", "Inf", "infinity"}) {
        CHECK(run(Words{"-f", "quat", "-t", "dcm", word, "0", "0", "1"}) == stopped("", {"rotconv: argument: ", word}));
    }
}

TEST_CASE("with VALUEs stdin is not read") {
    // Catches a program that waits for stdin, or adds it to the VALUEs.
    CHECK(run("-f quat -t quat 1 0 0 0", "0 1 0 0\n") == done("1 0 0 0\n"));
    Process process(words_of("-f quat -t quat 1 0 0 0"));
    CHECK(process.wait() == done("1 0 0 0\n")); // stdin is still open
}

TEST_CASE("a wrong number of VALUEs is an error") {
    // Catches missing numbers taken for zero, and surplus ones that are dropped.
    for (const char* values : {"1", "1 0 0", "1 0 0 0 0", "1 0 0 0 1 0 0 0", "1,0,0", "1,0,0,"}) {
        CHECK(run(std::string("-f quat -t dcm ") + values) == stopped("", {"rotconv: argument: "}));
    }
}

TEST_CASE("numbers may have a plus sign and any usual form") {
    // Catches a number reader that is narrower than that of C.
    for (const char* one : {"1", "+1", "1.", "1.0", "01", "1e0", "1E+0", "+1.0e-0", "10e-1", ".1e1", "0.001e+3"}) {
        CHECK(run(Words{"-f", "quat", "-t", "quat", one, "0", "0", "0"}) == done("1 0 0 0\n"));
    }
}

TEST_CASE("words that are no decimal numbers are row errors") {
    // Catches hexadecimal, trailing letters and other leniency.
    for (const char* word : {"0x1", "1x", "1e", "+-1", "++1", "1d0", "1_000", "e1", ".", "1,5.0"}) {
        CHECK(run(Words{"-f", "quat", "-t", "quat", "--", word, "0", "0", "0"}) ==
              stopped("", {"rotconv: argument: ", word}));
    }
}

TEST_CASE("a number too large for a double is an error and one too small is zero") {
    // Catches overflow to inf and underflow taken for an error.
    CHECK(run("-f quat -t quat 1 1e-400 -1e-400 0.0000000000000001e-400") == done("1 0 0 0\n"));
    const auto zeros = repeated("0", 400); // digits alone go beyond the range as well
    CHECK(run(Words{"-f", "quat", "-t", "quat", "1", "0." + zeros + "1", "-." + zeros + "1", "0"}) ==
          done("1 0 0 0\n"));
    CHECK(run(Words{"-f", "rotvec", "-t", "quat", "0", "1" + zeros, "0"}).exit_code == 2);
    CHECK(run(Words{"-f", "quat", "-t", "quat", "0." + zeros + "1e401", "0", "0", zeros + "e400"}) ==
          done("1 0 0 0\n"));
    for (const char* word : {"1e400", "-1e400", "2e308", "1e99999999999999999999"}) {
        CHECK(run(Words{"-f", "rotvec", "-t", "quat", "0", word, "0"}) ==
              stopped(any_output, {"rotconv: argument: ", word}));
    }
}
