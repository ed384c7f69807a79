// The numbers that are printed are the doubles nearest to the exact function of the numbers read: bits are compared.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include <rotconv/conversion.hpp>

#include "accuracy.hpp"
#include "catch.hpp"
#include "oracle.hpp"
#include "strata.hpp"

using rotconv::Spec;

namespace {

struct Count {
    std::size_t rows = 0;
    std::size_t numbers = 0;
    std::size_t wrong = 0;
    std::size_t beyond = 0; ///< off, but within the promise: where errors are enlarged, and next to ties
    std::size_t uncertain = 0;
};

/// A quaternion that is unit to 4 eps keeps its bits.
bool keeps_bits(const Spec& from, const Spec& to, std::span<const double> row) {
    if (from.name != rotconv::RepresentationId::quat || to.name != rotconv::RepresentationId::quat) {
        return false;
    }
    oracle::Real square = 0;
    for (const double component : row) {
        square += oracle::Real(component) * component;
    }
    return abs(sqrt(square) - 1) <= oracle::Real(4.001 * oracle::eps);
}

/// How much more the relative error of a number is than that of the attitude: by the condition of the output, by
/// cancellation, and in long rotation vectors. A small angle is known as well as a large one, where no sum of angles
/// makes it.
double enlargement(const Spec& from, const Spec& to, std::span<const double> row, double condition, double number) {
    const auto in_radians = [](const Spec& spec) {
        return spec.unit == rotconv::AngleUnit::degrees ? 0.017453292519943295 : 1.0;
    };
    double length = 0.0;
    if (from.name == rotconv::RepresentationId::rotvec) { // 2^-104 of it
        length = 0x1p-7 * std::hypot(row[0], row[1], row[2]) * in_radians(from);
    }
    const auto attitude = rotconv::read_attitude(from, row);
    const bool is_sum = rotconv::representation(from.name).has_gimbal_lock;
    const double angle = is_sum ? 1.0 : std::min(1.0, attitude->vector_length());
    return std::max(1.0, condition) * std::max(1.0, angle / std::fabs(number * in_radians(to))) * std::max(1.0, length);
}

double ulp_of(double number) {
    return std::nextafter(std::fabs(number), std::numeric_limits<double>::infinity()) - std::fabs(number);
}

Count compare(const Spec& from, const Spec& to, const std::vector<std::vector<double>>& rows) {
    const rotconv::Conversion conversion(from, to,
                                         {.tolerance = std::numeric_limits<double>::infinity(), .sensitivity = true});
    Count count;
    std::vector<double> result(to.size());
    std::vector<rotconv::Report> reports;
    for (const auto& row : rows) {
        conversion.run(row, result, reports);
        if (reports.at(0).error != rotconv::Error::none) {
            continue;
        }
        if (keeps_bits(from, to, row)) {
            continue;
        }
        ++count.rows;
        const auto exact = oracle::converted(from, to, row);
        for (std::size_t i = 0; i < result.size(); ++i) {
            ++count.numbers;
            if (!exact[i].certain) {
                ++count.uncertain;
            } else if (std::bit_cast<std::uint64_t>(exact[i].value) != std::bit_cast<std::uint64_t>(result[i])) {
                const double enlarged = enlargement(from, to, row, reports[0].sensitivity.condition, exact[i].value);
                const double off = std::fabs((result[i] - exact[i].value) - exact[i].rest) / ulp_of(exact[i].value);
                if (off <= 0.5 + 0x1p-45 * enlarged) {
                    ++count.beyond;
                    continue;
                }
                ++count.wrong;
                if (count.wrong <= 3) {
                    std::string text;
                    for (const double number : row) {
                        char digits[40];
                        std::snprintf(digits, sizeof digits, " %.17g", number);
                        text += digits;
                    }
                    std::printf("   number %zu:%s: %.17g for %.17g\n", i + 1, text.c_str(), result[i], exact[i].value);
                }
            }
        }
    }
    return count;
}

/// All strata, about `size` rows in each.
Count compare(const std::string& from_text, const std::string& to_text, int size) {
    const Spec from = accuracy::spec(from_text);
    const Spec to = accuracy::spec(to_text);
    return compare(from, to, accuracy::inputs(from, to, size));
}

void check(const std::string& from, const std::string& to, int size) {
    const Count count = compare(from, to, size);
    INFO(from << " to " << to << ": " << count.wrong << " of " << count.numbers);
    CHECK(count.wrong == 0);
    CHECK(count.rows > 0);
    CHECK(count.beyond <= count.numbers / 5);
    CHECK(count.uncertain <= count.numbers / 100);
}

const std::vector<std::string>& names() {
    static const std::vector<std::string> all{
        "quat", "dcm", "6d", "5d", "cayley", "rotvec", "rotvec:deg", "axis-angle:deg", "mrp", "rpy:deg", "euler:zxz"};
    return all;
}

} // namespace

// Would catch: a number that is not the nearest double.
TEST_CASE("every number of every pair is the double nearest to the exact function of the numbers read") {
    for (const auto& from : names()) {
        for (const auto& to : names()) {
            check(from, to, 60);
        }
    }
}

// Would catch: an axis, a sign or an order that one sequence alone gets wrong, and a modifier that rounds.
TEST_CASE("every sequence and every modifier is rounded once") {
    for (const auto sequence : rotconv::EulerSequence::all()) {
        const auto letters = sequence.letters();
        const std::string text = "euler:" + std::string(letters.data(), letters.size());
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
        const rotconv::Conversion conversion(angles, accuracy::spec("dcm"),
                                             {.left = rotconv::ConstantTurn::of_numbers(angles, left),
                                              .right = rotconv::ConstantTurn::of_numbers(quat, right)});
        std::vector<double> result(9);
        std::vector<rotconv::Report> reports;
        conversion.run(row, result, reports);
        const auto exact =
            oracle::attitude(angles, left) * oracle::attitude(angles, row) * oracle::attitude(quat, right);
        CHECK(result == oracle::numbers(accuracy::spec("dcm"), exact));
    }
}

// Ten million rows, a few hours: test_core "[large]", with --durations yes for a sign of life.
TEST_CASE("every pair at length", "[.large]") {
    for (const auto& from : names()) {
        for (const auto& to : names()) {
            const Count count = compare(from, to, 9000);
            std::printf("%s %s: %zu rows, %zu numbers, %zu wrong, %zu within the promise, %zu uncertain\n",
                        from.c_str(), to.c_str(), count.rows, count.numbers, count.wrong, count.beyond,
                        count.uncertain);
            CHECK(count.wrong == 0);
        }
    }
}
