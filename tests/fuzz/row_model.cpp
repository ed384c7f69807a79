#include "row_model.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <span>

#include <boost/multiprecision/cpp_int.hpp>
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

/// Of a number without an exponent, with at most 18 digits on either side of the point; nothing for others, which are
/// not modelled.
std::optional<Key> key_of(const std::string& text) {
    constexpr std::size_t most = 18;
    const std::string magnitude = text.substr(text.starts_with('+') || text.starts_with('-') ? 1 : 0);
    const std::size_t point = std::min(magnitude.find('.'), magnitude.size());
    std::string fraction = magnitude.substr(std::min(point + 1, magnitude.size()));
    if (point > most || fraction.size() > most ||
        (magnitude.substr(0, point) + fraction).find_first_not_of("0123456789") != std::string::npos) {
        return std::nullopt;
    }
    fraction.resize(most, '0');
    const std::string digits = magnitude.substr(0, point) + fraction;
    const Key units(digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1))); // 0 would mean octal
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

/// The rule of widths: whether a row, or a header, has as many fields as the first row.
bool is_as_wide(const Width& row, const Width& first) {
    const auto is_either = [&row](std::size_t count) { return row.fields == count || row.filled == count; };
    return is_either(first.fields) || is_either(first.filled);
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
        for (std::size_t i = 0; i < lines_.size() && outcome_.to_the_end; ++i) {
            write_added_header(i);
            write_line(i);
        }
        return outcome_;
    }

    std::optional<Outcome> operator()(std::string_view text, Model& reference, std::string_view reference_text) {
        if (!begin(text) || !reference.begin(reference_text) || !pair_with(reference)) {
            return std::nullopt;
        }
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
    /// Settles where rows begin, and where the selected names stand. False where that is not modelled: headers of other
    /// names, comments above the rows, and rows that are not numeric, or have other fields than names, in the place of
    /// the first. Where the options say that all lines are rows, the first numeric one fixes delimiter and width.
    bool begin(std::string_view text) {
        if (text.starts_with("\xEF\xBB\xBF")) {
            text.remove_prefix(3);
            meet("byte order mark");
        }
        lines_ = lines_of(text, rules_.comment);
        const bool has_names = !lines_.empty() && by_name_ && find_names(lines_[0]);
        const auto is_row = [](const Line& line) { return line.row(); };
        const auto first = std::find_if(lines_.begin() + (has_names ? 1 : 0), lines_.end(), is_row);
        first_data_ = static_cast<std::size_t>(first - lines_.begin());
        if (has_names != by_name_ || first == lines_.end() || has_time(text)) {
            return false;
        }
        const bool is_told = rules_.header == "no" || rules_.header == "add";
        std::size_t first_numeric = first_data_;
        std::size_t looked_at = 0;
        while (first_numeric < lines_.size() && !(is_data(first_numeric) && is_numeric(lines_[first_numeric]))) {
            looked_at += is_data(first_numeric++) ? 1 : 0;
        }
        constexpr std::size_t few = 50; // the program looks at twice as many, but not at long ones
        const bool is_found = first_numeric < lines_.size() && looked_at < few &&
                              lines_[first_numeric].text.data() - text.data() < std::ptrdiff_t{32} * 1024;
        if (!is_found && (looked_at >= few || first_numeric < lines_.size() || !is_told)) {
            return false;
        }
        const Line& row = is_found && (!stops() || first_numeric == first_data_) ? lines_[first_numeric] : *first;
        delimiter_ = delimiter_of(row.text, rules_.delimiter);
        line_end_ = row.end.empty() ? "\n" : row.end;
        Fields fields;
        static_cast<void>(split(row.text, delimiter_, fields));
        if (!items_.empty()) {
            width_ = width_of(fields, delimiter_);
        }
        if (by_name_ && !is_as_wide(header_width_, *width_)) {
            return false;
        }
        meet(fmt::format("{} delimiter {}", rules_.delimiter.empty() ? "detected" : "given", name_of(delimiter_)));
        return is_told || (first_numeric == first_data_ && (by_name_ || rules_.header == "auto") &&
                           std::none_of(lines_.begin(), first, [](const Line& line) { return line.comment; }));
    }

    /// Whether the selected fields are numbers or words for a missing one, at least one of them a number.
    bool is_numeric(const Line& line) {
        const char delimiter = delimiter_of(line.text, rules_.delimiter);
        Fields fields;
        if (!split(line.text, delimiter, fields)) {
            return false;
        }
        const Width width = width_of(fields, delimiter);
        if (items_.empty() && width.fields != rules_.inputs && width.filled != rules_.inputs) {
            return false;
        }
        bool has_number = false;
        for (std::size_t i = 0; i < rules_.inputs; ++i) {
            const std::size_t at = place(i);
            if (at >= fields.size()) {
                return false;
            }
            std::string text = content(fields[at], delimiter);
            double value = 0.0;
            const bool is_number = read(text, value);
            std::ranges::transform(text, text.begin(),
                                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
            constexpr std::string_view missing = " na n/a null none nil - ? . ";
            if (!is_number && !text.empty() && missing.find(" " + text + " ") == std::string_view::npos) {
                return false;
            }
            has_number = has_number || is_number;
        }
        return has_number;
    }

    /// A time of ISO 8601, which is not modelled, may stand in the place of a number.
    [[nodiscard]] bool has_time(std::string_view text) const {
        const auto is_digit = [text](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
        bool found = false;
        for (std::size_t at = text.find('T'); at != std::string_view::npos; at = text.find('T', at + 1)) {
            found = found || (is_digit(at - 1) && is_digit(at + 1));
        }
        return found && rules_.kept > 0;
    }

    /// Settles positions_ and the output's header where the line has each name once.
    bool find_names(const Line& line) {
        const char delimiter = delimiter_of(line.text, rules_.delimiter);
        Fields fields;
        if (!line.row() || !split(line.text, delimiter, fields)) {
            return false;
        }
        std::vector<std::string> names;
        for (const std::string_view field : fields) {
            names.push_back(content(field, delimiter));
        }
        const auto has_word = [&line](std::string_view word) { return line.text.find(word) != std::string_view::npos; };
        if (std::isalnum(static_cast<unsigned char>(line.text[0])) == 0 || has_word("=") || has_word("FMT") ||
            has_word("COMMENT")) {
            return false; // a mark, or a remark
        }
        const auto is_value = [](const std::string& name) { // a number after a name, which is no header's
            double value = 0.0;
            return read(name.substr(name.find_last_of(" \t:") + 1), value);
        };
        if (std::ranges::any_of(names, is_value)) {
            return false;
        }
        for (std::size_t i = 0; i < items_.size(); ++i) {
            if (const std::string& name = items_[i].name; !name.empty()) {
                positions_[i] = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
                if (std::ranges::count(names, name) != 1) {
                    return false;
                }
            }
        }
        read_by_own_names();
        header_ = 0;
        header_width_ = width_of(fields, delimiter);
        const std::string result = joined(result_names(), delimiter);
        header_text_ = rules_.append ? std::string(without_last_blanks(line.text, delimiter)) + delimiter + result
                                     : in_place(fields, result, delimiter);
        header_text_ += line.end.empty() ? "\n" : line.end;
        return std::set<std::size_t>(positions_.begin(), positions_.end()).size() == positions_.size();
    }

    /// Numbers that are listed by their own names are those, in whatever order.
    void read_by_own_names() {
        const auto own = std::span(rules_.numbers).subspan(rules_.kept);
        const auto listed = [this](const std::string& name) {
            return static_cast<std::size_t>(std::ranges::find(items_, name, &Item::name) - items_.begin());
        };
        if (std::ranges::all_of(own, [&](const std::string& name) { return listed(name) < items_.size(); })) {
            const auto positions = positions_;
            for (std::size_t i = 0; i < own.size(); ++i) {
                positions_[rules_.kept + i] = positions[listed(own[i])];
            }
        }
    }

    [[nodiscard]] bool is_data(std::size_t at) const { return lines_[at].row() && at >= first_data_ && header_ != at; }
    [[nodiscard]] bool stops() const { return rules_.on_error == "stop"; }

    /// Settles partners_; false where keys are not modelled.
    bool pair_with(Model& reference) {
        reference_ = &reference;
        std::vector<std::pair<std::size_t, Key>> rows;
        std::vector<std::pair<std::size_t, Key>> others;
        if (!find_rows(rows) || !reference.find_rows(others)) {
            return false;
        }
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
            const Key within = rules_.key_within.empty() ? Key(0) : *key_of(rules_.key_within);
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
        return true;
    }

    /// The rows that may be paired, with their keys; the others come into wrong_keys_. False where a key is not
    /// modelled.
    bool find_rows(std::vector<std::pair<std::size_t, Key>>& rows) {
        for (std::size_t at = 0; at < lines_.size(); ++at) {
            if (!is_data(at)) {
                continue;
            }
            Fields fields;
            std::optional<Key> key = 0;
            if (rules_.by_key) {
                const bool closed = split(lines_[at].text, delimiter_, fields);
                double value = 0.0;
                const std::string text =
                    closed && positions_[0] < fields.size() ? content(fields[positions_[0]], delimiter_) : "";
                const bool is_number = read(text, value) && std::isfinite(value);
                key = is_number ? key_of(text) : std::nullopt;
                if (is_number && !key) {
                    return false;
                }
                if (key && !rules_.key_offset.empty()) {
                    *key += *key_of(rules_.key_offset);
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
        return true;
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
            outcome_.failed.push_back({.line = wrong + 1, .of_reference = true});
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

    void meet(std::string rule) { outcome_.met.push_back(std::move(rule)); }

    /// Of the i-th number.
    [[nodiscard]] std::size_t place(std::size_t i) const { return items_.empty() ? i : positions_[i]; }

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
        } else if (!line.row()) {
            meet(line.blank() ? "blank row" : "comment");
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
            (items_.empty() && width_of(fields, delimiter_).filled != rules_.inputs)) {
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
            outcome_.failed.push_back({.line = number, .cause = answer.of_reference ? partners_.at(at) + 1 : 0});
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
    std::vector<std::size_t> positions_; ///< selected, in the order of the numbers
    std::vector<Line> lines_;
    std::size_t first_data_ = 0;
    std::optional<std::size_t> header_;
    std::string header_text_;
    Width header_width_;
    std::optional<Width> width_; ///< of the first numeric row
    char delimiter_ = ',';
    std::string_view line_end_ = "\n";
    Outcome outcome_;

    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    Model* reference_ = nullptr;
    std::map<std::size_t, std::size_t> partners_; ///< of each paired line that of the reference
    std::set<std::size_t> wrong_keys_;            ///< lines
    std::map<std::size_t, Key> keys_;             ///< of the other lines
    std::size_t next_wrong_key_ = none;           ///< of those not yet told of
    std::size_t settled_bytes_ = 0;               ///< of all lines up to the header or the last pair...
    std::size_t settled_failures_ = 0;            ///< ...and likewise
};

} // namespace

std::optional<Outcome> model(std::string_view text, const Rules& rules) { return Model(rules)(text); }

std::optional<Outcome> model(std::string_view text, std::string_view reference, const Rules& rules) {
    Model other(*rules.reference);
    return Model(rules)(text, other, reference);
}

} // namespace fuzz
