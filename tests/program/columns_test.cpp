#include <catch.hpp>

#include "process.hpp"

using namespace program;

TEST_CASE("without a selection a row has exactly the numbers") {
    // Catches surplus fields that are dropped and missing ones that are made up.
    for (const char* row : {"1,0,0", "1,0,0,0,0", "1,0,0,,", ",1,0,0,0", "1"}) {
        CHECK(run(reorder, std::string("1,0,0,0\n") + row + "\n") == stopped("0,0,0,1\n", {"rotconv: -:2: ", row}));
    }
}

TEST_CASE("a list of another length than the numbers is a usage error") {
    // Catches surplus items that are dropped.
    for (const char* list : {"1", "1-3", "1-5", "1,2,3", "1,2,3,4,5", "qw,qx,qy", "1-1000000000"}) {
        CHECK(run(reorder + "--columns " + list, "1,0,0,0\n") == stopped("", {"rotconv: ", "--columns"}));
    }
}

TEST_CASE("a column that is selected twice is a usage error") {
    // Catches overlap of ranges, of names, and of names with indices.
    for (const char* list : {"1,1,2,3", "1-3,3", "2-4,2", "qw,qw,qx,qy"}) {
        CHECK(run(reorder + "--columns " + list, "1,0,0,0\n") == stopped(""));
    }
    const auto mixed = run(reorder + "--columns qw,1,2,3", "qw,qx,qy,qz\n1,0,0,0\n");
    CHECK(mixed.exit_code == 2);
    CHECK(missing(mixed.out, {"0,0,0,1"}) != "");
}

TEST_CASE("an item that is no index nor range is a usage error") {
    // Catches index 0, ranges that run backwards and empty items.
    for (const char* list : {"0-3", "0,1,2,3", "4-1", "1,2,,3", ",1-4", "1-4,", "99999999999999999999,1,2,3"}) {
        CHECK(run(reorder + "--columns " + list, "1,0,0,0\n") == stopped("", {"rotconv: "}));
    }
}

TEST_CASE("canonical names in another order than the SPEC's are a usage error") {
    // Catches a wrong attitude in silence, and advice that does not help.
    struct Case {
        const char* from;
        const char* names;
        const char* right; ///< the SPEC that the message names, if there is one
    };
    for (const Case& c :
         {Case{"quat", "qx,qy,qz,qw", "the order of quat:xyzw ("},
          Case{"quat:passive", "qx,qy,qz,qw", "the order of quat:xyzw:passive ("},
          Case{"quat:ros", "qw,qx,qy,qz", "the order of quat ("}, Case{"quat", "qx,qw,qy,qz", ""},
          Case{"dcm", "r11,r21,r31,r12,r22,r32,r13,r23,r33", "the order of dcm:col ("},
          Case{"dcm:col", "r11,r12,r13,r21,r22,r23,r31,r32,r33", "the order of dcm ("},
          Case{"dcm", "r12,r11,r13,r21,r22,r23,r31,r32,r33", ""},
          Case{"rpy:deg", "yaw,pitch,roll", "the order of euler:ZYX:deg ("},
          Case{"euler:ZYX", "roll,pitch,yaw", "the order of rpy ("}, Case{"rpy", "pitch,roll,yaw", ""}}) {
        INFO(c.from << ' ' << c.names);
        const auto result =
            run(std::string("-t rotvec -f ") + c.from + " --columns " + c.names, std::string(c.names) + "\n");
        CHECK(result == stopped("", {"rotconv: --columns", c.names, "by index", c.right}));
        CHECK((missing(result.err, {"it is the order of "}) == "") == (*c.right != '\0'));
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
    CHECK(run("-f quat -t quat --columns qx,qy,qz,4", "qx,qy,qz,qw\n1,0,0,0\n").exit_code == 0);
}

TEST_CASE("numbers that are scanned where they stand come out as those whose fields are split") {
    // Catches a field or a line end that is lost around them. The numbers of the second row of each pair have a blank,
    // or quotes, so that its fields are split.
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
