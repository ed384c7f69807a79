// What people type first, and what the program makes of it.

#include "usage.hpp"

using namespace program;

TEST_CASE("a name from elsewhere is answered with what it is called here") {
    // Catches the nearest spelling in the place of the meaning.
    const auto from = [](const std::string& spec, const std::string& meant) {
        check_usage_error("-f " + spec + " -t dcm", {"'" + spec + "'", "did you mean " + meant + "?"});
    };
    from("tum", "quat:tum");
    from("matlab", "dcm:matlab");
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
    check_usage_error("-f quat -t yaw", {"yaw is a column of rpy"});
    check_usage_error("-f tum -t dcm", {"tum is a preset of quat"});
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
    check_usage_error("-f rpy:rad -t quat", {"'rad'", "without a modifier"});
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
