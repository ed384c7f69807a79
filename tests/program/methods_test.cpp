#include <catch.hpp>

#include "process.hpp"

using namespace program;

TEST_CASE("a method's failure is shown and named") {
    // Catches a method that is mended on the way, and a wrong answer without a word.
    const std::string half_turn = " -1 0 0 0 1 0 0 0 -1";
    const auto failed = run("-f dcm -t quat --method baruh --diagnostics rows" + half_turn);
    CHECK(failed.out == "0 nan 1 nan\n");
    CHECK(failed.err.starts_with("rotconv: argument: method-error: angle nan; "));
    CHECK(failed.exit_code == 0);
    CHECK(run("-f dcm -t quat --method default" + half_turn) == done("0 0 1 0\n"));
    CHECK(run("-f dcm -t quat --method shepperd" + half_turn) == done("0 0 1 0\n"));
    CHECK(run("--strict -f dcm -t quat --method baruh" + half_turn).exit_code == 1);
    const auto columns = run("-f quat -t dcm --method unit --diagnostics columns -p 3", "1,0,0,0\n0.7072,0,0,0.7072\n");
    CHECK(missing(columns.out, {"normalized+method-error\n", ",inf,1.41,0,\n"}) == "");
    const auto summary = run("-f dcm -t quat --method trace", "1 0 0 0 1 0 0 0 1\n-1 0 0 0 1 0 0 0 -1\n");
    CHECK(missing(summary.err, {"-: method-error: 1 row, first at line 2; "}) == "");
}

TEST_CASE("a wrong method is answered with the legal ones and where they hold") {
    // Catches a message that leaves the user to guess.
    const auto wrong = run("-f dcm -t quat --method sheperd 1 0 0 0 1 0 0 0 1");
    CHECK(wrong.exit_code == 2);
    CHECK(wrong.out.empty());
    CHECK(missing(wrong.err, {"'sheperd'", "did you mean shepperd?", "default", "bar-itzhack", "any proper matrix"}) ==
          "");
    const auto none = run("-f mrp -t 6d --method shepperd 0 0 0");
    CHECK(none.exit_code == 2);
    CHECK(missing(none.err, {"mrp to 6d", "only the default"}) == "");
    CHECK(run("-f mrp -t 6d --method default 0 0 0").exit_code == 0);
}

TEST_CASE("methods are listed with where they hold and their reference") {
    // Catches a table that lacks a pair, and figures that are compiled in.
    const auto listed = run("list methods");
    CHECK(listed.exit_code == 0);
    CHECK(count_rows(listed.out) == 47);
    CHECK(listed.out.starts_with(
        "FROM    TO      METHOD            holds for                                 reference\n"));
    CHECK(missing(listed.out, {"\nany     any     fast   ", "sarabandi-thomas", "Stuelpnagel 1964", "any proper matrix",
                               "rodrigues", "bernardes-arccos"}) == "");
    CHECK(missing(listed.out, {"\nquat    euler   matrix-threshold  to 4e-6 rad near lock                     "
                               "Shoemake 1994, Eul_FromQuat, threshold 1.9e-6\n"}) == "");
}

TEST_CASE("numbers are rounded once, but with --method fast") {
    // Catches a default that is off in the last digit, and a fast that is another word for it. The digits on the right
    // come from 60-digit arithmetic.
    CHECK(run("-f euler:ZYX:deg -t euler:ZYX:deg 30 40 50") == done("30 40 50\n"));
    CHECK(run("-f rotvec:deg -t rotvec:deg 60 0 0") == done("60 0 0\n"));
    CHECK(run("-f rpy -t rpy 0 1e-17 0") == done("0 1e-17 0\n"));
    CHECK(run("-f euler:ZYX:deg -t quat 90 0 180") == done("0 0.7071067811865476 0.7071067811865476 0\n"));
    const auto fast = run("-f euler:ZYX:deg -t euler:ZYX:deg --method fast 30 40 50");
    CHECK(fast.out != "30 40 50\n");
    CHECK(fast.exit_code == 0);
    CHECK(run("-f mrp -t 6d --method fast 0 0 0") == done("1 0 0 0 1 0\n"));
}

TEST_CASE("methods outside their domain end well") {
    // Catches a crash, a trap, an endless iteration.
    for (const char* method : {"trace", "baruh", "four-roots", "klumpp", "shepperd", "markley", "cayley",
                               "sarabandi-thomas", "bar-itzhack", "svd", "polar", "compensated"}) {
        INFO(method);
        const auto result = run(std::string("--tolerance inf --on-error nan -f dcm -t quat --method ") + method,
                                "0 0 0 0 0 0 0 0 0\n1e300 0 0 0 1e300 0 0 0 1e300\nnan 0 0 0 1 0 0 0 inf\n"
                                "1e-300 0 0 0 1 0 0 0 1\n1 0 0 0 1 0 0 0 -1\n-1 0 0 0 -1 0 0 0 1\n");
        CHECK(count_rows(result.out) == 6);
        CHECK(result.exit_code == 1);
    }
}
