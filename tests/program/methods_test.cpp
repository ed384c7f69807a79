#include <catch.hpp>

#include "process.hpp"

using namespace program;

// Catches a method that is mended on the way, and a wrong answer without a word.
TEST_CASE("a method's failure is shown and named") {
    const std::string half_turn = " -1 0 0 0 1 0 0 0 -1";
    const auto failed = run("-f dcm -t quat --method baruh --diagnostics rows" + half_turn);
    CHECK(failed.out == "0 nan 1 nan\n");
    CHECK(failed.err.starts_with("rotconv: argument: method-error: angle nan; "));
    CHECK(failed.exit_code == 0);
    CHECK(run("-f dcm -t quat --method default" + half_turn) == done("0 0 1 0\n"));
    CHECK(run("-f dcm -t quat --method shepperd" + half_turn) == done("0 0 1 0\n"));
    CHECK(run("--strict -f dcm -t quat --method baruh" + half_turn).exit_code == 1);
    const auto columns =
        run("-f quat -t dcm --method unit --diagnostics columns -p 3", "1,0,0,0\n0.7074,0,0,0.7072\n");
    CHECK(missing(columns.out, {"normalized+method-error\n", ",inf,1.41,0,\n"}) == "");
    const auto summary = run("-f dcm -t quat --method trace", "1 0 0 0 1 0 0 0 1\n-1 0 0 0 1 0 0 0 -1\n");
    CHECK(missing(summary.err, {"-: method-error: 1 row, first at line 2; "}) == "");
}

// Catches a message that leaves the user to guess.
TEST_CASE("a wrong method is answered with the legal ones and where they hold") {
    CHECK(run("-f dcm -t quat --method sheperd 1 0 0 0 1 0 0 0 1") ==
          Failure{2, "", {"'sheperd'", "did you mean shepperd?", "default", "bar-itzhack", "any proper matrix"}});
    CHECK(run("-f mrp -t 6d --method shepperd 0 0 0") ==
          stopped(any_output, {"mrp to 6d", "only default, fast and all"}));
    CHECK(run("-f mrp -t 6d --method default 0 0 0").exit_code == 0);
}

// Catches a table that lacks a pair, figures that are compiled in, and lines too long for a terminal.
TEST_CASE("methods are listed with where they hold and their reference") {
    const auto listed = run("list methods");
    CHECK(listed.exit_code == 0);
    CHECK(listed.out.starts_with("dcm to quat\n  default           every input that describes an attitude "));
    CHECK(missing(listed.out, {"\nquat to euler\n", "\ncayley to dcm\n", "\nany to any other\n", "sarabandi-thomas",
                               "Stuelpnagel 1964", "any proper matrix", "rodrigues", "bernardes-arccos"}) == "");
    CHECK(missing(listed.out, {"\n  matrix-threshold  to 4e-6 rad near lock                     "
                               "Shoemake 1994, threshold 1.9e-6\n"}) == "");
    for (const std::string& line : fields_of(listed.out, '\n')) {
        CHECK(line.size() <= 100);
    }
}

// Catches a pair that is not found by its other name or with its modifiers, and a pair that is none.
TEST_CASE("list methods takes a pair, as a command line names it") {
    const auto pair = run("list methods dcm quat");
    CHECK(pair.exit_code == 0);
    CHECK(pair.out.starts_with("dcm to quat\n"));
    CHECK(count_rows(pair.out) == 18);
    CHECK(run("list methods matrix quat:tum") == pair);
    CHECK(missing(run("list methods quat rpy:deg").out, {"quat to rpy\n", "bernardes-atan2"}) == "");
    const auto from = run("list methods dcm");
    CHECK(missing(from.out, {"dcm to quat\n", "dcm to rotvec\n", "dcm to cayley\n", "dcm to any other\n"}) == "");
    CHECK(from.out.find("quat to dcm") == std::string::npos);
    CHECK(count_rows(run("list methods mrp 6d").out) == 3);
    CHECK(run("list methods dcm quot") ==
          stopped(any_output, {"'quot' is not a known representation", "did you mean quat?"}));
    CHECK(missing(run("list methods quot:xyzw dcm").err, {"'quot' is not", "did you mean quat?"}) == "");
    CHECK(missing(run("list methods quat:xyz dcm").err, {"'xyz' is not a known modifier of quat"}) == "");
    CHECK(run("list methods euler dcm").exit_code == 0);
    for (const char* arguments : {"list methods dcm quat mrp", "list dcm quat", "list presets tum"}) {
        CHECK(run(arguments).exit_code == 2);
        CHECK(missing(run(arguments).err, {"unexpected argument"}) == "");
    }
}

/// The methods of a pair, by name.
Words methods_of(const std::string& pair) {
    Words names;
    for (const std::string& line : fields_of(run("list methods " + pair).out, '\n')) {
        if (line.starts_with("  ")) {
            names.push_back(line.substr(2, line.find(' ', 2) - 2));
        }
    }
    return names;
}

// Catches a method that is left out or stands beside another's answer, and a right answer that is called wrong.
TEST_CASE("each row is written once for every method of the pair") {
    const std::string half_turn = "-1 0 0 0 1 0 0 0 -1";
    const Words names = methods_of("dcm quat");
    CHECK(names.size() == 17);
    std::string expected;
    for (const std::string& name : names) {
        const auto alone = run("-f dcm -t quat --diagnostics off --method " + name, half_turn + "\n");
        CHECK(alone.exit_code == 0);
        const bool is_wrong = name == "trace" || name == "baruh"; // they divide by w
        expected += alone.out.substr(0, alone.out.size() - 1) + " " + name + (is_wrong ? " nan\n" : " 0\n");
    }
    const auto all = run("-f dcm -t quat --method all -- " + half_turn);
    CHECK(all.out == expected);
    CHECK(all.exit_code == 0);
    for (const char* diagnostics : {"", " --diagnostics rows"}) {
        const auto told = run("-f dcm -t quat --method all" + std::string(diagnostics) + " -- " + half_turn);
        CHECK(missing(told.err, {"method-error: trace: angle nan", "method-error: baruh: angle nan"}) == "");
        CHECK(count_rows(told.err) == 2);
    }
    CHECK(run("--strict -f dcm -t quat --method all -- " + half_turn).exit_code == 1);
    CHECK(run("-f mrp -t 6d --method all 0 0 0") == done("1 0 0 0 1 0 default 0\n1 0 0 0 1 0 fast 0\n"));
    // acos of 1 - 5e-19 is 0, and the attitude is 2e-9 rad away; the others are off by the rounding of 2e-9.
    const auto small = run("-f quat -t rotvec --method all 1 1e-9 0 0");
    CHECK(missing(small.out, {"2e-09 0 0 default ", "e-25\n", "0 0 0 acos 2e-09\n"}) == "");
}

// Catches one that stands twice under two names. Rows with a defect, on which no two agree in all digits.
TEST_CASE("the answer of each method is the one that it gives alone") {
    const std::string input = "1.1 .2 .3 -.4\n-.6 .5 .1 .9\n.2 -.7 1.3 .8\n";
    const std::string arguments = "-f quat -t rpy:deg --tolerance inf --diagnostics off --method ";
    const Words all = fields_of(run(arguments + "all", input).out, '\n');
    const Words names = methods_of("quat rpy");
    REQUIRE(all.size() >= 3 * names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Words alone = fields_of(run(arguments + names[i], input).out, '\n');
        for (std::size_t row = 0; row < 3; ++row) {
            CHECK(all[row * names.size() + i].starts_with(alone[row] + " " + names[i] + " "));
        }
    }
    CHECK(run(arguments + "fast", input).out != run(arguments + "default", input).out);
}

// Catches a header that does not fit the rows, and fields that are lost in every second row.
TEST_CASE("answers of all methods stand among the other fields, in columns of their own") {
    const std::string input = "id,w,x,y,z,note\n7,1,0,0,0,a\n";
    const std::string arguments = "-f quat -t cayley --method all --columns w,x,y,z ";
    CHECK(run(arguments, input) == done("id,cx,cy,cz,method,angle,note\n7,0,0,0,default,0,a\n7,0,0,0,fast,0,a\n"));
    CHECK(run(arguments + "--append --diagnostics columns", input) ==
          done("id,w,x,y,z,note,cx,cy,cz,method,angle,margin,condition,defect,notes\n"
               "7,1,0,0,0,a,0,0,0,default,0,3.141592653589793,0.5,0,\n7,1,0,0,0,a,0,0,0,fast,0,3.141592653589793,0.5,0,"
               "\n"));
    CHECK(run(arguments + "--format json", "id,w,x,y,z,method\n7,1,0,0,0,a\n") ==
          done("{\"id\": 7, \"6\": \"a\", \"cx\": 0, \"cy\": 0, \"cz\": 0, \"method\": \"default\", \"angle\": 0}\n"
               "{\"id\": 7, \"6\": \"a\", \"cx\": 0, \"cy\": 0, \"cz\": 0, \"method\": \"fast\", \"angle\": 0}\n"));
    CHECK(run("-f quat -t dcm:col --method all --format pretty 1 0 0 0")
              .out.starts_with("line 1\n  method     default\n  1  0  0\n  0  1  0\n  0  0  1\n  angle      0\n\nline "
                               "1\n  method     fast\n"));
    CHECK(missing(run("-f mrp -t rotvec --header add --method all", "0 0 0\n").out,
                  {"rx ry rz method angle\n0 0 0 default 0\n0 0 0 fast 0\n"}) == "");
    // The set has an angle of its own.
    CHECK(run("-f quat -t axis-angle --header add --method all", "1 0 0 0\n")
              .out.starts_with("ax ay az angle method method_angle\n1 0 0 0 default 0\n"));
    // A column of doubles that passes, into text.
    const double row[]{1, 0, 0, 0, 5};
    const std::string_view bytes(reinterpret_cast<const char*>(row), sizeof row);
    CHECK(run("-f quat -t mrp --method all --input-format f64 --width 5 --columns 1-4", bytes) ==
          done("0,0,0,default,0,5\n0,0,0,fast,0,5\n"));
}

// Catches an error that is told once for each method, or rows that are lost.
TEST_CASE("rows that fail under --method all") {
    const std::string input = "1 0 0 0\n0 0 0 0\nx 0 0 0\n0 1 0 0\n";
    const std::string arguments = "-f quat -t mrp --diagnostics off --method all --on-error ";
    const auto with_nan = run(arguments + "nan", input);
    CHECK(with_nan.out == "0 0 0 default 0\n0 0 0 fast 0\nnan nan nan default nan\nnan nan nan fast nan\n"
                          "nan nan nan default nan\nnan nan nan fast nan\n1 0 0 default 0\n1 0 0 fast 0\n");
    CHECK(with_nan.exit_code == 1);
    CHECK(count_rows(with_nan.err) == 2);
    CHECK(missing(with_nan.err, {"rotconv: -:2: ", "rotconv: -:3: not a number: 'x'"}) == "");
    const auto skipped = run(arguments + "skip", input);
    CHECK(skipped.out == "0 0 0 default 0\n0 0 0 fast 0\n1 0 0 default 0\n1 0 0 fast 0\n");
    CHECK(skipped.err == with_nan.err);
    CHECK(skipped.exit_code == 1);
    CHECK(run(arguments + "stop", input) == stopped("0 0 0 default 0\n0 0 0 fast 0\n"));
    const auto summary = run("-f dcm -t quat --method all", repeated("-1 0 0 0 1 0 0 0 -1\n1 0 0 0 1 0 0 0 1\n", 50));
    CHECK(count_rows(summary.out) == 100 * 17);
    CHECK(missing(summary.err, {"method-error: 50 rows, first at line 1; "}) == "");
    const auto singular = run("-f dcm -t rotvec --method all", "-1 0 0 0 1 0 0 0 -1\n");
    CHECK(missing(singular.err, {"half-turn: 1 row, first at line 1; "}) == "");
}

// Catches a default that is off in the last digit, and a fast that is another word for it. The digits on the right
// come from 60-digit arithmetic.
TEST_CASE("numbers are rounded once, but with --method fast") {
    CHECK(run("-f euler:ZYX:deg -t euler:ZYX:deg 30 40 50") == done("30 40 50\n"));
    CHECK(run("-f rotvec:deg -t rotvec:deg 60 0 0") == done("60 0 0\n"));
    CHECK(run("-f rpy -t rpy 0 1e-17 0") == done("0 1e-17 0\n"));
    CHECK(run("-f euler:ZYX:deg -t quat 90 0 180") == done("0 0.7071067811865476 0.7071067811865476 0\n"));
    const auto fast = run("-f euler:ZYX:deg -t euler:ZYX:deg --method fast 30 40 50");
    CHECK(fast.out != "30 40 50\n");
    CHECK(fast.exit_code == 0);
    CHECK(run("-f mrp -t 6d --method fast 0 0 0") == done("1 0 0 0 1 0\n"));
}

// Catches a crash, a trap, an endless iteration.
TEST_CASE("methods outside their domain end well") {
    for (const std::string target : {"quat", "rotvec", "rpy", "cayley"}) {
        INFO(target);
        const auto result = run("--tolerance inf --on-error nan -f dcm --method all -t " + target,
                                "0 0 0 0 0 0 0 0 0\n1e300 0 0 0 1e300 0 0 0 1e300\nnan 0 0 0 1 0 0 0 inf\n"
                                "1e-300 0 0 0 1 0 0 0 1\n1 0 0 0 1 0 0 0 -1\n-1 0 0 0 -1 0 0 0 1\n");
        CHECK(count_rows(result.out) % 6 == 0);
        CHECK(count_rows(result.out) > 24);
        CHECK(result.exit_code == 1);
    }
}
