#include <catch.hpp>

#include "process.hpp"

using namespace program;

namespace {

const std::string convert = "-f quat -t quat:xyzw ";

} // namespace

TEST_CASE("a first row without numbers is the header") {
    // Catches a header that is an error, lost, or left with the old names.
    CHECK(run(convert, "qw,qx,qy,qz\n1,0,0,0\n") == done("qx,qy,qz,qw\n0,0,0,1\n"));
    CHECK(run("-f quat -t cayley", "a b c d\n1 0 0 0\n") == done("cx cy cz\n0 0 0\n"));
    CHECK(run("-f quat -t euler:ZYX", "a;b;c;d\r\n1;0;0;0\r\n") == done("e1;e2;e3\r\n0;0;0\r\n"));
    CHECK(run(convert, "# note\n\nqw,qx,qy,qz\n1,0,0,0\n") == done("# note\n\nqx,qy,qz,qw\n0,0,0,1\n"));
}

TEST_CASE("only the selected fields tell a header from data") {
    // Catches a look at the whole row.
    CHECK(run(convert + "--columns 2-5", "2024,w,x,y,z\n1,1,0,0,0\n") == done("2024,qx,qy,qz,qw\n1,0,0,0,1\n"));
    CHECK(run(convert + "--columns 2-5", "time,1,0,0,0\nx,0,1,0,0\n") == done("time,0,0,0,1\nx,1,0,0,0\n"));
}

TEST_CASE("a first row with one number is data") {
    // Catches a broken first row that is taken for a header in silence.
    for (const char* row : {"1,x,y,z", "w,x,y,0", "nan,x,y,z", "w,inf,y,z", "w,x,-1e400,z"}) {
        const auto result = run(convert, std::string(row) + "\n1,0,0,0\n");
        CHECK(result.exit_code == 2);
        CHECK(result.out == "");
        CHECK(missing(result.err, {"rotconv: -:1: "}) == "");
    }
}

TEST_CASE("only the first row can be the header") {
    // Catches a second row of words that is let through.
    const auto result = run(convert, "qw,qx,qy,qz\nqw,qx,qy,qz\n1,0,0,0\n");
    CHECK(result.exit_code == 2);
    CHECK(result.out == "qx,qy,qz,qw\n");
    CHECK(missing(result.err, {"rotconv: -:2: "}) == "");
}

TEST_CASE("header yes takes any first row") {
    // Catches a header of numbers that is converted.
    CHECK(run(convert + "--header yes", "1,2,3,4\n1,0,0,0\n") == done("qx,qy,qz,qw\n0,0,0,1\n"));
    CHECK(run(convert + "--header yes --columns 2-5", "10,20,30,40,50\n1,1,0,0,0\n") ==
          done("10,qx,qy,qz,qw\n1,0,0,0,1\n"));
}

TEST_CASE("header no takes none") {
    // Catches words that vanish although the user said that all is data.
    const auto result = run(convert + "--header no", "qw,qx,qy,qz\n1,0,0,0\n");
    CHECK(result.exit_code == 2);
    CHECK(result.out == "");
    CHECK(missing(result.err, {"rotconv: -:1: ", "qw"}) == "");
    CHECK(run(convert + "--header no", "1,0,0,0\n") == done("0,0,0,1\n"));
}

TEST_CASE("header add prints one where there was none") {
    // Catches a missing header, and a first row that is lost to it.
    CHECK(run(convert + "--header add", "1,0,0,0\n") == done("qx,qy,qz,qw\n0,0,0,1\n"));
    CHECK(run("-f quat -t rotvec --header add", "1 0 0 0\n1 0 0 0\n") == done("rx ry rz\n0 0 0\n0 0 0\n"));
    CHECK(run(convert + "--header add", "1;0;0;0\r\n") == done("qx;qy;qz;qw\r\n0;0;0;1\r\n"));
}

TEST_CASE("header add names other columns by their index") {
    // Catches numbering of the output columns in place of the input columns.
    CHECK(run(convert + "--header add --columns 2-5", "t,1,0,0,0,x\n") == done("1,qx,qy,qz,qw,6\nt,0,0,0,1,x\n"));
    CHECK(run("-f rotvec -t quat --header add --columns 2,4,6", "a,0,b,0,c,0,d\n") ==
          done("1,qw,qx,qy,qz,3,5,7\na,1,0,0,0,b,c,d\n"));
    CHECK(run("-f rotvec -t quat --header add --append", "0,0,0\n") == done("1,2,3,qw,qx,qy,qz\n0,0,0,1,0,0,0\n"));
}

TEST_CASE("header add treats a first row of words as data") {
    // Catches two headers.
    const auto result = run(convert + "--header add", "qw,qx,qy,qz\n1,0,0,0\n");
    CHECK(result.exit_code == 2);
    CHECK(missing(result.err, {"rotconv: -:1: "}) == "");
}

TEST_CASE("names find their columns in the header") {
    // Catches an order taken from the file and not from the list.
    CHECK(run(convert + "--columns qw,qx,qy,qz", "t,qx,qy,qz,qw,note\n7,0,0,0,1,a\n") ==
          done("t,qx,qy,qz,qw,note\n7,0,0,0,1,a\n"));
    CHECK(run(convert + "--columns a,b,c,d", "d;c;b;a;x\n0.5;0.5;-0.5;0.5;9\n") ==
          done("qx;qy;qz;qw;x\n-0.5;0.5;0.5;0.5;9\n"));
    CHECK(run(convert + "--columns w,2-4", "t,x,y,z,w\n7,0,0,0,1\n") == done("t,qx,qy,qz,qw\n7,0,0,0,1\n"));
}

TEST_CASE("names are matched after blanks and quotes are trimmed") {
    // Catches a comparison of raw fields.
    CHECK(run(convert + "--columns qw,qx,qy,qz", " t , qw , qx,qy ,\tqz\n7,1,0,0,0\n") ==
          done(" t ,qx,qy,qz,qw\n7,0,0,0,1\n"));
    CHECK(run(convert + "--columns qw,qx,qy,qz", "\"qw\",\"qx\",\"qy\",\"qz\",\"a,b\"\n1,0,0,0,x\n") ==
          done("qx,qy,qz,qw,\"a,b\"\n0,0,0,1,x\n"));
}

TEST_CASE("names are case sensitive") {
    // Catches QW taken for qw.
    const auto result = run(convert + "--columns qw,qx,qy,qz", "QW,QX,QY,QZ\n1,0,0,0\n");
    CHECK(result.exit_code == 2);
    CHECK(result.out == "");
}

TEST_CASE("a name matches up to the first blank of a header field") {
    // Catches units that hide a column, as in EuRoC's ground truth.
    const std::string names = "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],";
    CHECK(run(convert + "--columns q_RS_w,q_RS_x,q_RS_y,q_RS_z",
              names +
                  "q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\n1403636580838555648,4.68,-1.78,0.78,0.5,-0.5,0.5,0.5\n") ==
          done(names + "qx,qy,qz,qw\n1403636580838555648,4.68,-1.78,0.78,-0.5,0.5,0.5,0.5\n"));
    CHECK(run(convert + "--columns q_RS_w,q_RS_x,q_RS_y,q_RS_z",
              "# t, q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z []\r\n"
              "7,1,0,0,0\r\n") == done("# t,qx,qy,qz,qw\r\n7,0,0,0,1\r\n"));
}

TEST_CASE("a header may begin with a number sign") {
    // Catches a first name that is not found behind it, or a header that is no comment any more.
    CHECK(run(convert + "--columns qw,qx,qy,qz", "# t qw qx qy qz note\n7 1 0 0 0 a\n") ==
          done("# t qx qy qz qw note\n7 0 0 0 1 a\n"));
    for (const std::string sign : {"#", "# ", "#  ", "#\t"}) {
        CHECK(run(convert + "--columns qw,qx,qy,qz", sign + "qw,qx,qy,qz,t\n1,0,0,0,7\n") ==
              done(sign + "qx,qy,qz,qw,t\n0,0,0,1,7\n"));
    }
}

TEST_CASE("comments before the header with the names pass") {
    // Catches the first comment taken for the header.
    CHECK(run(convert + "--columns qw,qx,qy,qz", "# ground truth\n# t qw qx\n\n# t qw qx qy qz\n7 1 0 0 0\n# end\n") ==
          done("# ground truth\n# t qw qx\n\n# t qx qy qz qw\n7 0 0 0 1\n# end\n"));
}

TEST_CASE("names without a header before the data are an error") {
    // Catches columns made up by guessing.
    for (const char* rows :
         {"7,1,0,0,0\n", "t,w,x,y,z\n7,1,0,0,0\n", "# t,qw,qx,qy\n7,1,0,0,0\n", "7,1,0,0,0\nt,qw,qx,qy,qz\n"}) {
        const auto result = run(convert + "--columns qw,qx,qy,qz", rows);
        CHECK(result.exit_code == 2);
        CHECK(missing(result.out, {"0,0,0,1"}) != "");
        CHECK(missing(result.err, {"rotconv: ", "qz"}) == "");
    }
}

TEST_CASE("names with header no or add are a usage error") {
    // Catches a header that the user said was not there.
    for (const char* mode : {"no", "add"}) {
        const auto result = run(convert + "--columns qw,qx,qy,qz --header " + mode, "qw,qx,qy,qz\n1,0,0,0\n");
        CHECK(result.exit_code == 2);
        CHECK(result.out == "");
    }
}

TEST_CASE("a header alone is still a header") {
    // Catches a header that waits for a data row.
    CHECK(run(convert, "qw,qx,qy,qz\n") == done("qx,qy,qz,qw\n"));
    CHECK(run(convert + "--columns qw,qx,qy,qz", "t,qw,qx,qy,qz\n") == done("t,qx,qy,qz,qw\n"));
}

TEST_CASE("a header under append keeps all names") {
    // Catches a header with another number of columns than the rows.
    CHECK(run(convert + "--append --columns qw,qx,qy,qz", "t,qw,qx,qy,qz\n7,1,0,0,0\n") ==
          done("t,qw,qx,qy,qz,qx,qy,qz,qw\n7,1,0,0,0,0,0,0,1\n"));
    CHECK(run("-f quat -t cayley --append", "a b c d  \n1 0 0 0  \n") == done("a b c d cx cy cz\n1 0 0 0 0 0 0\n"));
}

TEST_CASE("diagnostic columns are named after the result") {
    // Catches names that do not stand over their columns.
    CHECK(run(convert + "--diagnostics columns --columns 2-5", "t,w,x,y,z,n\n7,1,0,0,0,a\n") ==
          done("t,qx,qy,qz,qw,margin,condition,defect,notes,n\n7,0,0,0,1,inf,0.5,0,,a\n"));
}
