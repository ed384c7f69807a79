// Files as other programs write them: what stands before their rows, and what is said of it. The formats are theirs,
// the rows are ours.

#include <fmt/format.h>

#include "usage.hpp"

using namespace program;

namespace {

/// What is said of a file that is read as it is.
std::string told(const std::string& options, const std::string& text) {
    const Folder folder;
    const auto file = (folder / "data.log").string();
    write_file(file, text);
    Words words = words_of(options);
    words.push_back(file);
    const auto result = run(words);
    INFO(result);
    CHECK(result.exit_code == 2);
    CHECK(count_rows(result.err) == 1);
    std::string message = result.err;
    for (auto found = message.find(file); found != std::string::npos; found = message.find(file)) {
        message.erase(found, file.size());
        message.insert(found, 1, '@');
    }
    return message;
}

/// An Xsens MT Manager export: remarks, then names and rows parted by tabs.
const std::string xsens = "// Start Time: Unknown\n// Update Rate: 100.0Hz\n// Filter Profile: human (46.1)\n"
                          "PacketCounter\tSampleTimeFine\tQuat_q0\tQuat_q1\tQuat_q2\tQuat_q3\n"
                          "00001\t\t0.5\t0.5\t0.5\t0.5\n00002\t\t1\t0\t0\t0\n";
/// A log of ArduPilot as mavlogdump prints it in columns: descriptions of the rows, then rows of many kinds.
const std::string ardupilot = "FMT, 128, 89, FMT, BBnNZ, Type,Length,Name,Format,Columns\n"
                              "FMT, 129, 31, ATT, QccccCC, TimeUS,DesRoll,Roll,DesPitch,Pitch,DesYaw,Yaw\n"
                              "PARM, 100, SYSID, 1\nATT, 1000, 0.0, 10.0, 0.0, 20.0, 0.0, 30.0\n"
                              "IMU, 1001, 0.1, 0.2, 0.3\nATT, 2000, 0.0, 11.0, 0.0, 21.0, 0.0, 31.0\n";
/// A CCSDS Attitude Ephemeris Message: keywords, then rows of a time and a quaternion.
const std::string aem = "CCSDS_AEM_VERS = 1.0\nCREATION_DATE = 2026-11-01T00:00:00\nORIGINATOR = US\nMETA_START\n"
                        "OBJECT_NAME = BODY\nREF_FRAME_A = EME2000\nREF_FRAME_B = SC_BODY_1\nATTITUDE_DIR = A2B\n"
                        "ATTITUDE_TYPE = QUATERNION\nQUATERNION_TYPE = LAST\nMETA_STOP\nDATA_START\n"
                        "2026-11-01T00:00:00.0 0.5 0.5 0.5 0.5\n2026-11-01T00:00:01.0 0 0 0 1\nDATA_STOP\n";

} // namespace

TEST_CASE("remarks of other programs are no header, and what leaves them out is told") {
    // Catches a remark with as many words as the row has numbers, which passes for a header.
    for (const std::string mark : {"//", "%"}) {
        CHECK(missing(told("-f quat -t rpy", fmt::format("{} made by us\n1 0 0 0\n", mark)),
                      {fmt::format("@:1: not a number: '{}'; ", mark),
                       fmt::format("grep -v '^{}' @ | rotconv ...", mark)}) == "");
        CHECK(run("-f quat -t rpy", fmt::format("{} made by us\n", mark)).out == "");
        CHECK(run("-f quat -t rpy --header yes", fmt::format("{} made by us\n1 0 0 0\n", mark)).exit_code ==
              0); // if you say so
        CHECK(missing(told("-f quat -t rpy --columns qw,qx,qy,qz", fmt::format("{} qw qx qy qz\n1 0 0 0\n", mark)),
                      {"@:1: not a header", fmt::format("sed 's|^{} *||' @ | rotconv ...", mark)}) == "");
        CHECK(run("-f quat -t rpy --columns qw,qx,qy,qz", "qw qx qy qz\n1 0 0 0\n").exit_code == 0);
    }
}

TEST_CASE("keywords before the rows are no header, and what leaves them out is told") {
    // Catches a keyword and its value that pass for two of three names.
    CHECK(missing(told("-f rpy -t quat", "FRAME = BODY\nRATE = FAST\n0 0 0\n"),
                  {"@:1: not a number: 'FRAME'; the first row of numbers is line 3: tail -n +3 @ | rotconv ..."}) ==
          "");
    CHECK(missing(told("-f quat -t rpy", "COMMENT made by us\n\n1 0 0 0\n"), {"tail -n +3 @ |"}) == "");
    CHECK(missing(told("-f quat -t rpy", "recorded today\non a bench\nby us\n1 0 0 0\n"), {"tail -n +4 @ |"}) == "");
    CHECK(run("-f rpy -t quat", "FRAME = BODY\n0 0 0\n").err.find("; the header has") != 0);
    CHECK(missing(run("-f quat -t rpy", "recorded today by\n\nme\n1 0 0 0\n").err, {"tail -n +4 | rotconv ..."}) == "");
}

TEST_CASE("exports of Xsens are read behind the grep that is told") {
    // Catches advice that does not help.
    const std::string options = "-f quat -t rpy -d --columns Quat_q0,Quat_q1,Quat_q2,Quat_q3";
    CHECK(missing(told(options, xsens), {"@:1: ", "grep -v '^//' @ | rotconv ..."}) == "");
    std::string rest = xsens.substr(xsens.find("Packet"));
    CHECK(run(options, rest) ==
          done("PacketCounter\tSampleTimeFine\troll\tpitch\tyaw\n00001\t\t90\t0\t90\n00002\t\t0\t0\t0\n"));
}

TEST_CASE("logs of ArduPilot are read behind the grep that is told") {
    // Catches the description of the rows taken for their header.
    CHECK(missing(told("-f rpy:deg -t quat --columns 4,6,8", ardupilot), {"@:1: ", "grep '^ATT,' @ | rotconv ..."}) ==
          "");
    CHECK(missing(told("-f rpy:deg -t quat --columns Roll,Pitch,Yaw", ardupilot.substr(ardupilot.find("FMT, 129"))),
                  {"@:1: not a header", "grep '^ATT,' @ | rotconv ..."}) == "");
    CHECK(run("-f rpy:deg -t rpy:deg --columns 4,6,8 -p 6", "ATT, 1000, 0.0, 10.0, 0.0, 20.0, 0.0, 30.0\n") ==
          done("ATT, 1000, 0.0,10,20,30, 0.0, 0.0\n"));
}

TEST_CASE("attitude ephemeris messages are read behind the sed that is told") {
    // Catches a tail that keeps the line after the rows.
    const std::string options = "-f quat:xyzw -t rpy:deg --columns 2-5";
    CHECK(missing(told(options, aem), {"@:1: ", "sed -n '/DATA_START/,/DATA_STOP/{//!p}' @ | rotconv ..."}) == "");
    const auto begin = aem.find("DATA_START\n") + 11;
    CHECK(run(options, aem.substr(begin, aem.find("DATA_STOP") - begin)) ==
          done("2026-11-01T00:00:00.0 90 0 90\n2026-11-01T00:00:01.0 0 0 0\n"));
}

TEST_CASE("a header that is wider or narrower than the rows is told of, with what to add") {
    // Catches a message about the row alone.
    CHECK(missing(told("-f quat -t rpy", "t,qw,qx,qy,qz\n1,0,0,0\n"),
                  {"@:1: ", "the header has 5 names and the rows 4 fields: add --header yes\n"}) == "");
    CHECK(run("-f quat -t rpy --header yes", "t,qw,qx,qy,qz\n1,0,0,0\n") == done("roll,pitch,yaw\n0,0,0\n"));
    CHECK(missing(told("-f quat -t rpy", "qw,qx,qy,qz\n7,1,0,0,0\n"),
                  {"@:2: ", "the header has 4 names and the rows 5 fields: add --header yes --columns LIST\n"}) == "");
    CHECK(run("-f quat -t rpy --header yes --columns 2-5", "qw,qx,qy,qz\n7,1,0,0,0\n").out.ends_with("\n7,0,0,0\n"));
    CHECK(missing(told("-f quat -t rpy --columns 5-8", "a,b,c,d,w,x,y,z\n1,0,0,0\n"),
                  {"@:2: no column 5", "the header has 8 names and the rows 4 fields\n"}) == "");
}

TEST_CASE("files with decimal commas are told so") {
    // Catches a message that leaves it to the reader to see it.
    for (const std::string rows : {"0,5;0,5;0,5;0,5\n", "qw;qx;qy;qz\n0,5;0,5;0,5;0,5\n", "0,5\t0,5\t0,5\t0,5\n"}) {
        CHECK(missing(told("-f quat -t rpy", rows), {"decimal commas into points: tr , . < @ | rotconv ..."}) == "");
    }
    CHECK(missing(told("-f quat -t rpy --delimiter semicolon", "0,5;0,5;0,5;0,5\n"), {"'0,5'; ", "decimal commas"}) ==
          "");
    CHECK(run("-f quat -t rpy -d", "0.5;0.5;0.5;0.5\n") == done("90;0;90\n"));
}

TEST_CASE("advice is for the beginning of a file") {
    // Catches a word about a header where a row far below is bad, or where there is nothing to advise.
    for (const std::string rows :
         {"1 0 0 0\n% 1 0 0\n", "1 0 0 x\n", "1 0 0 0\n1 0 0\n", "qw qx qy qz\n1 0 0 0\n// a b c\n"}) {
        CHECK(told("-f quat -t rpy", rows).find(';') == std::string::npos);
    }
    const auto result = run("-f quat -t rpy --on-error skip", "% a b c\n% d e f\n1 0 0 0\n");
    CHECK(result.out == "0 0 0\n");
    CHECK(count_rows(result.err) == 2);
    CHECK(run("-f quat -t rpy % 0 0 0").exit_code == 2);
}
