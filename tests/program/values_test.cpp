#include <catch.hpp>

#include "process.hpp"

using namespace program;

TEST_CASE("VALUEs as separate arguments are answered as one row parted by blanks") {
    // Catches an answer in the wrong delimiter, or on several lines.
    CHECK(run("-f quat -t dcm 1 0 0 0") == done("1 0 0 0 1 0 0 0 1\n"));
    CHECK(run("-f quat -t quat:xyzw 0.5 -0.5 0.5 0.5") == done("-0.5 0.5 0.5 0.5\n"));
}

TEST_CASE("a VALUE may begin with a minus sign") {
    // Catches negative numbers that are taken for options.
    CHECK(run("-f quat -t quat:xyzw -1 0 0 0") == done("0 0 0 1\n"));
    CHECK(run("-f quat -t quat:xyzw -.5 .5 -.5 .5") == done("-0.5 0.5 -0.5 0.5\n"));
    CHECK(run("-f rotvec -t rotvec -p 6 -1e-3 -2E-3 -0") == done("-0.001 -0.002 0\n"));
    CHECK(run("-f euler:ZYX -t dcm -d -90 -0 -0.0") == done("0 1 0 -1 0 0 0 0 1\n"));
}

TEST_CASE("nan and inf with any sign are VALUEs and row errors") {
    // Catches -inf taken for an option, and attitudes made of nan.
    for (const char* word : {"nan", "-nan", "inf", "-inf", "+inf", "-NAN", "Inf", "infinity"}) {
        const auto result = run(Words{"-f", "quat", "-t", "dcm", word, "0", "0", "1"});
        CHECK(result.exit_code == 2);
        CHECK(result.out == "");
        CHECK(missing(result.err, {"rotconv: argument: ", word}) == "");
        CHECK(count_rows(result.err) == 1);
    }
}

TEST_CASE("one argument with commas or blanks is the row") {
    // Catches a list that is taken for one number or answered in another delimiter.
    CHECK(run(Words{"-f", "quat", "-t", "quat:xyzw", "1,0,0,0"}) == done("0,0,0,1\n"));
    CHECK(run(Words{"-f", "quat", "-t", "quat:xyzw", "1, 0, 0, 0"}) == done("0,0,0,1\n"));
    CHECK(run(Words{"-f", "quat", "-t", "quat:xyzw", "1 0 0 0"}) == done("0 0 0 1\n"));
    CHECK(run(Words{"-f", "quat", "-t", "quat:xyzw", "  1  0 0   0 "}) == done("0 0 0 1\n"));
}

TEST_CASE("one argument with commas may begin with a minus sign") {
    // Catches a list that is taken for a cluster of short options.
    CHECK(run(Words{"-f", "quat", "-t", "quat:xyzw", "-1,0,0,0"}) == done("0,0,0,1\n"));
    CHECK(run(Words{"-f", "quat", "-t", "quat:xyzw", "-.5 .5 -.5 .5"}) == done("-0.5 0.5 -0.5 0.5\n"));
}

TEST_CASE("what follows two dashes is a VALUE") {
    // Catches a program that knows no end of options.
    CHECK(run("-f quat -t quat:xyzw -- -1 0 0 0") == done("0 0 0 1\n"));
    CHECK(run("-f quat -t quat:xyzw -1 -- 0 0 0") == done("0 0 0 1\n"));
    const auto result = run("-f quat -t dcm -- 1 0 0 -d");
    CHECK(result.exit_code == 2);
    CHECK(missing(result.err, {"rotconv: argument: ", "-d"}) == "");
}

TEST_CASE("options may stand before and between and after VALUEs") {
    // Catches options that are only looked for in front.
    const auto expected = done("0 1 0 -1 0 0 0 0 1\n");
    CHECK(run("-f euler:ZYX -t dcm -d -90 0 0") == expected);
    CHECK(run("-90 0 0 -f euler:ZYX -t dcm -d") == expected);
    CHECK(run("-90 -f euler:ZYX 0 -d 0 -t dcm") == expected);
    CHECK(run("-d -90 -f euler:ZYX 0 -t dcm 0") == expected);
}

TEST_CASE("long options take their argument after a blank or an equals sign") {
    // Catches one of the two usual forms being left out.
    const auto expected = done("0 1 0 -1 0 0 0 0 1\n");
    CHECK(run("--from euler:ZYX --to dcm --degrees -90 0 0") == expected);
    CHECK(run("--from=euler:ZYX --to=dcm --degrees -90 0 0") == expected);
}

TEST_CASE("short options may be glued to their argument and to each other") {
    // Catches a parser of its own that knows only separate words.
    const auto expected = done("0 1 0 -1 0 0 0 0 1\n");
    CHECK(run("-feuler:ZYX -tdcm -d -90 0 0") == expected);
    CHECK(run("-dfeuler:ZYX -tdcm -90 0 0") == expected);
    CHECK(run("-df euler:ZYX -t dcm -90 0 0") == expected);
    CHECK(run("-fquat -tquat -p3 0.5 0.5 0.5 0.5") == done("0.5 0.5 0.5 0.5\n"));
}

TEST_CASE("a number after an option that awaits its argument is no VALUE") {
    // Catches numbers that are taken away from options.
    CHECK(run("-f quat -t quat 1 0 0 0 -p 3") == done("1 0 0 0\n"));
    CHECK(run("-f quat -t quat -p 3 1 0 0 0") == done("1 0 0 0\n"));
    CHECK(run("-f quat -t quat --tolerance inf --diagnostics off 3 0 0 0") == done("1 0 0 0\n"));
    CHECK(run("-f euler:ZYX -t euler:ZYX --lock-margin 1e-3 0 0 0") == done("0 0 0\n"));
    // -1 belongs to --tolerance, which does not like it.
    const auto result = run("-f quat -t quat --tolerance -1 1 0 0 0");
    CHECK(result.exit_code == 2);
    CHECK(missing(result.err, {"--tolerance", "-1"}) == "");
}

TEST_CASE("with VALUEs stdin is not read") {
    // Catches a program that waits for stdin, or adds it to the VALUEs.
    CHECK(run("-f quat -t quat 1 0 0 0", "0 1 0 0\n") == done("1 0 0 0\n"));
    Process process(words_of("-f quat -t quat 1 0 0 0"));
    CHECK(process.wait() == done("1 0 0 0\n")); // stdin is still open
}

TEST_CASE("a wrong number of VALUEs is an error") {
    // Catches missing numbers taken for zero, and surplus ones that are dropped.
    for (const char* values : {"1", "1 0 0", "1 0 0 0 0", "1 0 0 0 1 0 0 0", "1,0,0", "1,0,0,0,"}) {
        const auto result = run(std::string("-f quat -t dcm ") + values);
        CHECK(result.exit_code == 2);
        CHECK(result.out == "");
        CHECK(missing(result.err, {"rotconv: argument: "}) == "");
    }
}

TEST_CASE("a VALUE without a number in it is an error") {
    // Catches a shell variable without a value that gives no attitude and exit 0.
    for (const char* word : {"", " ", "# 1 0 0 0"}) {
        const auto result = run(Words{"-f", "quat", "-t", "dcm", word});
        CHECK(result.exit_code == 2);
        CHECK(result.out == "");
    }
}

TEST_CASE("a row error of VALUEs names the argument without a line") {
    // Catches a file name or a line number where there is none.
    const auto result = run("-f quat -t dcm 1 0 zero 0");
    CHECK(result.exit_code == 2);
    CHECK(result.out == "");
    CHECK(missing(result.err, {"rotconv: argument: ", "zero"}) == "");
    CHECK(missing(result.err, {"argument:1"}) != "");
}

TEST_CASE("VALUEs that fail under nan and skip end with exit 1") {
    // Catches policies that hold for streams only.
    const auto as_nan = run("-f quat -t quat --on-error nan 0 0 0 0");
    CHECK(as_nan.exit_code == 1);
    CHECK(as_nan.out == "nan nan nan nan\n");
    const auto skipped = run("-f quat -t quat --on-error skip 0 0 0 0");
    CHECK(skipped.exit_code == 1);
    CHECK(skipped.out == "");
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
        const auto result = run(Words{"-f", "quat", "-t", "quat", "--", word, "0", "0", "0"});
        CHECK(result.exit_code == 2);
        CHECK(result.out == "");
        CHECK(missing(result.err, {"rotconv: argument: ", word}) == "");
    }
}

TEST_CASE("nothing is quoted where blanks delimit") {
    // Catches a quoted number that is read in one place and split in another.
    const auto result = run("-f quat -t quat --delimiter blank", "\"1\" 0 0 0\n");
    CHECK(result.exit_code == 2);
    CHECK(missing(result.err, {"rotconv: -:1: not a number: '\"1\"'"}) == "");
    CHECK(run("-f quat -t quat", "\"1\",0,\" 0 \",0\n") == done("1,0,0,0\n"));
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
        const auto result = run(Words{"-f", "rotvec", "-t", "quat", "0", word, "0"});
        CHECK(result.exit_code == 2);
        CHECK(missing(result.err, {"rotconv: argument: ", word}) == "");
    }
}

TEST_CASE("an argument of the row may be selected by its index") {
    // Catches --columns that works on streams only.
    CHECK(run("-f quat -t quat --columns 4,1-3 0 0 0 1") == done("1 0 0 0\n"));
    CHECK(run(Words{"-f", "quat", "-t", "quat:xyzw", "--columns", "2-5", "7,1,0,0,0,x"}) == done("7,0,0,0,1,x\n"));
}
