// What people type first, and what the program makes of it.

#include "usage.hpp"

using namespace program;

TEST_CASE("a name from elsewhere is answered with what it is called here") {
    // Catches the nearest spelling in the place of the meaning.
    const auto from = [](const std::string& spec, const std::string& meant) {
        check_usage_error("-f " + spec + " -t dcm", {"'" + spec + "'", "did you mean " + meant + "?"});
    };
    const auto from_project = [](const std::string& name, const std::string& numbers, const std::string& preset) {
        check_usage_error("-f " + name + " -t dcm", {name + ": " + numbers, "; for example " + preset});
    };
    from_project("tum", "quat:xyzw", "quat:tum");
    from_project("matlab", "dcm:passive", "dcm:matlab");
    from_project("ros", "quat:xyzw geometry_msgs/Quaternion; rpy setRPY", "quat:ros");
    from_project("bunge", "euler:ZXZ", "euler:bunge");
    check_usage_error("-f schaub -t dcm", {"basilisk: dcm:passive [BN]; quat", "; for example dcm:basilisk"});
    from("xyzw", "quat:xyzw");
    from("yaw", "rpy");
    from("qw", "quat");
    from("aa", "axis-angle");
    from("AxisAngle", "axis-angle");
    from("rotmat", "dcm");
    from("rotation_matrix", "dcm");
    from("q", "quat");
    from("ypr", "euler:ZYX");
    from("euler321", "euler:ZYX");
    from("eulerzyx", "euler:zyx");
    from("ZXZ", "euler:ZXZ");
    from("313", "euler:ZXZ");
    check_usage_error("list aa", {"did you mean axis-angle?"});
}

TEST_CASE("a sequence or a modifier in other words is answered with the known ones") {
    // Catches a spelling that leads to another convention.
    const auto part = [](const std::string& spec, const std::string& meant) {
        check_usage_error("-f " + spec + " -t quat", {"did you mean " + meant + "?"});
    };
    part("euler:321", "euler:ZYX");
    part("euler:313:deg", "euler:ZXZ");
    part("euler:rzyx", "euler:ZYX");
    part("euler:sxyz", "euler:xyz");
    part("euler:ypr", "euler:ZYX");
    part("euler:rpy", "rpy");
    part("euler:deg:ZYX", "euler:ZYX:deg");
    part("rpy:ZYX", "euler:ZYX");
    part("dcm:BN", "basilisk");
    part("dcm:transpose", "passive");
    part("quat:scalar-last", "xyzw");
    part("quat:scalar_first", "wxyz");
    part("quat:scippy", "scipy");
    check_usage_error("-f rpy:rad -t quat", {"'rad'", "leave it out"});
    check_usage_error("-f mrp:scalar-last -t quat", {"'scalar-last'", "passive"});
}

TEST_CASE("the JPL quaternion and wxyz have names of their own") {
    // Catches a spelling that is refused, or says something else.
    CHECK(run("-f quat:jpl -t dcm:jpl 0 0 0.6 0.8") == run("-f quat:trawny -t dcm:trawny 0 0 0.6 0.8"));
    CHECK(run("-f quat:wxyz -t quat 0.8 0 0 0.6") == done("0.8 0 0 0.6\n"));
    CHECK(run("-f quat -t quat:wxyz:passive 0.8 0 0 0.6") == done("0.8 0 0 -0.6\n"));
    check_usage_error("-f quat:wxyz:xyzw -t dcm", {"quat:wxyz:xyzw", "first and last"});
    check_usage_error("-f quat:tum:wxyz -t dcm", {"quat:tum:wxyz"});
    check_usage_error("-f dcm:wxyz -t quat", {"wxyz", "passive", "col"});
    check_usage_error("-f quat:jpl:tum -t quat", {"tum", "preset"});
}

TEST_CASE("an option that is begun, or called otherwise elsewhere, is answered with its name") {
    // Catches the nearest spelling of another option, or none.
    check_usage_error("-f quat -t dcm --prec 3", {"'--prec'", "did you mean --precision?"});
    check_usage_error("-f quat -t dcm --deg", {"did you mean --degrees?"});
    check_usage_error("-f quat -t dcm --json", {"did you mean --format json?"});
    check_usage_error("-f quat -t dcm --sep=,", {"did you mean --delimiter?"});
    check_usage_error("-f quat -t dcm --quiet", {"did you mean --diagnostics off?"});
    check_usage_error("rates -f quat --inv", {"did you mean --inverse?"});
}

TEST_CASE("the help groups the options and names modifiers, presets and exit codes") {
    // Catches a help that has to be read from end to end.
    const auto help = run("--help");
    CHECK(help.exit_code == 0);
    std::size_t at = 0;
    for (const char* group : {"\nWhat:\n", "\nColumns:\n", "\nOutput:\n", "\nErrors:\n", "\nMore:\n"}) {
        INFO(group);
        at = help.out.find(group, at);
        REQUIRE(at != std::string::npos);
    }
    CHECK(missing(help.out, {" passive deg col xyzw wxyz positive\n",
                             " scipy ros tum matlab basilisk spice bunge baruh trawny jpl ", "rotconv list presets",
                             "0  ", "1  ", "2  "}) == "");
    CHECK(help.out.find("\n\n\n") == std::string::npos);
    for (const char* command : {"rates", "propagate", "survey", "compare", "identify"}) {
        const auto one = run(command + std::string(" --help")).out;
        CHECK(missing(one, {"What:\n", "Columns:\n", "Errors:\n", "More:\n"}) == "");
        CHECK(one.find("\nOptions:\n") == std::string::npos);
    }
}

TEST_CASE("list explains presets") {
    // Catches a preset that can be looked up nowhere.
    const auto one = run("list basilisk");
    CHECK(one.exit_code == 0);
    CHECK(missing(one.out, {"basilisk", "Schaub", "passive on dcm, 6d, 5d\n"}) == "");
    CHECK(missing(run("list jpl").out, {"passive on dcm, 6d, 5d; xyzw on quat\n"}) == "");
    const auto all = run("list presets");
    CHECK(all.exit_code == 0);
    for (const char* preset :
         {"scipy", "ros", "tum", "matlab", "basilisk", "spice", "bunge", "baruh", "trawny", "jpl", "stuelpnagel"}) {
        CHECK(missing(all.out, {preset}) == "");
        CHECK(run(std::string("list ") + preset).exit_code == 0);
    }
    check_usage_error("list presets quat", {"quat"});
}

TEST_CASE("names that no header has are answered with those that it has") {
    // Catches a header that has to be looked up by hand.
    const auto lines = [](const std::string& input) {
        const auto result = run("-f quat -t rpy --columns qw,qx,qy,qzz", input);
        CHECK(result.exit_code == 2);
        CHECK(count_rows(result.err) == 1);
        return result.err;
    };
    CHECK(missing(lines("t,qw,qx,qy,qz\n0,1,0,0,0\n"),
                  {"-:1: ", "'qzz'", "1 t, 2 qw, 3 qx, 4 qy, 5 qz: 't,qw,qx,qy,qz'\n"}) == "");
    CHECK(missing(lines("#timestamp [ns],q_RS_w [],q_RS_x []\n1,2,3\n"),
                  {"'qw', 'qx', 'qy', 'qzz'", "1 timestamp [ns], 2 q_RS_w [], 3 q_RS_x []: '1,2,3'\n"}) == "");
    CHECK(missing(lines("# a remark\n1,0,0,0\n"), {"-:2: ", "(it has none): '1,0,0,0'\n"}) == "");
    std::string wide = "t";
    for (int i = 0; i < 1000; ++i) {
        wide += ",n" + std::to_string(i);
    }
    CHECK(lines(wide + "\n").size() < 1000);
}

TEST_CASE("columns of one name are answered with their indices") {
    // Catches the second step of a pipe that does not know how to go on.
    const std::string first = run("-f quat -t rpy --columns 1-4 --append", "qw,qx,qy,qz\n1,0,0,0\n").out;
    const std::string second = run("-f quat -t rpy --columns 1-4 --append", first).out;
    CHECK(run("-f rpy -t quat --columns roll,pitch,yaw", second) ==
          stopped(any_output, {"-:1: ", "more than one column is called 'roll': 5 and 8;", "by index"}));
    CHECK(run("-f rpy -t quat --columns 8-10", second).exit_code == 0);
}
