// Numbers at the beginning of a text: the quick way against fast_float's own.

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>

#include <sys/mman.h>
#include <unistd.h>

#include "catch.hpp"
#include "scan_comparison.hpp"

namespace {

/// Memory that ends where no byte may be read.
class Edge {
public:
    Edge() : size_(static_cast<std::size_t>(::sysconf(_SC_PAGESIZE))) {
        void* const pages = ::mmap(nullptr, 2 * size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (pages == MAP_FAILED) {
            throw std::runtime_error("no memory");
        }
        pages_ = static_cast<char*>(pages);
        if (::mprotect(pages_ + size_, size_, PROT_NONE) != 0) {
            throw std::runtime_error("no page can be closed");
        }
    }
    ~Edge() { ::munmap(pages_, 2 * size_); }
    Edge(const Edge&) = delete;
    Edge& operator=(const Edge&) = delete;

    /// A copy of the text that ends there.
    [[nodiscard]] std::string_view place(std::string_view text) const {
        char* const to = pages_ + size_ - text.size();
        text.copy(to, text.size());
        return {to, text.size()};
    }

private:
    std::size_t size_;
    char* pages_ = nullptr;
};

/// Texts that are numbers, almost numbers, or none.
class Texts {
public:
    explicit Texts(unsigned seed) : engine_(seed) {}

    /// Below the limit.
    unsigned up_to(unsigned limit) { return static_cast<unsigned>((engine_() >> 32U) * limit >> 32U); }

    std::string next() {
        switch (up_to(8)) {
        case 0: return printed(std::bit_cast<double>(engine_()));
        case 1: return printed(360.0 * (static_cast<double>(engine_()) * 0x1p-64 - 0.5));
        case 2: // subnormal and the smallest normal ones
            return printed(std::bit_cast<double>(engine_() & 0x001f'ffff'ffff'ffffU));
        case 3: return tie();
        case 4: return junk();
        default: return parts();
        }
    }

private:
    std::string digits(unsigned count) {
        const unsigned kind = up_to(12); // some are all the same
        std::string text;
        for (; count > 0; --count) {
            text += kind == 0 ? '0' : kind == 1 ? '9' : static_cast<char>('0' + up_to(10));
        }
        return text;
    }

    std::string printed(double value) {
        std::array<char, 400> text{};
        if (up_to(2) == 0) {
            return {text.data(), std::to_chars(text.begin(), text.end(), value).ptr};
        }
        static constexpr std::array forms{"%.*e", "%.*g", "%.*f"};
        const auto* const form = forms[up_to(std::abs(value) < 1e9 ? 3 : 2)];
        std::snprintf(text.data(), text.size(), form, static_cast<int>(up_to(26)),
                      value); // NOLINT(*-format-nonliteral)
        return text.data();
    }

    /// The middle between two doubles, in all of its digits or in some, perhaps with another last one.
    std::string tie() {
        const std::uint64_t significand = 1ULL << 53U | engine_() >> 11U | 1U;
        std::array<char, 400> text{};
        std::snprintf(text.data(), text.size(), up_to(2) == 0 ? "%.*Lf" : "%.*Le", static_cast<int>(up_to(40)),
                      std::ldexp(static_cast<long double>(significand), static_cast<int>(up_to(80)) - 70));
        std::string tied = text.data();
        if (up_to(3) == 0) {
            tied[tied.find_last_of("0123456789")] = static_cast<char>('0' + up_to(10));
        }
        return tied;
    }

    std::string junk() {
        // clang-format off
        static constexpr std::array hard{
            "", "-", ".", "-.", "+1", "--1", "+-1", "-.5", ".5", "5.", "-5.", "0.", "-0", "-0.0", "00", "0e0",
            "-0e5", "1e", "1e+", "1e-", "1e+-5", "1.e5", ".e5", "e5", "1e5e5", "1.2.3", "0x1p3", "1_000", "1'000",
            "1d5", "1e400", "-1e400", "1e-400", "1e99999999999", "1e-99999999999", "1e0000000000000001", "1E5",
            "1e+05", "infinity", "Infinit", "-inf", "INF", "nan", "-nan", "NaN(ab_9)", "nan(", "nan(x", "\xb1",
            "1\xb1", "1.\xff" "5", "1e\xb5", "18446744073709551615", "18446744073709551616", "9999999999999999999",
            "10000000000000000000", "0.9999999999999999999", "9.999999999999999999", "9007199254740993",
            "9007199254740992.9999999", "2.2250738585072011e-308", "2.2250738585072012e-308",
            "2.2250738585072014e-308", "2.4703282292062327e-324", "2.4703282292062328e-324",
            "1.7976931348623157e308", "1.7976931348623159e308", "179769313486231580793e289"};
        // clang-format on
        if (up_to(2) == 0) {
            return hard[up_to(hard.size())];
        }
        static constexpr std::string_view alphabet = ".-+eE,na(i)fx \t/:;\xb0\xb9\xff";
        std::string text;
        for (unsigned count = up_to(40); count > 0; --count) {
            text += up_to(4) > 0 ? static_cast<char>('0' + up_to(10)) : alphabet[up_to(alphabet.size())];
        }
        return text;
    }

    /// A sign, zeros, digits, a point, zeros, digits, zeros and an exponent, each perhaps, some of them long.
    std::string parts() {
        std::string text = up_to(2) == 0 ? "-" : "";
        text += up_to(4) == 0 ? std::string(up_to(up_to(4) > 0 ? 3 : 45), '0') : "";
        text += digits(up_to(3) == 0 ? up_to(26) : up_to(4));
        if (up_to(8) > 0) {
            text += '.' + std::string(up_to(3) == 0 ? up_to(up_to(4) > 0 ? 8 : 45) : 0, '0');
            text += digits(up_to(3) > 0 ? 12 + up_to(8) : up_to(44));
            text += std::string(up_to(10) == 0 ? up_to(45) : 0, '0');
        }
        text += up_to(1000) == 0 ? digits(up_to(900)) : "";
        if (up_to(3) == 0) {
            static constexpr std::array begins{"e", "E", "e-", "E-", "e+"};
            text += begins[up_to(begins.size())];
            text +=
                std::string(up_to(10) == 0 ? up_to(6) : 0, '0') + std::to_string(up_to(3) > 0 ? up_to(30) : up_to(345));
        }
        return text;
    }

    std::mt19937_64 engine_;
};

/// What follows a number.
std::string tail(Texts& texts) {
    static const std::array tails{std::string(100, ','),        "," + std::string(100, '7'),
                                  "\n" + std::string(100, '0'), "\r\n" + std::string(100, '\xff'),
                                  std::string(100, '\0'),       std::string(100, '9'),
                                  ".5" + std::string(100, ' '), "e5," + std::string(100, '.'),
                                  "x" + std::string(100, 'e')};
    const std::string& all = tails[texts.up_to(tails.size())];
    return texts.up_to(4) > 0 ? all : all.substr(0, texts.up_to(100));
}

} // namespace

// Catches a digit that is lost or counted twice, an exponent of another sign, a number that ends elsewhere, one
// that is rounded the other way, a byte that is read behind the text (a crash), and a quick way that is never taken.
TEST_CASE("numbers are scanned as fast_float reads them") {
    const Edge edge;
    Texts texts(31);
    const int count = tried(1'500'000);
    int numbers = 0;
    int direct = 0;
    int infinite = 0;
    int subnormal = 0;
    for (int i = 0; i < count; ++i) {
        const std::string number = texts.next();
        for (const std::string& text : {number, number + tail(texts)}) {
            const std::string_view placed = edge.place(text);
            const auto compared = compare_scan(placed.data(), placed.data() + placed.size());
            if (!compared.is_same) {
                FAIL("another number than fast_float's at the beginning of: " << text);
            }
            numbers += compared.is_number ? 1 : 0;
            direct += compared.is_direct ? 1 : 0;
            infinite += std::isinf(compared.value) ? 1 : 0;
            subnormal += std::fpclassify(compared.value) == FP_SUBNORMAL ? 1 : 0;
        }
    }
    CHECK(numbers > count);
    CHECK(direct > count / 3);
    CHECK(infinite > count / 1000);
    CHECK(subnormal > count / 100);
}

// Catches a bound too low, by which numbers of a common form are left to fast_float, or too high, by which digits
// are lost.
TEST_CASE("numbers of up to 19 digits are scanned directly") {
    const auto is_direct = [](const std::string& number) {
        const std::string text = number + std::string(rotconv::stream::NumberScan::reach, ',');
        const auto compared = compare_scan(text.data(), text.data() + text.size());
        INFO(number);
        CHECK(compared.is_same);
        return compared.is_direct;
    };
    for (const std::string number :
         {"0", "-1", "1.", "0.5", "-0.12345678901234567", "179.12345678901234", "1e-5", "1E+0005",
          "-1.2345678901234567e-101", "1403636579763555584", "1403636579.763555584", "0.0000123456789012345678",
          "9999999999999999999", "0.9999999999999999999"}) {
        CHECK(is_direct(number));
    }
    // The last two are too close to a tie for compute_float(): 64 bits of their product with a power of five are ones.
    for (const std::string number : {"10000000000000000000", "1.0000000000000000001", ".5", "nan", "1e10000", "1e",
                                     "9792353653691471313e270", "9586467486297153595e-46"}) {
        CHECK_FALSE(is_direct(number));
    }
}
