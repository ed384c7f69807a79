#include <catch.hpp>

#include "process.hpp"

using namespace program;

namespace {

const std::string convert = "-f quat -t quat:xyzw ";

} // namespace

TEST_CASE("columns are taken in the order of the list") {
    // Catches columns sorted by their place in the row.
    CHECK(run(convert + "--columns 4,3,2,1", "0.5,0.5,-0.5,0.5\n") == done("-0.5,0.5,0.5,0.5\n"));
    CHECK(run(convert + "--columns 5,2-4", "7 0 0 0 1\n") == done("7 0 0 0 1\n"));
    CHECK(run(convert + "--columns 1-2,5-6", "1,0,a,b,0,0\n") == done("0,0,0,1,a,b\n"));
    CHECK(run("-f rotvec -t cayley --columns 3-3,1-1,2", "0 0 0\n") == done("0 0 0\n"));
}

TEST_CASE("the result stands where the leftmost selected column stood") {
    // Catches a result at the front, at the end, or where the first item of the list stood.
    CHECK(run(convert + "--columns 2-5", "a,1,0,0,0,b\n") == done("a,0,0,0,1,b\n"));
    CHECK(run(convert + "--columns 6,4,2,8", "a,0,b,0,c,1,d,0,e\n") == done("a,0,0,0,1,b,c,d,e\n"));
    CHECK(run("-f rotvec -t dcm --columns 3,4,2", "a 0 0 0 b\n") == done("a 1 0 0 0 1 0 0 0 1 b\n"));
    CHECK(run("-f dcm -t rotvec --columns 2-10", "a 1 0 0 0 1 0 0 0 1 b\n") == done("a 0 0 0 b\n"));
}

TEST_CASE("other fields pass byte for byte") {
    // Catches numbers that are written anew, blanks that are trimmed and quotes that are lost.
    CHECK(run(convert + "--columns 3-6", "1403636579763555584, 0010.500 ,1,0,0,0,\"x\",,1e5,-0.0, \n") ==
          done("1403636579763555584, 0010.500 ,0,0,0,1,\"x\",,1e5,-0.0, \n"));
}

TEST_CASE("rows may have different numbers of other fields") {
    // Catches a number of columns that is taken from the first row.
    CHECK(run(convert + "--columns 1-4", "1,0,0,0\n1,0,0,0,a\n1,0,0,0,a,b,c\n1,0,0,0,\n") ==
          done("0,0,0,1\n0,0,0,1,a\n0,0,0,1,a,b,c\n0,0,0,1,\n"));
}

TEST_CASE("append keeps the row and adds the result at its end") {
    // Catches a row that is put together anew, and a delimiter after trailing blanks.
    CHECK(run(convert + "--append", "1,0,0,0\n") == done("1,0,0,0,0,0,0,1\n"));
    CHECK(run(convert + "--append", "+1.0 , 0e0,0,0  \t\n") == done("+1.0 , 0e0,0,0,0,0,0,1\n"));
    CHECK(run(convert + "--append", "  1   0 0  0  \n") == done("  1   0 0  0 0 0 0 1\n"));
    CHECK(run(convert + "--append --columns 2-5", "a;1;0;0;0;b\n") == done("a;1;0;0;0;b;0;0;0;1\n"));
}

TEST_CASE("append keeps an empty last field") {
    // Catches a tab that parts the fields taken for a blank at the end.
    CHECK(run("-f quat -t mrp --columns 1-4 --append --header no", "1\t0\t0\t0\t\n0\t1\t0\t0\tx\n").out ==
          "1\t0\t0\t0\t\t0\t0\t0\n0\t1\t0\t0\tx\t1\t0\t0\n");
}

TEST_CASE("without a selection a row has exactly the numbers") {
    // Catches surplus fields that are dropped and missing ones that are made up.
    for (const char* row : {"1,0,0", "1,0,0,0,0", "1,0,0,0,", ",1,0,0,0", "1"}) {
        const auto result = run(convert, std::string("1,0,0,0\n") + row + "\n");
        CHECK(result.exit_code == 2);
        CHECK(result.out == "0,0,0,1\n");
        CHECK(missing(result.err, {"rotconv: -:2: ", row}) == "");
    }
}

TEST_CASE("a row without a selected column is a row error") {
    // Catches a read past the end of the row.
    const auto result = run(convert + "--columns 2-5", "a,1,0,0,0\nb,1,0,0\n");
    CHECK(result.exit_code == 2);
    CHECK(result.out == "a,0,0,0,1\n");
    CHECK(missing(result.err, {"rotconv: -:2: ", "b,1,0,0"}) == "");
    CHECK(run(convert + "--columns 4194300-4194303", "1,0,0,0\n").exit_code == 2);
}

TEST_CASE("a list of another length than the numbers is a usage error") {
    // Catches surplus items that are dropped.
    for (const char* list : {"1", "1-3", "1-5", "1,2,3", "1,2,3,4,5", "qw,qx,qy", "1-1000000000"}) {
        const auto result = run(convert + "--columns " + list, "1,0,0,0\n");
        CHECK(result.exit_code == 2);
        CHECK(result.out == "");
        CHECK(missing(result.err, {"rotconv: ", "--columns"}) == "");
        CHECK(count_rows(result.err) == 1);
    }
}

TEST_CASE("a column that is selected twice is a usage error") {
    // Catches overlap of ranges, of names, and of names with indices.
    for (const char* list : {"1,1,2,3", "1-3,3", "2-4,2", "qw,qw,qx,qy"}) {
        const auto result = run(convert + "--columns " + list, "1,0,0,0\n");
        CHECK(result.exit_code == 2);
        CHECK(result.out == "");
    }
    const auto mixed = run(convert + "--columns qw,1,2,3", "qw,qx,qy,qz\n1,0,0,0\n");
    CHECK(mixed.exit_code == 2);
    CHECK(missing(mixed.out, {"0,0,0,1"}) != "");
}

TEST_CASE("an item that is no index nor range is a usage error") {
    // Catches index 0, ranges that run backwards and empty items.
    for (const char* list : {"0-3", "0,1,2,3", "4-1", "1,2,,3", ",1-4", "1-4,", "99999999999999999999,1,2,3"}) {
        const auto result = run(convert + "--columns " + list, "1,0,0,0\n");
        CHECK(result.exit_code == 2);
        CHECK(result.out == "");
        CHECK(missing(result.err, {"rotconv: "}) == "");
    }
}

TEST_CASE("digits are an index even where a column is called so") {
    // Catches a header of numbers that changes the meaning of the list.
    CHECK(run(convert + "--columns 1-4 --header yes", "4,3,2,1\n1,0,0,0\n") == done("qx,qy,qz,qw\n0,0,0,1\n"));
    CHECK(run(convert + "--columns 1,2,3,4 --header yes", "4,3,2,1\n1,0,0,0\n") == done("qx,qy,qz,qw\n0,0,0,1\n"));
}

TEST_CASE("canonical names in another order than the SPEC's are a usage error") {
    // Catches a wrong attitude in silence, and advice that does not help.
    struct Case {
        const char* from;
        const char* names;
        const char* right; ///< the SPEC that the message names; null: there is none
    };
    for (const Case& c :
         {Case{"quat", "qx,qy,qz,qw", "the order of quat:xyzw ("},
          Case{"quat:passive", "qx,qy,qz,qw", "the order of quat:xyzw:passive ("},
          Case{"quat:ros", "qw,qx,qy,qz", "the order of quat ("}, Case{"quat", "qx,qw,qy,qz", nullptr},
          Case{"dcm", "r11,r21,r31,r12,r22,r32,r13,r23,r33", "the order of dcm:col ("},
          Case{"dcm:col", "r11,r12,r13,r21,r22,r23,r31,r32,r33", "the order of dcm ("},
          Case{"dcm", "r12,r11,r13,r21,r22,r23,r31,r32,r33", nullptr},
          Case{"rpy:deg", "yaw,pitch,roll", "the order of euler:ZYX:deg ("},
          Case{"euler:ZYX", "roll,pitch,yaw", "the order of rpy ("}, Case{"rpy", "pitch,roll,yaw", nullptr}}) {
        INFO(c.from << ' ' << c.names);
        const auto result =
            run(std::string("-t rotvec -f ") + c.from + " --columns " + c.names, std::string(c.names) + "\n");
        CHECK(result.exit_code == 2);
        CHECK(result.out == "");
        CHECK(count_rows(result.err) == 1);
        CHECK(missing(result.err, {"rotconv: --columns", c.names, "by index"}) == "");
        CHECK((result.err.find("it is the order of ") != std::string::npos) == (c.right != nullptr));
        CHECK(missing(result.err, {c.right != nullptr ? c.right : ""}) == "");
    }
    CHECK(run("rates -f quat --columns qx,qy,qz,qw,wx,wy,wz", "1,0,0,0,0,0,0\n").exit_code == 2);
    CHECK(run("survey -f quat --columns qx,qy,qz,qw", "1,0,0,0\n").exit_code == 2);
}

TEST_CASE("names in the SPEC's order are taken, and so are others") {
    // Catches an error where nothing is wrong.
    CHECK(run("-f quat:tum -t quat --columns qx,qy,qz,qw", "qw,qx,qy,qz\n1,0,0,0\n") == done("qw,qx,qy,qz\n1,0,0,0\n"));
    for (const char* arguments : {"-f euler:ZYX --columns yaw,pitch,roll", "-f euler:zyx --columns yaw,pitch,roll",
                                  "-f euler:XYZ --columns roll,pitch,yaw", "-f euler:ZXZ --columns yaw,pitch,roll"}) {
        CHECK(run(std::string("-t rotvec ") + arguments, "yaw,pitch,roll\n0,1,0\n").exit_code == 0);
    }
    CHECK(run("-f axis-angle -t quat --columns qx,qy,qz,qw", "qw,qx,qy,qz\n0,1,0,0\n").exit_code == 0);
    CHECK(run("-f quat -t quat --columns x,y,z,w", "x,y,z,w\n1,0,0,0\n").exit_code == 0);
    CHECK(run("-f quat -t quat --columns qx,qy,qz,4", "qx,qy,qz,qw\n1,0,0,0\n").exit_code == 0);
}
