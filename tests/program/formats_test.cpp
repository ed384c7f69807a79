#include <catch.hpp>

#include "process.hpp"

using namespace program;

namespace {

/// JSON without the blanks outside of its strings.
std::string compact(std::string_view json) {
    std::string result;
    bool quoted = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        if (quoted && json[i] == '\\') {
            result += json[i++];
        } else if (json[i] == '"') {
            quoted = !quoted;
        }
        if (quoted || json[i] != ' ') {
            result += json[i];
        }
    }
    return result;
}

std::string json_of(const std::string& arguments, const std::string& input) {
    const auto result = run("--format json " + arguments, input);
    CHECK(result.exit_code == 0);
    CHECK(result.err == "");
    return compact(result.out);
}

const std::string convert = "-f quat -t quat:xyzw ";

} // namespace

TEST_CASE("csv is the format unless another is named") {
    // Catches a default that depends on the place of the output.
    CHECK(run(convert + "--format csv", "1,0,0,0\n") == run(convert, "1,0,0,0\n"));
}

TEST_CASE("precision is in significant digits") {
    // Catches digits after the point, and trailing zeros.
    const std::string third = "--tolerance 1 --diagnostics off 1 1 1 0"; // 1/sqrt 3 = 0.57735026918962576...
    CHECK(run("-f quat -t quat -p 1 " + third) == done("0.6 0.6 0.6 0\n"));
    CHECK(run("-f quat -t quat -p 3 " + third) == done("0.577 0.577 0.577 0\n"));
    CHECK(run("-f quat -t quat --precision=10 " + third) == done("0.5773502692 0.5773502692 0.5773502692 0\n"));
    CHECK(run("-f rotvec -t rotvec:deg -p 6 0.1 0 0") == done("5.72958 0 0\n"));
    CHECK(run("-f rotvec -t rotvec -p 3 1e-9 0 0") == done("1e-09 0 0\n"));
}

TEST_CASE("numbers are the shortest that read back") {
    // Catches 17 digits everywhere, and digits that are lost.
    CHECK(run("-f quat -t quat 0.5 0.5 0.5 0.5") == done("0.5 0.5 0.5 0.5\n"));
    CHECK(run("-f quat -t rotvec --diagnostics off 0 1 0 0") == done("3.141592653589793 0 0\n"));
}

TEST_CASE("decimals are digits after the point") {
    // Catches an exponent in a table, a sign of 0, and digits that count from the first.
    CHECK(run("-f rpy:deg -t rpy:deg --decimals 4 2.679e-08 -2.679e-08 123.45678") == done("0.0000 0.0000 123.4568\n"));
    CHECK(run("-f rotvec -t rotvec --decimals=0 0.4 0.6 -1.7") == done("0 1 -2\n"));
    CHECK(run("-f rpy -t rpy -d --decimals 2 -179.999 0 -179.99") == done("180.00 0.00 -179.99\n"));
    CHECK(run("-f euler:ZYX -t euler:ZYX --decimals 4 -- -3.14158 0 -3.141548") == done("3.1416 0.0000 -3.1415\n"));
    CHECK(run("-f cayley -t cayley --decimals 1 inf 0 0").exit_code == 2);
    CHECK(run("-f quat -t cayley --diagnostics off --decimals 1 0 1 0 0") == done("inf 0.0 0.0\n"));
    CHECK(compact(run("-f rotvec -t rotvec --decimals 2 --format json 1e-9 0 1").out) ==
          "{\"rx\":0.00,\"ry\":0.00,\"rz\":1.00}\n");
    CHECK(missing(run("compare -f rpy -d --decimals 2 0 0 0 0 0 30").out, {"max       30.00 at 1\n"}) == "");
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
    CHECK(compact(run(angles + "--format json -d -179.99999 0 0").out) == "{\"e1\":180,\"e2\":0,\"e3\":0}\n");
}

TEST_CASE("a half-turn is 180 and not minus 180") {
    // Catches the open end of the range.
    CHECK(run("-f euler:ZYX -t euler:ZYX -d", "-180 0 0\n180 0 0\n540 0 0\n0 0 -180\n") ==
          done("180 0 0\n180 0 0\n180 0 0\n0 0 180\n"));
    CHECK(run("-f euler:ZYX -t euler:ZYX -d -p 3", "-180 0 0\n") == done("180 0 0\n"));
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

TEST_CASE("json has one object a row with other fields first") {
    // Catches another order, wrong keys, and numbers in quotes.
    CHECK(json_of(convert, "1 0 0 0\n0 1 0 0\n") ==
          "{\"qx\":0,\"qy\":0,\"qz\":0,\"qw\":1}\n{\"qx\":1,\"qy\":0,\"qz\":0,\"qw\":0}\n");
    CHECK(json_of(convert + "--columns 2-5", "a,1,0,0,0,7\n") ==
          "{\"1\":\"a\",\"6\":7,\"qx\":0,\"qy\":0,\"qz\":0,\"qw\":1}\n");
    CHECK(json_of(convert + "--columns qw,qx,qy,qz", "# t,qw,qx,qy,qz, note \n7,0.5,-0.5,0.5,0.5,b\n") ==
          "{\"t\":7,\"note\":\"b\",\"qx\":-0.5,\"qy\":0.5,\"qz\":0.5,\"qw\":0.5}\n");
}

TEST_CASE("json leaves out header and comments and blank rows") {
    // Catches lines that are no JSON.
    CHECK(json_of("-f rotvec -t cayley", "# note\n\na b c\n0 0 0\n\n# end\n") == "{\"cx\":0,\"cy\":0,\"cz\":0}\n");
    CHECK(json_of("-f rotvec -t cayley --header add", "0 0 0\n") == "{\"cx\":0,\"cy\":0,\"cz\":0}\n");
}

TEST_CASE("json takes fields out of their quotes and escapes them") {
    // Catches strings that no JSON reader takes.
    CHECK(json_of("-f rotvec -t cayley --columns 2-4", "\"a,\"\"b\"\"\",0,0,0,c\\d\n") ==
          "{\"1\":\"a,\\\"b\\\"\",\"5\":\"c\\\\d\",\"cx\":0,\"cy\":0,\"cz\":0}\n");
    CHECK(json_of("-f rotvec -t cayley --columns 2-4 --delimiter comma", "a\tb,0,0,0\n").find('\t') ==
          std::string::npos);
}

TEST_CASE("json prints an infinite result as a string and nan as null") {
    // Catches bare nan and inf, which are no JSON.
    CHECK(json_of("-f quat -t cayley --diagnostics off", "0 0 1 0\n") == "{\"cx\":0,\"cy\":\"inf\",\"cz\":0}\n");
    const auto failed = run("-f rotvec -t cayley --format json --on-error nan --columns 2-4", "a 0 x 0\n");
    CHECK(failed.exit_code == 1);
    CHECK(compact(failed.out) == "{\"1\":\"a\",\"cx\":null,\"cy\":null,\"cz\":null}\n");
}

TEST_CASE("json has the diagnostic columns") {
    // Catches notes without quotes.
    CHECK(json_of("-f quat -t quat --diagnostics columns", "1 0 0 0\n") ==
          "{\"qw\":1,\"qx\":0,\"qy\":0,\"qz\":0,\"margin\":\"inf\",\"condition\":0.5,\"defect\":0,\"notes\":\"\"}\n");
}

TEST_CASE("pretty labels every number") {
    // Catches numbers that have to be counted.
    const auto result = run(convert + "--format pretty", "# note\n\n0.5 -0.25 0.75 0.353553390593273762\n");
    CHECK(result.exit_code == 0);
    CHECK(missing(result.out, {"3", "qx", "qy", "qz", "qw", "0.5", "-0.25", "0.75"}) == "");
    CHECK(missing(result.out, {"note"}) != "");
    CHECK(result.out.find("qx") < result.out.find("-0.25"));
    CHECK(result.out.find("-0.25") < result.out.find("qy"));
}

TEST_CASE("pretty prints a matrix as three rows of three") {
    // Catches nine numbers in a line, and a matrix that is transposed.
    const auto result = run("-f quat -t dcm --format pretty", "0.5 0.5 0.5 0.5\n");
    CHECK(result.exit_code == 0);
    std::vector<Words> matrix;
    for (const auto& line : fields_of(result.out, '\n')) {
        if (words_of(line).size() == 3) {
            matrix.push_back(words_of(line));
        }
    }
    CHECK(matrix == std::vector<Words>{{"0", "0", "1"}, {"1", "0", "0"}, {"0", "1", "0"}});
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

TEST_CASE("a JSON object has no key twice") {
    // Catches fields that a parser would drop.
    const auto result =
        run("-f quat:xyzw -t quat --columns 1-4 --append --format json", "qx,qy,b,\"q\"\"w\",b,b\n0,0,0,1,7,8\n");
    CHECK(result == done("{\"1\": 0, \"2\": 0, \"b\": 0, \"q\\\"w\": 1, \"5\": 7, \"6\": 8, "
                         "\"qw\": 1, \"qx\": 0, \"qy\": 0, \"qz\": 0}\n"));
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
    CHECK(json(by_name, "7,qw,qx,qy,qz\n8,1,0,0,0\n8,1,0,0,0,5,6\n") ==
          "{\"7\": 8, " + result + "{\"1\": 8, \"6\": 5, \"7\": 6, " + result);
    CHECK(json(by_name, "a\xFF,a\xFE,qw,qx,qy,qz\n8,9,1,0,0,0\n") == "{\"a\xEF\xBF\xBD\": 8, \"2\": 9, " + result);
    CHECK(json(by_name, "rx,\"a\",a,qw,qx,qy,qz\n7,8,9,1,0,0,0\n") == "{\"1\": 7, \"a\": 8, \"3\": 9, " + result);
    CHECK(json(by_name, "margin,qw,qx,qy,qz\n8,1,0,0,0\n") == "{\"margin\": 8, " + result);
    CHECK(json(by_name + "--diagnostics columns", "margin,notes,qw,qx,qy,qz\n8,9,1,0,0,0\n")
              .starts_with("{\"1\": 8, \"2\": 9, \"rx\": 0"));
    // a name that is not written takes none away
    CHECK(json("-f quat -t rotvec --columns 1-4", "a,b,c,d,a\n1,0,0,0,8\n") == "{\"a\": 8, " + result);
}
