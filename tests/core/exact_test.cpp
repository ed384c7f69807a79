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
    std::size_t beyond = 0; ///< off, but with an error that is enlarged 2^40 times
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

/// By how much a number may be off whose error is enlarged 2^40 times or more by the condition and by cancellation.
double beyond_promise(double condition, double value) {
    const double enlarged = std::max(1.0, condition) / std::fabs(value);
    return enlarged >= 0x1p40 ? 0x1p-96 * std::max(1.0, condition) + 0x1p-52 * std::fabs(value) : 0.0;
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
                if (std::fabs(result[i] - exact[i].value) <=
                    beyond_promise(reports[0].sensitivity.condition, exact[i].value)) {
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

Count compare(const std::string& from_text, const std::string& to_text, int size) {
    const Spec from = accuracy::spec(from_text);
    const Spec to = accuracy::spec(to_text);
    const Count count = compare(from, to, accuracy::inputs(from, to, size));
    std::printf("%s %s: %zu rows, %zu wrong, %zu beyond, %zu uncertain\n", from_text.c_str(), to_text.c_str(),
                count.rows, count.wrong, count.beyond, count.uncertain);
    return count;
}

} // namespace

// Would catch: a number that is not the nearest double.
TEST_CASE("every number is the double nearest to the exact function of the numbers read") {
    const auto names = {"quat", "dcm",           "6d",       "5d", "cayley", "rotvec", "rotvec:deg", "axis-angle:deg",
                        "mrp",  "euler:ZYX:deg", "euler:zxz"};
    for (const std::string from : names) {
        for (const std::string to : names) {
            const Count count = compare(from, to, 100);
            INFO(from << " to " << to);
            CHECK(count.wrong == 0);
            CHECK(count.rows > 100);
            CHECK(count.uncertain <= count.numbers / 100);
        }
    }
}
