// Motions of which it is known what they demand.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include <rotconv/axis_angle.hpp>
#include <rotconv/conversion.hpp>

#include "../../src/core/kinematics/survey.hpp"
#include "accuracy.hpp"
#include "catch.hpp"

using namespace rotconv;
using accuracy::spec;

namespace {

constexpr double pi = std::numbers::pi;

/// A turn about an axis of length 1.
Rotation turn(double x, double y, double z, double angle) {
    const double s = std::sin(angle / 2.0);
    return Rotation::near_unit(std::cos(angle / 2.0), s * x, s * y, s * z);
}

Rotation about_z(double angle) { return turn(0, 0, 1, angle); }

/// `count` attitudes of a motion, rows from 1.
template <class Motion> Survey survey_of(const Motion& motion, int count) {
    Survey survey;
    for (int i = 0; i < count; ++i) {
        survey.add(motion(i), static_cast<std::size_t>(i) + 1);
    }
    return survey;
}

const RepresentationSurvey& find(const Survey& survey, std::string_view text) {
    for (const RepresentationSurvey& set : survey.representations()) {
        if (set.spec.name == spec(text).name &&
            (set.spec.name != RepresentationId::euler || set.spec.sequence == spec(text).sequence)) {
            return set;
        }
    }
    FAIL("no such set");
    return survey.representations()[0];
}

/// The smallest set, after a look at all that serve.
const RepresentationSurvey& smallest(const Survey& survey, double limit) {
    const RepresentationSurvey* const found = survey.smallest(limit);
    REQUIRE(found != nullptr);
    CHECK(found->serves(limit));
    for (const RepresentationSurvey& set : survey.representations()) {
        if (set.serves(limit) && set.spec.size() <= found->spec.size()) {
            CHECK(set.spec.size() == found->spec.size());
            CHECK(set.greatest_condition >= found->greatest_condition);
        }
    }
    return *found;
}

} // namespace

// Catches a set that is left out or listed twice.
TEST_CASE("a survey has every set once") {
    const Survey survey;
    for (const RepresentationId id : all_representations) {
        const Representation& entry = representation(id);
        std::set<std::string> sequences;
        std::size_t count = 0;
        for (const RepresentationSurvey& set : survey.representations()) {
            if (set.spec.name == id) {
                ++count;
                sequences.insert(set.spec.sequence.text());
                CHECK((set.spec.sequence.intrinsic() || !entry.takes_sequence));
            }
        }
        INFO(entry.text);
        // roll, pitch and yaw are one of the sequences
        CHECK(count == (entry.takes_sequence ? 12 : entry.has_gimbal_lock ? 0 : 1));
        CHECK(sequences.size() == count);
    }
}

// Catches wraps and shadow switches that are not seen, and smooth sets that are accused.
TEST_CASE("a spin about z through half-turns") {
    // three turns in steps of 1.23 degrees, never exactly at a half-turn: it is passed three times
    const Survey survey = survey_of([](int i) { return about_z(0.003 + i * 1.23 * pi / 180.0); }, 878);
    for (const char* name : {"rotvec", "mrp", "cayley", "euler:ZYX", "euler:XYZ", "quat"}) {
        INFO(name);
        CHECK(find(survey, name).jumps == 3);
        CHECK(find(survey, name).jump_row == 148); // (180 - 0.17)/1.23 = 146.2 steps
    }
    CHECK(find(survey, "axis-angle").jumps == 5); // its axis also turns over at the two full turns
    for (const char* name : {"dcm", "6d", "5d"}) {
        INFO(name);
        CHECK(find(survey, name).jumps == 0);
        CHECK(find(survey, name).serves(10.0));
    }
    CHECK_FALSE(find(survey, "rotvec").serves(1e9));
    CHECK(smallest(survey, 1e3).spec.size() == 4);
    CHECK(find(survey, "quat").serves(1e3));
}

// Catches margin and condition of the wrong attitude, or their row.
TEST_CASE("figures of a slow spin about z") {
    const Survey survey = survey_of([](int i) { return about_z(0.1 * i); }, 21); // up to 2 radians
    const RepresentationSurvey& cayley = find(survey, "cayley");
    CHECK(cayley.least_margin == Approx(pi - 2.0).epsilon(1e-14));
    CHECK(cayley.margin_row == 21);
    CHECK(cayley.greatest_condition == Approx(0.5 / (std::cos(1.0) * std::cos(1.0))).epsilon(1e-14));
    CHECK(cayley.condition_row == 21);
    CHECK(find(survey, "rotvec").greatest_condition == Approx(1.0 / std::sin(1.0)).epsilon(1e-14));
    CHECK(find(survey, "quat").greatest_condition == 0.5);
    CHECK(std::isinf(find(survey, "quat").least_margin));
    CHECK(find(survey, "euler:ZYX").greatest_condition == Approx(1.0).epsilon(1e-14));
    // the first row is the identity, where the proper sequences are locked
    CHECK(find(survey, "euler:ZXZ").least_margin == 0.0);
    CHECK(find(survey, "euler:ZXZ").margin_row == 1);
    CHECK_FALSE(find(survey, "euler:ZXZ").serves(1e3));
    CHECK(smallest(survey, 1e3).spec.size() == 3);
    CHECK(smallest(survey, 1e3).greatest_condition <= 0.25 * (1 + std::pow(std::tan(0.5), 2)) * (1 + 1e-15)); // mrp
    for (const char* name : {"dcm", "6d", "5d", "quat", "rotvec", "cayley", "mrp", "euler:ZYX", "euler:XYZ"}) {
        INFO(name);
        CHECK(find(survey, name).jumps == 0);
    }
    CHECK(find(survey, "euler:XZY").jumps == 1); // its lock is at 90 degrees
    CHECK(find(survey, "euler:XZY").jump_row == 17);
}

// Catches an infinite set that serves, and a loop without end.
TEST_CASE("rows exactly at a half-turn") {
    Survey survey;
    survey.add(Rotation::near_unit(0.1, 0, 0, 1), 1);
    survey.add(Rotation::near_unit(0, 0, 0, 1), 2);
    survey.add(Rotation::near_unit(0, 0, 0, 1), 3);
    survey.add(Rotation::near_unit(-0.1, 0, 0, 1), 4);
    const RepresentationSurvey& cayley = find(survey, "cayley");
    CHECK(cayley.least_margin == 0.0);
    CHECK(std::isinf(cayley.greatest_condition));
    CHECK(cayley.condition_row == 2);
    CHECK_FALSE(cayley.serves(1e300));
    CHECK(find(survey, "rotvec").jumps == 1);
    CHECK(find(survey, "rotvec").jump_row == 4);
}

namespace {

/// The manual's rule read once more: parts of the shortest rotation from a to b as intervals of [0, 1].
class PlainRule {
public:
    PlainRule(const Spec& set, Eigen::Quaterniond a, Eigen::Quaterniond b)
        : conversion_(spec("quat"), set, {.sensitivity = true}), a_(a.normalized()), b_(b.normalized()),
          condition_(std::min(1e15, std::max(report_at(0).sensitivity.condition, report_at(1).sensitivity.condition))) {
    }

    [[nodiscard]] bool jumps() const {
        double from = 0.0;
        double to = 1.0;
        while (change(from, to) > 1.0) {
            if (jumps_between(from, to)) {
                return true;
            }
            const double middle = 0.5 * (from + to);
            (change(from, middle) >= change(middle, to) ? to : from) = middle;
        }
        return false;
    }

    [[nodiscard]] bool jumps_between(double from, double to) const {
        const double step = change(from, to);
        return step > 1.0 && step > 2.0 * condition_ * (to - from) * a_.angularDistance(b_);
    }

private:
    [[nodiscard]] RowReport report_at(double t, std::vector<double>* numbers = nullptr) const {
        const Eigen::Quaterniond q = a_.slerp(t, b_);
        std::vector<double> out(conversion_.to().size());
        std::vector<RowReport> reports;
        conversion_.run(std::vector<double>{q.w(), q.x(), q.y(), q.z()}, out, reports);
        if (numbers != nullptr) {
            *numbers = out;
        }
        return reports.at(0);
    }

    [[nodiscard]] double change(double from, double to) const {
        std::vector<double> first;
        std::vector<double> second;
        static_cast<void>(report_at(from, &first));
        static_cast<void>(report_at(to, &second));
        double sum = 0.0;
        for (std::size_t i = 0; i < first.size(); ++i) {
            sum += (first[i] - second[i]) * (first[i] - second[i]);
        }
        return std::sqrt(sum);
    }

    Conversion conversion_;
    Eigen::Quaterniond a_;
    Eigen::Quaterniond b_;
    double condition_;
};

} // namespace

// Catches a search that finds other jumps than the manual says, such as those of the parts that it does not keep.
TEST_CASE("jumps are those of the manual's rule") {
    const auto check = [](const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
        Survey survey;
        survey.add(Rotation::from_components(a.w(), a.x(), a.y(), a.z()), 1);
        survey.add(Rotation::from_components(b.w(), b.x(), b.y(), b.z()), 2);
        std::size_t found = 0;
        for (const RepresentationSurvey& set : survey.representations()) {
            INFO(std::string(representation(set.spec.name).text));
            CHECK(set.jumps == (PlainRule(set.spec, a, b).jumps() ? 1 : 0));
            found += set.jumps;
        }
        return found;
    };
    // Past the lock of YZX: one part is steep enough, but the halves in which the angles change more do not lead to it.
    const Eigen::Quaterniond a(0.6289, 0.0403, 0.0545, 0.7745);
    const Eigen::Quaterniond b(0.7150, 0.0463, 0.0544, 0.6954);
    const PlainRule yzx(spec("euler:YZX"), a, b);
    CHECK_FALSE(yzx.jumps());
    CHECK(yzx.jumps_between(0.86, 0.9075));
    check(a, b);

    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::size_t found = 0;
    for (int i = 0; i < 500; ++i) {
        const Eigen::Quaterniond from(normal(random), normal(random), normal(random), normal(random));
        const double size = std::pow(10.0, -0.01 * (i % 300));
        const Eigen::Quaterniond turn(1.0, size * normal(random), size * normal(random), size * normal(random));
        found += check(from, from * turn);
    }
    CHECK(found > 500);
}

// Catches a switch to the shadow within a step that ends near to where it began.
TEST_CASE("a jump within a long step is seen") {
    for (const double from : {95.0, 100.0, 120.0}) {
        Survey survey;
        for (const double yaw : {from, 360.0 - from}) {
            survey.add(*euler::to_rotation({{0, 0, yaw}, "xyz", AngleUnit::degrees}), 1);
        }
        for (const RepresentationSurvey& set : survey.representations()) {
            const auto name = set.spec.name;
            INFO(from << ' ' << representation(name).text);
            if (name == RepresentationId::mrp || name == RepresentationId::rotvec) {
                CHECK(set.jumps == 1);
            }
            if (name == RepresentationId::dcm || name == RepresentationId::two_column) {
                CHECK(set.jumps == 0);
            }
        }
    }
}
