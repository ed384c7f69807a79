#include "delimiter.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "../numbers/number_text.hpp"

namespace rotconv::stream {
namespace {

// find_first_of and its like ask for each character whether it is in a text: most of the time of a split.
constexpr bool is_blank_character(char c) noexcept { return c == ' ' || c == '\t'; }

/// The position after the closing quote of the field that begins at `start` with a quote, or npos where there is none.
std::size_t after_quotes(std::string_view row, std::size_t start) noexcept {
    std::size_t at = start + 1;
    while ((at = row.find('"', at)) != std::string_view::npos) {
        if (at + 1 == row.size() || row[at + 1] != '"') {
            return at + 1;
        }
        at += 2;
    }
    return std::string_view::npos;
}

} // namespace

std::optional<Delimiter> Delimiter::parse(std::string_view text) noexcept {
    using Named = std::pair<std::string_view, char>;
    static constexpr auto names =
        std::to_array<Named>({{"comma", ','}, {"tab", '\t'}, {"\\t", '\t'}, {"semicolon", ';'}, {"blank", ' '}});
    if (const auto* const found = std::ranges::find(names, text, &Named::first); found != names.end()) {
        return Delimiter(found->second);
    }
    constexpr std::string_view refused = "0123456789+-.\"\r\n#aefintyAEFINTY";
    if (text.size() != 1 || refused.find(text[0]) != std::string_view::npos ||
        (static_cast<unsigned char>(text[0]) & 0x80U) != 0U) {
        return std::nullopt;
    }
    return character(text[0]);
}

Delimiter Delimiter::of_row(std::string_view row) noexcept {
    constexpr std::string_view candidates = ",\t;"; // the first of them that occurs
    std::size_t best = candidates.size();
    bool begins_field = true;
    for (std::size_t at = 0; at < row.size(); ++at) {
        const std::size_t end = begins_field && row[at] == '"' ? after_quotes(row, at) : std::string_view::npos;
        if (end != std::string_view::npos) {
            at = end - 1;
            begins_field = false;
            continue;
        }
        const std::size_t found = candidates.find(row[at]);
        begins_field = found != std::string_view::npos;
        best = std::min(best, found);
    }
    return best < candidates.size() ? character(candidates[best]) : blanks();
}

bool Delimiter::split(std::string_view row, std::vector<std::string_view>& fields) const {
    if (is_blanks()) {
        for (const char *at = row.data(), *const end = at + row.size(); at != end;) {
            const char* const first = std::find_if_not(at, end, is_blank_character);
            at = std::find_if(first, end, is_blank_character);
            if (at != first) {
                fields.emplace_back(first, at);
            }
        }
        return true;
    }
    bool closed = true;
    std::size_t start = 0;
    while (true) {
        std::size_t from = start;
        if (start < row.size() && row[start] == '"') {
            from = after_quotes(row, start);
            closed = closed && from != std::string_view::npos;
        }
        const std::size_t end = from == std::string_view::npos ? from : row.find(character_, from);
        if (end == std::string_view::npos) {
            fields.push_back(row.substr(start));
            return closed;
        }
        fields.push_back(row.substr(start, end - start));
        start = end + 1;
    }
}

bool Delimiter::is_quoted(std::string_view field) const noexcept {
    return !is_blanks() && field.size() >= 2 && field.front() == '"' && field.back() == '"';
}

std::string Delimiter::unquoted(std::string_view field) const {
    if (!is_quoted(field)) {
        return std::string(field);
    }
    std::string text;
    for (std::size_t i = 1; i + 1 < field.size(); ++i) {
        text.push_back(field[i]);
        if (field[i] == '"' && field[i + 1] == '"' && i + 2 < field.size()) {
            ++i;
        }
    }
    return text;
}

std::string_view Delimiter::text_of(std::string_view field) const noexcept {
    field = trimmed(field);
    return is_quoted(field) ? trimmed(field.substr(1, field.size() - 2)) : field;
}

} // namespace rotconv::stream
