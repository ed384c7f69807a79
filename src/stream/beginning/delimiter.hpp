#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rotconv::stream {

/// How many fields a line has.
struct FieldCount {
    std::size_t all = 0;
    std::size_t filled = 0; ///< without empty ones at the end

    /// Whether the counts are equal, with or without the empty fields at the end of either.
    [[nodiscard]] constexpr bool fits(const FieldCount& other) const noexcept {
        return all == other.all || all == other.filled || filled == other.all || filled == other.filled;
    }
};

/// What parts the fields of a row: one character, or runs of blanks.
class Delimiter {
public:
    /// Runs of blanks and tabs.
    static constexpr Delimiter blanks() noexcept { return Delimiter(' '); }
    static constexpr Delimiter character(char c) noexcept { return Delimiter(c); }

    /// One character, or `comma`, `tab`, `semicolon`, `blank`; nothing for a text that is neither, or for a character
    /// that can be part of a number or a quoted field.
    [[nodiscard]] static std::optional<Delimiter> parse(std::string_view text) noexcept;

    /// Comma, otherwise tab, otherwise semicolon, otherwise blanks; those inside quotes do not count.
    [[nodiscard]] static Delimiter of_row(std::string_view row) noexcept;

    [[nodiscard]] constexpr bool is_blanks() const noexcept { return character_ == ' '; }
    /// What is put between fields.
    [[nodiscard]] constexpr char text() const noexcept { return character_; }

    /// Appends the row's fields to `fields`. Quoted fields keep their quotes. If blanks part fields, quotes mean
    /// nothing.
    /// @return false if a quote is left open
    bool split(std::string_view row, std::vector<std::string_view>& fields) const;

    /// The field without the quotes around it, doubled ones inside made single; unchanged if blanks part fields.
    [[nodiscard]] std::string unquoted(std::string_view field) const;

    /// The field's content: blanks around it, and where fields may be quoted the quotes around it, left out. Doubled
    /// quotes inside stay.
    [[nodiscard]] std::string_view text_of(std::string_view field) const noexcept;

    [[nodiscard]] FieldCount count(std::span<const std::string_view> fields) const noexcept {
        FieldCount count{fields.size(), fields.size()};
        while (count.filled > 0 && text_of(fields[count.filled - 1]).empty()) {
            --count.filled;
        }
        return count;
    }

private:
    [[nodiscard]] bool is_quoted(std::string_view field) const noexcept;
    constexpr explicit Delimiter(char c) noexcept : character_(c) {}
    char character_;
};

} // namespace rotconv::stream
