// ConversionSettings::left and ConversionSettings::right: attitudes turned by constant ones.

#include <algorithm>
#include <array>
#include <cmath>

#include <rotconv/rotconv.hpp>

#include "accuracy.hpp"
#include "catch.hpp"
#include "oracle.hpp"
#include "strata.hpp"

using namespace rotconv;

namespace {

std::vector<double> converted(const Spec& from, const Spec& to, const ConversionSettings& settings,
                              const std::vector<double>& row) {
    return accuracy::converted(from, to, row, settings).numbers;
}

ConversionSettings turned(const Rotation& left, const Rotation& right) {
    return {.tolerance = 1e300, .lock_margin = 0.0, .left = left, .right = right};
}

/// The doubles of a unit quaternion.
std::vector<double> random_quaternion(strata::Source& source) {
    return oracle::numbers(accuracy::spec("quat"), source.attitude());
}

} // namespace

// Catches plain products, which add 2, a product in the wrong order, and one taken on the wrong side of an inverse.
TEST_CASE("a turn on each side adds at most 1 eps to a conversion's error") {
    strata::Source source(1301);
    for (const auto* from_text : {"quat", "quat:passive", "dcm:passive", "euler:ZYX:deg", "rotvec"}) {
        const auto from = accuracy::spec(from_text);
        for (const auto* to_text : {"quat", "quat:xyzw:passive", "dcm", "dcm:col:passive", "rpy", "rotvec:passive"}) {
            const auto to = accuracy::spec(to_text);
            const double limit = accuracy::limit_from(from) + accuracy::limit_to(to);
            for (const auto& row : accuracy::inputs(from, to, 40)) {
                const auto left = random_quaternion(source);
                const auto right = random_quaternion(source);
                const Rotation l = *read_attitude(Spec{}, left);
                const Rotation r = *read_attitude(Spec{}, right);
                const auto exact = oracle::attitude(from, row);
                const auto exact_left = oracle::attitude(Spec{}, left);
                const auto exact_right = oracle::attitude(Spec{}, right);
                const auto error = [&](const ConversionSettings& settings, const oracle::Quaternion& expected) {
                    return oracle::error_in_eps(expected, oracle::attitude(to, converted(from, to, settings, row)));
                };
                CHECK(error(turned(l, {}), exact_left * exact) <= limit + 1.0);
                CHECK(error(turned({}, r), exact * exact_right) <= limit + 1.0);
                CHECK(error(turned(l, r), exact_left * exact * exact_right) <= limit + 2.0);
            }
        }
    }
}

// Catches a turn that rounds, scales a unit quaternion, or leaves a sign or -0 that is not printed.
TEST_CASE("a turn by the identity, half-turns and quarter turns is exact") {
    const Rotation identity;
    strata::Source source(1303);
    for (int i = 0; i < 1000; ++i) {
        const auto row = random_quaternion(source);
        const auto plain = converted(Spec{}, Spec{}, {}, row);
        CHECK(converted(Spec{}, Spec{}, turned(identity, {}), row) == plain);
        CHECK(converted(Spec{}, Spec{}, turned(identity, identity), row) == plain);
        // i q = -x + w i - z j + y k, with the sign that is printed
        const Rotation half = *read_attitude(accuracy::spec("rpy:deg"), std::array{180.0, 0.0, 0.0});
        std::vector<double> expected{-row[1], row[0], -row[3], row[2]};
        if (expected[0] < 0.0) {
            std::ranges::transform(expected, expected.begin(), [](double v) { return -v; });
        }
        CHECK(converted(Spec{}, Spec{}, turned(half, {}), row) == expected);
    }
    const auto degrees = accuracy::spec("rpy:deg");
    const Rotation quarter = *read_attitude(degrees, std::array{0.0, 0.0, 90.0});
    CHECK(converted(degrees, degrees, turned(quarter, quarter), {0, 0, 90}) == std::vector<double>{0, 0, -90});
    CHECK(converted(degrees, accuracy::spec("dcm"), turned(quarter, {}), {0, 0, 90}) ==
          std::vector<double>{-1, 0, 0, 0, -1, 0, 0, 0, 1});
}

// Catches a lock that is looked for before the turn, and a defect that the turn has changed.
TEST_CASE("what is told of a turned attitude is the input's defect and the output's sensitivity") {
    const auto degrees = accuracy::spec("rpy:deg");
    const Rotation down = *read_attitude(degrees, std::array{0.0, 90.0, 0.0});
    std::vector<double> out(6);
    std::vector<RowReport> reports;
    const std::array<double, 8> rows{1.0005, 0, 0, 0, 0.70745, 0, -0.70745, 0};
    Conversion(Spec{}, degrees, {.tolerance = 1e-2, .sensitivity = true, .left = down}).run(rows, out, reports);
    REQUIRE(reports.size() == 2);
    CHECK(reports[0].diagnostics.has(DiagnosticKind::gimbal_lock));
    CHECK(reports[0].sensitivity.margin <= 1e-15);
    CHECK(reports[0].defect == Approx(5e-4));
    CHECK(!reports[1].diagnostics.has(DiagnosticKind::gimbal_lock));
    CHECK(reports[1].sensitivity.margin == Approx(M_PI_2));
    CHECK(out == std::vector<double>{0, 90, 0, 0, 0, 0});
}

// Catches the order or the inverse left out.
TEST_CASE("an attitude is read with all that its SPEC says") {
    const auto spec = accuracy::spec("quat:xyzw:passive");
    const std::array<double, 4> numbers{0.1, 0.2, 0.3, 0.9};
    const Reading reading = read_attitude(spec, numbers);
    REQUIRE(reading);
    CHECK(oracle::error_in_eps(
              oracle::attitude(spec, numbers),
              oracle::Quaternion(reading->w(), reading->x(), reading->y(), reading->z()).normalized()) < 1e-6);
    CHECK(reading.defect() == Approx(1.0 - std::sqrt(0.95)));
    CHECK(read_attitude(spec, std::array<double, 4>{}).error() == Error::zero_quaternion);
}
