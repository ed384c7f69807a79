#include "values.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "../stream/fmt.hpp"
#include "../stream/number_text.hpp"
#include "column_names.hpp"
#include "option_set.hpp"
#include "words.hpp"

namespace rotconv::cli {
namespace {

constexpr std::string_view brackets = "[](){}<>";
constexpr std::string_view opening = "[({<\"'";
constexpr std::string_view separators = ",; \t\r\n[](){}<>\"'";

/// Numbers without words.
Values row_of_numbers(std::string text, stream::Delimiter given) {
    if (text.find_first_of("[](){}<>;\r\n") == std::string::npos) {
        return {std::move(text), given, {}};
    }
    const std::string around = fmt::format("{}; \t\r\n{}", brackets, given.text());
    std::string row;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t begin = std::min(text.find_first_not_of(around, at), text.size());
        const std::string gap = text.substr(at, begin - at);
        const bool at_edge = at == 0 || begin == text.size();
        const bool has_bracket = gap.find_first_of(brackets) != std::string::npos;
        const auto delimiters = static_cast<std::size_t>(
            std::ranges::count_if(gap, [&](char c) { return c == ';' || (c == given.text() && !given.is_blanks()); }));
        if (!has_bracket && delimiters == 0 && gap.find_first_of("\r\n") == std::string::npos) {
            row += at_edge ? "" : gap;
        } else { // a bracket or line end leaves no empty field beside it
            const std::size_t least = at_edge ? 0 : 1;
            row.append(has_bracket || given.is_blanks() ? least : std::max(delimiters, least), given.text());
        }
        at = std::min(text.find_first_of(around, begin), text.size());
        row += text.substr(begin, at - begin);
    }
    return {row, given, {}};
}

/// A word, or a number, and what stands around it.
struct Token {
    std::string_view text;
    bool is_number = false;
    char next = '\0';      ///< the character after it, and after blanks if it is : or =
    bool opens = false;    ///< a bracket or a quote follows at once, or after : or = and blanks
    bool is_first = false; ///< of its line
};

/// Parts a text into words and numbers.
std::vector<Token> tokens_of(std::string_view text) {
    std::vector<Token> tokens;
    const std::string ends = fmt::format("{}:=", separators);
    for (std::size_t at = text.find_first_not_of(ends); at != std::string_view::npos;) {
        const std::size_t end = std::min(text.find_first_of(ends, at), text.size());
        Token& token = tokens.emplace_back(Token{text.substr(at, end - at)});
        token.is_number = stream::is_number(token.text);
        const bool is_quoted =
            at > 0 && end < text.size() && text[at - 1] == text[end] && (text[end] == '"' || text[end] == '\'');
        const std::size_t stop = end + (is_quoted ? 1 : 0); // "x": 0.6
        const std::size_t after = std::min(text.find_first_not_of(" \t", stop), text.size());
        token.next = after < text.size() ? text[after] : '\0';
        const bool has_mark = token.next == ':' || token.next == '=';
        const std::size_t value = has_mark ? text.find_first_not_of(" \t", after + 1) : stop;
        token.opens = value < text.size() && opening.find(text[value]) != std::string_view::npos;
        const std::size_t before = text.substr(0, at).find_last_not_of(" \t");
        token.is_first = before == std::string_view::npos ? text.find('\n') != before : text[before] == '\n';
        at = text.find_first_not_of(ends, end);
    }
    return tokens;
}

/// Letters, digits, _ and dots, from a letter on; not a unit of angles, nor a number in words.
bool may_be_label(std::string_view word) {
    static constexpr std::array<std::string_view, 8> numbers_and_units{"pi",  "deg",    "degree",  "degrees",
                                                                       "rad", "radian", "radians", "f"};
    return std::ranges::count(numbers_and_units, lower(word)) == 0 && is_alphanumeric(word.front()) &&
           (word.front() < '0' || word.front() > '9') &&
           std::ranges::all_of(word, [](char c) { return is_alphanumeric(c) || c == '_' || c == '.'; });
}

/// A letter, a digit, a byte beyond ASCII, or the sign of a number, which no list has before each.
bool means_something(const Token& token, bool before_number) {
    const bool is_sign =
        token.text.size() == 1 && std::string_view("+-*/").find(token.text[0]) != std::string_view::npos;
    return (is_sign && before_number && !token.is_first) || std::ranges::any_of(token.text, [](char c) {
               return is_alphanumeric(c) || (static_cast<unsigned char>(c) & 0x80U) != 0;
           });
}

/// A quote right after a number that stands in none: minutes and seconds of arc.
bool has_mark_of_arc(std::string_view text) {
    char open = '\0';
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == open) {
            open = '\0';
        } else if (open == '\0' && (text[i] == '"' || text[i] == '\'')) {
            if (i > 0 && (is_alphanumeric(text[i - 1]) || text[i - 1] == '.')) {
                return true;
            }
            open = text[i];
        }
    }
    return false;
}

/// Numbers among words. `by_blank`: a word before a blank and a number is its label; nothing where then only some
/// numbers have one.
std::optional<Values> row_of_words(const std::string& text, stream::Delimiter delimiter, bool by_blank) {
    Values values{.delimiter = delimiter};
    std::vector<std::string_view> fields;
    std::string_view label;
    bool is_value_of_key = false;
    std::string_view value_of_key; // which is no number
    const std::vector<Token> tokens = tokens_of(text);
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const Token& token = tokens[i];
        const bool is_key = token.next == ':' || token.next == '=';
        const bool before_number = i + 1 < tokens.size() && tokens[i + 1].is_number;
        if (std::exchange(is_value_of_key, false) && !token.is_number) {
            value_of_key = token.text;
            continue; // dtype=float64
        }
        const bool is_call = token.opens;
        const bool may_be_by_blank = by_blank && !is_call && token.next != ',' && token.next != ';';
        if (is_key && token.is_number) {
            fields.emplace_back(token.text.data(), token.text.size() + 1); // 10:30
            values.labels.emplace_back();
        } else if (before_number && !token.is_number &&
                   ((is_key && !is_call) || (may_be_by_blank && may_be_label(token.text)))) {
            label = token.text;
        } else if (is_key) {
            is_value_of_key = token.next == '=';
        } else if (token.is_number) {
            fields.push_back(token.text);
            values.labels.emplace_back(std::exchange(label, {}));
        } else if (!is_call && means_something(token, before_number) &&
                   !(fields.empty() && !before_number &&
                     may_be_label(token.text))) { // in Quaternion [...] // Quaternion(...) is a call
            fields.push_back(token.text);         // which is not a number
            values.labels.emplace_back();
        }
    }
    const auto labelled = values.labels.size() - static_cast<std::size_t>(std::ranges::count(values.labels, ""));
    const bool is_first_alone = labelled == 1 && !values.labels.front().empty();
    if (labelled > 0 && labelled < values.labels.size() && !is_first_alone && !value_of_key.empty()) {
        fields.push_back(value_of_key); // another number must not take its place
        values.labels.emplace_back();
    }
    if (by_blank && labelled < values.labels.size() && !is_first_alone) {
        return std::nullopt; // 1 0 zero 0
    }
    if (labelled == 0 || (is_first_alone && values.labels.size() > 1)) {
        values.labels.clear();
    }
    values.row = joined(fields, std::string(1, delimiter.text()));
    return values;
}

} // namespace

bool is_value(std::string_view word) {
    const std::size_t first = std::min(word.find_first_not_of("[](){}<> \t\r\n"), word.size());
    const bool has_bracket = word.substr(0, first).find_first_of(brackets) != std::string_view::npos;
    word.remove_prefix(first);
    return stream::is_number(word.substr(0, word.find_first_of(",; \t\r\n[](){}<>"))) ||
           (has_bracket && word.find_first_of("0123456789+-.") == 0);
}

bool holds_number(std::string_view word) { return std::ranges::any_of(tokens_of(word), &Token::is_number); }

Values values_of(const std::vector<std::string>& words, std::optional<stream::Delimiter> given) {
    std::string text = joined(words, " ");
    if (!given || words.size() > 1) {
        given = text.find(',') != std::string::npos ? stream::Delimiter::character(',') : stream::Delimiter::blanks();
    }
    const bool has_words = text.find_first_of(":=\"'") != std::string::npos ||
                           std::ranges::any_of(tokens_of(text), [](const Token& token) { return !token.is_number; });
    if (!has_words || !holds_number(text) || has_mark_of_arc(text)) {
        return row_of_numbers(std::move(text), *given);
    }
    auto values = row_of_words(text, *given, true);
    return values ? *values : row_of_words(text, *given, false).value_or(Values());
}

void take_attitude(Values& values, const Spec& spec) {
    std::vector<std::string_view> fields;
    static_cast<void>(values.delimiter.split(values.row, fields));
    const auto is = [&fields](std::size_t at, double expected) {
        double value = 0.0;
        return stream::read_number(stream::trimmed(fields[at]), value) == stream::NumberError::none &&
               value == expected;
    };
    if (spec.name == RepresentationId::dcm && fields.size() == 16 && is(12, 0.0) && is(13, 0.0) && is(14, 0.0) &&
        is(15, 1.0)) {
        const std::array<std::size_t, 9> places{0, 1, 2, 4, 5, 6, 8, 9, 10};
        const auto kept = mapped(places, [&fields](std::size_t place) { return fields[place]; });
        values.row = joined(kept, std::string(1, values.delimiter.text()));
        values.labels.clear();
        return;
    }
    const bool has_more = fields.size() > spec.size() && std::ranges::all_of(fields, stream::is_number);
    if (const auto known = has_more ? find_names(spec, values.labels) : std::nullopt; known && known->decides) {
        throw Usage("{0} where {1} has {2}: {3} are at {4} (--columns {4})", counted(fields.size(), "number"),
                    spec.text(), spec.size(), joined(known->of(values.labels)), known->columns());
    }
}

} // namespace rotconv::cli
