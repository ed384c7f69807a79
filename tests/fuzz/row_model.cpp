#include "row_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

namespace fuzz {
namespace {

using Fields = std::vector<std::string_view>;

struct Line {
    std::string_view text;
    std::string_view end;
    bool comment = false;
    [[nodiscard]] bool blank() const { return text.find_first_not_of(" \t") == std::string_view::npos; }
    [[nodiscard]] bool row() const { return !blank() && !comment; }
};

std::vector<Line> lines_of(std::string_view text, std::string_view comment) {
    comment = comment == "none" ? "" : comment;
    std::vector<Line> lines;
    while (!text.empty()) {
        const std::size_t newline = text.find('\n');
        const std::size_t size = std::min(newline, text.size() - 1) + 1;
        std::string_view line = text.substr(0, size);
        const std::size_t end_size = newline == std::string_view::npos ? 0 : line.ends_with("\r\n") ? 2 : 1;
        lines.push_back({line.substr(0, size - end_size), line.substr(size - end_size)});
        lines.back().comment = !comment.empty() && !lines.back().blank() && line.starts_with(comment);
        text.remove_prefix(size);
    }
    return lines;
}

std::string_view trim(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    return text.substr(0, text.find_last_not_of(" \t") + 1);
}

constexpr std::array<std::pair<std::string_view, char>, 4> delimiters{
    {{"comma", ','}, {"tab", '\t'}, {"semicolon", ';'}, {"blank", ' '}}};

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
    return text;
}

/// What --delimiter says, else the first of comma, tab and semicolon that stands outside quotes, else blanks. Quotes
/// that do not come in pairs enclose nothing.
char delimiter_of(std::string_view row, const std::string& given) {
    if (!given.empty()) {
        const auto* const named = std::ranges::find(delimiters, given, [](const auto& entry) { return entry.first; });
        return named == delimiters.end() ? given[0] : named->second;
    }
    const std::string_view candidates = ",\t;";
    std::string bare; // without the fields in quotes
    for (std::size_t i = 0; i < row.size(); ++i) {
        const bool starts = bare.empty() || candidates.find(bare.back()) != std::string_view::npos;
        std::size_t close = starts && row[i] == '"' ? row.find('"', i + 1) : std::string_view::npos;
        while (close != std::string_view::npos && row.substr(close).starts_with("\"\"")) {
            close = row.find('"', close + 2);
        }
        i = close == std::string_view::npos ? i : close;
        bare += row[i];
    }
    const auto found = std::ranges::find_if(candidates, [&](char c) { return bare.find(c) != std::string::npos; });
    return found == candidates.end() ? ' ' : *found;
}

/// A field that begins with a quote ends at a delimiter after the closing one.
bool split(std::string_view row, char delimiter, Fields& fields) {
    std::size_t start = 0;
    bool quoted = false;
    for (std::size_t i = 0; i <= row.size(); ++i) {
        const bool is_end = i == row.size();
        if (delimiter == ' ') {
            if (is_end || row[i] == ' ' || row[i] == '\t') {
                if (i > start) {
                    fields.push_back(row.substr(start, i - start));
                }
                start = i + 1;
            }
        } else if (is_end || (row[i] == delimiter && !quoted)) {
            fields.push_back(row.substr(start, i - start));
            start = i + 1;
        } else if (row[i] == '"' && i == start) {
            quoted = true;
        } else if (row[i] == '"' && quoted) {
            const bool doubled = i + 1 < row.size() && row[i + 1] == '"';
            quoted = doubled;
            i += doubled ? 1 : 0;
        }
    }
    return !quoted;
}

bool has_quotes(std::string_view field, char delimiter) {
    return delimiter != ' ' && field.size() >= 2 && field.starts_with('"') && field.ends_with('"');
}

std::string unquoted(std::string_view field, char delimiter) {
    if (!has_quotes(field, delimiter)) {
        return std::string(field);
    }
    std::string text(field.substr(1, field.size() - 2));
    for (std::size_t at = 0; (at = text.find("\"\"", at)) != std::string::npos; ++at) {
        text.erase(at, 1);
    }
    return text;
}

/// The text that is read as a number.
std::string content(std::string_view field, char delimiter) {
    return std::string(trim(unquoted(trim(field), delimiter)));
}

/// [+-] digits with a point and an exponent, nan or inf; false for anything else. Too large a number becomes infinite.
bool read(const std::string& text, double& value) {
    const std::string small = lower(text);
    const char* at = small.c_str();
    at += *at == '+' || *at == '-' ? 1 : 0;
    const std::string_view word = std::string_view(small).substr(static_cast<std::size_t>(at - small.data()));
    bool legal = word == "nan" || word == "inf" || word == "infinity";
    if (word.starts_with("nan(") && word.ends_with(")")) {
        legal = word.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_", 4) == word.size() - 1;
    }
    if (!legal) {
        const auto digits = [&at] {
            const char* const from = at;
            while (*at >= '0' && *at <= '9') {
                ++at;
            }
            return at - from;
        };
        auto count = digits();
        if (*at == '.') {
            ++at;
            count += digits();
        }
        legal = count > 0;
        if (*at == 'e') {
            at += at[1] == '+' || at[1] == '-' ? 2 : 1;
            legal = legal && digits() > 0;
        }
        legal = legal && at == small.data() + small.size();
    }
    value = legal ? std::strtod(text.c_str(), nullptr) : 0.0;
    return legal;
}

/// How many fields a row has.
struct Width {
    std::size_t fields = 0;
    std::size_t filled = 0; ///< without the empty ones at its end
};

Width width_of(const Fields& fields, char delimiter) {
    Width width{fields.size(), fields.size()};
    while (width.filled > 0 && content(fields[width.filled - 1], delimiter).empty()) {
        --width.filled;
    }
    return width;
}

/// The rule of widths: whether a row has as many fields as the first row.
bool is_as_wide(const Width& row, const Width& first) {
    const auto is_either = [&row](std::size_t count) { return row.fields == count || row.filled == count; };
    return is_either(first.fields) || is_either(first.filled);
}

/// Of a list such as "1,3-5".
std::vector<std::size_t> positions_of(const std::string& list) {
    std::vector<std::size_t> positions;
    Fields parts;
    if (!list.empty()) {
        split(list, ',', parts);
    }
    for (const std::string_view part : parts) {
        const std::size_t dash = part.find('-');
        const std::size_t first = std::stoul(std::string(part));
        const std::size_t last =
            dash == std::string_view::npos ? first : std::stoul(std::string(part.substr(dash + 1)));
        for (std::size_t i = first; i <= last; ++i) {
            positions.push_back(i - 1);
        }
    }
    return positions;
}

/// Blanks at the row's end are left out; a tab that parts fields is none.
std::string_view without_last_blanks(std::string_view row, char delimiter) {
    const bool tabs_are_blanks = delimiter != '\t';
    return row.substr(0, row.find_last_not_of(tabs_are_blanks ? " \t" : " ") + 1);
}

class Model {
public:
    explicit Model(const Rules& rules) : rules_(rules), positions_(positions_of(rules.columns)) {
        for (std::size_t i = 0; rules.columns.empty() && i < rules.inputs; ++i) {
            positions_.push_back(i);
        }
        replaced_.assign(positions_.begin() + static_cast<std::ptrdiff_t>(rules.kept), positions_.end());
    }

    std::optional<Outcome> operator()(std::string_view text) {
        if (!begin(text)) {
            return std::nullopt;
        }
        for (std::size_t i = 0; i < lines_.size() && outcome_.to_the_end; ++i) {
            write_line(lines_[i], i + 1);
        }
        return outcome_;
    }

private:
    /// Settles where rows begin. False where that is not modelled: a header, comments above the rows, and a first row
    /// that cannot be read, which may be a header or the title of one.
    bool begin(std::string_view text) {
        if (text.starts_with("\xEF\xBB\xBF")) {
            text.remove_prefix(3);
            meet("byte order mark");
        }
        lines_ = lines_of(text, rules_.comment);
        const auto first = std::ranges::find_if(lines_, &Line::row);
        if (first == lines_.end() || (rules_.kept > 0 && text.find('T') != std::string_view::npos)) {
            return false; // an ISO time may stand in the place of a number
        }
        delimiter_ = delimiter_of(first->text, rules_.delimiter);
        line_end_ = first->end.empty() ? "\n" : first->end;
        Fields fields;
        std::vector<std::string> texts;
        if (!numbers_of(*first, fields, texts)) {
            return false;
        }
        if (!rules_.columns.empty()) {
            width_ = width_of(fields, delimiter_);
        }
        const auto* const named =
            std::ranges::find(delimiters, delimiter_, [](const auto& entry) { return entry.second; });
        meet(fmt::format("{} delimiter {}", rules_.delimiter.empty() ? "detected" : "given",
                         named == delimiters.end() ? "character" : named->first));
        return rules_.header == "no" ||
               (rules_.header == "auto" && std::ranges::none_of(lines_.begin(), first, &Line::comment));
    }

    void meet(std::string rule) { outcome_.met.push_back(std::move(rule)); }

    /// The fields that are not selected, and the result where the leftmost selected one stood or at the end. Without
    /// --columns the row is its numbers: of one with others nothing is kept.
    [[nodiscard]] std::string in_place(const Fields& fields, const std::string& result) const {
        const std::size_t place = std::ranges::min(replaced_);
        const bool keeps = !rules_.columns.empty() || rules_.kept > 0;
        std::vector<std::string> texts;
        for (std::size_t i = 0; i < std::max(fields.size(), place + 1); ++i) {
            if (i == place) {
                texts.push_back(result);
            }
            if (i < fields.size() && keeps && std::ranges::count(replaced_, i) == 0) {
                texts.emplace_back(fields[i]);
            }
        }
        return fmt::format("{}", fmt::join(texts, std::string_view(&delimiter_, 1)));
    }

    void write_line(const Line& line, std::size_t number) {
        if (line.row()) {
            write_row(line, number);
            return;
        }
        meet(line.blank() ? "blank row" : "comment");
        outcome_.bytes += std::string(line.text) + std::string(line.end);
    }

    /// The numbers of a row, where it has them.
    std::optional<std::vector<double>> numbers_of(const Line& line, Fields& fields, std::vector<std::string>& texts) {
        if (!split(line.text, delimiter_, fields) ||
            (rules_.columns.empty() && width_of(fields, delimiter_).filled != rules_.inputs)) {
            return std::nullopt;
        }
        std::vector<double> numbers(rules_.inputs);
        for (std::size_t i = 0; i < rules_.inputs; ++i) {
            const std::size_t at = positions_[i];
            if (at >= fields.size()) {
                meet("missing field");
                return std::nullopt;
            }
            const std::string text = content(fields[at], delimiter_);
            const bool has_digits = text.find_first_of("0123456789") != std::string::npos;
            if (!read(text, numbers[i]) || (std::isinf(numbers[i]) && has_digits)) {
                return std::nullopt;
            }
            texts.push_back(text);
            if (has_quotes(fields[at], delimiter_)) {
                meet("quoted number");
            }
        }
        if (width_ && !rules_.ragged && !is_as_wide(width_of(fields, delimiter_), *width_)) {
            meet("row of another width");
            return std::nullopt;
        }
        return numbers;
    }

    void write_row(const Line& line, std::size_t number) {
        Fields fields;
        std::vector<std::string> texts;
        const auto numbers = numbers_of(line, fields, texts);
        auto result = numbers ? rules_.calculate(*numbers, texts) : std::nullopt;
        if (line.end.size() != 1) {
            meet(line.end.empty() ? "last row without newline" : "CRLF");
        }
        meet(result ? "row compared" : "failed row under " + rules_.on_error);
        if (result) {
            ++outcome_.answered;
        } else {
            outcome_.failed.push_back(number);
            outcome_.to_the_end = rules_.on_error != "stop";
            if (rules_.on_error != "nan") {
                return;
            }
            result = std::vector<double>(rules_.results, std::numeric_limits<double>::quiet_NaN());
        }
        std::vector<std::string> shown;
        for (const double value : *result) {
            shown.push_back(fmt::format("{}", std::isnan(value) ? std::abs(value) : value + 0.0)); // no -0
        }
        const std::string text = fmt::format("{}", fmt::join(shown, std::string_view(&delimiter_, 1)));
        outcome_.bytes += rules_.append ? std::string(without_last_blanks(line.text, delimiter_)) + delimiter_ + text
                                        : in_place(fields, text);
        outcome_.bytes += line.end.empty() ? line_end_ : line.end;
    }

    const Rules& rules_;
    std::vector<std::size_t> positions_; ///< of the numbers, in their order...
    std::vector<std::size_t> replaced_;  ///< ...and of those among them that are not kept
    std::vector<Line> lines_;
    std::optional<Width> width_; ///< of the first numeric row
    char delimiter_ = ',';
    std::string_view line_end_ = "\n";
    Outcome outcome_;
};

} // namespace

std::optional<Outcome> model(std::string_view text, const Rules& rules) { return Model(rules)(text); }

} // namespace fuzz
