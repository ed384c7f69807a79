// The printed numbers' ranges, signs and zeros.

#include <cmath>
#include <numbers>

#include <rotconv/conversion.hpp>

#include "accuracy.hpp"
#include "catch.hpp"
#include "strata.hpp"

using accuracy::spec;

namespace {

constexpr double pi = std::numbers::pi;

double norm(const std::vector<double>& v, std::size_t count = 3) {
    double square = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        square += v[i] * v[i];
    }
    return std::sqrt(square);
}

/// w > 0, or w = 0 and the first nonzero of the rest positive.
bool canonical(double w, double x, double y, double z) {
    return w > 0 || (w == 0 && (x > 0 || (x == 0 && (y > 0 || (y == 0 && z > 0)))));
}

} // namespace

// Catches a branch that leaves its range near a border, a modifier that is applied after the range was made, a -0.
TEST_CASE("outputs stay in their ranges with and without modifiers") {
    const auto quat = spec("quat");
    for (const std::string modifier : {"", ":passive", ":deg", ":deg:passive", ":positive", ":deg:positive"}) {
        const bool degrees = modifier.find("deg") != std::string::npos;
        const double half_turn = degrees ? 180.0 : pi;
        const double rounding = 4e-16 * half_turn;
        for (const auto id : rotconv::all_representations) {
            const auto& entry = rotconv::representation(id);
            if ((degrees && !entry.has_angles()) || (modifier.ends_with("positive") && !entry.has_gimbal_lock)) {
                continue;
            }
            std::vector<std::string> texts{std::string(entry.text) + modifier};
            if (entry.name == rotconv::RepresentationId::euler) {
                texts.clear();
                for (const std::string& sequence : accuracy::signed_sequences()) {
                    texts.push_back("euler:" + sequence + modifier);
                }
            }
            for (const auto& text : texts) {
                const auto to = spec(text);
                const auto convert = accuracy::own(quat, to);
                for (const auto& row :
                     accuracy::inputs(quat, to, entry.name == rotconv::RepresentationId::euler ? 3 : tried(150))) {
                    const auto v = convert(row);
                    INFO(text << ' ' << row[0] << ' ' << row[1] << ' ' << row[2] << ' ' << row[3]);
                    for (const double number : v) {
                        REQUIRE_FALSE((number == 0.0 && std::signbit(number)));
                        REQUIRE_FALSE(std::isnan(number));
                    }
                    switch (entry.name) {
                    case rotconv::RepresentationId::quat:
                        REQUIRE(canonical(v[0], v[1], v[2], v[3]));
                        REQUIRE(norm(v, 4) == Approx(1).epsilon(1e-15));
                        break;
                    case rotconv::RepresentationId::rotvec: REQUIRE(norm(v) <= half_turn + rounding); break;
                    case rotconv::RepresentationId::mrp: REQUIRE(norm(v) <= 1 + 4e-16); break;
                    case rotconv::RepresentationId::axis_angle:
                        REQUIRE(norm(v) == Approx(1).epsilon(1e-15));
                        REQUIRE(v[3] >= 0);
                        REQUIRE(v[3] <= half_turn);
                        break;
                    case rotconv::RepresentationId::euler:
                    case rotconv::RepresentationId::rpy:
                        for (const std::size_t outer : {std::size_t{0}, std::size_t{2}}) {
                            if (to.positive) {
                                REQUIRE(v[outer] >= 0.0);
                                REQUIRE(v[outer] < 2 * half_turn);
                            } else {
                                REQUIRE(v[outer] > -half_turn);
                                REQUIRE(v[outer] <= half_turn);
                            }
                        }
                        REQUIRE(v[1] >= (to.sequence.proper() ? 0 : -half_turn / 2));
                        REQUIRE(v[1] <= (to.sequence.proper() ? half_turn : half_turn / 2));
                        break;
                    case rotconv::RepresentationId::five_d:
                        REQUIRE(norm(v, 5) >= std::sqrt(2.0) - 1 - 4e-16);
                        REQUIRE(norm(v, 5) <= std::sqrt(2.0) + 1 + 4e-16);
                        break;
                    case rotconv::RepresentationId::dcm:
                    case rotconv::RepresentationId::two_column:
                        for (const double entry_of_matrix : v) {
                            REQUIRE(std::abs(entry_of_matrix) <= 1.0);
                        }
                        break;
                    case rotconv::RepresentationId::cayley: break; // any number
                    }
                }
            }
        }
    }
}

// Catches a sign that follows the input where it should follow the rule, after the inverse too.
TEST_CASE("the sign of a half-turn follows the quaternion rule") {
    const std::vector<double> turn{0, -0.6, 0.8, 0};
    for (const std::string modifier : {"", ":passive"}) {
        CHECK(accuracy::own(spec("quat"), spec("quat" + modifier))(turn) == std::vector<double>{0, 0.6, -0.8, 0});
        const auto mrp = accuracy::own(spec("quat"), spec("mrp" + modifier))(turn);
        CHECK(mrp[0] == Approx(0.6));
        CHECK(mrp[1] == Approx(-0.8));
        const auto rotvec = accuracy::own(spec("quat"), spec("rotvec" + modifier))(turn);
        CHECK(rotvec[0] > 0);
        const auto axis = accuracy::own(spec("quat"), spec("axis-angle" + modifier))(turn);
        CHECK(axis[0] > 0);
        CHECK(axis[3] == pi);
    }
}

// Catches quarter turns that pick up a rounding in degrees.
TEST_CASE("multiples of 90 degrees are exact both ways") {
    for (const std::string& sequence : accuracy::signed_sequences()) {
        const std::string text = "euler:" + sequence + ":deg";
        const auto to_matrix = accuracy::own(spec(text), spec("dcm"));
        const auto back = accuracy::own(spec("dcm"), spec(text));
        for (int i = 0; i < 64; ++i) {
            const std::vector<double> angles{90.0 * (i % 4 - 1) + 3600, 90.0 * (i / 4 % 4) - 720, 90.0 * (i / 16)};
            const auto matrix = to_matrix(angles);
            for (const double entry : matrix) {
                CHECK((entry == 0.0 || entry == 1.0 || entry == -1.0));
            }
            for (const double angle : back(matrix)) {
                CHECK(std::fmod(angle, 90.0) == 0.0);
            }
        }
    }
    CHECK(accuracy::own(spec("rotvec:deg"), spec("dcm"))(std::vector<double>{0, -270, 0}) ==
          std::vector<double>{0, 0, 1, 0, 1, 0, -1, 0, 0});
    CHECK(accuracy::own(spec("dcm"), spec("rotvec:deg"))(std::vector<double>{0, 0, 1, 0, 1, 0, -1, 0, 0}) ==
          std::vector<double>{0, 90, 0});
    CHECK(accuracy::own(spec("axis-angle:deg"), spec("dcm"))(std::vector<double>{0, 0, 5, 450}) ==
          std::vector<double>{0, -1, 0, 1, 0, 0, 0, 0, 1});
}

// Catches normalising what is normalised, so that a second pass changes bits.
TEST_CASE("a unit quaternion keeps its bits") {
    const auto quat = accuracy::own(spec("quat"), spec("quat"));
    strata::Source source(41);
    for (int i = 0; i < 2000; ++i) {
        const auto once = quat(oracle::numbers(spec("quat"), source.attitude()));
        CHECK(quat(once) == once);
    }
}
