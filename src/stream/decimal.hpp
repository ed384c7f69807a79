#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace rotconv::stream {

/// A decimal number as it is written, with all its digits.
class Decimal {
public:
    /// 0.
    Decimal() = default;

    /// Takes what read_number() takes as a finite number, too large and too small ones included; nothing else. Powers
    /// of ten beyond 10^(10^18) count as that.
    [[nodiscard]] static std::optional<Decimal> parse(std::string_view text);

    /// By value: 1.50 and 15e-1 are equal.
    friend bool operator==(const Decimal& a, const Decimal& b) noexcept = default;
    friend std::strong_ordering operator<=>(const Decimal& a, const Decimal& b) noexcept;

    /// Exact, except where the larger number ends more than 800 digits before the smaller one begins: only the sign of
    /// the smaller is kept then, which is all that rounded() can depend on.
    friend Decimal operator-(const Decimal& a, const Decimal& b);

    /// A number, and how often it is added to a sum.
    using Term = std::pair<const Decimal*, int>;
    /// A number with the sign of the sum, exact however large or small the terms are.
    [[nodiscard]] static int sign_of_sum(std::initializer_list<Term> terms) noexcept;

    /// This times 10^power.
    [[nodiscard]] Decimal scaled(std::int64_t power) const;
    /// The double nearest to this times 10^power; infinite where that is too large.
    [[nodiscard]] double rounded(std::int64_t power = 0) const { return difference(*this, {}, power); }
    /// The same of a - b.
    [[nodiscard]] static double difference(const Decimal& a, const Decimal& b, std::int64_t power);
    /// a / b, where |a| <= |b|, rounded once if both differ from whole numbers of up to 15 digits by one power of ten,
    /// otherwise three times.
    [[nodiscard]] static double ratio(const Decimal& a, const Decimal& b) {
        const std::int64_t last = std::max(std::min(a.end(), b.end()), b.point_ - 300); // not too large for a double
        return a.rounded(-last) / b.rounded(-last);
    }
    /// All its digits, with an e only where there would be many zeros.
    [[nodiscard]] std::string text() const;

private:
    static std::strong_ordering compare_magnitudes(const Decimal& a, const Decimal& b) noexcept;
    /// The place after the last digit.
    [[nodiscard]] std::int64_t end() const noexcept { return point_ - static_cast<std::int64_t>(digits_.size()); }
    void strip();

    bool negative_ = false;
    std::string digits_;     ///< without zeros at either end; none for 0
    std::int64_t point_ = 0; ///< the value is 0.digits_ times 10^point_; 0 for 0
};

/// What is wrong with a time; `blank`: one in the place of T, or a date alone; `has_unit`: it should be a number.
enum class TimeError : std::uint8_t {
    none,
    not_a_time,
    blank,
    offset,
    decimal_comma,
    leap_second,
    no_such_time,
    has_unit
};

struct Time {
    Decimal value{}; ///< in the unit of the text; of ISO 8601 seconds since 1970
    TimeError error = TimeError::none;
};

/// A number, or a time of ISO 8601 with a date of the calendar (2026-11-22) or of the year (2026-326), a T and at least
/// hours and minutes, in UTC with or without Z. As in POSIX there are no leap seconds.
[[nodiscard]] Time read_time(std::string_view text);

} // namespace rotconv::stream
