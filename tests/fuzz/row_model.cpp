#include "row_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <numeric>
#include <regex>
#include <set>

#include <boost/multiprecision/cpp_int.hpp>
#include <fmt/format.h>

namespace fuzz {
namespace {

using Fields = std::vector<std::string_view>;

struct Line {
    std::string_view text;
    std::string_view end;
    std::string_view mark; ///< with which it is a comment; empty: it is not
    [[nodiscard]] bool blank() const { return text.find_first_not_of(" \t") == std::string_view::npos; }
    [[nodiscard]] bool comment() const { return !mark.empty(); }
    [[nodiscard]] bool row() const { return !blank() && !comment(); }
};

std::vector<Line> lines_of(std::string_view text, std::string_view comment) {
    comment = comment == "none" ? "" : comment;
    std::vector<Line> lines;
    while (!text.empty()) {
        const std::size_t newline = text.find('\n');
        const std::size_t size = std::min(newline, text.size() - 1) + 1;
        std::string_view line = text.substr(0, size);
        const std::size_t end_size = newline == std::string_view::npos ? 0 : line.ends_with("\r\n") ? 2 : 1;
        lines.push_back({line.substr(0, size - end_size), line.substr(size - end_size), {}});
        lines.back().mark = !lines.back().blank() && lines.back().text.starts_with(comment) ? comment : "";
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

/// The text that is read as a number or a name.
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

/// A key in units of 1e-18.
using Key = boost::multiprecision::cpp_int;

/// Of a text that is a number, rounded to a unit, ties to even; nothing for nan, inf, and what would be 1e20 or more.
std::optional<Key> key_of(const std::string& text) {
    const std::size_t first = text.find_first_of("0123456789.");
    const std::string magnitude = text.substr(std::min(first, text.size()));
    const std::size_t mantissa_end = std::min(magnitude.find_first_of("eE"), magnitude.size());
    std::string digits = magnitude.substr(0, mantissa_end);
    const std::size_t point = digits.find('.');
    const auto decimals = static_cast<long>(point == std::string::npos ? 0 : digits.size() - point - 1);
    std::erase(digits, '.');
    if (digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos) {
        return std::nullopt;
    }
    digits.erase(0, digits.find_first_not_of('0')); // which would mean octal
    const long power = mantissa_end < magnitude.size() ? std::strtol(magnitude.c_str() + mantissa_end + 1, nullptr, 10)
                                                       : 0; // the greatest long where it is larger
    const long zeros = std::clamp(power, -1'000'000L, 1'000'000L) + 18 - decimals; // after the digits of the units
    const auto size = static_cast<long>(digits.size());
    if (digits.empty() || size + zeros < 0) {
        return Key(0);
    }
    if (size + zeros > 38) {
        return std::nullopt;
    }
    Key units(digits);
    if (zeros >= 0) {
        units *= pow(Key(10), static_cast<unsigned>(zeros));
    } else {
        const Key unit = pow(Key(10), static_cast<unsigned>(-zeros));
        const Key twice_rest = 2 * (units % unit);
        units /= unit;
        units += twice_rest > unit || (twice_rest == unit && units % 2 == 1) ? 1 : 0;
    }
    return text.starts_with('-') ? Key(-units) : units;
}

/// All digits of the key.
std::string decimal_text_of(const Key& key) {
    std::string digits = Key(abs(key)).str();
    digits.insert(0, 19 - std::min<std::size_t>(digits.size(), 19), '0');
    digits.insert(digits.size() - 18, ".");
    digits.erase(digits.find_last_not_of('0') + 1);
    digits.erase(digits.size() - (digits.ends_with('.') ? 1 : 0));
    return (key < 0 ? "-" : "") + digits;
}

/// Of a time of ISO 8601 in UTC the seconds since 1970, as they are written; any other text as it is.
std::string as_number(const std::string& text) {
    static const std::regex form(R"((\d{4})-(?:(\d{3})|(\d\d)-(\d\d))T(\d\d):(\d\d)(?::(\d\d)(?:\.(\d+))?)?Z?)");
    std::smatch part;
    if (!std::regex_match(text, part, form)) {
        return text;
    }
    const auto number = [&part](std::size_t i) { return part[i].matched ? std::stol(part[i].str()) : 0; };
    const auto leaps = [](long year) { return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0; };
    const std::array<long, 12> months{31, leaps(number(1)) ? 29 : 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    long day = part[2].matched ? number(2) : number(4); // of the year
    const long last = leaps(number(1)) ? 366 : 365;
    if (!part[2].matched) {
        if (number(3) < 1 || number(3) > 12 || day < 1 || day > months.at(static_cast<std::size_t>(number(3) - 1))) {
            return text;
        }
        day = std::accumulate(months.begin(), months.begin() + number(3) - 1, day);
    }
    if (day < 1 || day > last || number(5) > 23 || number(6) > 59 || number(7) > 59) {
        return text;
    }
    for (long year = number(1); year != 1970; year += year < 1970 ? 1 : -1) {
        day += year < 1970 ? (leaps(year) ? -366 : -365) : (leaps(year - 1) ? 366 : 365);
    }
    const std::string fraction = part[8].str();
    const std::string part_of_second = fraction.substr(std::min(fraction.find_first_not_of('0'), fraction.size()));
    const Key units = (Key(day - 1) * 86400 + number(5) * 3600 + number(6) * 60 + number(7)) *
                          pow(Key(10), static_cast<unsigned>(fraction.size())) +
                      (part_of_second.empty() ? Key(0) : Key(part_of_second));
    return units.str() + "e-" + std::to_string(fraction.size());
}

bool stands_for_missing(const std::string& text) {
    return std::set<std::string>{"", "na", "n/a", "null", "none", "nil", "-", "?", "."}.contains(lower(text));
}

/// The manual says that the words by which other programs begin their files make no header, and not more: they are not
/// modelled.
bool may_be_remark(const Line& line) {
    const auto has = [&line](std::string_view word) { return line.text.find(word) != std::string_view::npos; };
    return has("FMT") || has("COMMENT") || has("=");
}

/// A word in brackets and numbers between blanks in brackets are no JSON; all else that begins with a bracket may be.
bool may_be_json(const Line& line) {
    static const std::regex other(R"(\[(?:[A-DF-Za-df-z][^]*|[0-9][0-9.]*[ \t]+[0-9][^]*))");
    const std::string text(trim(line.text));
    return text.starts_with('{') || (text.starts_with('[') && !std::regex_match(text, other));
}

/// The number of fields, without empty ones at the end.
std::size_t width_of(const Fields& fields, char delimiter) {
    std::size_t width = fields.size();
    while (width > 0 && content(fields[width - 1], delimiter).empty()) {
        --width;
    }
    return width;
}

/// Of a mark before the first name.
bool is_mark(char c) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    return !is_letter && c != '"' && c != '\'' && static_cast<unsigned char>(c) < 0x80;
}

bool begins_with_mark_alone(const Fields& fields) {
    return !fields.empty() && !fields[0].empty() && std::ranges::all_of(fields[0], is_mark);
}

/// A name in lower case without its unit, such as "yaw" for "Yaw [deg]" and "Yaw_deg"; `modelled` becomes false where
/// it may be another unit.
std::string without_unit(const std::string& text, bool& modelled) {
    const std::string name = lower(text);
    const std::size_t bracket = name.ends_with(']')   ? name.rfind('[')
                                : name.ends_with(')') ? name.rfind('(')
                                                      : std::string::npos;
    if (bracket != std::string::npos) {
        return std::string(trim(std::string_view(name).substr(0, bracket)));
    }
    static const std::set<std::string> units{"deg",     "degree", "degrees", "degs", "rad", "radian",
                                             "radians", "rads",   "s",       "ms",   "us",  "ns"};
    static const std::regex others(
        "_.*(?:sec|dps|rps|per|-1|/|nano|micro|milli|degrees|radians|degree|radian|[^ -~]).*");
    for (std::size_t at = name.find('_', 1); at != std::string::npos; at = name.find('_', at + 1)) {
        std::string unit = name.substr(at);
        std::erase_if(unit, [](char c) { return c == '_' || c == ' ' || c == '\t'; });
        if (units.contains(unit)) {
            return name.substr(0, at);
        }
    }
    modelled = modelled && !std::regex_search(name, others);
    return name;
}

/// Where the names of an attitude's numbers stand, in its order.
struct Places {
    std::vector<std::size_t> places;
    bool is_numbered = false; ///< the names are 0 1 2 3
    [[nodiscard]] bool in_order() const { return places.back() + 1 == places.size() && std::ranges::is_sorted(places); }
};

/// What may be left of the names of an attitude's numbers, in its order; the last are numbers of a quaternion.
std::vector<std::vector<std::string>> remains_of(const Attitude& attitude) {
    std::vector<std::vector<std::string>> all;
    for (const std::string kind : {"w", "s", "scalar", "0"}) {
        auto& remains = all.emplace_back();
        for (const std::string& name : attitude.names) {
            if (attitude.names.size() == 4) {
                const std::string letter = name.substr(1);
                const bool is_numbered = kind == "0";
                remains.push_back(letter == "w" ? kind : is_numbered ? std::to_string(letter[0] - 'w') : letter);
            } else if (attitude.names.size() == 9) {
                const int less = kind == "w" ? 0 : 11;
                remains.push_back(fmt::format("{:02}", std::stoi(name.substr(1)) - less));
            } else {
                remains.push_back(name);
            }
        }
    }
    return all;
}

/// The names of an attitude's numbers among others, with any prefix and suffix that they share.
std::optional<Places> find_attitude(const Attitude& attitude, const std::vector<std::string>& names, bool& modelled) {
    std::vector<std::string> as_written;
    std::vector<std::string> bare;
    for (const std::string& name : names) {
        as_written.push_back(lower(name));
        bare.push_back(without_unit(name, modelled));
    }
    for (const auto& remains :
         attitude.names.empty() ? std::vector<std::vector<std::string>>() : remains_of(attitude)) {
        for (const auto& texts : {as_written, bare}) {
            for (const std::string& text : texts) {
                const std::string& first = remains[0];
                for (std::size_t at = text.find(first); at != std::string::npos; at = text.find(first, at + 1)) {
                    Places found{.places = {}, .is_numbered = std::ranges::count(remains, "0") > 0};
                    for (const std::string& each : remains) {
                        const std::string whole = text.substr(0, at) + each + text.substr(at + first.size());
                        const auto place = static_cast<std::size_t>(std::ranges::find(texts, whole) - texts.begin());
                        if (place < texts.size()) {
                            found.places.push_back(place);
                        }
                    }
                    if (found.places.size() == remains.size()) {
                        return found;
                    }
                }
            }
        }
    }
    return std::nullopt;
}

/// An item of --columns: a name, or a position.
struct Item {
    std::string name;
    std::size_t position = 0;
};

std::vector<Item> items_of(const std::string& list) {
    std::vector<Item> items;
    Fields parts;
    if (!list.empty()) {
        split(list, ',', parts);
    }
    for (const std::string_view part : parts) {
        const std::string item(trim(part));
        const auto dash = item.find('-');
        if (item.find_first_not_of("0123456789-") != std::string::npos) {
            items.push_back({item});
            continue;
        }
        const std::size_t first = std::stoul(item);
        const std::size_t last = dash == std::string::npos ? first : std::stoul(item.substr(dash + 1));
        for (std::size_t i = first; i <= last; ++i) {
            items.push_back({{}, i - 1});
        }
    }
    return items;
}

/// Blanks at the row's end are left out; a tab that parts fields is none.
std::string_view without_last_blanks(std::string_view row, char delimiter) {
    const bool tabs_are_blanks = delimiter != '\t';
    return row.substr(0, row.find_last_not_of(tabs_are_blanks ? " \t" : " ") + 1);
}

/// An integer beyond 2^53 would be rounded by readers.
bool is_json_number(const std::string& text) {
    double value = 0.0;
    const std::string digits = text.substr(text.starts_with('-') ? 1 : 0);
    const auto is_digit = [&digits](std::size_t i) {
        return i < digits.size() && digits[i] >= '0' && digits[i] <= '9';
    };
    const std::size_t point = digits.find('.');
    const bool legal = read(text, value) && is_digit(0) && !(digits[0] == '0' && is_digit(1)) &&
                       (point == std::string::npos || is_digit(point + 1));
    const bool is_integer = digits.find_first_of(".eE") == std::string::npos;
    const bool is_large = digits.size() > 16 || (digits.size() == 16 && digits > "9007199254740992");
    return legal && !(is_integer && is_large);
}

class Model {
public:
    explicit Model(const Rules& rules) : rules_(rules), items_(items_of(rules.columns)) {
        for (const Item& item : items_) {
            by_name_ = by_name_ || !item.name.empty();
            positions_.push_back(item.position);
        }
    }

    std::optional<Outcome> operator()(std::string_view text) {
        if (!begin(text)) {
            return std::nullopt;
        }
        if (refused_) {
            return Outcome{.to_the_end = false, .refused_line = *header_ + 1};
        }
        for (std::size_t i = 0; i < lines_.size() && outcome_.to_the_end; ++i) {
            write_added_header(i);
            if (i == refused_row_) {
                outcome_.to_the_end = false;
                outcome_.refused_line = i + 1;
                outcome_.refused_width = true;
            } else {
                write_line(i);
            }
        }
        return outcome_;
    }

    std::optional<Outcome> operator()(std::string_view text, Model& reference, std::string_view reference_text) {
        if (!begin(text) || !reference.begin(reference_text) || refused_ || reference.refused_ ||
            refused_row_ != none || reference.refused_row_ != none) {
            return std::nullopt;
        }
        pair_with(reference);
        for (std::size_t i = 0; i < lines_.size() && outcome_.to_the_end; ++i) {
            write_added_header(i);
            const bool has_key = is_data(i) && !wrong_keys_.contains(i);
            if (has_key && partners_.contains(i) && !fail_keys_before(partners_.at(i))) {
                return std::nullopt;
            }
            if (is_data(i) && !has_key && stops() && reference.next_wrong_key_ < next_partner(i)) {
                return std::nullopt; // which of the two errors comes first is not said
            }
            if (outcome_.to_the_end) {
                write_line(i);
            }
        }
        if (outcome_.to_the_end && !fail_keys_before(reference.lines_.size())) {
            return std::nullopt;
        }
        outcome_.met.insert(outcome_.met.end(), reference.outcome_.met.begin(), reference.outcome_.met.end());
        return outcome_;
    }

private:
    /// False where what the text begins with is not modelled.
    bool begin(std::string_view text) {
        if (text.starts_with("\xEF\xBB\xBF")) {
            text.remove_prefix(3);
            meet("byte order mark");
        }
        lines_ = lines_of(text, rules_.comment);
        const auto comment = std::ranges::find_if(lines_, &Line::comment);
        if (comment != lines_.end() && std::ranges::none_of(lines_, &Line::row)) {
            note('c', static_cast<std::size_t>(comment - lines_.begin()) + 1);
        }
        if (std::ranges::any_of(lines_, may_be_remark) || !find_header() ||
            (rules_.header == "add" && first_data_ == lines_.size()) || !hear_names()) {
            return false;
        }
        if (header_ && first_data_ == lines_.size()) {
            note('h', *header_ + 1);
        }
        if (first_data_ < lines_.size()) {
            const Line& first = lines_[first_data_];
            delimiter_ = delimiter_of(first.text, rules_.delimiter);
            line_end_ = first.end.empty() ? "\n" : first.end;
            const auto met = outcome_.met;
            for (std::size_t i = first_data_; i < lines_.size(); ++i) {
                Fields fields;
                std::vector<std::string> texts;
                const auto numbers = is_data(i) ? numbers_of(lines_[i], fields, texts) : std::nullopt;
                if (numbers && !width_ && !items_.empty()) {
                    width_ = width_of(fields, delimiter_);
                    refused_row_ = by_name_ && name_count_ != *width_ ? i : none;
                }
            }
            outcome_.met = met;
            meet(fmt::format("{} delimiter {}", rules_.delimiter.empty() ? "detected" : "given", name_of(delimiter_)));
        }
        return true;
    }

    [[nodiscard]] bool is_data(std::size_t at) const { return lines_[at].row() && at >= first_data_ && header_ != at; }
    [[nodiscard]] bool stops() const { return rules_.on_error == "stop"; }

    /// Settles partners_.
    void pair_with(Model& reference) {
        reference_ = &reference;
        std::vector<std::pair<std::size_t, Key>> rows;
        std::vector<std::pair<std::size_t, Key>> others;
        find_rows(rows);
        reference.find_rows(others);
        std::set<std::size_t> paired;
        const auto join = [&](std::size_t i, std::size_t j) {
            partners_[rows[i].first] = others[j].first;
            paired.insert(others[j].first);
        };
        if (!rules_.by_key) {
            for (std::size_t i = 0; i < std::min(rows.size(), others.size()); ++i) {
                join(i, i);
            }
        } else if (!rows.empty() && !others.empty()) {
            const Key anything = pow(Key(10), 40);
            const Key within = rules_.key_within.empty() ? Key(0) : key_of(rules_.key_within).value_or(anything);
            const auto distance = [](const auto& a, const auto& b) { return Key(abs(a.second - b.second)); };
            const auto nearest = [&](const auto& row, const auto& among) {
                return std::ranges::min_element(among, {}, [&](const auto& other) { return distance(row, other); }) -
                       among.begin();
            };
            for (std::size_t i = 0; i < rows.size(); ++i) {
                const auto j = static_cast<std::size_t>(nearest(rows[i], others));
                if (distance(rows[i], others[j]) <= within && static_cast<std::size_t>(nearest(others[j], rows)) == i) {
                    join(i, j);
                }
            }
        }
        for (const auto& [at, key] : others) {
            if (!paired.contains(at)) {
                outcome_.unpaired[1].push_back(at + 1);
                meet("unpaired row of the reference");
            }
        }
    }

    /// The rows that may be paired, with their keys; the others come into wrong_keys_.
    void find_rows(std::vector<std::pair<std::size_t, Key>>& rows) {
        for (std::size_t at = 0; at < lines_.size(); ++at) {
            if (!is_data(at)) {
                continue;
            }
            Fields fields;
            std::optional<Key> key = 0;
            if (rules_.by_key) {
                const bool closed = split(lines_[at].text, delimiter_, fields);
                double value = 0.0;
                const std::string text = closed && positions_[0] < fields.size()
                                             ? as_number(content(fields[positions_[0]], delimiter_))
                                             : "";
                key = read(text, value) ? key_of(text) : std::nullopt;
                if (key && !rules_.key_offset.empty()) {
                    *key += key_of(rules_.key_offset).value_or(0);
                }
                if (key && !rows.empty() && *key <= rows.back().second) {
                    key.reset();
                }
            }
            if (key) {
                rows.emplace_back(at, *key);
                keys_[at] = *key;
            } else {
                wrong_keys_.insert(at);
            }
        }
        next_wrong_key_ = wrong_keys_.empty() ? none : *wrong_keys_.begin();
    }

    /// The least partner of a row after that one.
    [[nodiscard]] std::size_t next_partner(std::size_t at) const {
        const auto next = partners_.upper_bound(at);
        return next == partners_.end() ? none : next->second;
    }

    /// The reference's rows before `end` whose keys are wrong; false where one stops the run and it is not said which
    /// lines of the stream come before it.
    bool fail_keys_before(std::size_t end) {
        for (std::size_t& wrong = reference_->next_wrong_key_; wrong < end && outcome_.to_the_end;) {
            meet("failed key of the reference");
            if (stops() && (outcome_.bytes.size() != settled_bytes_ || outcome_.failed.size() != settled_failures_)) {
                return false;
            }
            outcome_.failed.push_back({wrong + 1, true});
            outcome_.to_the_end = !stops();
            const auto next = reference_->wrong_keys_.upper_bound(wrong);
            wrong = next == reference_->wrong_keys_.end() ? none : *next;
        }
        return true;
    }

    static std::string_view name_of(char delimiter) {
        const auto* const found =
            std::ranges::find(delimiters, delimiter, [](const auto& entry) { return entry.second; });
        return found == delimiters.end() ? "character" : found->first;
    }

    /// The first of its kind.
    void note(char kind, std::size_t line) {
        if (outcome_.notes.find(kind) == std::string::npos) {
            outcome_.notes += fmt::format("{}{}", kind, line);
        }
    }

    /// The names of the header against those of the attitudes; false where they may have units that are not modelled.
    bool hear_names() {
        std::vector<std::string> names;
        for (std::size_t i = 0; header_ && i < rules_.inputs; ++i) {
            if (place(i) >= header_names_.size() || (items_.empty() && name_count_ != rules_.inputs)) {
                return true;
            }
            names.push_back(header_names_[place(i)]);
        }
        bool modelled = true;
        for (const Attitude& attitude : rules_.attitudes) {
            if (names.empty() || attitude.names.empty()) {
                continue;
            }
            const auto first = names.begin() + static_cast<std::ptrdiff_t>(attitude.first);
            const std::vector<std::string> own(first, first + static_cast<std::ptrdiff_t>(attitude.names.size()));
            if (const auto found = find_attitude(attitude, own, modelled)) {
                if (!found->in_order()) {
                    note('o', *header_ + 1);
                    refused_ = refused_ || (rules_.refuses_order && items_.empty() && !found->is_numbered);
                }
            } else if (!items_.empty() && !by_name_) {
                const auto elsewhere = find_attitude(attitude, header_names_, modelled);
                if (elsewhere && !elsewhere->is_numbered) {
                    note('o', *header_ + 1);
                    meet("names in other columns");
                }
            }
        }
        return modelled;
    }

    void meet(std::string rule) { outcome_.met.push_back(std::move(rule)); }

    /// Settles header_ and first_data_, and positions_ where they are names; false where that is not modelled.
    bool find_header() {
        const auto next_row = [this](std::size_t at) {
            while (at < lines_.size() && !lines_[at].row()) {
                ++at;
            }
            return at;
        };
        first_data_ = next_row(0);
        const bool at_end = first_data_ == lines_.size();
        if (!at_end && may_be_json(lines_[first_data_])) {
            return false;
        }
        if (by_name_) {
            return find_by_name();
        }
        if (rules_.header == "no" || rules_.header == "add" || at_end) {
            return true;
        }
        const Line& first = lines_[first_data_];
        const char delimiter = delimiter_of(first.text, rules_.delimiter);
        Fields fields;
        const bool closed = split(first.text, delimiter, fields);
        const bool is_remark = first.text.starts_with("//") || first.text.starts_with('%');
        const bool selects_all = selects(fields, delimiter);
        const bool is_header = closed && !is_remark && selects_all && !holds_a_number(fields, delimiter);
        const bool is_data = rules_.header == "yes" ? selects_all && holds_numbers(fields, delimiter) : !is_header;
        if (is_data && find_comment_header(width_of(fields, delimiter), delimiter)) {
            return true;
        }
        if (rules_.header == "yes" || is_header) {
            use_header(first_data_, {delimiter, begins_with_mark_alone(fields)});
            first_data_ = next_row(first_data_ + 1);
        }
        return true;
    }

    [[nodiscard]] bool selects(const Fields& fields, char delimiter) const {
        return items_.empty() ? width_of(fields, delimiter) == rules_.inputs
                              : std::ranges::max(positions_) < fields.size();
    }

    /// Of the i-th number.
    [[nodiscard]] std::size_t place(std::size_t i) const { return items_.empty() ? i : positions_[i]; }

    [[nodiscard]] std::vector<std::string> selected(const Fields& fields, char delimiter) const {
        std::vector<std::string> texts;
        for (std::size_t i = 0; i < rules_.inputs; ++i) {
            texts.push_back(content(fields[place(i)], delimiter));
        }
        return texts;
    }

    /// In a selected field, with a point or a comma, or a word for a missing one.
    [[nodiscard]] bool holds_a_number(const Fields& fields, char delimiter) const {
        return std::ranges::any_of(selected(fields, delimiter), [](std::string text) {
            double value = 0.0;
            const bool is_missing = stands_for_missing(text);
            if (const auto comma = text.find(','); comma != std::string::npos) {
                text[comma] = '.';
            }
            return is_missing || read(text, value);
        });
    }

    /// In all selected fields.
    [[nodiscard]] bool holds_numbers(const Fields& fields, char delimiter) const {
        double value = 0.0;
        return std::ranges::all_of(selected(fields, delimiter), [&](const auto& text) { return read(text, value); });
    }

    /// The last comment before the first data row, where it has the fields of that row; commas may part them where
    /// blanks part the row.
    bool find_comment_header(std::size_t field_count, char row_delimiter) {
        std::size_t at = first_data_;
        while (at > 0 && !lines_[at - 1].comment()) {
            --at;
        }
        if (at == 0) {
            return false;
        }
        const std::string_view text = lines_[at - 1].text.substr(prefix_of(lines_[at - 1]).size());
        const bool has_commas = row_delimiter == ' ' && count_fields(text, ',') == field_count;
        const char delimiter = has_commas ? ',' : row_delimiter;
        Fields fields;
        if (!split(text, delimiter, fields) || width_of(fields, delimiter) != field_count ||
            !selects(fields, delimiter)) {
            return false;
        }
        if (rules_.header == "yes") { // then as many fields are enough
            use_header(at - 1, {delimiter});
            return true;
        }
        double value = 0.0;
        if (std::ranges::any_of(fields, [&](auto field) { return read(content(field, delimiter), value); })) {
            return false;
        }
        if (row_delimiter == ' ' && !are_own_names(selected(fields, delimiter))) {
            return false;
        }
        use_header(at - 1, {delimiter});
        return true;
    }

    /// Of all numbers but those that are kept, in any order.
    [[nodiscard]] bool are_own_names(const std::vector<std::string>& texts) const {
        auto own = rules_.input_names;
        std::vector<std::string> names;
        bool modelled = true;
        for (const std::string& text : texts) {
            names.push_back(without_unit(text, modelled));
        }
        for (const Attitude& attitude : rules_.attitudes) {
            const auto first = texts.begin() + static_cast<std::ptrdiff_t>(attitude.first);
            const std::vector<std::string> part(first, first + static_cast<std::ptrdiff_t>(attitude.names.size()));
            const auto found = find_attitude(attitude, part, modelled);
            for (std::size_t i = 0; found && !found->is_numbered && i < part.size(); ++i) {
                names[attitude.first + found->places[i]] = own[attitude.first + i];
            }
        }
        const auto kept = static_cast<std::ptrdiff_t>(rules_.kept);
        return std::is_permutation(names.begin() + kept, names.end(), own.begin() + kept, own.end());
    }

    /// The last row that has all the names, before the first row that is no comment and lacks one. That row says what
    /// parts the fields of a comment; elsewhere it is what makes fields of the names.
    bool find_by_name() {
        first_data_ = 0;
        while (first_data_ < lines_.size() && (!lines_[first_data_].row() || look_up(lines_[first_data_], 0))) {
            ++first_data_;
        }
        char of_comments = 0;
        if (first_data_ < lines_.size()) {
            const char delimiter = delimiter_of(lines_[first_data_].text, rules_.delimiter);
            Fields fields;
            split(lines_[first_data_].text, delimiter, fields);
            of_comments = fields.size() > 1 ? delimiter : '\0';
        }
        for (std::size_t i = first_data_; i > 0; --i) {
            const Line& line = lines_[i - 1];
            if (const auto parts = look_up(line, line.comment() ? of_comments : '\0')) {
                use_header(i - 1, *parts);
                const std::set<std::size_t> different(positions_.begin(), positions_.end());
                return !is_unsure_ && !ambiguous_ && different.size() == positions_.size();
            }
        }
        return false;
    }

    static std::size_t count_fields(std::string_view text, char delimiter) {
        Fields fields;
        split(text, delimiter, fields);
        return width_of(fields, delimiter);
    }

    static std::string_view prefix_of(const Line& line) {
        return line.text.substr(
            0, line.comment() ? std::min(line.text.find_first_not_of(" \t", line.mark.size()), line.text.size()) : 0);
    }

    /// How the names of a header are parted, and whether a mark stands before the first.
    struct Parting {
        char delimiter = ',';
        bool has_mark = false;
    };

    /// What stands before the names.
    static std::string_view prefix_of(const Line& line, const Parting& parts) {
        std::size_t size = prefix_of(line).size();
        while (parts.has_mark && size < line.text.size() && is_mark(line.text[size]) &&
               (parts.delimiter == ' ' || line.text[size] != parts.delimiter)) {
            ++size;
        }
        return line.text.substr(0, size);
    }

    /// Sets positions_ where the line has all the names, and returns under which parting it has. A mark is left aside
    /// where it stands alone, and where they are not all there as they stand.
    std::optional<Parting> look_up(const Line& line, char known) {
        const std::string_view text = line.text.substr(prefix_of(line).size());
        std::string candidates = ",\t; ";
        if (known != '\0' || !rules_.delimiter.empty()) {
            candidates = known != '\0' ? known : delimiter_of(text, rules_.delimiter);
            candidates += line.comment() && candidates == " " ? "," : "";
        }
        std::optional<Parting> found;
        for (const char delimiter : line.blank() ? std::string() : candidates) {
            if (candidates.size() > 1 && delimiter != ' ' && text.find(delimiter) == std::string_view::npos) {
                continue;
            }
            Fields fields;
            split(text, delimiter, fields);
            for (const bool aside : {begins_with_mark_alone(fields), !begins_with_mark_alone(fields)}) {
                const Parting parts{delimiter, aside};
                Fields names;
                split(line.text.substr(prefix_of(line, parts).size()), delimiter, names);
                if ((!found || found->delimiter != delimiter) && find_names(names, delimiter)) {
                    is_unsure_ = found.has_value();
                    found = parts;
                }
            }
            if (found && candidates != " ,") {
                break;
            }
        }
        return found;
    }

    bool find_names(const Fields& fields, char delimiter) {
        std::vector<std::size_t> positions;
        ambiguous_ = false;
        for (const Item& item : items_) {
            std::vector<std::size_t> whole;
            std::vector<std::size_t> part;
            for (std::size_t i = 0; i < fields.size(); ++i) {
                const std::string text = content(fields[i], delimiter);
                if (text == item.name) {
                    whole.push_back(i);
                }
                if (text.substr(0, text.find_first_of(" \t")) == item.name) {
                    part.push_back(i);
                }
            }
            const auto& found = whole.empty() ? part : whole;
            if (found.empty() && !item.name.empty()) {
                return false;
            }
            ambiguous_ = ambiguous_ || (found.size() > 1 && !item.name.empty());
            positions.push_back(item.name.empty() ? item.position : found.front());
        }
        positions_ = positions;
        return true;
    }

    void use_header(std::size_t at, const Parting& parts) {
        header_ = at;
        const Line& line = lines_[at];
        const char delimiter = parts.delimiter;
        Fields fields;
        const std::string_view prefix = prefix_of(line, parts);
        split(line.text.substr(prefix.size()), delimiter, fields);
        name_count_ = width_of(fields, delimiter);
        if (prefix.size() > prefix_of(line).size()) {
            meet("mark before the names");
        }
        for (const std::string_view field : fields) {
            header_names_.push_back(content(field, delimiter));
        }
        const auto whole = without_last_blanks(line.text, delimiter);
        header_text_ = rules_.append
                           ? fmt::format("{}{}{}", whole, delimiter, joined(result_names(), delimiter))
                           : std::string(prefix) + in_place(fields, joined(result_names(), delimiter), delimiter);
        header_text_ += line.end.empty() ? "\n" : line.end;
    }

    static std::string joined(const std::vector<std::string>& texts, char delimiter) {
        return fmt::format("{}", fmt::join(texts, std::string_view(&delimiter, 1)));
    }

    [[nodiscard]] std::vector<std::size_t> replaced() const {
        std::vector<std::size_t> selected = positions_;
        for (std::size_t i = 0; items_.empty() && i < rules_.inputs; ++i) {
            selected.push_back(i);
        }
        selected.erase(selected.begin(), selected.begin() + static_cast<std::ptrdiff_t>(rules_.kept));
        return selected;
    }

    /// The fields that are not selected. Without --columns the row is its numbers: of one with others nothing is kept.
    [[nodiscard]] std::vector<std::size_t> others(std::size_t count) const {
        std::vector<std::size_t> result;
        const auto selected = replaced();
        for (std::size_t i = 0; i < count; ++i) {
            if (rules_.append || (std::ranges::count(selected, i) == 0 && (!items_.empty() || rules_.kept > 0))) {
                result.push_back(i);
            }
        }
        return result;
    }

    /// The other fields, and the result where the leftmost selected one stood or at the end.
    [[nodiscard]] std::string in_place(const Fields& fields, const std::string& result, char delimiter) const {
        const std::size_t place = std::ranges::min(replaced());
        std::vector<std::string> texts;
        bool placed = false;
        for (const std::size_t i : others(fields.size())) {
            if (i > place && !placed) {
                texts.push_back(result);
                placed = true;
            }
            texts.emplace_back(fields[i]);
        }
        if (!placed) {
            texts.push_back(result);
        }
        return joined(texts, delimiter);
    }

    void write_line(std::size_t at) {
        const Line& line = lines_[at];
        const bool is_csv = rules_.format == "csv";
        if (header_ == at) {
            meet("header");
            outcome_.bytes += is_csv ? header_text_ : "";
            settled_bytes_ = outcome_.bytes.size();
        } else if (!line.row() || at < first_data_) { // of several rows with all the names the last is the header
            meet(line.blank() ? "blank row" : line.comment() ? "comment" : "row before the header");
            outcome_.bytes += is_csv ? std::string(line.text) + std::string(line.end) : "";
        } else {
            write_row(line, at + 1);
        }
    }

    /// Before the first data row.
    void write_added_header(std::size_t at) {
        if (at != first_data_ || rules_.header != "add" || rules_.format != "csv") {
            return;
        }
        Fields fields;
        split(lines_[at].text, delimiter_, fields);
        std::vector<std::string> indices;
        for (std::size_t i = 0; i < fields.size(); ++i) {
            indices.push_back(std::to_string(i + 1));
        }
        const std::string result = joined(result_names(), delimiter_);
        const Fields views(indices.begin(), indices.end());
        outcome_.bytes +=
            rules_.append ? joined(indices, delimiter_) + delimiter_ + result : in_place(views, result, delimiter_);
        outcome_.bytes += line_end_;
        settled_bytes_ = outcome_.bytes.size();
        meet("added header");
    }

    /// The numbers of a row, where it has them.
    std::optional<std::vector<double>> numbers_of(const Line& line, Fields& fields, std::vector<std::string>& texts) {
        if (!split(line.text, delimiter_, fields) ||
            (items_.empty() && width_of(fields, delimiter_) != rules_.inputs)) {
            return std::nullopt;
        }
        std::vector<double> numbers(rules_.inputs);
        for (std::size_t i = 0; i < rules_.inputs; ++i) {
            const std::size_t at = place(i);
            if (at >= fields.size()) {
                meet("missing field");
                return std::nullopt;
            }
            const std::string text = content(fields[at], delimiter_);
            const bool has_digits = text.find_first_of("0123456789") != std::string::npos;
            const std::string number = i < rules_.kept && !rules_.has_unit ? as_number(text) : text;
            if (!read(number, numbers[i]) || (std::isinf(numbers[i]) && has_digits)) {
                return std::nullopt;
            }
            if (number != text) {
                meet("time of ISO 8601");
            }
            texts.push_back(text);
            if (has_quotes(fields[at], delimiter_)) {
                meet("quoted number");
            }
        }
        if (width_ && !rules_.ragged && width_of(fields, delimiter_) != *width_) {
            meet("row of another width");
            return std::nullopt;
        }
        return numbers;
    }

    /// The result of a row, and of its partner where there is a reference.
    Answer answer_of(std::size_t at, Fields& fields) {
        std::vector<std::string> texts;
        const Answer nothing{.numbers = {}, .notes = {}, .failed = true};
        if (wrong_keys_.contains(at)) {
            meet("failed key of the stream");
            return nothing;
        }
        auto numbers = numbers_of(lines_[at], fields, texts);
        if (!numbers) {
            return nothing;
        }
        if (reference_ != nullptr) {
            Fields other_fields;
            const auto others = reference_->numbers_of(reference_->lines_[partners_.at(at)], other_fields, texts);
            if (!others) {
                return {.numbers = {}, .notes = {}, .failed = true, .of_reference = true};
            }
            numbers->insert(numbers->end(), others->begin(), others->end());
        }
        Answer answer = rules_.calculate(*numbers, texts);
        answer.of_reference = answer.of_reference && reference_ != nullptr;
        return answer;
    }

    void write_row(const Line& line, std::size_t number) {
        const std::size_t at = number - 1;
        if (reference_ != nullptr && !partners_.contains(at) && !wrong_keys_.contains(at)) {
            meet("unpaired row of the stream");
            outcome_.unpaired[0].push_back(number);
            return;
        }
        Fields fields;
        Answer answer = answer_of(at, fields);
        if (line.end.size() != 1) {
            meet(line.end.empty() ? "last row without newline" : "CRLF");
        }
        meet(answer.failed ? "failed row under " + rules_.on_error : "row compared");
        if (reference_ != nullptr && partners_.contains(at)) {
            meet(answer.failed   ? answer.of_reference ? "failed row of the reference" : "failed row of the stream"
                 : rules_.by_key ? "pair by key"
                                 : "pair by row");
        }
        if (answer.failed) {
            outcome_.failed.push_back({answer.of_reference ? partners_.at(at) + 1 : number, answer.of_reference});
            outcome_.to_the_end = !stops();
        } else {
            ++outcome_.answered;
        }
        if (!answer.failed || (rules_.on_error == "nan" && rules_.format != "result")) {
            write_answer(line, number, fields, answer);
        }
        if (partners_.contains(at)) {
            settled_bytes_ = outcome_.bytes.size();
            settled_failures_ = outcome_.failed.size();
        }
    }

    void write_answer(const Line& line, std::size_t number, const Fields& fields, Answer& answer) {
        if (answer.failed) {
            const std::size_t notes = rules_.diagnostic_columns ? 1 : 0;
            answer = Answer{std::vector<double>(rules_.names.size() - notes, std::numeric_limits<double>::quiet_NaN()),
                            "error"};
        }
        if (rules_.format == "result") {
            for (const double value : answer.numbers) {
                outcome_.bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
            }
            return;
        }
        if (rules_.format == "json") {
            auto& values = outcome_.others.emplace_back();
            for (const std::size_t i : others(fields.size())) {
                const std::string written(trim(fields[i]));
                const std::string text = unquoted(fields[i], delimiter_);
                const bool plain =
                    std::ranges::all_of(text, [](char c) { return c >= ' ' && c != '"' && c != '\\' && c != '\x7f'; });
                values.push_back(is_json_number(written) ? written : plain ? '"' + text + '"' : "");
            }
            return;
        }
        const std::string result = text_of(answer) + partner_of(number - 1);
        outcome_.bytes += rules_.append ? std::string(without_last_blanks(line.text, delimiter_)) + delimiter_ + result
                                        : in_place(fields, result, delimiter_);
        outcome_.bytes += line.end.empty() ? line_end_ : line.end;
    }

    [[nodiscard]] bool writes_partners() const { return rules_.by_key && rules_.format == "csv"; }

    [[nodiscard]] std::vector<std::string> result_names() const {
        auto names = rules_.names;
        if (writes_partners()) {
            names.insert(names.end(), {"reference_line", "reference_key", "key_difference"});
        }
        return names;
    }

    /// What follows the result of a row: the line and key of its partner, and the difference of their keys.
    [[nodiscard]] std::string partner_of(std::size_t at) const {
        if (!writes_partners()) {
            return {};
        }
        std::vector<std::string> texts(3, "nan");
        if (partners_.contains(at)) {
            const std::size_t other = partners_.at(at);
            Fields fields;
            split(reference_->lines_[other].text, reference_->delimiter_, fields);
            texts = {std::to_string(other + 1), content(fields[reference_->positions_[0]], reference_->delimiter_),
                     decimal_text_of(Key(keys_.at(at) - reference_->keys_.at(other)))};
        }
        return delimiter_ + joined(texts, delimiter_);
    }

    [[nodiscard]] std::string text_of(const Answer& answer) const {
        std::vector<std::string> texts;
        for (const double value : answer.numbers) {
            const double shown = std::isnan(value) ? std::abs(value) : value;
            std::string text = rules_.decimals >= 0    ? fmt::format("{:.{}f}", shown, rules_.decimals)
                               : rules_.precision == 0 ? fmt::format("{}", shown)
                                                       : fmt::format("{:.{}g}", shown, rules_.precision);
            const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
            texts.push_back(is_zero && text.starts_with('-') ? text.substr(1) : text);
        }
        if (rules_.diagnostic_columns) {
            texts.push_back(answer.notes.empty() && delimiter_ == ' ' ? "-" : answer.notes);
        }
        return joined(texts, delimiter_);
    }

    const Rules& rules_;
    std::vector<Item> items_;
    bool by_name_ = false;
    bool ambiguous_ = false;
    bool is_unsure_ = false;             ///< blanks, and commas as well, part the names of the header
    std::vector<std::size_t> positions_; ///< selected, in the order of the numbers
    std::vector<Line> lines_;
    std::size_t first_data_ = 0;
    std::optional<std::size_t> header_;
    std::string header_text_;
    std::vector<std::string> header_names_;
    std::size_t name_count_ = 0;       ///< of them, without empty ones at the end
    bool refused_ = false;             ///< for the order of those names
    std::optional<std::size_t> width_; ///< under --columns, of the first row whose selected fields are numbers
    char delimiter_ = ',';
    std::string_view line_end_ = "\n";
    Outcome outcome_;

    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::size_t refused_row_ = none; ///< whose fields are not as many as the names
    Model* reference_ = nullptr;
    std::map<std::size_t, std::size_t> partners_; ///< of each paired line that of the reference
    std::set<std::size_t> wrong_keys_;            ///< lines
    std::map<std::size_t, Key> keys_;             ///< of the other lines
    std::size_t next_wrong_key_ = none;           ///< of those not yet told of
    std::size_t settled_bytes_ = 0;               ///< of all lines up to the header or the last pair...
    std::size_t settled_failures_ = 0;            ///< ...and likewise
};

/// A flat object's keys and values, as they are written; false where the text is none.
bool read_object(std::string_view text, std::vector<std::pair<std::string, std::string>>& members) {
    static const std::string_view parts = "{:,}";
    std::vector<std::string> words{""};
    bool quoted = false;
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (text[i] == '"') {
            quoted = !quoted;
        } else if (!quoted && parts.find(text[i]) != std::string_view::npos) {
            words.emplace_back();
            continue;
        }
        const bool escapes = quoted && text[i] == '\\';
        if (quoted || text[i] != ' ') {
            words.back() += text.substr(i, escapes ? 2 : 1);
        }
        i += escapes ? 1 : 0;
    }
    for (std::size_t i = 0; i + 2 < words.size(); i += 2) {
        members.emplace_back(words[i], words[i + 1]);
    }
    return text.starts_with('{') && text.ends_with('}') && !quoted && words.size() % 2 == 1;
}

} // namespace

std::optional<Outcome> model(std::string_view text, const Rules& rules) { return Model(rules)(text); }

std::optional<Outcome> model(std::string_view text, std::string_view reference, const Rules& rules) {
    Model other(*rules.reference);
    return Model(rules)(text, other, reference);
}

bool json_agrees(std::string_view json, const Outcome& outcome, const Rules& rules) {
    for (const auto& others : outcome.others) {
        const std::size_t end = json.find('\n');
        std::vector<std::pair<std::string, std::string>> members;
        if (end == std::string_view::npos || !read_object(json.substr(0, end), members) ||
            members.size() != others.size() + rules.names.size()) {
            return false;
        }
        json.remove_prefix(end + 1);
        std::set<std::string> keys;
        for (std::size_t i = 0; i < members.size(); ++i) {
            const auto& [key, value] = members[i];
            keys.insert(key);
            const bool agrees = i >= others.size() ? key == '"' + rules.names[i - others.size()] + '"'
                                                   : others[i].empty() || value == others[i];
            if (!agrees) {
                return false;
            }
        }
        if (keys.size() != members.size()) {
            return false;
        }
    }
    return json.empty();
}

} // namespace fuzz
