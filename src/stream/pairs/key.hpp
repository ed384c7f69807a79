#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>

namespace rotconv::stream {

__extension__ using Int128 = __int128;
__extension__ using Uint128 = unsigned __int128;

/// The exact distance of two keys.
struct KeyDistance {
    Uint128 units = 0; ///< 1e-18 each

    friend constexpr bool operator==(const KeyDistance&, const KeyDistance&) = default;
    friend constexpr auto operator<=>(const KeyDistance& a, const KeyDistance& b) noexcept {
        return a.units <=> b.units;
    }
    /// The nearest double.
    [[nodiscard]] double rounded() const;
    /// All its digits.
    [[nodiscard]] std::string text() const;
};

/// A key or a time as a fixed-point number of 18 decimals.
struct Key {
    Int128 units = 0; ///< 1e-18 each

    friend constexpr bool operator==(const Key&, const Key&) = default;
    friend constexpr auto operator<=>(const Key& a, const Key& b) noexcept { return a.units <=> b.units; }
    /// The nearest double.
    [[nodiscard]] double rounded() const;
};

[[nodiscard]] constexpr KeyDistance distance(const Key& a, const Key& b) noexcept {
    const auto first = static_cast<Uint128>(a.units);
    const auto second = static_cast<Uint128>(b.units);
    return {a < b ? second - first : first - second};
}

/// a / b, where a <= b and b > 0: rounded once if both are whole numbers below 2^53 of one of the units 1, 1e-3, ...,
/// 1e-18, otherwise three times.
[[nodiscard]] double ratio(KeyDistance a, KeyDistance b);

/// Why a text is not read as a key.
enum class KeyError : std::uint8_t {
    none,
    not_a_number,
    too_large,  ///< it would be 1e20 or more in size
    not_a_time, ///< it begins with a date, and no time that can be read follows
    blank,      ///< it is a date alone, or has a blank instead of the T
    has_unit    ///< it is a time of ISO 8601, and should be a number
};

struct ReadKey {
    Key value{};
    KeyError error = KeyError::none;
};

/// Reads a number times 10^power, rounded to a whole unit, ties to even. Or a time of ISO 8601, which becomes seconds
/// since 1970, without leap seconds as in POSIX: a date of the calendar (2026-11-22) or of the year (2026-326), a T and
/// at least hours and minutes, in UTC, with Z, +00:00 or neither. Valid range: power -18 to 0, keys below 1e20 in size.
[[nodiscard]] ReadKey read_key(std::string_view text, int power = 0);

/// Reads a number as a distance: the largest distance if it is too large, 0 if it is negative or not a number.
[[nodiscard]] KeyDistance read_distance(std::string_view text);

} // namespace rotconv::stream
