// Changes of axes by name, against the matrices that their letters mean.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <rotconv/rotconv.hpp>

#include "accuracy.hpp"
#include "catch.hpp"
#include "oracle.hpp"
#include "strata.hpp"

using namespace rotconv;

namespace {

using Vector = std::array<double, 3>;

AxesChange axes(const std::string& text) {
    INFO(text);
    const auto parsed = parse_axes(text);
    REQUIRE(std::holds_alternative<AxesChange>(parsed));
    return std::get<AxesChange>(parsed);
}

AxesError error_of(const std::string& text) {
    INFO(text);
    const auto parsed = parse_axes(text);
    REQUIRE(std::holds_alternative<AxesError>(parsed));
    return std::get<AxesError>(parsed);
}

/// In the axes TO.
Vector changed(const std::string& text, const Vector& v) {
    const Eigen::Vector3d to = axes(text).matrix * Eigen::Vector3d(v.data());
    return {to[0], to[1], to[2]};
}

/// The words for x, -x, y, -y, z, -z.
using Words = std::array<std::string, 6>;

/// All 48 triples of a set.
std::vector<std::string> triples(const Words& words) {
    std::vector<std::string> all;
    for (std::size_t x = 0; x < 6; ++x) {
        for (std::size_t y = 0; y < 6; ++y) {
            for (std::size_t z = 0; z < 6; ++z) {
                if (x / 2 != y / 2 && x / 2 != z / 2 && y / 2 != z / 2) {
                    all.push_back(words.at(x) + words.at(y) + words.at(z));
                }
            }
        }
    }
    return all;
}

/// Nine numbers row by row.
Dcm matrix_of(const std::vector<double>& numbers) {
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(numbers.data());
}

} // namespace

// Catches a matrix that is transposed, and letters that are taken for where old axes go. The numbers of MAVROS's
// test mavros/test/test_frame_conversions.cpp, transform_static_frame__ned_to_enu_123 and
// __aircraft_to_baselink_123.
TEST_CASE("vectors change as in other projects' own conversions") {
    CHECK(changed("ned:enu", {1, 2, 3}) == Vector{2, 1, -3});
    CHECK(changed("enu:ned", {1, 2, 3}) == Vector{2, 1, -3});
    CHECK(changed("frd:flu", {1, 2, 3}) == Vector{1, -2, -3});
    // ROS-TCP-Connector of Unity, Runtime/ROSGeometry/CoordinateSpaces.cs: (z, -x, y) of FLU, its inverse (-y, z, x),
    // (z, x, -y) of FRD, and of a Unity whose z is north (x, z, y) of ENU and (z, x, -y) of NED
    CHECK(changed("ruf:flu", {1, 2, 3}) == Vector{3, -1, 2});
    CHECK(changed("flu:ruf", {1, 2, 3}) == Vector{-2, 3, 1});
    CHECK(changed("ruf:frd", {1, 2, 3}) == Vector{3, 1, -2});
    CHECK(changed("eun:enu", {1, 2, 3}) == Vector{1, 3, 2});
    CHECK(changed("eun:ned", {1, 2, 3}) == Vector{3, 1, -2});
    // nerfstudio, docs/quickstart/data_conventions.md: y and z of COLMAP's camera are the opposite ones
    CHECK(changed("rdf:rub", {1, 2, 3}) == Vector{1, -2, -3});
    CHECK(changed("xyz:yx-z", {1, 2, 3}) == Vector{2, 1, -3});
    CHECK(changed("-xyz:xyz", {1, 2, 3}) == Vector{-1, 2, 3});
    CHECK(changed("zxy:xyz", {1, 2, 3}) == Vector{2, 3, 1}); // not the inverse, (3, 1, 2)
    CHECK(changed("xyz:zxy", {1, 2, 3}) == Vector{3, 1, 2});
    CHECK(axes("NED:Enu").matrix == axes("ned:enu").matrix);
    CHECK(axes("x-YZ:xyz").matrix == axes("x-yz:xyz").matrix);
}

// Catches a sign of the permutation, and a set whose axes are taken in a left-handed order.
TEST_CASE("hands are those of the letters") {
    for (const std::string right :
         {"ned", "enu", "nwu", "wsu", "esd", "frd", "flu", "rdf", "rub", "rfu", "luf", "xyz", "yzx", "yx-z"}) {
        INFO(right);
        CHECK(!axes(right + ":" + right).from_left_handed);
    }
    for (const std::string left : {"neu", "end", "ruf", "fru", "fld", "-xyz", "yxz", "-x-y-z"}) {
        INFO(left);
        CHECK(axes(left + ":" + left).to_left_handed);
    }
    CHECK(axes("ruf:flu").changes_hand());
    CHECK(!axes("ruf:fru").changes_hand());
}

// Catches a triple that is refused or mistaken, and a turn that rounds.
TEST_CASE(
    "of all pairs of triples the matrix has an entry 1 or -1 in each row and column, and the hands are its sign's") {
    for (const Words& set : {Words{"e", "w", "n", "s", "u", "d"}, Words{"f", "b", "l", "r", "u", "d"},
                             Words{"x", "-x", "y", "-y", "z", "-z"}}) {
        const auto all = triples(set);
        REQUIRE(all.size() == 48);
        for (const auto& from : all) {
            for (const auto& to : all) {
                const AxesChange change = axes(from + ":" + to);
                const Dcm& m = change.matrix;
                INFO(from << ':' << to);
                CHECK(m * m.transpose() == Dcm::Identity());
                CHECK(m.cwiseAbs().sum() == 3.0);
                CHECK(axes(to + ":" + from).matrix == m.transpose());
                const double sign = m.determinant();
                CHECK(change.changes_hand() == (sign < 0.0));
                CHECK(dcm::from_rotation(change.rotation().rotation) == sign * m);
                CHECK(axes(axes_text(change.rotation().rotation)).matrix == sign * m);
            }
        }
    }
}

// Catches N in the place of N', sides exchanged, a hand that is lost, and a constant rotation that is rounded.
TEST_CASE("axes on both sides exchange and negate entries of the matrix, and change no other bit") {
    strata::Source source(2301);
    const auto dcm = accuracy::spec("dcm");
    const auto mrp = accuracy::spec("mrp");
    const auto all = triples({"f", "b", "l", "r", "u", "d"});
    const auto any = [&] { return all[static_cast<std::size_t>(source.integer(0, 47))]; };
    int mirrored = 0;
    for (int i = 0; i < 4000; ++i) {
        const AxesChange reference = axes(any() + ":" + any());
        const AxesChange body = axes(any() + ":" + any());
        if (reference.changes_hand() != body.changes_hand()) {
            continue;
        }
        mirrored += reference.changes_hand() ? 1 : 0;
        const auto row = oracle::numbers(mrp, source.attitude());
        const auto plain = accuracy::converted(mrp, dcm, row, {}).numbers;
        const ConversionSettings turns{.left = reference.rotation(), .right = body.rotation().inverse()};
        const Dcm expected = reference.matrix * matrix_of(plain) * body.matrix.transpose();
        CHECK(matrix_of(accuracy::converted(mrp, dcm, row, turns).numbers) == expected);
    }
    CHECK(mirrored > 500);
}

// Catches one fault that is told as another, a message without the text that is wrong, and one of another error.
TEST_CASE("a text that names no axes says why") {
    using What = AxesError::What;
    for (const std::string text :
         {"", ":", "frd", "frd:", ":flu", "frd:flu:", "frd:fl", "frd:flux", "frd:fl-", "frd:fl--u", "f-rd:flu",
          "-ned:enu", "abc:def", "xy z:xyz", "xyz:xy", "x y z :xyz", "xyz:--xyz"}) {
        INFO(text);
        CHECK(error_of(text).what == What::form);
    }
    for (const std::string text : {"ned:flu", "nfd:enu", "xyz:enu", "frd:xyz", "nxd:ned", "ud-x:xyz"}) {
        INFO(text);
        CHECK(error_of(text).what == What::mixed_sets);
    }
    CHECK(error_of("NND:ned").what == What::same_direction);
    CHECK(error_of("NND:ned").triple == "NND");
    CHECK(error_of("ned:nsd").what == What::opposite_directions);
    CHECK(error_of("ned:nsd").triple == "nsd");
    CHECK(error_of("fud:flu").what == What::opposite_directions);
    CHECK(error_of("xyz:xy-x").triple == "xy-x");
    CHECK(error_of("xyz:-xy-x").what == What::same_direction);
    CHECK(message(error_of("frd:fl")).starts_with("'frd:fl' is not FROM:TO, such as ned:enu"));
    CHECK(message(error_of("ned:flu")).starts_with("'ned:flu': the letters must be of one set"));
    CHECK(message(error_of("NND:ned")) == "'NND:ned': 'NND' has one direction twice");
    CHECK(message(error_of("ned:nsd")).starts_with("'ned:nsd': 'nsd' has opposite directions"));
}

// Catches a product in plain double, in the other order, and rests that are lost.
TEST_CASE("constant rotations are multiplied to 100 bits") {
    strata::Source source(2303);
    const auto rpy = accuracy::spec("rpy:deg");
    using oracle::Real;
    for (int i = 0; i < 1000; ++i) {
        const std::array<double, 3> a{source.uniform(-180, 180), source.uniform(-90, 90), source.uniform(-180, 180)};
        const std::array<double, 3> b{source.uniform(-180, 180), source.uniform(-90, 90), source.uniform(-180, 180)};
        const FixedRotation product = FixedRotation::of_numbers(rpy, a) * FixedRotation::of_numbers(rpy, b);
        const Rotation& q = product.rotation;
        const auto sum = [&](double rounded, std::size_t k) { return Real(rounded) + Real(product.rest.at(k)); };
        const auto found = oracle::Quaternion(sum(q.w(), 0), sum(q.x(), 1), sum(q.y(), 2), sum(q.z(), 3)).normalized();
        CHECK(oracle::error_in_eps(oracle::attitude(rpy, a) * oracle::attitude(rpy, b), found) < 0x1p-46);
    }
}
