#include <catch.hpp>

#include "process.hpp"

using namespace program;

TEST_CASE("precision is in significant digits") {
    // Catches digits after the point, and trailing zeros.
    const std::string third = "--tolerance 1 --diagnostics off 1 1 1 0"; // 1/sqrt 3 = 0.57735026918962576...
    CHECK(run("-f quat -t quat -p 1 " + third) == done("0.6 0.6 0.6 0\n"));
    CHECK(run("-f quat -t quat -p 3 " + third) == done("0.577 0.577 0.577 0\n"));
    CHECK(run("-f quat -t quat --precision=10 " + third) == done("0.5773502692 0.5773502692 0.5773502692 0\n"));
    CHECK(run("-f rotvec -t rotvec:deg -p 6 0.1 0 0") == done("5.72958 0 0\n"));
    CHECK(run("-f rotvec -t rotvec -p 3 1e-9 0 0") == done("1e-09 0 0\n"));
}

TEST_CASE("decimals are digits after the point") {
    // Catches an exponent in a table, a sign of 0, and digits that count from the first.
    CHECK(run("-f rpy:deg -t rpy:deg --decimals 4 2.679e-08 -2.679e-08 123.45678") == done("0.0000 0.0000 123.4568\n"));
    CHECK(run("-f rotvec -t rotvec --decimals=0 0.4 0.6 -1.7") == done("0 1 -2\n"));
    CHECK(run("-f rpy -t rpy -d --decimals 2 -179.999 0 -179.99") == done("180.00 0.00 -179.99\n"));
    CHECK(run("-f euler:ZYX -t euler:ZYX --decimals 4 -- -3.14158 0 -3.141548") == done("3.1416 0.0000 -3.1415\n"));
    CHECK(run("-f cayley -t cayley --decimals 1 inf 0 0").exit_code == 2);
    CHECK(run("-f quat -t cayley --diagnostics off --decimals 1 0 1 0 0") == done("inf 0.0 0.0\n"));
    CHECK(run("-f rotvec -t rotvec --decimals 2 --format json 1e-9 0 1").out ==
          "{\"rx\": 0.00, \"ry\": 0.00, \"rz\": 1.00}\n");
    CHECK(missing(run("compare -f rpy -d --decimals 2 0 0 0 0 0 30").out, {"max       30.00 deg at 1\n"}) == "");
    CHECK(run("-f quat -t dcm --on-error nan --decimals 2", "0 0 0 0\n").out ==
          "nan nan nan nan nan nan nan nan nan\n");
    CHECK(run("-f quat -t euler:ZYX -d --decimals 1 --diagnostics columns", "1,0,0,0\n") ==
          done("0.0,0.0,0.0,1.6,1.0,0.0,\n"));
}

TEST_CASE("an angle that rounds to minus 180 is printed as 180") {
    // Catches an angle outside of its range after rounding.
    const std::string angles = "-f euler:ZYX -t euler:ZYX -p 6 ";
    CHECK(run(angles + "-d -179.99999 0 0") == done("180 0 0\n"));
    CHECK(run(angles + "-d 0 0 -179.99999") == done("0 0 180\n"));
    CHECK(run(angles + "-d -179.999 0 0") == done("-179.999 0 0\n"));
    CHECK(run(angles + "-3.14159265 0 0") == done("3.14159 0 0\n"));
    CHECK(run("-f rpy:deg -t rpy:deg -p 4 0 0 -179.99") == done("0 0 180\n"));
    CHECK(std::stod(run("-f rpy:deg -t rpy:deg -p 2 -178 0 0").out) == 180); // in whatever notation
    CHECK(run("-f euler:ZXZ:deg -t euler:ZXZ:deg -p 5 -179.9999 90 -179.9999") == done("180 90 180\n"));
    CHECK(run(angles + "--format json -d -179.99999 0 0").out == "{\"e1\": 180, \"e2\": 0, \"e3\": 0}\n");
}

TEST_CASE("zero has no sign") {
    // Catches -0 from a negated or a rounded number.
    CHECK(run("-f quat -t quat -- -1 0 -0 0.0") == done("1 0 0 0\n"));
    CHECK(run("-f quat -t quat:passive 1 0 0 0") == done("1 0 0 0\n"));
    CHECK(run("-f quat -t quat:passive -p 3 1 -0 -0 -0") == done("1 0 0 0\n"));
    CHECK(run("-f rotvec -t rotvec:passive 0 0 0") == done("0 0 0\n"));
    CHECK(run("-f euler:ZYX -t euler:ZYX:passive 0 0 0") == done("0 0 0\n"));
    CHECK(run("-f euler:ZYX -t dcm -d 270 0 0") == done("0 1 0 -1 0 0 0 0 1\n"));
    CHECK(run("-f euler:ZYX -t dcm -d 0 0 360") == done("1 0 0 0 1 0 0 0 1\n"));
    CHECK(run("-f cayley -t cayley:passive 0 -0 0") == done("0 0 0\n"));
}

TEST_CASE("pretty tells the diagnostics in words") {
    // Catches a block that hides that its axis is a convention.
    const auto result = run("-f quat -t rotvec --format pretty", "0 1 0 0\n");
    CHECK(result.exit_code == 0);
    CHECK(missing(result.out, {"half-turn"}) == "");
    const auto off = run("-f quat -t rotvec --format pretty --diagnostics off", "0 1 0 0\n");
    CHECK(missing(off.out, {"half-turn"}) != "");
    CHECK(off.err == "");
}

TEST_CASE("only an angle that is minus pi to the printed digits changes its sign") {
    // Catches a sign flipped far from the end of the range.
    const std::string same = "-f euler:ZYX -t euler:ZYX -p ";
    CHECK(run(same + "2 -3.06 0 0") == done("-3.1 0 0\n"));
    CHECK(run(same + "2 -3.14 0 0") == done("3.1 0 0\n"));
    CHECK(run(same + "5 -3.141548 0 0") == done("-3.1415 0 0\n"));
    CHECK(run(same + "4 -3.1415 0 0") == done("3.142 0 0\n"));
    CHECK(run(same + "4 -3.14 0 0") == done("-3.14 0 0\n"));
    CHECK(run("-d " + same + "4 -179.96 0 0") == done("180 0 0\n"));
    CHECK(run("-d " + same + "4 -179.94 0 0") == done("-179.9 0 0\n"));
}

TEST_CASE("json keeps the digits of what is a JSON number") {
    // Catches numbers in quotes, numbers that a JSON reader refuses or rounds, and digits that are written anew.
    const auto value_of = [](const std::string& field) {
        const std::string out = run("-f rotvec -t rotvec --columns 2-4 --format json", field + ",0,0,0\n").out;
        return out.substr(0, out.find(", \"rx\""));
    };
    for (const char* number : {"0", "-0", "7", "0.50", "-1.0e-05", "1E+5", "1e400", "9007199254740992",
                               "-9007199254740992", "9007199254740993.0", "1403715524907143168e0"}) {
        CHECK(value_of(number) == std::string("{\"1\": ") + number);
    }
    CHECK(value_of(" 5\t") == "{\"1\": 5");
    for (const char* text : {"+1", "01", "-01", ".5", "5.", "1e", "1e+", "-", "0x10", "nan", "inf", "1_0", "1 2", "٣",
                             "9007199254740993", "-9007199254740993", "10000000000000000", "1403715524907143168"}) {
        CHECK(value_of(text) == std::string("{\"1\": \"") + text + '"');
    }
    CHECK(value_of("\"5\"") == "{\"1\": \"5\""); // whoever quotes it means text
    CHECK(value_of("") == "{\"1\": \"\"");
}

TEST_CASE("json loses no character of a field with quotes inside") {
    // Catches a quote that is taken for half of a doubled one.
    const auto value_of = [](const std::string& field) {
        const std::string out = run("-f rotvec -t rotvec --columns 2-4 --format json", field + ",0,0,0\n").out;
        return out.substr(0, out.find(", \"rx\""));
    };
    CHECK(value_of(R"("5"x6" board")") == R"({"1": "5\"x6\" board")");
    CHECK(value_of(R"("a""b")") == R"({"1": "a\"b")");
    CHECK(value_of(R"("""")") == R"({"1": "\"")");
    CHECK(value_of(R"("")") == R"({"1": "")");
    CHECK(value_of(R"("a"b"")") == R"({"1": "a\"b\"")");
}

TEST_CASE("json has each key once, whatever the header") {
    // Catches an index that is another field's name, names that become the same, and those of the result.
    const auto json = [](const std::string& arguments, const std::string& rows) {
        return run("--format json " + arguments, rows).out;
    };
    const std::string by_name = "-f quat -t rotvec --columns qw,qx,qy,qz ";
    const std::string result = "\"rx\": 0, \"ry\": 0, \"rz\": 0}\n";
    CHECK(json(by_name, "2,,qw,qx,qy,qz\n8,9,1,0,0,0\n") == "{\"1\": 8, \"2\": 9, " + result);
    CHECK(json(by_name, "a,2024,qw,qx,qy,qz\n8,9,1,0,0,0\n") == "{\"a\": 8, \"2024\": 9, " + result);
    CHECK(json(by_name + "--ragged", "7,qw,qx,qy,qz\n8,1,0,0,0\n8,1,0,0,0,5,6\n") ==
          "{\"7\": 8, " + result + "{\"1\": 8, \"6\": 5, \"7\": 6, " + result);
    CHECK(json(by_name, "a\xFF,a\xFE,qw,qx,qy,qz\n8,9,1,0,0,0\n") == "{\"a\xEF\xBF\xBD\": 8, \"2\": 9, " + result);
    CHECK(json(by_name, "rx,\"a\",a,qw,qx,qy,qz\n7,8,9,1,0,0,0\n") == "{\"1\": 7, \"a\": 8, \"3\": 9, " + result);
    CHECK(json(by_name, "margin,qw,qx,qy,qz\n8,1,0,0,0\n") == "{\"margin\": 8, " + result);
    CHECK(json(by_name + "--diagnostics columns", "margin,notes,qw,qx,qy,qz\n8,9,1,0,0,0\n")
              .starts_with("{\"1\": 8, \"2\": 9, \"rx\": 0"));
    // a name that is not written takes none away
    CHECK(json("-f quat -t rotvec --columns 1-4", "a,b,c,d,a\n1,0,0,0,8\n") == "{\"a\": 8, " + result);
}
