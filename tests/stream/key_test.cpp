// Keys: numbers as they are written, times of ISO 8601, and the distances of both.

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>

#include "catch.hpp"
#include "stream/numbers/number_text.hpp"
#include "stream/pairs/key.hpp"

using namespace rotconv::stream;
using Rational = boost::multiprecision::cpp_rational;

namespace {

Key key(const std::string& text, int power = 0) {
    const ReadKey read = read_key(text, power);
    INFO(text);
    REQUIRE(read.error == KeyError::none);
    return read.value;
}

Rational units(Int128 number) { return Rational(boost::multiprecision::cpp_int(number)); }
Rational units(KeyDistance distance) { return Rational(boost::multiprecision::cpp_int(distance.units)); }

/// A number with up to 20 digits before the point and `digits` behind it, and its value.
struct Sample {
    std::string text;
    Rational value;
};

Sample sample(std::mt19937_64& random, std::size_t digits) {
    const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    std::string all;
    const std::size_t before = below(21);
    const std::size_t count = before + below(digits + 1);
    while (all.size() < count || all.empty()) {
        all += static_cast<char>('0' + (below(3) == 0 ? below(10) : 9 * below(2))); // often rows of 0 or 9
    }
    const int power = static_cast<int>(below(31)) - 15; // of the text, whose point makes up for it
    const auto point = static_cast<int>(before) - power;
    const bool is_negative = below(2) == 0;
    std::string text = all;
    if (point <= 0) {
        text = "." + std::string(static_cast<std::size_t>(-point), '0') + text;
    } else if (point >= static_cast<int>(all.size())) {
        text += std::string(static_cast<std::size_t>(point) - all.size(), '0');
    } else {
        text.insert(static_cast<std::size_t>(point), ".");
    }
    Rational value = boost::multiprecision::cpp_int(all.substr(std::min(all.find_first_not_of('0'), all.size() - 1)));
    for (std::size_t i = before; i < all.size(); ++i) {
        value /= 10;
    }
    for (std::size_t i = all.size(); i < before; ++i) {
        value *= 10;
    }
    return {(is_negative ? "-" : "+") + text + "e" + std::to_string(power), is_negative ? Rational(-value) : value};
}

/// No other double is nearer.
bool is_nearest(double found, const Rational& exact) {
    const auto off = [&exact](double value) { return Rational(abs(Rational(value) - exact)); };
    return off(found) <= off(std::nextafter(found, HUGE_VAL)) && off(found) <= off(std::nextafter(found, -HUGE_VAL));
}

const Rational unit = Rational(1) / boost::multiprecision::pow(boost::multiprecision::cpp_int(10), 18);

} // namespace

// Catches an order of doubles or of texts.
TEST_CASE("keys compare by value, whatever their length and form") {
    CHECK(key("1.50") == key("+15e-1"));
    CHECK(key("-0.0e5") == key("0"));
    CHECK(key("9") < key("10"));
    CHECK(key("-9") > key("-10"));
    CHECK(key("1403715524907143168") < key("1403715524907143169"));
    CHECK(key(std::string(3000, '0') + "1.5") == key("1.5"));
    CHECK(key("0." + std::string(3000, '0') + "15e3001") == key("1.5"));
    CHECK(key("15e-999999999999999999999") == Key());
}

// Catches digits that are cut off, a tie that goes up, and one that is taken for a tie although digits follow.
TEST_CASE("keys are held to 1e-18, of equals to the even unit") {
    CHECK(key("0.0000000000000000005") == Key());
    CHECK(key("0.0000000000000000015").units == 2);
    CHECK(key("-0.00000000000000000050000000000000000000001").units == -1);
    CHECK(key("0.00000000000000000049999999999999").units == 0);
    CHECK(key("1e-400") == Key());
    CHECK(key("2500000000.5", -9).units == 2500000000500000000);
    CHECK(key("99999999999999999999.9999999999999999994") < key("99999999999999999999.9999999999999999996"));
}

// Catches a digit in the wrong place, a distance with the wrong sign, and a result that is rounded twice.
TEST_CASE("keys, distances and fractions are those of rational arithmetic") {
    std::mt19937_64 random(20261122);
    for (int i = 0; i < 4000; ++i) {
        const Sample a = sample(random, i % 3 == 0 ? 40 : i % 3 == 1 ? 18 : 9);
        const Sample b = i % 5 == 0 ? a : sample(random, 12);
        INFO(a.text << " and " << b.text);
        const Key left = key(a.text);
        const Key right = key(b.text);
        CHECK(abs(units(left.units) * unit - a.value) <= unit / 2);
        CHECK((left < right) == (units(left.units) < units(right.units)));
        CHECK(is_nearest(left.rounded(), units(left.units) * unit));
        const KeyDistance found = distance(left, right);
        const Rational exact = abs(units(left.units) - units(right.units));
        CHECK(units(found) == exact);
        CHECK(is_nearest(found.rounded(), exact * unit));
        if (exact < 100000 / unit * 1000000000000000) {
            CHECK(read_distance(found.text()) == found);
        }
        const auto [small, large] = std::minmax({found, KeyDistance{found.units / 7 * 2 + 3}});
        if (large.units > 0) {
            const Rational share = units(small) / units(large);
            CHECK(abs(Rational(ratio(small, large)) - share) <= Rational(3 * 0x1p-53) * share);
        }
    }
    CHECK(ratio(read_distance("0.1"), read_distance("0.3")) == 1.0 / 3.0);
    CHECK(ratio(read_distance("86400000.001"), read_distance("259200000.003")) == 1.0 / 3.0);
}

// Catches a point in the wrong place, and zeros at the end.
TEST_CASE("distances are written with all digits and no more") {
    for (const char* text :
         {"0", "7", "1200", "12.5", "0.000005584", "1403636579763555584.25", "0.000000000000000001"}) {
        CHECK(read_distance(text).text() == text);
    }
    CHECK(read_distance("00100.00e0").text() == "100");
    CHECK(read_distance("1e300") > distance(key("99999999999999999999"), key("-99999999999999999999")));
}

// Catches a number that has a double and no key, or the other way round.
TEST_CASE("keys are the numbers that are read as such") {
    std::mt19937_64 random(7);
    const std::string letters = "0019.eE+- \tx";
    int numbers = 0;
    for (int i = 0; i < 200000; ++i) {
        std::string text;
        for (std::size_t length = random() % 8; text.size() < length;) {
            text += letters[random() % letters.size()];
        }
        double value = 0.0;
        const bool is_one = is_number(text);
        const bool is_small = is_one && read_number(text, value) == NumberError::none && std::abs(value) < 1e20;
        const ReadKey read = read_key(text);
        const KeyError expected = is_small ? KeyError::none : is_one ? KeyError::too_large : KeyError::not_a_number;
        numbers += is_small ? 1 : 0;
        if (read.error != expected || (is_small && std::abs(value) > 1e-9 && read.value.rounded() != value)) {
            FAIL("'" << text << "' is " << value);
        }
    }
    CHECK(numbers > 10000);
    CHECK(read_key("nan").error == KeyError::not_a_number);
    CHECK(read_key("-inf").error == KeyError::not_a_number);
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
                const Key seconds = key(std::to_string(86400 * (day + of_month - 1)));
                const auto ordinal = text(year, 4) + "-" + text(of_year + of_month, 3) + "T00:00";
                const auto date = text(year, 4) + "-" + text(month, 2) + "-" + text(of_month, 2) + "T00:00:00Z";
                wrong += read_key(date).value == seconds && read_key(ordinal).value == seconds ? 0U : 1U;
            }
            day += last;
            of_year += last;
            const auto none = text(year, 4) + "-" + text(month, 2) + "-" + text(last + 1, 2) + "T00:00";
            wrong += read_key(none).error == KeyError::not_a_time ? 0U : 1U;
        }
        const auto none = text(year, 4) + "-" + text(of_year + 1, 3) + "T00:00";
        wrong += read_key(none).error == KeyError::not_a_time ? 0U : 1U;
    }
    CHECK(wrong == 0);
    CHECK(read_key("1970-01-01T00:00:00").value == Key());
}

// Catches a fraction of a second that is lost, and a number that is taken for a date.
TEST_CASE("times of ISO 8601 are exact, and numbers are themselves") {
    const auto check = [](const std::string& text, const std::string& seconds) {
        INFO(text);
        const ReadKey time = read_key(text);
        CHECK(time.error == KeyError::none);
        CHECK(time.value == key(seconds));
    };
    check("2026-11-22T13:00:00.5Z", "1795352400.5");
    check(" 2026-326T13:00:00.123456789012345678 ", "1795352400.123456789012345678");
    check("2026-326T13:00:00.9999999999999999996Z", "1795352401"); // rounded like a number
    check("1969-12-31T23:59:59.25", "-0.75");
    check("2024-02-29T23:59", "1709251140");
    check("2026-11-22T13:00:00+00:00", "1795352400");
    check("2026-326T13:00:00.5+00:00", "1795352400.5");
    check("2024-02-29T23:59+00:00", "1709251140");
    check("-1.5e3", "-1500");
    check("20261122", "20261122");
}

// Catches a text that is read although a part of it is passed over, and one that is answered as another.
TEST_CASE("what is not read as a time") {
    using enum KeyError;
    const std::vector<std::pair<std::string, KeyError>> texts{
        {"", not_a_number},
        {"nan", not_a_number},
        {"2026-11", not_a_number},
        {"2026-11-2", not_a_number},
        {"x2026-11-22T13:00", not_a_number},
        {"2026-11-22T", not_a_time},
        {"2026-11-22T13", not_a_time},
        {"2026-11-22T13:00:0", not_a_time},
        {"2026-11-22T13:00:00.", not_a_time},
        {"2026-11-22T13:00:00.5z", not_a_time},
        {"2026-11-22t13:00:00", not_a_time},
        {"2026-11-22T13:00.5", not_a_time},
        {"2026-3260T13:00:00", not_a_time},
        {"20261122T130000Z", not_a_number},
        {"2026-11-22", blank},
        {"2026-11-22 13:00:00", blank},
        {"2026-11-22T13:00:00+00:00Z", not_a_time},
        {"2026-11-22T13:00:00Z+00:00", not_a_time},
        {"2026-11-22T13:00:00-00:00", not_a_time},
        {"2026-11-22T13:00:00+02:00", not_a_time},
        {"2026-11-22T13:00+0530", not_a_time},
        {"2026-11-22T13:00:00,5", not_a_time},
        {"2026-12-31T23:59:60", not_a_time},
        {"2026-12-31T23:60", not_a_time},
        {"2026-12-31T24:00", not_a_time},
        {"2026-13-01T00:00", not_a_time},
        {"2025-366T00:00", not_a_time},
        {"2025-02-29T00:00", not_a_time},
        {"1e20", too_large},
        {"-99999999999999999999.5e1", too_large},
    };
    for (const auto& [text, error] : texts) {
        INFO(text);
        CHECK(read_key(text).error == error);
    }
}
