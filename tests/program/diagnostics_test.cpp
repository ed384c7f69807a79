#include <cmath>
#include <limits>
#include <numbers>

#include <catch.hpp>

#include "process.hpp"

using namespace program;

namespace {

/// The four diagnostic columns of one row.
struct Figures {
    double margin;
    double condition;
    double defect;
    std::string notes;
};

Figures figures_of(const std::string& arguments) {
    INFO("rotconv " << arguments);
    const auto result = run("--diagnostics columns " + arguments);
    CHECK(result.exit_code == 0);
    CHECK(result.err == "");
    const auto fields = fields_of(result.out, ' ');
    REQUIRE(fields.size() > 4);
    const auto* last = &fields[fields.size() - 4];
    return {std::stod(last[0]), std::stod(last[1]), std::stod(last[2]), last[3]};
}

constexpr double pi = std::numbers::pi;
const double root2 = std::sqrt(2.0);
constexpr double infinity = std::numeric_limits<double>::infinity();

/// For numbers that are rounded several times.
Approx near(double value) { return Approx(value).epsilon(1e-14).margin(1e-15); }

} // namespace

TEST_CASE("normalized has the defect as its figure") {
    // Catches a defect that is squared, and the border at 1e-6.
    const auto quat = figures_of("-f quat -t dcm 1.000103 0 0 0");
    CHECK(quat.notes == "normalized");
    CHECK(quat.defect == Approx(1.03e-4).epsilon(1e-9));
    const auto dcm = figures_of("-f dcm -t quat 1 0 0 0 0.9999 0 0 0 1");
    CHECK(dcm.notes == "normalized");
    CHECK(dcm.defect == Approx(1e-4).epsilon(1e-9));
    const auto columns = figures_of("-f 6d -t quat 1 0 0 0 1.0002 0");
    CHECK(columns.notes == "normalized");
    CHECK(columns.defect == Approx(2e-4).epsilon(1e-9));
    const auto little = figures_of("-f quat -t dcm 1.00000050 0 0 0");
    CHECK(little.notes == "-");
    CHECK(little.defect == Approx(5e-7).epsilon(1e-6));
    CHECK(figures_of("-f quat -t dcm 0.9999981 0 0 0").notes == "normalized");
}

TEST_CASE("a defect that rounding explains is not told") {
    // Catches half a digit, which a sum of four exceeds, a small number's last place, and an integer of a decimal
    // place.
    CHECK(figures_of("-f quat -t dcm 1.0001 0 0 0").notes == "-");
    CHECK(figures_of("-f quat -t dcm 1.00019 0.00 0 0").notes == "normalized");
    CHECK(figures_of("-f quat -t dcm 1.0002 0 0 0").notes == "-");
    CHECK(figures_of("-f quat -t dcm 1.0003 0 0.01 0").notes == "normalized");
    CHECK(figures_of("-f quat -t dcm 1 0.01 0 0").notes == "normalized");
    CHECK(figures_of("-f 6d -t quat 9.999e-1 0 0 0 9.999e-01 0").notes == "-");
    CHECK(figures_of("-f dcm -t quat 0.9998 0 0 0 0.9999 0 0 0 0.9999").notes == "-");
    CHECK(figures_of("-f dcm -t quat 0.9997 0 0 0 0.9999 0 0 0 0.9999").notes == "normalized");
    CHECK(figures_of("-f dcm -t quat 0.9998 0 0 0 1.0 0 0 0 1.0").notes == "normalized"); // an integer: exact
    CHECK(figures_of("-f quat -t dcm 1.000100 0 0 0").notes == "-");                      // four decimals
    // Quoted, of selected columns in another order, after a header.
    const auto others = run("-f quat:xyzw -t quat --columns 5,4,3,2 --diagnostics columns -p 3",
                            "t,w,x,y,z\n0.123,0.6132,\"0.5964\",-0.3311, -0.3986\n0.1,0.613200,0.59640,-0.331,-0.4\n");
    CHECK(missing(others.out,
                  {"t,qw,", "0.123,0.613,-0.399,-0.331,0.596,inf,0.5,0.0001", ",\n0.1,", ",normalized\n"}) == "");
}

TEST_CASE("margin and condition without a singularity") {
    // Catches figures of another representation.
    CHECK(run("-f quat -t dcm --diagnostics columns 1 0 0 0").out == "1 0 0 0 1 0 0 0 1 inf 1.4142135623730951 0 -\n");
    CHECK(run("-f quat -t 6d --diagnostics columns 1 0 0 0").out == "1 0 0 0 1 0 inf 1.4142135623730951 0 -\n");
    const auto hopf = figures_of("-f quat -t 5d 1 0 0 0");
    CHECK(hopf.margin == infinity);
    CHECK(hopf.condition == near(root2 / (root2 - 1)));
    CHECK(figures_of("-f quat -t 5d 0 0 1 0").condition == near(root2 / (root2 + 1)));
}

TEST_CASE("margin and condition of what is singular at a half-turn") {
    // Catches halves and doubles of the angle.
    const std::string quarter = " 1 1 0 0 --tolerance 1";
    const auto rotvec = figures_of("-f axis-angle -t rotvec 0 0 1 2");
    CHECK(rotvec.margin == near(pi - 2));
    CHECK(rotvec.condition == near(1 / std::sin(1.0)));
    CHECK(figures_of("-f quat -t rotvec 1 0 0 0").condition == 1);
    const auto cayley = figures_of("-f cayley -t cayley 0 2 0");
    CHECK(cayley.margin == near(pi - 2 * std::atan(2.0)));
    CHECK(cayley.condition == near(2.5));
    const auto mrp = figures_of("-f mrp -t mrp 0 0.5 0");
    CHECK(mrp.margin == near(pi - 4 * std::atan(0.5)));
    CHECK(mrp.condition == near(0.3125));
    CHECK(figures_of("-f quat -t mrp" + quarter).margin == near(pi / 2));
}

TEST_CASE("margin and condition of axis and angle") {
    // Catches a margin that looks at one end only.
    const auto small = figures_of("-f rotvec -t axis-angle 0.1 0 0");
    CHECK(small.margin == near(0.1));
    CHECK(small.condition == near(1 / (2 * std::sin(0.05))));
    const auto large = figures_of("-f rotvec -t axis-angle 3 0 0");
    CHECK(large.margin == near(pi - 3));
    CHECK(large.condition == 1);
}

TEST_CASE("margin and condition of Euler angles") {
    // Catches a margin measured from the wrong middle angle, or in degrees.
    for (const char* unit : {"", ":deg"}) {
        const auto upright = figures_of(std::string("-f quat -t euler:ZYX") + unit + " 1 0 0 0");
        CHECK(upright.margin == near(pi / 2));
        CHECK(upright.condition == near(1));
    }
    const auto tilted = figures_of("-f euler:zyx -t euler:zyx 0.3 1 0.2");
    CHECK(tilted.margin == near(pi / 2 - 1));
    CHECK(tilted.condition == near(1 / (root2 * std::sin((pi / 2 - 1) / 2))));
    const auto proper = figures_of("-f euler:ZXZ -t euler:ZXZ 0.3 1 0.2");
    CHECK(proper.margin == near(1));
    CHECK(proper.condition == near(1 / (root2 * std::sin(0.5))));
    CHECK(figures_of("-f euler:ZXZ -t euler:ZXZ 0.3 3 0.2").margin == near(pi - 3));
}

TEST_CASE("near gimbal lock begins at a condition of 1e6") {
    // Catches a warning at every steep attitude, or at none.
    const auto near_lock = figures_of("-f euler:ZXZ -t euler:ZXZ 0.3 1e-7 0.2");
    CHECK(near_lock.notes == "near-gimbal-lock");
    CHECK(near_lock.margin == near(1e-7));
    CHECK(near_lock.condition == near(1 / (root2 * std::sin(0.5e-7))));
    CHECK(figures_of("-f euler:ZXZ -t euler:ZXZ 0.3 1.4e-6 0.2").notes == "near-gimbal-lock");
    CHECK(figures_of("-f euler:ZXZ -t euler:ZXZ 0.3 1.42e-6 0.2").notes == "-");
}

TEST_CASE("a half-turn is told where the sign of the axis is a convention") {
    // Catches a half-turn that is told everywhere, or nowhere.
    for (const char* name : {"rotvec", "axis-angle", "mrp"}) {
        const auto figures = figures_of(std::string("-f quat -t ") + name + " 0 0 -1 0");
        CHECK(figures.notes == "half-turn");
        CHECK(figures.margin == Approx(0).margin(1e-15));
    }
    for (const char* name : {"quat", "dcm", "6d", "5d"}) {
        CHECK(figures_of(std::string("-f quat -t ") + name + " 0 0 -1 0").notes == "-");
    }
    CHECK(run("-f quat -t rotvec --diagnostics off 0 0 -1 0") == done("0 3.141592653589793 0\n"));
    CHECK(run("-f quat -t mrp --diagnostics off 0 0 0 -1") == done("0 0 1\n"));
    CHECK(run("-f quat -t axis-angle -d --diagnostics off 0 -1 0 0") == done("1 0 0 180\n"));
}

TEST_CASE("strict ends with exit 1 for any diagnostic but normalized") {
    // Catches a strictness that depends on what is shown, and a run that ends early.
    for (const char* where : {"off", "summary", "rows", "columns"}) {
        INFO(where);
        const std::string convert = std::string("--strict -p 3 --diagnostics ") + where + " -f quat -t ";
        const auto met = run(convert + "rotvec", "0 1 0 0\n1 0 0 0\n");
        CHECK(met.exit_code == 1);
        CHECK(count_rows(met.out) == 2);
        CHECK(run(convert + "dcm", "0 1 0 0\n1.0001 0 0 0\n").exit_code == 0);
        CHECK(run(convert + "axis-angle", "1 0 0 0\n").exit_code == 1);
        CHECK(run(convert + "cayley", "0 0 1 0\n").exit_code == 1);
        CHECK(run(convert + "mrp", "0 0 1 0\n").exit_code == 1);
    }
    CHECK(run("--strict -d -f euler:ZYX -t euler:ZYX 30 90 20").exit_code == 1);
    CHECK(run("--strict -f euler:ZXZ -t euler:ZXZ 0.3 1e-7 0.2").exit_code == 1);
    CHECK(run("--strict -f euler:ZXZ -t euler:ZXZ 0.3 1e-3 0.2").exit_code == 0);
}
