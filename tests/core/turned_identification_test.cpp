// Conventions that differ by constant turns as well are found again, and no wrong one is.

#include <array>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "../../src/core/identification/identification.hpp"
#include "accuracy.hpp"
#include "catch.hpp"
#include "oracle.hpp"
#include "strata.hpp"

using namespace rotconv;
using accuracy::spec;

namespace {

using Row = std::vector<double>;
using oracle::Matrix3;
using oracle::Quaternion;
using oracle::Real;
using oracle::Vector3;

constexpr double degree = std::numbers::pi / 180.0;
constexpr int runs = is_sanitized ? 15 : 150; // of each case

/// A convention against another: rows of an attitude written in the one, and turned and written in the other.
struct Case {
    std::string name;
    Spec unknown;
    Spec known;
    Quaternion left;
    Quaternion right;
    std::string written; ///< the answer by the order of preference, "L" or "R" for a turn without a name; or "none"
};

/// A turn of a normally distributed vector, standard deviation in radians on each axis, at most thrice that long.
Quaternion small(strata::Source& random, double deviation) {
    Vector3 v;
    do {
        v = {random.normal(), random.normal(), random.normal()};
    } while (v.norm() > 3);
    return oracle::about(v, v.norm() * deviation);
}

/// The proper rotation whose rows are these, or their opposites.
Quaternion axes(const std::array<std::array<int, 3>, 3>& rows) {
    Matrix3 m;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            m(i, k) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
        }
    }
    return Quaternion(m.determinant() < 0 ? Matrix3(-m) : m).normalized();
}

const Quaternion ned_to_enu = axes({{{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}});
const Quaternion frd_to_flu = axes({{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}});
const Quaternion ruf_to_flu = axes({{{0, 0, 1}, {-1, 0, 0}, {0, 1, 0}}}); // left-handed to right-handed
const Quaternion fru_to_flu = axes({{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}}); // likewise
const Quaternion rdf_to_rub = frd_to_flu;
const Quaternion identity = Quaternion::Identity();

std::vector<Case> cases() {
    const Quaternion mounting = oracle::attitude(spec("rpy:deg"), std::vector<double>{3.1, -12.7, 4.4});
    return {
        {"NED and FRD to ENU and FLU", spec("quat"), spec("quat:xyzw"), ned_to_enu, frd_to_flu.conjugate(),
         "quat ned:enu frd:flu"},
        {"the same as angles", spec("euler:ZYX:deg"), spec("quat"), ned_to_enu, frd_to_flu.conjugate(),
         "euler:ZYX:deg ned:enu frd:flu"},
        {"NED to ENU", spec("rpy"), spec("quat"), ned_to_enu, identity, "rpy ned:enu -"},
        {"Unity", spec("quat:xyzw"), spec("dcm"), ruf_to_flu, ruf_to_flu.conjugate(), "quat:xyzw ruf:flu ruf:flu"},
        {"another left-handed one", spec("quat"), spec("dcm"), fru_to_flu, fru_to_flu.conjugate(),
         "quat fru:flu fru:flu"},
        {"Unreal", spec("euler:Z-Y-X:deg"), spec("quat"), identity, identity, "euler:Z-Y-X:deg - -"},
        {"COLMAP to NeRF", spec("quat:passive"), spec("dcm"), identity, rdf_to_rub.conjugate(),
         "quat:passive - rdf:rub"},
        {"OPK from a camera with other axes", spec("rotvec:passive"), spec("euler:XYZ:deg"), ned_to_enu,
         rdf_to_rub.conjugate(), "rotvec:passive ned:enu frd:flu"},
        {"a mounting", spec("euler:ZYX:deg"), spec("quat"), identity, mounting, "euler:ZYX:deg - R"},
        {"a mounting of the reference", spec("rotvec"), spec("quat"), mounting, identity, "rotvec L -"},
        {"turns on both sides", spec("mrp"), spec("quat"), mounting, mounting, "none"},
        {"other axes on both sides", spec("quat"), spec("dcm"), ned_to_enu, ruf_to_flu, "none"},
        {"compass heading", spec("euler:-ZYX:deg"), spec("quat"),
         oracle::attitude(spec("rpy:deg"), std::vector<double>{0, 0, 90}), identity, "euler:-ZYX:deg L -"},
        {"Chandra", spec("euler:Z-YX:deg"), spec("quat"), identity, identity, "euler:Z-YX:deg - -"},
        {"Android", spec("euler:-Z-XY"), spec("quat"), identity, identity, "euler:-Z-XY - -"},
        {"its inverse in degrees", spec("euler:zx-y:deg"), spec("quat"), identity, identity, "euler:zx-y:deg - -"},
        {"negated yaw", spec("euler:ZX-Y:deg"), spec("quat"), identity, identity,
         "euler:yzx:deg:passive ruf:flu ruf:flu"}, // no project's, and axes that have names are before signs
    };
}

/// Rows of a case, with noise, radians on each axis. Sets of rows are drawn from them, for the oracle takes its time.
std::vector<Row> pairs_of(const Case& each, strata::Source& random, double noise) {
    constexpr std::size_t count = 1000;
    std::vector<Row> pairs(count);
    for (Row& pair : pairs) {
        pair = oracle::numbers(each.unknown, random.attitude());
        Quaternion turned = each.left * oracle::attitude(each.unknown, pair) * each.right;
        if (noise > 0) {
            turned = turned * small(random, noise);
        }
        const Row known = oracle::numbers(each.known, turned);
        pair.insert(pair.end(), known.begin(), known.end());
    }
    return pairs;
}

/// What the answer makes of an attitude, written as the unknown numbers are, less what the case makes of it, in
/// radians.
double error_of(const Candidate& found, const Case& each, const Quaternion& own) {
    const Row numbers = oracle::numbers(each.unknown, own);
    Row ordered;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        ordered.push_back(numbers[found.columns.at(i)]);
    }
    const auto& [left, right] = found.constant;
    const Quaternion answer = oracle::attitude(left) * oracle::attitude(found.spec, ordered) * oracle::attitude(right);
    const Quaternion truth = each.left * oracle::attitude(each.unknown, numbers) * each.right;
    return oracle::error_in_eps(answer, truth) * oracle::eps;
}

std::string text_of(const Candidate& answer) {
    const auto constant = [](std::string_view axes, const Rotation& rotation, std::string_view side) {
        return std::string(!axes.empty() ? axes : rotation.is_identity() ? "-" : side);
    };
    return answer.spec.text() + ' ' + constant(answer.reference_axes, answer.constant.left, "L") + ' ' +
           constant(answer.body_axes, answer.constant.right, "R");
}

void check(const Case& each, int seed, std::size_t count, double noise, double within, double allowed) {
    strata::Source random(static_cast<unsigned>(seed));
    std::size_t wrong = 0;
    std::size_t undecided = 0;
    const Identification fresh(each.unknown.size(), each.known, {}, {.within = within});
    std::vector<Row> pairs = pairs_of(each, random, noise);
    for (int run = 0; run < runs; ++run) {
        Row rows;
        for (std::size_t i = 0; i < count; ++i) {
            const int other = random.integer(static_cast<int>(i), static_cast<int>(pairs.size()) - 1);
            std::swap(pairs[i], pairs[static_cast<std::size_t>(other)]);
            rows.insert(rows.end(), pairs[i].begin(), pairs[i].end());
        }
        const std::vector<std::size_t> lines(count, 1);
        std::vector<RowReport> reports;
        Identification identification = fresh;
        identification.add(rows, lines, reports);
        const Verdict verdict = identification.verdict();
        if (each.written == "none") {
            wrong += verdict.fitting;
            continue;
        }
        if (!verdict.answer) {
            ++undecided;
            continue;
        }
        const Candidate& found = *verdict.answer;
        CHECK(text_of(found) == each.written);
        wrong += error_of(found, each, random.attitude()) <= allowed ? 0 : 1;
    }
    INFO(each.name);
    CHECK(wrong == 0);
    CHECK(undecided == 0);
}

} // namespace

// Catches a turn on the wrong side or the wrong way round, a sign or an order that is not tried, one of two
// conventions that are the same but for turns.
TEST_CASE("conventions with constant turns are found, and no wrong one is") {
    int seed = 1;
    for (const Case& each : cases()) {
        check(each, ++seed, 8, 0.0, 1e-3, 1e-12);
    }
}

// Catches turns that are taken from the first rows alone, and limits for exact numbers.
TEST_CASE("conventions with constant turns are found in noise of 0.2 degrees") {
    int seed = 100;
    for (const Case& each : cases()) {
        check(each, ++seed, 16, 0.2 * degree, 1.0 * degree, 0.5 * degree);
    }
}

// Catches an answer that is right on these rows alone.
TEST_CASE("no wrong convention is found where all rows turn little, or about one axis") {
    int seed = 200;
    std::size_t answered = 0;
    for (const Case& each : cases()) {
        strata::Source random(static_cast<unsigned>(++seed));
        for (const bool is_small : {true, false}) {
            std::size_t wrong = 0;
            for (int run = 0; run < (is_sanitized ? 10 : 60); ++run) {
                const Quaternion base = random.attitude();
                const Vector3 axis = random.axis();
                Row rows;
                for (int i = 0; i < 8; ++i) {
                    const Quaternion step =
                        is_small ? small(random, 0.02) : oracle::about(axis, 0.1 * random.integer(0, 59));
                    const Row unknown = oracle::numbers(each.unknown, base * step);
                    const Row known =
                        oracle::numbers(each.known, each.left * oracle::attitude(each.unknown, unknown) * each.right);
                    rows.insert(rows.end(), unknown.begin(), unknown.end());
                    rows.insert(rows.end(), known.begin(), known.end());
                }
                const std::vector<std::size_t> lines(8, 1);
                std::vector<RowReport> reports;
                Identification identification(each.unknown.size(), each.known, {}, {.within = 1e-6});
                identification.add(rows, lines, reports);
                const Verdict verdict = identification.verdict();
                answered += verdict.answer ? 1 : 0;
                wrong += verdict.answer && error_of(*verdict.answer, each, random.attitude()) > 1e-5 ? 1 : 0;
            }
            INFO(each.name << (is_small ? ", little" : ", about one axis"));
            CHECK(wrong == 0);
        }
    }
    CHECK(answered > (is_sanitized ? 20 : 200)); // else the rows lack something, and that is said
}
