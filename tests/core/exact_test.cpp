// The numbers that are printed are the doubles nearest to the exact function of the numbers read: bits are compared.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <rotconv/axes.hpp>
#include <rotconv/conversion.hpp>

#include "accuracy.hpp"
#include "catch.hpp"
#include "oracle.hpp"
#include "rounding.hpp"
#include "strata.hpp"

using rotconv::Spec;

namespace {

void check(const std::string& from, const std::string& to, int size) {
    const auto count = accuracy::rounding_of(from, to, size);
    INFO(from << " to " << to << ": " << count.wrong << " of " << count.numbers);
    CHECK(count.wrong == 0);
    CHECK(count.rows > 0);
    CHECK(count.uncertain <= count.numbers / 100);
}

/// Of rows whose numbers may all have a large K.
void check_rows(const std::string& from, const std::string& to, const std::vector<std::vector<double>>& rows) {
    const auto count = accuracy::rounding_of(accuracy::spec(from), accuracy::spec(to), rows);
    INFO(from << " to " << to << ": " << count.wrong << " of " << count.numbers);
    CHECK(count.wrong == 0);
    CHECK(count.rows == rows.size());
    CHECK(count.uncertain <= count.numbers / 100);
}

} // namespace

// Catches a number that is not the nearest double.
TEST_CASE("every number of every pair is the double nearest to the exact function of the numbers read") {
    for (const auto& from : accuracy::compared_specs()) {
        for (const auto& to : accuracy::compared_specs()) {
            check(from, to, tried(40));
        }
    }
}

// Catches a number that is 0 and printed as what its terms leave, and one that is not and taken for it; an angle that
// only nearly is one of those whose sine is known.
TEST_CASE("rows with zeros, with few digits and with multiples of 15 degrees are rounded once") {
    strata::Source source(96);
    const auto number = [&](const Spec& spec) {
        const double size = spec.unit == rotconv::AngleUnit::degrees ? 100.0 : 1.5;
        switch (source.integer(0, 6)) {
        case 0:
        case 1: return 0.0;
        case 2: return 15.0 * source.integer(-24, 24);
        case 3: return 90.0 * source.integer(-4, 4);
        case 4: return std::round(source.uniform(-size, size));
        case 5: return std::round(100.0 * source.uniform(-size, size)) / 100.0;
        default: return source.uniform(-size, size);
        }
    };
    for (const auto& from_text : accuracy::compared_specs()) {
        const Spec from = accuracy::spec(from_text);
        for (const auto& to : accuracy::compared_specs()) {
            std::vector<std::vector<double>> rows;
            while (rows.size() < static_cast<std::size_t>(tried(25))) {
                const bool is_matrix = from.name == rotconv::RepresentationId::dcm;
                const Spec own = is_matrix ? Spec{} : from;
                std::vector<double> row;
                for (std::size_t k = 0; k < own.size(); ++k) {
                    row.push_back(number(own));
                }
                const auto read = rotconv::read_attitude(own, row);
                const bool is_turn =
                    read &&
                    rotconv::angle_between(*read, rotconv::Rotation()) < 1e-9 && // whole turns: any axis is theirs
                    std::ranges::count(row, 0.0) < std::ranges::ssize(row);
                if (read && !is_turn) {
                    rows.push_back(is_matrix ? accuracy::converted(own, from, row, {.tolerance = 1e9}).numbers : row);
                }
            }
            const auto count = accuracy::rounding_of(from, accuracy::spec(to), rows);
            INFO(from_text << " to " << to << ": " << count.wrong << " of " << count.numbers);
            CHECK(count.wrong == 0);
            CHECK(count.rows > 0);
        }
    }
}

// Catches an axis, a sign or an order that one sequence alone gets wrong, and a modifier that rounds.
TEST_CASE("every sequence and every modifier is rounded once") {
    for (const auto sequence : rotconv::EulerSequence::all()) {
        const std::string text = "euler:" + sequence.text();
        check("quat", text + ":deg", 2);
        check(text, "dcm", is_sanitized ? 2 : 12);
        check(text + ":deg", text, is_sanitized ? 1 : 6);
    }
    for (const std::string& sequence : accuracy::signed_sequences()) {
        check("quat", "euler:" + sequence + ":deg:positive", 1);
        check("euler:" + sequence, "quat", 2);
    }
    for (const auto& text : accuracy::all_specs()) {
        check("quat", text, 2);
        check(text, "quat", 2);
    }
}

// Catches a constant turn that is rounded before it turns.
TEST_CASE("attitudes that are turned are rounded once") {
    const Spec angles = accuracy::spec("rpy:deg");
    const Spec quat;
    strata::Source source(77);
    for (int i = 0; i < 300; ++i) {
        const std::vector<double> left{source.uniform(-180, 180), source.uniform(-90, 90), source.uniform(-180, 180)};
        const std::vector<double> row{source.uniform(-180, 180), source.uniform(-90, 90), source.uniform(-180, 180)};
        const std::vector<double> right{source.normal(), source.normal(), source.normal(), source.normal()};
        const auto result = accuracy::converted(angles, accuracy::spec("dcm"), row,
                                                {.left = rotconv::FixedRotation::of_numbers(angles, left),
                                                 .right = rotconv::FixedRotation::of_numbers(quat, right)});
        const auto exact =
            oracle::attitude(angles, left) * oracle::attitude(angles, row) * oracle::attitude(quat, right);
        CHECK(result.numbers == oracle::numbers(accuracy::spec("dcm"), exact));
    }
}

// Catches an entry of a matrix, small after other axes are named, that has passed a sum with large ones; axes on
// the wrong side of an inverse.
TEST_CASE("matrices in other axes are rounded once, however small a number becomes") {
    strata::Source source(79);
    for (const char* axes : {"wnd:unw", "ned:enu", "xyz:-x-yz", "yzx:xyz", "xyz:xzy"}) {
        const auto change = std::get<rotconv::AxesChange>(rotconv::parse_axes(axes));
        const rotconv::Dcm moves = change.changes_hand() ? -change.matrix : change.matrix;
        for (int i = 0; i < 200; ++i) {
            // L R S is a turn of 1e-13 about an axis with two components of 1e-7 of the third
            const std::vector<double> tilt{1e-13 * source.normal(), 1e-20 * source.normal(), 1e-20 * source.normal()};
            const auto vectors = accuracy::converted(accuracy::spec("rotvec"), accuracy::spec("dcm"), tilt, {});
            const rotconv::Dcm near = Eigen::Map<const rotconv::Dcm>(vectors.numbers.data()).transpose();
            const bool left = i % 2 == 0;
            const rotconv::Dcm turned =
                left ? rotconv::Dcm(moves.transpose() * near) : rotconv::Dcm(near * moves.transpose());
            for (const bool from_passive : {false, true}) {
                for (const char* to : {"mrp", "rotvec:passive"}) {
                    const Spec from = accuracy::spec(from_passive ? "dcm:passive" : "dcm");
                    const rotconv::Dcm rows =
                        from_passive ? turned : rotconv::Dcm(turned.transpose()); // column by column
                    rotconv::ConversionSettings settings;
                    (left ? settings.left : settings.right) = change.rotation();
                    const auto result =
                        accuracy::converted(from, accuracy::spec(to), {rows.data(), rows.data() + 9}, settings);
                    const rotconv::Dcm expected = near.transpose();
                    const auto exact =
                        oracle::converted(accuracy::spec("dcm"), accuracy::spec(to), {expected.data(), 9});
                    for (std::size_t k = 0; k < 3; ++k) {
                        INFO(axes << ' ' << to << ' ' << left << from_passive);
                        CHECK(result.numbers[k] == exact[k].value);
                    }
                }
            }
        }
    }
}

namespace {

/// A number of a kind: of all digits, small, tiny, large, 0, of few digits, whole, a known angle, a power of two,
/// near 1.
double number_of(int kind, bool is_angle, strata::Source& source) {
    const double sign = source.integer(0, 1) == 0 ? 1.0 : -1.0;
    switch (kind) {
    case 0: return sign * std::pow(10.0, source.uniform(-18, 0));
    case 1: return sign * std::pow(10.0, source.uniform(-70, -18));
    case 2: return sign * std::pow(10.0, source.uniform(0, is_angle ? 9 : 60));
    case 3: return 0.0;
    case 4: return source.integer(-999, 999) / 1000.0;
    case 5: return source.integer(-12, 12);
    case 6: return is_angle ? 15.0 * source.integer(-24, 24) : 0.5 * source.integer(-2, 2);
    case 7: return sign * std::ldexp(1.0, source.integer(-60, 3));
    case 8: return sign * (1.0 + 0x1p-53 * source.integer(-20, 20));
    default: return source.uniform(-3, 3);
    }
}

/// Numbers of one kind, or each of its own.
std::vector<double> mixed_numbers(const Spec& spec, strata::Source& source) {
    constexpr int kinds = 10;
    const int one = source.integer(0, kinds + 3);
    std::vector<double> row(spec.size());
    for (std::size_t k = 0; k < row.size(); ++k) {
        const bool is_length = spec.name == rotconv::RepresentationId::axis_angle && k < 3;
        const bool is_angle = rotconv::representation(spec.name).modifiers.has(rotconv::Modifier::deg) && !is_length;
        row[k] = number_of(one < kinds ? one : source.integer(0, kinds - 1), is_angle, source);
    }
    return row;
}

/// Those of a matrix are near those of a rotation.
std::vector<double> mixed_row(const Spec& spec, strata::Source& source) {
    if (!accuracy::has_limits(spec.name) || spec.size() < 5) {
        return mixed_numbers(spec, source);
    }
    std::vector<double> quaternion;
    while (std::ranges::all_of(quaternion, [](double number) { return number == 0.0; })) {
        quaternion = mixed_numbers(Spec{}, source);
    }
    auto row = accuracy::converted(Spec{}, spec, quaternion, {.tolerance = 1e99}).numbers;
    const int noise = source.integer(0, 5);
    const double size = std::pow(10.0, source.uniform(-17, -1));
    const double scale = noise == 3 ? std::pow(10.0, source.uniform(-1, 1)) : 1.0;
    for (double& number : row) {
        number *= scale * (noise == 1 ? 1.0 + 0x1p-50 * source.uniform(-1, 1) : 1.0);
        number += noise == 2 ? size * source.uniform(-1, 1) : 0.0;
        number = noise == 4 ? std::round(number * 1e4) / 1e4 : number;
        number = noise == 5 && std::fabs(number) < 1e-3 && source.integer(0, 1) == 0 ? 0.0 : number;
    }
    return row;
}

} // namespace

// Catches a number that is taken for 0 because a row before it, or a row that is not locked, has 0 there: 2 of 100,000
// rows of each of three faults that this found.
TEST_CASE("rows of numbers of all kinds, each its own, are rounded once") {
    strata::Source source(49);
    for (const auto& from_text : accuracy::compared_specs()) {
        const Spec from = accuracy::spec(from_text);
        for (const auto& to : accuracy::compared_specs()) {
            std::vector<std::vector<double>> rows(static_cast<std::size_t>(tried(60)));
            std::ranges::generate(rows, [&] { return mixed_row(from, source); });
            const auto count = accuracy::rounding_of(from, accuracy::spec(to), rows);
            INFO(from_text << " to " << to << ": " << count.wrong << " of " << count.numbers);
            CHECK(count.wrong == 0);
        }
    }
}

// Catches a zero that rows of the same pattern of zeros, but not of signs, have elsewhere: turns about x have y = z =
// 0, and w = x = 0 where r11 is -1.
TEST_CASE("no row decides what is 0 in another") {
    const std::vector<double> upright{
        1.0000000000000004,  0, 0, 0, -1.0000000000000004, 4.9633133639286068e-147, 0, -4.9633133639286129e-147,
        -0.99999999999999933};
    const std::vector<double> turned{-1, 0, 0, 0, -0.28, 0.96, 0, 0.96, 0.28};
    for (const char* to : {"quat", "5d", "6d", "rotvec", "rpy", "euler:zxz"}) {
        check_rows("dcm", to, {turned, upright, turned});
        check_rows("dcm", to, {upright, turned, upright});
        check_rows("6d", to, {{-1, 0, 0, 0, 0.28, 0.96}, {1, 0, 0, 0, -1.0000000000000004, 5e-147}});
        check_rows("6d", to, {{1, 0, 0, 0, 0.28, 0.96}, {-1, 0, 0, 0, -1.0000000000000004, 5e-147}});
    }
}

// Catches a component that Newton's steps leave at 0 by chance, and an angle at lock that is 0 where it is not locked.
TEST_CASE("what is 0 in fewer digits, or off a lock, is not taken for 0") {
    check_rows("dcm", "rotvec",
               {{-1, 9.5400523458937616e-247, 7.5896345946532797e-57, 0, -0.99989776959479348, 0.014298613896359771,
                 -7.5896345946532797e-57, 0.014298613896359771, 0.99989776959479348}});
    check_rows("rpy:deg", "euler:XYX:deg", {{-1.97e-37, 6.4e-18, -0.0}, {-1.97e-20, 6.4e-18, 0}});
    check_rows("rpy:deg", "rpy:deg", {{1e-30, 90, 1e-70}, {30, 90, 30}, {1e-40, -90, 0}});
}

// Catches digits lost where a sum or a whole turn cancels.
TEST_CASE("rows in which nearly everything cancels are rounded once") {
    strata::Source source(78);
    std::vector<std::vector<double>> near_turns{{0, -2.6386326881465196, -18.663959279216765}};
    std::vector<std::vector<double>> nearly_symmetric;
    for (int i = 0; i < 300; ++i) {
        const oracle::Vector3 turns = source.axis() * (2 * oracle::pi() * source.integer(1, 1000));
        near_turns.push_back(
            {turns[0].convert_to<double>(), turns[1].convert_to<double>(), turns[2].convert_to<double>()});
        const auto tilt = [&] { return std::pow(10.0, -source.uniform(20, 25)); };
        const auto shear = [&] { return source.uniform(-0.04, 0.04); };
        const double xy = shear();
        const double xz = shear();
        const double yz = shear();
        nearly_symmetric.push_back({1 + shear(), xy, xz + tilt(), xy, 1 + shear(), yz, xz, yz - tilt(), 1 + shear()});
    }
    check_rows("rotvec", "rotvec", near_turns);
    check_rows("rotvec", "rpy", near_turns);
    check_rows("dcm", "rotvec", nearly_symmetric);
    check_rows("dcm", "quat", nearly_symmetric);
}

// Catches a component that is scaled to nothing with the quaternion, and then taken for 0 or for what it was.
TEST_CASE("the smallest numbers beside large ones are rounded once") {
    const auto check_row = [](const char* from, std::vector<double> row, const char* to = "dcm") {
        const Spec written = accuracy::spec(to);
        const auto exact = oracle::converted(accuracy::spec(from), written, row);
        const auto result = accuracy::converted(accuracy::spec(from), written, row,
                                                {.tolerance = std::numeric_limits<double>::infinity()});
        for (std::size_t i = 0; i < written.size(); ++i) {
            INFO(from << " to " << to << ", number " << i);
            CHECK(result.numbers[i] == exact[i].value);
        }
    };
    check_row("quat", {2.1505664366284374, 0, 0x2p-1074, -0x1p-1074});
    check_row("quat", {-0x3p-1074, 1e10, 0, 3e-314});
    check_row("quat", {1e300, 0, 1e-20, 1e-90});
    check_row("cayley", {1.5, 0, 0x1p-1074});
    check_row("mrp", {0.5, 0, 0x1p-1074});
    // the angle is not a half-turn, nor whole turns, by what the smallest numbers add to the length
    for (const double half_turns : {180.0, -180.0, 540.0, 900.0, 360.0}) {
        for (const char* to : {"quat", "cayley", "cayley:passive"}) {
            check_row("rotvec:deg", {half_turns, 5.01e-67, -1.82e-67}, to);
            check_row("rotvec:deg", {2.5e-120, half_turns, 1e-300}, to);
            check_row("rotvec:deg", {-1e-149, 1e-150, half_turns}, to);
        }
    }
}

// Catches a norm of 2^k taken for 1, digits lost in the smallest turns, a lost limit of a lock margin.
TEST_CASE("rows at the ends of ranges are rounded once") {
    const auto converted = [](const char* from, const char* to, std::vector<double> row, double lock_margin = 0.0) {
        return accuracy::converted(accuracy::spec(from), accuracy::spec(to), row,
                                   {.tolerance = std::numeric_limits<double>::infinity(), .lock_margin = lock_margin});
    };
    const std::vector<double> double_norm{0.97941450320233581, -1.1864884421863426, 0.45504420822612834,
                                          1.1941219267876333};
    CHECK(converted("quat", "quat", double_norm).numbers ==
          oracle::numbers(Spec{}, oracle::attitude(Spec{}, double_norm)));
    const std::vector<double> smallest{1e-310, 1e-311, 1e-312};
    CHECK(converted("rpy", "rpy", smallest).numbers == smallest);
    CHECK(converted("rotvec", "rotvec", smallest).numbers == smallest);
    // a middle angle that as a double is 0 beside outer angles that are not 90 degrees
    const std::vector<double> all_but_locked{4.1324199971023663e-13, -8.0962537384005071e-320, 0,
                                             -0.0037221530345439074};
    CHECK(converted("quat", "euler:zxz:deg", all_but_locked).numbers[0] == Approx(90.0000000063611).epsilon(1e-15));
    // The pitch of (k, 0, h, 0) is 2 atan(h/k). Fractions that are ever nearer to its limit lie on either side of it.
    for (const double margin : {0.5, 1.0}) {
        const oracle::Real limit = tan((oracle::pi() / 2 - oracle::Real(margin)) / 2);
        oracle::Real rest = limit;
        double h[] = {0, 1};
        double k[] = {1, 0};
        while (k[1] < 0x1p41) {
            const auto whole = floor(rest).convert_to<double>();
            rest = 1 / (rest - whole);
            h[0] = std::exchange(h[1], whole * h[1] + h[0]);
            k[0] = std::exchange(k[1], whole * k[1] + k[0]);
            const auto found = converted("quat", "rpy", {k[1], 0, h[1], 0}, margin);
            INFO(margin << ": " << h[1] << "/" << k[1]);
            CHECK(found.report.diagnostics.has(rotconv::DiagnosticKind::gimbal_lock) ==
                  (oracle::Real(h[1]) / k[1] >= limit));
        }
    }
}
