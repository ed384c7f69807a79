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

TEST_CASE("the summary has one line for each kind with its count and first line") {
    // Catches a line for each row, and wrong counts.
    const auto result = run("-f quat -t rotvec", "1 0 0 0\n0 1 0 0\n\n# note\n1.0001 0 0 0\n0 0 1 0\n0 0 0 1\n");
    CHECK(result.exit_code == 0);
    CHECK(count_rows(result.out) == 7);
    const auto lines = fields_of(result.err, '\n');
    REQUIRE(lines.size() == 2);
    const bool normalized_first = missing(lines[0], {"normalized"}) == "";
    CHECK(missing(lines[normalized_first ? 0 : 1], {"normalized", "1", "5"}) == "");
    CHECK(missing(lines[normalized_first ? 1 : 0], {"half-turn", "3", "2"}) == "");
}

TEST_CASE("off says nothing") {
    // Catches messages that cannot be turned off.
    CHECK(run("-f quat -t rotvec --diagnostics off -p 3", "0 1.0001 0 0\n") == done("3.14 0 0\n"));
}

TEST_CASE("rows has one line for each diagnostic") {
    // Catches diagnostics that are lost, or without their line.
    const auto result = run("-f quat -t rotvec --diagnostics rows -p 3", "0 1 0 0\n1 0 0 0\n0 1.0009765625 0 0\n");
    CHECK(result.exit_code == 0);
    CHECK(result.out == "3.14 0 0\n0 0 0\n3.14 0 0\n");
    const auto lines = fields_of(result.err, '\n');
    REQUIRE(lines.size() == 3);
    CHECK(missing(lines[0], {"rotconv: -:1: ", "half-turn"}) == "");
    CHECK(missing(lines[1], {"rotconv: -:3: "}) == "");
    CHECK(missing(lines[2], {"rotconv: -:3: "}) == "");
    CHECK(missing(lines[1] + lines[2], {"normalized", "half-turn", "0.00097"}) == "");
}

TEST_CASE("columns stand directly after the result") {
    // Catches columns at the end of the row, and a line on stderr as well.
    CHECK(run("-f quat -t quat --diagnostics columns --columns 2-5", "a,1,0,0,0,b\n") ==
          done("a,1,0,0,0,inf,0.5,0,,b\n"));
    CHECK(run("-f quat -t quat --diagnostics columns --append --columns 2-5", "a,1,0,0,0,b\n") ==
          done("a,1,0,0,0,b,1,0,0,0,inf,0.5,0,\n"));
}

TEST_CASE("no notes are a minus sign where blanks delimit and nothing elsewhere") {
    // Catches a row with a column less.
    const std::string convert = "-f quat -t quat --diagnostics columns";
    CHECK(run(convert, "1 0 0 0\n") == done("1 0 0 0 inf 0.5 0 -\n"));
    CHECK(run(convert, "1,0,0,0\n") == done("1,0,0,0,inf,0.5,0,\n"));
    CHECK(run(convert, "1;0;0;0\n") == done("1;0;0;0;inf;0.5;0;\n"));
    CHECK(run(convert, "1\t0\t0\t0\n") == done("1\t0\t0\t0\tinf\t0.5\t0\t\n"));
}

TEST_CASE("notes are joined by a plus sign") {
    // Catches one kind that hides the other.
    const auto notes = figures_of("-f quat -t rotvec 0 1.0001 0 0").notes;
    CHECK((notes == "normalized+half-turn" || notes == "half-turn+normalized"));
}

TEST_CASE("normalized has the defect as its figure") {
    // Catches a defect that is squared, and the border at 1e-6.
    const auto quat = figures_of("-f quat -t dcm 1.0001 0 0 0");
    CHECK(quat.notes == "normalized");
    CHECK(quat.defect == Approx(1e-4).epsilon(1e-9));
    const auto dcm = figures_of("-f dcm -t quat 1 0 0 0 0.9999 0 0 0 1");
    CHECK(dcm.notes == "normalized");
    CHECK(dcm.defect == Approx(1e-4).epsilon(1e-9));
    const auto columns = figures_of("-f 6d -t quat 1 0 0 0 1.0002 0");
    CHECK(columns.notes == "normalized");
    CHECK(columns.defect == Approx(2e-4).epsilon(1e-9));
    const auto little = figures_of("-f quat -t dcm 1.0000005 0 0 0");
    CHECK(little.notes == "-");
    CHECK(little.defect == Approx(5e-7).epsilon(1e-6));
    CHECK(figures_of("-f quat -t dcm 0.999998 0 0 0").notes == "normalized");
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

TEST_CASE("gimbal lock sets the third angle to zero") {
    // Catches two angles that noise has split.
    for (const char* spec : {"euler:ZYX:deg", "rpy:deg"}) {
        INFO(spec);
        const bool rpy = spec[0] == 'r';
        const auto result = run(std::string("--diagnostics columns -p 12 -f euler:ZYX:deg -t ") + spec + " 30 90 20");
        CHECK(result.exit_code == 0);
        const auto fields = fields_of(result.out, ' ');
        REQUIRE(fields.size() == 7);
        // roll pitch yaw is the same set read backwards: yaw is the third there
        CHECK(std::stod(fields[0]) == Approx(rpy ? -10 : 10).epsilon(1e-12));
        CHECK(fields[1] == "90");
        CHECK(fields[2] == "0");
        CHECK(fields[6] == "gimbal-lock");
    }
    const auto proper = run("--diagnostics off -p 12 -f euler:ZXZ:deg -t euler:ZXZ:deg 30 0 20");
    CHECK(proper == done("50 0 0\n"));
}

TEST_CASE("a lock margin takes nearby attitudes for locked") {
    // Catches a margin in degrees, or one that holds on one side only.
    const std::string convert = "-f euler:ZYX -t euler:ZYX -d --diagnostics columns -p 6 ";
    for (const char* pitch : {"89.9", "90.1", "-89.9"}) {
        INFO(pitch);
        const auto locked = fields_of(run(convert + "--lock-margin 0.002 0 " + pitch + " 0").out, ' ');
        REQUIRE(locked.size() == 7);
        CHECK(locked[1] == (pitch[0] == '-' ? "-90" : "90"));
        CHECK(locked[2] == "0");
        CHECK(locked[6] == "gimbal-lock");
        const auto free = fields_of(run(convert + "--lock-margin 0.0017 0 " + pitch + " 0").out, ' ');
        REQUIRE(free.size() == 7);
        CHECK(free[1] == (pitch[0] == '-' ? "-89.9" : "89.9"));
        CHECK(free[6] == "-");
    }
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

TEST_CASE("a Cayley vector is infinite at a half-turn") {
    // Catches nan, and infinity along an axis without a component.
    CHECK(run("-f quat -t cayley --diagnostics columns 0 0 1 0").out == "0 inf 0 0 inf 0 infinite\n");
    CHECK(run("-f quat -t cayley --diagnostics off --tolerance 1 0 1 0 -1") == done("inf 0 -inf\n"));
    CHECK(run("-f quat -t cayley --diagnostics off --tolerance 1 0 0 -1 1") == done("0 inf -inf\n"));
}

TEST_CASE("the axis of the identity is a convention") {
    // Catches a zero axis or nan.
    const auto result = run("-f quat -t axis-angle --diagnostics columns 1 0 0 0");
    CHECK(result.out == "1 0 0 0 0 inf 0 identity-axis\n");
    CHECK(result.exit_code == 0);
    CHECK(figures_of("-f rotvec -t axis-angle 1e-200 0 0").notes == "-");
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

TEST_CASE("without strict a diagnostic is no failure") {
    // Catches a warning that breaks scripts.
    CHECK(run("-f quat -t rotvec 0 1 0 0").exit_code == 0);
}

TEST_CASE("a failed row has no diagnostics") {
    // Catches figures of a row that has no attitude.
    const auto result = run("-f quat -t rotvec --on-error skip --diagnostics rows", "0 0 0 0\n2 0 0 0\n");
    CHECK(result.exit_code == 1);
    CHECK(count_rows(result.err) == 2);
    CHECK(missing(result.err, {"normalized"}) != "");
    CHECK(missing(result.err, {"half-turn"}) != "");
}
