// Numbers to and from text.

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <string_view>

#include "catch.hpp"
#include "stream/numbers/number_text.hpp"

using namespace rotconv::stream;

namespace {

std::string text_of(double value, int precision = 0, int decimals = -1) {
    Buffer buffer;
    append_number(buffer, value, {.significant = precision, .decimals = decimals});
    return fmt::to_string(buffer);
}

/// As fmt writes it, without the sign of what rounds to 0 with decimals.
std::string expected(double value, int precision = 0, int decimals = -1) {
    if (decimals < 0) {
        return precision > 0 ? fmt::format("{:.{}g}", value, precision) : fmt::format("{}", value);
    }
    const std::string text = fmt::format("{:.{}f}", value, decimals);
    return text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos ? text.substr(1) : text;
}

void compare_with_fmt(double value, int precision = 0, int decimals = -1) {
    if (!std::isnan(value) && text_of(value, precision, decimals) != expected(value, precision, decimals)) {
        CHECK(text_of(value, precision, decimals) == expected(value, precision, decimals));
    }
}

/// Angles, any bits, decimals, their ties as decimals and as doubles, and what lies beside.
void compare_random_numbers(int numbers) {
    std::mt19937_64 engine(11);
    const auto digits = [&engine](int count) {
        return std::floor(std::uniform_real_distribution<>(0, 1)(engine) * std::pow(10, count));
    };
    const auto sized = [&engine](double number) {
        return number * std::pow(10, std::uniform_int_distribution(-6, 6)(engine));
    };
    for (int i = 0; i < numbers; ++i) {
        const int count = i % 17 + 1;
        const int decimals = i / 17 % (count + 1);
        const double tie = (digits(count) + 0.5) / std::pow(10, decimals);
        const double few_bits = std::ldexp(std::floor(digits(count)), -std::uniform_int_distribution(0, 30)(engine));
        for (const double value :
             {std::uniform_real_distribution<>(-180, 180)(engine), std::bit_cast<double>(engine()),
              sized(digits(count)), sized(tie), tie, few_bits, std::nextafter(tie, 0.0), std::nextafter(tie, 1e300)}) {
            compare_with_fmt(value, std::uniform_int_distribution(1, 18)(engine));
            compare_with_fmt(i % 2 == 0 ? value : -value, 0, decimals);
        }
    }
}

double value_of(const std::string& text) {
    double value = -1.0;
    INFO(text);
    REQUIRE(read_number(text, value) == NumberError::none);
    return value;
}

} // namespace

// Catches junk that passes for a number.
TEST_CASE("what is not a decimal number is refused") {
    for (const std::string text :
         {"",    " ",   "+",   "-",   ".",     "e5",  "1e",        "1e+", "0x10",  "1,5",
          "1 2", "--1", "+-1", "-+1", "1.2.3", "one", "1\xC2\xA0", "1f",  "1e5.0", "\xEF\xBC\x91"}) {
        double value = 0.0;
        INFO(text);
        CHECK(read_number(text, value) == NumberError::not_a_number);
        CHECK_FALSE(is_number(text));
    }
    double value = 0.0;
    CHECK(read_number(std::string_view("1\0", 2), value) == NumberError::not_a_number);
}

// Catches a number out of range that is taken for the other end of it.
TEST_CASE("too large is a error and too small is zero") {
    double value = 0.0;
    for (const std::string text :
         {"1e309", "-1e309", "1e99999999999999999999", "17976931348623159e292", "0.001e313", "12345678901e300"}) {
        INFO(text);
        CHECK(read_number(text, value) == NumberError::too_large);
    }
    CHECK(read_number("1" + std::string(400, '0'), value) == NumberError::too_large);
    for (const std::string text :
         {"1e-400", "-1e-400", "1e-99999999999999999999", "0.0000001e-320", "123e-340", "0e999"}) {
        INFO(text);
        CHECK(value_of(text) == 0.0);
    }
    CHECK(value_of("0." + std::string(400, '0') + "1") == 0.0);
    CHECK(value_of("5e-324") == 5e-324);
    CHECK(value_of("1.7976931348623157e308") == std::numeric_limits<double>::max());
}

// Catches a text that does not read back to the same double.
TEST_CASE("the shortest text reads back to the same double") {
    std::mt19937_64 engine(71);
    for (int i = 0; i < 20000; ++i) {
        const auto value = std::bit_cast<double>(engine());
        if (std::isfinite(value)) {
            REQUIRE(value_of(text_of(value)) == value);
        }
    }
    CHECK(text_of(0.1) == "0.1");
    CHECK(text_of(1.0) == "1");
    CHECK(text_of(-0.5) == "-0.5");
    CHECK(text_of(-std::numeric_limits<double>::quiet_NaN()) == "nan");
    CHECK(text_of(std::numeric_limits<double>::infinity()) == "inf");
    CHECK(text_of(-2.2250738585072014e-308) == "-2.2250738585072014e-308");
}

// Catches a point, a sign or a zero in the wrong place, at the borders of the forms above all.
TEST_CASE("the shortest text has the form of fmt's {}") {
    for (int tens = -7; tens < 19; ++tens) {
        for (const double digits : {1.0, 1.2, 1.23, 1.234, 2.0, 9.0, 9.9, 9.99, 9.999}) {
            for (const double value : {std::pow(10, tens) * digits, -std::pow(10, tens) * digits}) {
                compare_with_fmt(value);
                compare_with_fmt(std::nextafter(value, 0.0));
                compare_with_fmt(std::nextafter(value, 1e20));
            }
        }
    }
    for (int i = 0; i <= 2000; ++i) {
        compare_with_fmt(i);
        compare_with_fmt(-i / 1000.0);
        compare_with_fmt(i / 16.0);
    }
    std::mt19937_64 engine(72);
    std::uniform_real_distribution<double> exponent(-6, 4);
    for (int i = 0; i < 50000; ++i) {
        compare_with_fmt(std::pow(10, exponent(engine)));
    }
}

// Catches digits that are rounded twice, a tie that does not go to the even digit, a carry that is lost, digits
// after the point in the place of significant ones, a sign of what rounds to 0.
TEST_CASE("digits are those of the exact value, in the form of fmt") {
    compare_random_numbers(tried(50'000));
    CHECK(text_of(0.125, 2) == "0.12"); // ties to even, as the value is exact
    CHECK(text_of(2.675, 3) == "2.67"); // 2.67499999999999982236431605997495353221893310546875
    CHECK(text_of(-2.679e-08, 0, 4) == "0.0000");
    CHECK(text_of(std::numeric_limits<double>::infinity(), 0, 3) == "inf");
    CHECK(text_of(-std::numeric_limits<double>::quiet_NaN(), 0, 3) == "nan");
    CHECK(text_of(1e300, 0, 1).size() == 303);
    CHECK(text_of(-1e-300, 0, 100) == expected(-1e-300, 0, 100));
}

// Catches a number that is taken for one of the next decade, or carried into it without its form.
TEST_CASE("digits beside powers of ten have the form of fmt") {
    for (int tens = -19; tens < 19; ++tens) {
        for (int digits = 1; digits <= 20; ++digits) {
            const double power = std::pow(10, tens);
            for (const double near : {power, power * (1 - std::pow(10, -digits) / 2)}) {
                for (const double value : {-near, near, std::nextafter(near, 0.0), std::nextafter(near, 1e20)}) {
                    compare_with_fmt(value, digits);
                    compare_with_fmt(value, 0, digits - 1);
                }
            }
        }
    }
}

// A few minutes: test_stream "[large]".
TEST_CASE("digits of a hundred million numbers", "[.large]") { compare_random_numbers(12'000'000); }
