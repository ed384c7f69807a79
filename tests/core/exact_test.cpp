// The numbers that are printed are the doubles nearest to the exact function of the numbers read: bits are compared.

#include <string>
#include <vector>

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
    CHECK(count.beyond <= count.numbers / 5);
    CHECK(count.uncertain <= count.numbers / 100);
}

} // namespace

// Would catch: a number that is not the nearest double.
TEST_CASE("every number of every pair is the double nearest to the exact function of the numbers read") {
    for (const auto& from : accuracy::compared_specs()) {
        for (const auto& to : accuracy::compared_specs()) {
            check(from, to, 60);
        }
    }
}

// Would catch: an axis, a sign or an order that one sequence alone gets wrong, and a modifier that rounds.
TEST_CASE("every sequence and every modifier is rounded once") {
    for (const auto sequence : rotconv::EulerSequence::all()) {
        const std::string text = "euler:" + sequence.text();
        check("quat", text + ":deg", 8);
        check(text, "dcm", 200);
        check(text + ":deg", text, 100);
    }
    for (const auto& text : accuracy::all_specs()) {
        check("quat", text, 4);
        check(text, "quat", 8);
    }
}

// Would catch: a constant turn that is rounded before it turns.
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
