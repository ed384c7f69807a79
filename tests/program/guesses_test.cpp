// What people type first, and what the program makes of it.

#include "usage.hpp"

using namespace program;

TEST_CASE("a word from elsewhere, or spelled nearly as a legal one, is answered with what it is called here") {
    // Catches the nearest spelling in the place of the meaning, and one that leads to another convention.
    const auto answers = [](const std::string& before, const std::string& after, const std::string& answered) {
        for (const std::string& pair : words_of(answered)) {
            const auto to = pair.find('>');
            check_usage_error(before + pair.substr(0, to) + after,
                              {pair.substr(0, pair.find_first_of("=>")), "did you mean " + pair.substr(to + 1) + "?"});
        }
    };
    answers("-f ", " -t dcm",
            "xyzw>quat:xyzw yaw>rpy qw>quat aa>axis-angle AxisAngle>axis-angle rotmat>dcm rotation_matrix>dcm q>quat "
            "ypr>euler:ZYX euler321>euler:ZYX eulerzyx>euler:zyx ZXZ>euler:ZXZ 313>euler:ZXZ QUAT>quat rotvek>rotvec "
            "quaternoin>quaternion");
    answers(
        "-t quat -f ", "",
        "euler:321>euler:ZYX euler:313:deg>euler:ZXZ euler:rzyx>euler:ZYX euler:rpy>rpy euler:deg:ZYX>euler:ZYX:deg "
        "rpy:ZYX>euler:ZYX dcm:BN>basilisk dcm:transpose>passive quat:scalar-last>xyzw quat:scalar_first>wxyz "
        "quat:scippy>scipy quat:xyzx>xyzw");
    answers("-f quat -t dcm ", "", "--prec>--precision --precison>--precision --degree>--degrees --sep=,>--delimiter");
    answers("-f quat -t dcm --on-error ", "", "nam>nan");
    answers("-f quat -t dcm --format ", "", "jsn>json");
    answers("-f quat -t dcm --diagnostics ", "", "colums>columns");
    answers("rates -f quat ", "", "--inv>--inverse");
    answers("list ", "", "aa>axis-angle quaternoin>quaternion");
    check_usage_error("-f schaub -t dcm", {"basilisk: dcm:passive [BN]; quat", "; for example dcm:basilisk"});
    check_usage_error("-f tum -t dcm", {"tum: quat:xyzw", "; for example quat:tum"});
}

TEST_CASE("the JPL quaternion and wxyz have names of their own") {
    // Catches a spelling that is refused, or says something else.
    CHECK(run("-f quat:jpl -t dcm:jpl 0 0 0.6 0.8") == run("-f quat:trawny -t dcm:trawny 0 0 0.6 0.8"));
    CHECK(run("-f quat:wxyz -t quat 0.8 0 0 0.6") == done("0.8 0 0 0.6\n"));
    CHECK(run("-f quat -t quat:wxyz:passive 0.8 0 0 0.6") == done("0.8 0 0 -0.6\n"));
    check_usage_error("-f mrp:scalar-last -t quat", {"'scalar-last'", "passive"});
    check_usage_error("-f quat:wxyz:xyzw -t dcm", {"quat:wxyz:xyzw", "first and last"});
    check_usage_error("-f quat:tum:wxyz -t dcm", {"quat:tum:wxyz"});
    check_usage_error("-f dcm:wxyz -t quat", {"wxyz", "passive", "col"});
    check_usage_error("-f quat:jpl:tum -t quat", {"tum", "preset"});
}

TEST_CASE("presets are listed, each with what it means") {
    // Catches a preset that can be looked up nowhere.
    CHECK(missing(run("list basilisk").out, {"Schaub", "passive on dcm, 6d, 5d\n"}) == "");
    CHECK(missing(run("list jpl").out, {"passive on dcm, 6d, 5d; xyzw on quat\n"}) == "");
    const auto all = run("list presets");
    CHECK(all.exit_code == 0);
    for (const std::string& preset :
         words_of("scipy ros tum matlab basilisk spice bunge baruh trawny jpl stuelpnagel")) {
        CHECK(missing(all.out, {"\n" + preset + " "}) == "");
        CHECK(run("list " + preset).exit_code == 0);
    }
}

TEST_CASE("the names of a wide header that lacks one are cut") {
    // Catches a message of many kilobytes.
    std::string wide = "t";
    for (int i = 0; i < 1000; ++i) {
        wide += ",n" + std::to_string(i);
    }
    const auto result = run("-f quat -t rpy --columns qw,qx,qy,qzz", wide + "\n");
    CHECK(result == stopped("", {"'qzz'", "1 t, 2 n0, 3 n1,"}));
    CHECK(result.err.size() < 1000);
}
