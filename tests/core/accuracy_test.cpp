// The table of limits: every way between the quaternion and a representation, over all strata.

#include <algorithm>
#include <sstream>

#include "accuracy.hpp"
#include "catch.hpp"
#include "oracle.hpp"
#include "strata.hpp"

using accuracy::spec;

constexpr int size = tried(2000);

// Catches any loss of digits anywhere, however near to a singularity.
TEST_CASE("every way stays within its limit in radians") {
    const auto way = GENERATE(from_range(accuracy::ways()));
    const auto worst = accuracy::worst_of(way, size);
    INFO(worst.where);
    CHECK(worst.error <= way.limit);
    CHECK((is_sanitized || worst.error > 0.3 * way.worst)); // a check that sees no error sees nothing
}

// Catches a reduction of degrees or a factor of pi/180 that costs digits.
TEST_CASE("every way stays within its limit in degrees") {
    for (const auto& way : accuracy::ways()) {
        if (spec(way.from == "euler" ? "rpy" : way.from).in_degrees().unit == rotconv::AngleUnit::radians &&
            spec(way.to == "euler" ? "rpy" : way.to).in_degrees().unit == rotconv::AngleUnit::radians) {
            continue; // no angles
        }
        const auto worst = accuracy::worst_of(way, size, rotconv::AngleUnit::degrees);
        INFO(worst.where);
        CHECK(worst.error <= way.limit);
    }
}

// Catches squares that underflow, sums that swallow a small angle.
TEST_CASE("tiny angles keep their relative accuracy") {
    strata::Source source(21);
    const std::vector<std::string> names{"quat", "rotvec", "cayley", "mrp"};
    for (const auto& from : names) {
        for (const auto& to : names) {
            const auto convert = accuracy::fast(spec(from), spec(to));
            double worst = 0.0;
            for (int i = 0; i < 400; ++i) {
                const auto angle = pow(oracle::Real(10), oracle::Real(source.uniform(-290, -1)));
                const auto row = oracle::numbers(spec(from), oracle::about(source.axis(), angle));
                const auto exact = oracle::attitude(spec(from), row);
                const auto result = oracle::attitude(spec(to), convert(row));
                worst = std::max(worst, oracle::relative_error_in_eps(exact, result));
            }
            INFO(from << " to " << to);
            CHECK(worst <= 8.0);
        }
    }
}

// Catches a projection by 1 in the place of a length that is nearly 1, which is lost beside a turn of ordinary
// size.
TEST_CASE("matrices and columns that are nearly clean keep the relative accuracy of a small angle") {
    strata::Source source(22);
    for (const std::string from : {"dcm", "6d"}) {
        const auto convert = accuracy::fast(spec(from), spec("quat"));
        double worst = 0.0;
        for (int i = 0; i < 2000; ++i) {
            const auto angle = pow(oracle::Real(10), oracle::Real(source.uniform(-12, -1)));
            auto row = oracle::numbers(spec(from), oracle::about(source.axis(), angle));
            for (double& number : row) {
                number += 5e-10 * source.uniform(-1, 1);
            }
            const auto exact = oracle::attitude(spec(from), row);
            worst = std::max(worst, oracle::relative_error_in_eps(exact, oracle::attitude(spec("quat"), convert(row))));
        }
        INFO(from);
        CHECK(worst <= 8.0);
    }
}

// Catches an argument reduction that fails for huge angles. sin and cos of 1e22 are Payne and Hanek's example;
// the digits come from 60-digit arithmetic.
TEST_CASE("angles of any finite size are taken modulo the full turn") {
    const auto quat = spec("quat");
    const oracle::Real sine("-0.852200849767188801772705893753029368");
    const oracle::Real cosine("0.523214785395138945497594473384709492");
    const oracle::Quaternion twice(cosine, 0, 0, sine); // the attitude of 2e22 about z
    for (const auto& [text, row] : std::vector<std::pair<std::string, std::vector<double>>>{
             {"rotvec", {0, 0, 1e22}}, {"axis-angle", {0, 0, 3, 1e22}}, {"euler:ZYX", {1e22, 0, 0}}}) {
        const auto once = oracle::attitude(quat, accuracy::fast(spec(text), quat)(row));
        INFO(text);
        CHECK(oracle::error_in_eps(once * once, twice) < 5.0);
    }
    for (const double huge : {1e300, 1.7976931348623157e308}) {
        for (const std::string text : {"rotvec", "rotvec:deg"}) {
            const auto q = accuracy::fast(spec(text), quat)(std::vector<double>{huge, -huge, huge});
            INFO(text << ' ' << huge);
            CHECK(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] == Approx(1.0));
        }
    }
    // 2^1000 = 16 modulo 360
    const auto turned = accuracy::fast(spec("rotvec:deg"), spec("rotvec:deg"))(std::vector<double>{0, 0x1p1000, 0});
    CHECK(turned[1] == Approx(16.0).epsilon(1e-15));
}

// Catches a page that claims other limits or figures than the tests hold.
TEST_CASE("the page on accuracy shows the table of limits") {
    const std::string page = accuracy::text_of(ROTCONV_EXAMPLES "/accuracy.md");
    for (const auto& way : accuracy::ways()) {
        std::ostringstream row;
        row << "| `" << way.from << "` | `" << way.to << "` | " << way.limit << " | " << way.worst << " |";
        INFO(row.str());
        CHECK(page.find(row.str()) != std::string::npos);
    }
}

// Catches a README that promises less or more than the table.
TEST_CASE("the README lists the limits of plain double arithmetic") {
    std::string readme = accuracy::text_of(ROTCONV_README);
    std::ranges::replace(readme, '\n', ' ');
    const auto listed = [](const std::vector<std::string>& names, auto limit, const std::string& preposition) {
        double largest = 0.0;
        std::string list;
        for (std::size_t i = 0; i < names.size(); ++i) {
            largest = std::max(largest, limit(spec(names[i] == "euler" ? "euler:ZYX" : names[i])));
            list += (i == 0 ? "" : (i + 1 == names.size() ? " and " : ", ")) + names[i];
        }
        std::ostringstream text;
        text << largest << ' ' << preposition << ' ' << list;
        return text.str();
    };
    using accuracy::limit_from;
    using accuracy::limit_to;
    std::ostringstream text;
    text << "From a quaternion they are " << listed({"quat", "cayley", "mrp"}, limit_to, "to") << ", "
         << listed({"dcm", "6d", "rotvec", "axis-angle"}, limit_to, "to") << ", "
         << listed({"5d", "euler"}, limit_to, "to") << "; to a quaternion "
         << listed({"cayley", "mrp", "rotvec", "axis-angle"}, limit_from, "from") << ", "
         << listed({"dcm", "6d", "euler"}, limit_from, "from") << ", " << listed({"5d"}, limit_from, "from") << '.';
    INFO(text.str());
    CHECK(readme.find(text.str()) != std::string::npos);
}
