// Decimals as they are written: order and differences.

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>

#include "catch.hpp"
#include "stream/decimal.hpp"
#include "stream/number_text.hpp"

using namespace rotconv::stream;
using Rational = boost::multiprecision::cpp_rational;

namespace {

Decimal decimal(const std::string& text) {
    const auto parsed = Decimal::parse(text);
    INFO(text);
    REQUIRE(parsed);
    return *parsed;
}

double difference(const std::string& a, const std::string& b, int power = 0) {
    const double found = (decimal(a) - decimal(b)).rounded(power);
    CHECK(Decimal::difference(decimal(a), decimal(b), power) == found);
    return found;
}

/// A number with up to `digits` digits on each side of the point, and its value.
struct Sample {
    std::string text;
    Rational value;
};

Sample sample(std::mt19937_64& random, std::size_t digits) {
    const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    std::string before;
    std::string after;
    while (before.size() < below(digits + 1)) {
        before += static_cast<char>('0' + (below(3) == 0 ? below(10) : 9 * below(2))); // often rows of 0 or 9
    }
    while (after.size() < below(digits + 1) || (before.empty() && after.empty())) {
        after += static_cast<char>('0' + (below(3) == 0 ? below(10) : 9 * below(2)));
    }
    const int power = static_cast<int>(below(41)) - 20;
    const bool negative = below(2) == 0;
    boost::multiprecision::cpp_int digits_value = 0;
    for (const char c : before + after) {
        digits_value = 10 * digits_value + (c - '0');
    }
    Rational value = digits_value;
    for (int i = static_cast<int>(after.size()) - power; i != 0; i += i < 0 ? 1 : -1) {
        value = i > 0 ? Rational(value / 10) : Rational(value * 10);
    }
    return {(negative ? "-" : "") + before + "." + after + "e" + std::to_string(power),
            negative ? Rational(-value) : value};
}

/// No other double is nearer.
bool is_nearest(double found, const Rational& exact) {
    const auto distance = [&exact](double value) { return Rational(abs(Rational(value) - exact)); };
    const double infinity = std::numeric_limits<double>::infinity();
    return distance(found) <= distance(std::nextafter(found, infinity)) &&
           distance(found) <= distance(std::nextafter(found, -infinity));
}

} // namespace

TEST_CASE("times of many digits lose nothing in their difference") {
    // Catches a difference of doubles, in which these are 0 or off.
    CHECK(difference("1403715524907143169", "1403715524907143168", -9) == 1e-9);
    CHECK(difference("9999999999999999999", "9999999999999999998", -9) == 1e-9);
    CHECK(difference("18446744073709551618", "1") == 0x1p64); // 20 digits: 2^64 + 1 is not 1
    CHECK(difference("1305031098.6758", "1305031098.6659") == 0.0099);
    CHECK(difference("1305031098.66590000000000000000000000000000000000001",
                     "1305031098.66590000000000000000000000000000000000000") == 1e-41);
    CHECK(difference("0.3", "0.2") == 0.1);
    CHECK(difference("-1", "1e0", -3) == -2e-3);
    CHECK(difference("7", "7.000") == 0.0);
    CHECK_FALSE(std::signbit(difference("-7", "-7.000")));
    CHECK(difference("0", "-0.5") == 0.5);
    CHECK(difference("0.5", "0") == 0.5);
    CHECK(difference("-0", "0.5") == -0.5);
}

TEST_CASE("decimals compare by value, whatever their length and form") {
    // Catches an order of doubles or of texts.
    CHECK(decimal("1.50") == decimal("+15e-1"));
    CHECK(decimal("-0.0e5") == decimal("0"));
    CHECK(decimal("9") < decimal("10"));
    CHECK(decimal("-9") > decimal("-10"));
    CHECK(decimal("-1") < decimal("0"));
    CHECK(decimal("0") < decimal("1e-999999"));
    CHECK(decimal("1403715524907143168") < decimal("1403715524907143169"));
    const std::string nines(5000, '9');
    CHECK(decimal("0." + nines) < decimal("1"));
    CHECK(decimal("0." + nines) > decimal("0." + nines.substr(1)));
}

TEST_CASE("differences and order are those of rational arithmetic") {
    // Catches a digit that is carried wrongly, and a result that is rounded twice.
    std::mt19937_64 random(20261122);
    for (int i = 0; i < 4000; ++i) {
        const Sample a = sample(random, i % 2 == 0 ? 12 : 40);
        const Sample b = i % 5 == 0 ? Sample{a.text, a.value} : sample(random, 12);
        INFO(a.text << " - " << b.text);
        const Decimal found = decimal(a.text) - decimal(b.text);
        const Rational exact = a.value - b.value;
        CHECK((decimal(a.text) < decimal(b.text)) == (a.value < b.value));
        CHECK((decimal(a.text) == decimal(b.text)) == (a.value == b.value));
        CHECK((found < Decimal()) == (exact < 0));
        CHECK((found == Decimal()) == (exact == 0));
        CHECK(is_nearest(found.rounded(), exact));
        CHECK(is_nearest(found.rounded(3), exact * 1000));
        const Decimal left = decimal(a.text);
        const Decimal right = decimal(b.text);
        CHECK(is_nearest(Decimal::difference(left, right, -3), exact / 1000));
        const Rational sum = 2 * a.value - b.value * (i % 3);
        const int sign = Decimal::sign_of_sum({{&left, 2}, {&right, -(i % 3)}});
        CHECK((sign > 0 ? 1 : sign < 0 ? -1 : 0) == sum.sign());
        // as a text, in other units, and as a part of another
        CHECK(decimal(found.text()) == found);
        CHECK(decimal(left.scaled(-9).text()).scaled(9) == left);
        if (abs(a.value) <= abs(b.value) && b.value != 0) {
            const Rational error = abs(Rational(Decimal::ratio(left, right)) - a.value / b.value);
            CHECK(error <= Rational(3 * 0x1p-53) * abs(a.value / b.value));
        }
        // what was taken away can be added again
        CHECK(found - (Decimal() - decimal(b.text)) == decimal(a.text));
    }
}

TEST_CASE("a difference of numbers far apart is that of the larger, rounded the right way") {
    // Catches memory that grows with an exponent, and a tie that is broken as if the smaller were not there.
    const std::string tie = "9007199254740993"; // between two doubles
    CHECK(difference(tie, "1e-1000000000000") == 9007199254740992.0);
    CHECK(difference(tie, "-1e-1000000000000") == 9007199254740994.0);
    CHECK(difference("1e-99999999999999999999", tie) == -9007199254740992.0);
    CHECK(difference("1e999999999999", "-1") == std::numeric_limits<double>::infinity());
    CHECK(difference("-1e308", "1e308") == -std::numeric_limits<double>::infinity());
    CHECK(difference("1e308", "-1e308", -9) == 2e299);
    CHECK(difference("1e-999999999999", "0") == 0.0);
}

TEST_CASE("decimals are written with all digits and no more") {
    // Catches a point in the wrong place, and a text as long as an exponent.
    for (const char* text : {"0", "7", "-7", "1200", "12.5", "-0.000005584", "1403636579763555584.25", "1.25e1000000",
                             "3e-1000000", "-1e25"}) {
        CHECK(decimal(text).text() == text);
    }
    CHECK(decimal("00100.00e0").text() == "100");
    CHECK(decimal("-0.0").text() == "0");
    CHECK(decimal("5584").scaled(-9).text() == "0.000005584");
    CHECK(decimal("0").scaled(-9) == decimal("0"));
}

TEST_CASE("the sign of a sum is exact however far its terms are apart") {
    // Catches a term that is cut off, and time or memory that grows with an exponent.
    const Decimal large = decimal("1e1000000000000");
    const Decimal tiny = decimal("-1e-1000000000000");
    const Decimal one = decimal("1");
    CHECK(Decimal::sign_of_sum({{&large, 1}, {&large, -1}}) == 0);
    CHECK(Decimal::sign_of_sum({{&large, 1}, {&tiny, 1}, {&large, -1}}) < 0);
    CHECK(Decimal::sign_of_sum({{&tiny, 3}, {&one, 1}}) > 0);
    CHECK(Decimal::sign_of_sum({{&one, -1}, {&tiny, -1}, {&one, 1}}) > 0);
    CHECK(Decimal::sign_of_sum({}) == 0);
}

TEST_CASE("decimals are the numbers that are read as such") {
    // Catches a number that has a double and no decimal, or the other way round.
    std::mt19937_64 random(7);
    const std::string letters = "0019.eE+- \tx";
    int numbers = 0;
    for (int i = 0; i < 200000; ++i) {
        std::string text;
        for (std::size_t length = random() % 8; text.size() < length;) {
            text += letters[random() % letters.size()];
        }
        const bool number = is_number(text);
        numbers += number ? 1 : 0;
        if (Decimal::parse(text).has_value() != number) {
            FAIL("'" << text << "'");
        }
        double value = 0.0;
        if (number && read_number(text, value) == NumberError::none && decimal(text).rounded() != value) {
            FAIL("'" << text << "' is not " << value);
        }
    }
    CHECK(numbers > 10000);
    CHECK_FALSE(Decimal::parse("nan"));
    CHECK_FALSE(Decimal::parse("-inf"));
}

// Catches days that are counted wrong at the ends of February, of years and of centuries, in any year of four digits:
// each day is one more than the one before, whether by the month or by the year, and 1970 begins at 0.
TEST_CASE("times of ISO 8601 count days one by one") {
    const auto text = [](int value, std::size_t width) {
        const std::string digits = std::to_string(value);
        return std::string(width - digits.size(), '0') + digits;
    };
    long long day = -719528; // of the year 0 before 1970
    std::size_t wrong = 0;
    for (int year = 0; year <= 9999; ++year) {
        const bool leaps = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
        int of_year = 0;
        for (int month = 1; month <= 12; ++month) {
            const int last = month == 2                                                ? (leaps ? 29 : 28)
                             : (month == 4 || month == 6 || month == 9 || month == 11) ? 30
                                                                                       : 31;
            for (int of_month : {1, last}) {
                const Decimal seconds = decimal(std::to_string(86400 * (day + of_month - 1)));
                const auto ordinal = text(year, 4) + "-" + text(of_year + of_month, 3) + "T00:00";
                const auto date = text(year, 4) + "-" + text(month, 2) + "-" + text(of_month, 2) + "T00:00:00Z";
                wrong += read_time(date).value == seconds && read_time(ordinal).value == seconds ? 0U : 1U;
            }
            day += last;
            of_year += last;
            const auto none = text(year, 4) + "-" + text(month, 2) + "-" + text(last + 1, 2) + "T00:00";
            wrong += read_time(none).error == TimeError::no_such_time ? 0U : 1U;
        }
        const auto none = text(year, 4) + "-" + text(of_year + 1, 3) + "T00:00";
        wrong += read_time(none).error == TimeError::no_such_time ? 0U : 1U;
    }
    CHECK(wrong == 0);
    CHECK(read_time("1970-01-01T00:00:00").value == Decimal());
}

TEST_CASE("times of ISO 8601 are exact, and numbers are themselves") {
    const auto check = [](const std::string& text, const std::string& seconds) {
        INFO(text);
        const Time time = read_time(text);
        CHECK(time.error == TimeError::none);
        CHECK(time.value == decimal(seconds));
    };
    check("2026-11-22T13:00:00.5Z", "1795352400.5");
    check(" 2026-326T13:00:00.123456789012345678901 ", "1795352400.123456789012345678901");
    check("1969-12-31T23:59:59.25", "-0.75");
    check("2024-02-29T23:59", "1709251140");
    check("-1.5e3", "-1500");
    check("20261122", "20261122");
}

TEST_CASE("what is not read as a time") {
    using enum TimeError;
    const std::vector<std::pair<std::string, TimeError>> texts{
        {"", not_a_time},
        {"nan", not_a_time},
        {"2026-11", not_a_time},
        {"2026-11-2", not_a_time},
        {"x2026-11-22T13:00", not_a_time},
        {"2026-11-22T", not_a_time},
        {"2026-11-22T13", not_a_time},
        {"2026-11-22T13:0", not_a_time},
        {"2026-11-22T13:00:0", not_a_time},
        {"2026-11-22T13:00:00.", not_a_time},
        {"2026-11-22T13:00:00.5z", not_a_time},
        {"2026-11-22t13:00:00", not_a_time},
        {"2026-11-22T13:00.5", not_a_time},
        {"2026-11-22T13:00:00ZZ", not_a_time},
        {"2026-3260T13:00:00", not_a_time},
        {"20261122T130000Z", not_a_time},
        {"2026-11-22", blank},
        {"2026-326", blank},
        {"2026-11-22 13:00:00", blank},
        {"2026-11-22T13:00:00+00:00", offset},
        {"2026-11-22T13:00:00.5-08", offset},
        {"2026-11-22T13:00+0530", offset},
        {"2026-11-22T13:00:00,5", decimal_comma},
        {"2026-11-22T13:00:00,5+01:00", offset},
        {"2026-12-31T23:59:60", leap_second},
        {"2026-12-31T23:59:60.9Z", leap_second},
        {"2026-12-31T23:59:61", no_such_time},
        {"2026-12-31T23:60", no_such_time},
        {"2026-12-31T24:00", no_such_time},
        {"2026-13-01T00:00", no_such_time},
        {"2026-00-01T00:00", no_such_time},
        {"2026-000T00:00", no_such_time},
        {"2025-366T00:00", no_such_time},
        {"2025-02-29T00:00", no_such_time},
    };
    for (const auto& [text, error] : texts) {
        INFO(text);
        CHECK(read_time(text).error == error);
    }
}
