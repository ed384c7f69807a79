#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "fmt.hpp"

namespace rotconv::stream {

/// The text without blanks and tabs at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text) noexcept;

enum class NumberError : std::uint8_t { none, not_a_number, too_large };

/// Reads a decimal number as in C, `nan` or `inf`, with an optional sign and blanks around it; no hexadecimal.
/// Correctly rounded, independent of the locale. Too small for a double is 0.
NumberError read_number(std::string_view text, double& value) noexcept;

/// Whether read_number() would take the text, or it is a number that is too large.
[[nodiscard]] bool is_number(std::string_view text) noexcept;

using Buffer = fmt::memory_buffer;

inline void append(Buffer& to, std::string_view text) {
    const std::size_t size = to.size();
    to.resize(size + text.size());
    text.copy(to.data() + size, text.size());
}

/// With how many digits a number is written.
struct Digits {
    int significant = 0; ///< 0: the shortest text that reads back to the same double
    int decimals = -1;   ///< after the point, in the place of significant digits; -1: these count

    [[nodiscard]] bool shortest() const noexcept { return significant == 0 && decimals < 0; }
};

void append_number(Buffer& to, double value, Digits digits);
[[nodiscard]] std::string number_text(double value, Digits digits = {});

/// Appends all of them, with the delimiter between them.
void append_numbers(Buffer& to, std::span<const double> numbers, char delimiter, Digits digits);
/// Writes all of them into room for `room_for` as many.
/// @return their end, beyond which it may have written
char* write_numbers(char* to, std::span<const double> numbers, char delimiter, Digits digits);
/// Bytes: with the 100 digits that may be asked for, those before the point, and what is written beyond the end.
[[nodiscard]] constexpr std::size_t room_for(std::size_t count, Digits digits) noexcept {
    return count * (digits.decimals >= 0 ? 448 : 128);
}

/// The numbers as they are in memory, little-endian.
void append_bytes(Buffer& to, std::span<const double> numbers);

} // namespace rotconv::stream
