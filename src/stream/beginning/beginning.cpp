#include "beginning.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "../../core/text.hpp"
#include "../numbers/number_text.hpp"
#include "../pairs/key.hpp"

namespace rotconv::stream {
namespace {

using Positions = std::vector<std::size_t>;
using Lookup = std::variant<Positions, ColumnError>;

/// Whether a text is a word for a missing number, in any case.
bool is_missing(std::string_view text) {
    constexpr std::array<std::string_view, 9> words{"", "na", "n/a", "null", "none", "nil", "-", "?", "."};
    return std::ranges::count(words, lower(text)) != 0;
}

bool may_be_number(std::string_view text) { return is_number(text) || is_missing(text); }

/// Whether a text begins an object with keys, or an array of objects or of numbers between commas; "[INFO]" and a
/// matrix of NumPy do not.
bool begins_json(std::string_view text) noexcept {
    if (!text.starts_with('{') && !text.starts_with('[')) {
        return false;
    }
    const std::string_view inside = trimmed(text.substr(std::min(text.find_first_not_of("{[ \t"), text.size())));
    const std::size_t end = std::min(inside.find_first_not_of("0123456789+-.eE"), inside.size());
    const std::string_view after = trimmed(inside.substr(end));
    return after.empty() || (end == 0 ? after.front() == '"' : text.starts_with('[') && after.front() == ',') ||
           after.front() == ']' || after.front() == '}';
}

/// Whether a text has as many brackets that open as that close.
bool is_closed(std::string_view text) noexcept {
    return std::ranges::count(text, '[') + std::ranges::count(text, '{') ==
           std::ranges::count(text, ']') + std::ranges::count(text, '}');
}

/// Whether a text is one word, perhaps with a unit in brackets behind it.
bool is_word(std::string_view text) noexcept {
    if (text.ends_with(']') || text.ends_with(')')) {
        text = trimmed(text.substr(0, std::min(text.find_last_of("[("), text.size())));
    }
    return !text.empty() && text.find_first_of(" \t") == std::string_view::npos && !is_number(text);
}

/// A line in fields, as it parts them itself.
struct Fields : HeaderLine {
    Fields(const Line& line_, std::size_t index_, const InputOptions& options)
        : HeaderLine(line_, options.delimiter.value_or(Delimiter::of_row(line_.text))), index(index_),
          is_comment(options.is_comment(line_.text)) {}
    std::size_t index; ///< of the line
    bool is_comment;

    [[nodiscard]] HeaderLine as_header() const {
        const HeaderLine& own = *this;
        return begins_with_mark() ? without_mark() : own;
    }
    [[nodiscard]] std::string_view text(std::size_t at) const { return delimiter.text_of(fields[at]); }
};

/// Whether a field of a line is a number, perhaps with a name before it.
bool holds_number(const HeaderLine& line) {
    return std::ranges::any_of(line.fields, [&line](std::string_view field) {
        const std::string_view text = line.delimiter.text_of(field);
        return is_number(text.substr(text.find_last_of(" \t:=") + 1));
    });
}

/// Lines from the last to the first. (clang 14 does not take std::views::reverse of this library.)
struct Backwards {
    std::span<const Fields> lines;

    [[nodiscard]] auto begin() const { return lines.rbegin(); }
    [[nodiscard]] auto end() const { return lines.rend(); }
};

/// The decision on one list of lines.
class Decision {
public:
    Decision(std::span<const Line> lines, const InputOptions& options, bool is_end)
        : options_(options), is_end_(is_end) {
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (!is_blank(lines[i].text)) {
                all_.emplace_back(lines[i], i, options);
            }
        }
        const auto is_first = [](const Fields& each) { return !each.is_comment; };
        first_ = static_cast<std::size_t>(std::ranges::find_if(all_, is_first) - all_.begin());
    }

    [[nodiscard]] std::optional<Beginning> operator()() const {
        if (first_ == all_.size()) {
            return is_end_ && by_name() && may_have_header() ? of_comments() : std::nullopt;
        }
        const Fields& last = all_.back();
        if (begins_with_json()) {
            const bool is_over = is_end_ || (first_ + 1 < all_.size() && is_closed(all_[first_].line.text));
            return is_over ? std::optional(error({.what = StreamError::What::json}, all_[first_])) : std::nullopt;
        }
        const bool is_above = options_.header == HeaderMode::yes && !is_row_of_no_header(last);
        if (auto found = last.is_comment || is_above ? std::nullopt : selection(last)) {
            return found->error ? std::optional(*found) : with_row(std::move(*found), last);
        }
        return is_end_ || (options_.stops && !may_have_header()) ? without_row() : std::nullopt;
    }

private:
    [[nodiscard]] std::size_t count() const noexcept { return options_.numbers.names.size(); }
    [[nodiscard]] bool is_automatic() const noexcept { return options_.header == HeaderMode::automatic; }
    [[nodiscard]] bool by_name() const noexcept { return options_.columns.has_names(); }
    [[nodiscard]] bool may_have_header() const noexcept { return is_automatic() || options_.header == HeaderMode::yes; }
    [[nodiscard]] std::span<const Fields> above(const Fields& row) const {
        return std::span(all_).first(static_cast<std::size_t>(&row - all_.data()));
    }

    static Beginning error(StreamError error, const Fields& line) {
        return {.rows = line.index + 1, .error = std::move(error), .error_line = line.line};
    }

    /// Whether the first line begins JSON and cannot be converted.
    [[nodiscard]] bool begins_with_json() const {
        const Fields& row = all_[first_];
        return options_.stops && is_automatic() && begins_json(trimmed(row.line.text)) &&
               (by_name() || !is_numeric(row, options_.columns.positions()));
    }

    /// Under --header yes, the first line is the header, unless it is numeric and a comment above it may be.
    [[nodiscard]] bool is_row_of_no_header(const Fields& row) const {
        return &row != &all_[first_] ||
               (!by_name() && is_numeric(row, options_.columns.positions()) && comment_above(row, false) != nullptr);
    }

    [[nodiscard]] bool has_width(const Fields& row) const {
        const FieldCount width = row.width();
        return count() == 0 || width.all == count() || width.filled == count();
    }

    /// Whether the fields at these positions, or all, are numbers or stand for missing ones, at least one a number.
    [[nodiscard]] bool is_numeric(const Fields& row, const Positions& positions) const {
        const std::size_t size = !positions.empty() ? positions.size() : count() > 0 ? count() : row.width().filled;
        std::size_t numbers = 0;
        if (!row.is_closed || (positions.empty() && !has_width(row))) {
            return false;
        }
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t at = positions.empty() ? i : positions[i];
            const std::string_view text = at < row.fields.size() ? row.text(at) : " ";
            const bool is_time = i < options_.numbers.kept && read_key(text).error != KeyError::not_a_number;
            numbers += is_number(text) || is_time ? 1 : 0;
            if (!is_number(text) && !is_time && !(at < row.fields.size() && is_missing(text))) {
                return false;
            }
        }
        return numbers > 0;
    }

    /// The line as a header of the row, in all ways in which it has the row's width; without a row, in its own ways. In
    /// a comment commas may part names where blanks part the row.
    [[nodiscard]] std::vector<HeaderLine> headers_of(const Fields& line, const Fields* row) const {
        std::vector<HeaderLine> made;
        const auto add = [&](Delimiter delimiter) {
            const HeaderLine header(line.line, delimiter, options_.comment);
            made.push_back(header);
            if (HeaderLine without = header.without_mark(); without.prefix.size() > header.prefix.size()) {
                made.insert(made.end() - (header.begins_with_mark() ? 1 : 0), std::move(without));
            }
        };
        if (line.is_comment && row != nullptr && row->delimiter.is_blanks()) {
            add(Delimiter::character(','));
        }
        add(line.is_comment && row != nullptr ? row->delimiter : line.delimiter);
        std::erase_if(made, [&](const HeaderLine& each) {
            return !each.is_closed || each.is_remark(true) || (row != nullptr && !each.width().fits(row->width()));
        });
        return made;
    }

    /// The line as a header that has names of all numbers, and where these say that the numbers are.
    [[nodiscard]] std::optional<HeaderLine> header_with_set(const Fields& line, const Fields* row,
                                                            ChosenColumns* chosen = nullptr) const {
        const auto words = std::ranges::ssize(line.fields) - std::ranges::count_if(line.fields, is_number);
        const bool may_be_header =
            options_.columns_of && (line.is_comment || words >= static_cast<std::ptrdiff_t>(count()));
        for (const HeaderLine& header : may_be_header ? headers_of(line, row) : std::vector<HeaderLine>()) {
            ChosenColumns found = options_.columns_of(header.names());
            if (found.are_known) {
                if (chosen != nullptr) {
                    *chosen = std::move(found);
                }
                return header;
            }
        }
        return std::nullopt;
    }

    /// Whether there is a line above, no comment, that has all names, but not as many fields as the row.
    [[nodiscard]] bool is_below_other_names(const Fields& row) const {
        return std::ranges::any_of(above(row), [&](const Fields& each) {
            if (each.is_comment || !is_automatic() || each.delimiter.text() != row.delimiter.text()) {
                return false;
            }
            const auto header = header_with_set(each, nullptr);
            return header && !header->width().fits(row.width());
        });
    }

    /// Where the numbers of a row are, if it is numeric: `positions`, `choice`, and the header that says it; or an
    /// error.
    [[nodiscard]] std::optional<Beginning> selection(const Fields& row) const {
        if (by_name()) {
            for (const Fields& line : Backwards{above(row)}) {
                auto made = named(line, row);
                if (made &&
                    (made->error || (made->header->width().fits(row.width()) && is_numeric(row, made->positions)))) {
                    return made;
                }
            }
            return std::nullopt;
        }
        const Beginning made{.positions = options_.columns.positions()};
        if (!options_.columns.empty() || (has_width(row) && !options_.are_chosen)) {
            return is_numeric(row, made.positions) && !is_below_other_names(row) ? std::optional(made) : std::nullopt;
        }
        return chosen(row);
    }

    /// The same for a row of more fields than numbers, of which nobody has selected any.
    [[nodiscard]] std::optional<Beginning> chosen(const Fields& row) const {
        const auto numbers = std::ranges::count_if(row.fields, is_number);
        if (!options_.columns_of || numbers == 0 || is_below_other_names(row)) {
            return std::nullopt;
        }
        Beginning made;
        ChosenColumns found;
        for (std::size_t i = above(row).size(); may_have_header() && !made.header && i-- > 0;) {
            made.header = header_with_set(all_[i], &row, &found);
            if (made.header && !found.text.empty() && found.positions.empty()) { // there are several
                return error({.what = StreamError::What::count,
                              .column = {.text = std::string(all_[i].line.text)},
                              .wrong = found.text},
                             all_[i]);
            }
        }
        if (!made.header) {
            found = options_.project_columns ? options_.project_columns(row.width().filled) : ChosenColumns();
        }
        if (found.positions.empty() || !is_numeric(row, found.positions)) {
            return std::nullopt;
        }
        made.positions = std::move(found.positions);
        made.choice = Note{.kind = Note::Kind::columns, .text = std::move(found.text)};
        return made;
    }

    /// What the lines are, now that the last is the first numeric one.
    [[nodiscard]] Beginning with_row(Beginning made, const Fields& row) const {
        made.row = row;
        if (!made.header && may_have_header()) {
            made.header = header_of(row, made.positions);
        }
        if (made.header) {
            after_header(made);
            return made;
        }
        const auto is_row = [&row](const HeaderLine& each) {
            return each.width().fits(row.width()) && holds_number(each);
        };
        const auto is_error = [&](const Fields& each) {
            return !each.is_comment && (options_.header != HeaderMode::automatic || is_row(each) ||
                                        is_row(HeaderLine(each.line, row.delimiter)) ||
                                        std::ranges::all_of(each.fields, [&each](auto field) {
                                            return may_be_number(each.delimiter.text_of(field));
                                        }));
        };
        made.rows = std::ranges::find_if(all_, is_error)->index;
        return made;
    }

    /// The header above the first row.
    [[nodiscard]] std::optional<HeaderLine> header_of(const Fields& row, const Positions& positions) const {
        if (options_.header == HeaderMode::yes) {
            if (&row == &all_[first_]) {
                const Fields* const comment = comment_above(row, false);
                return comment == nullptr ? std::nullopt : std::optional(headers_of(*comment, &row).front());
            }
            return all_[first_].as_header();
        }
        for (const Fields& line : Backwards{above(row)}) {
            if (auto header = header_with_set(line, &row)) {
                return header;
            }
        }
        if (const Fields* const comment = comment_above(row, true)) {
            return headers_of(*comment, &row).front();
        }
        for (const Fields& line : Backwards{above(row)}) {
            if (line.is_comment || is_units(line) || is_row(line, row, positions)) {
                continue;
            }
            const bool has_mark = line.line.text.starts_with("//") || line.line.text.starts_with('%');
            const bool is_header = line.is_closed && line.width().fits(row.width()) &&
                                   line.delimiter.text() == row.delimiter.text() && !has_mark && !line.is_remark();
            return is_header ? std::optional(line.as_header()) : std::nullopt;
        }
        return std::nullopt;
    }

    /// The last comment of the row's width: with `has_words` one that is parted by commas, each part one word and its
    /// unit.
    [[nodiscard]] const Fields* comment_above(const Fields& row, bool has_words) const {
        for (const Fields& line : Backwards{above(row)}) {
            const auto headers = line.is_comment ? headers_of(line, &row) : std::vector<HeaderLine>();
            if (headers.empty()) {
                continue;
            }
            const auto names = headers.front().names_at({}).value();
            if (!has_words || (headers.front().delimiter.text() == ',' && !headers.front().is_remark() &&
                               std::ranges::all_of(names, is_word))) {
                return &line;
            }
        }
        return nullptr;
    }

    /// Whether a line above the first row would be a row, of its width and with a number where numbers are.
    [[nodiscard]] static bool is_row(const Fields& line, const Fields& row, const Positions& positions) {
        if (!line.width().fits(row.width())) {
            return false;
        }
        const std::size_t size = positions.empty() ? line.fields.size() : positions.size();
        bool is = is_number(line.text(0));
        for (std::size_t i = 0; i < size && !is; ++i) {
            const std::size_t at = positions.empty() ? i : positions[i];
            is = at < line.fields.size() && may_be_number(line.text(at));
        }
        return is;
    }

    /// Whether each field is a unit, in brackets or not, or none, and at least one is.
    [[nodiscard]] bool is_units(const Fields& line) const {
        std::size_t units = 0;
        for (std::size_t i = 0; i < line.fields.size(); ++i) {
            const std::string_view text = line.text(i);
            const bool is_unit = options_.is_unit != nullptr && options_.is_unit(text);
            units += is_unit && !is_number(text) ? 1 : 0; // 1 of no dimension
            if (!is_unit && !text.empty() && text != "-" && text != "[]" && text != "[-]") {
                return false;
            }
        }
        return units > 0;
    }

    /// Sets where rows begin below the header: a line of units next to it is none.
    void after_header(Beginning& made) const {
        const auto at = std::ranges::find_if(
            all_, [&made](const Fields& each) { return each.line.text.data() == made.header->line.text.data(); });
        made.rows = at->index + 1;
        const auto next = std::find_if(at + 1, all_.end(), [](const Fields& each) { return !each.is_comment; });
        if (next != all_.end() && is_units(*next) && next->width().fits(made.header->width())) {
            made.units = *next;
            made.rows = next->index + 1;
        }
    }

    /// What the lines are if none is numeric.
    [[nodiscard]] std::optional<Beginning> without_row() const {
        Beginning made;
        for (std::size_t i = all_.size(); i-- > 0 && may_have_header() && !made.header;) {
            if (by_name()) {
                made = named(all_[i], all_[first_]).value_or(Beginning());
                if (made.error) {
                    return made;
                }
            } else {
                ChosenColumns found;
                made.header = header_with_set(all_[i], nullptr, &found);
                if (made.header && options_.columns.empty() && (options_.are_chosen || !has_width(all_[i]))) {
                    made.positions = std::move(found.positions);
                    made.header = made.positions.empty() ? std::nullopt : std::move(made.header);
                }
            }
        }
        if (!made.header && options_.header == HeaderMode::yes) {
            made.header = all_[first_].as_header();
        }
        const bool is_below_rows = made.header && made.header->line.text.data() > all_[first_].line.text.data();
        if (!made.header || is_below_rows) { // a line above a header without rows is a row
            if (by_name()) {
                return lacking();
            }
            made.header.reset();
            made.rows = all_[first_].index;
            made.row = all_[first_];
            return options_.columns.empty() && (may_have_header() || options_.are_chosen) ? too_wide().value_or(made)
                                                                                          : made;
        }
        after_header(made);
        for (const Fields& each : all_) {
            if (each.index >= made.rows && !each.is_comment) {
                const FieldCount names = made.header->width();
                if (!made.row && holds_number(each) && !names.fits(each.width()) &&
                    each.delimiter.text() == made.header->delimiter.text() && !made.positions.empty()) {
                    return Decision::error({.what = StreamError::What::columns,
                                            .column = {.what = ColumnError::What::other_width,
                                                       .text = std::string(each.line.text),
                                                       .count = names.all,
                                                       .fields = each.width().all}},
                                           each);
                }
                made.row = made.row ? made.row : each;
            }
        }
        return made;
    }

    /// Comments alone: one of them may have the names.
    [[nodiscard]] std::optional<Beginning> of_comments() const {
        for (const Fields& line : Backwards{all_}) {
            if (auto made = named(line, line); made && !made->error) {
                made->rows = line.index + 1;
                return made;
            }
        }
        return std::nullopt;
    }

    /// The error about rows of more fields than numbers, of which nothing says where these are.
    [[nodiscard]] std::optional<Beginning> too_wide() const {
        const std::size_t wanted = count() - (options_.are_chosen ? 1 : 0);
        const auto is_wide = [this, wanted](const Fields& each) {
            const auto numbers = static_cast<std::size_t>(std::ranges::count_if(each.fields, is_number));
            return !each.is_comment && numbers >= wanted && (each.fields.size() > wanted || options_.are_chosen);
        };
        auto found = options_.columns_of && count() > 0 ? std::ranges::find_if(all_, is_wide) : all_.end();
        if (found == all_.end() && !options_.are_chosen) {
            return std::nullopt;
        }
        const Fields& row = found == all_.end() ? all_[first_] : *found;
        const auto lines = above(row);
        const auto names = lines.empty() ? std::vector<std::string>() : lines.back().names();
        const bool are_names = names.size() == row.fields.size() && std::ranges::none_of(names, is_number);
        return error({.what = StreamError::What::columns,
                      .column = {.what = ColumnError::What::none,
                                 .text = std::string(row.line.text),
                                 .fields = row.width().all,
                                 .wanted = wanted,
                                 .header = are_names ? names : std::vector<std::string>()}},
                     row);
    }

    /// Whether no name is missing, whatever else is wrong with them.
    static bool has_all(const Lookup& found) noexcept {
        const auto* error = std::get_if<ColumnError>(&found);
        return error == nullptr || error->what != ColumnError::What::missing;
    }

    /// Looks the names up with each delimiter until all are found, in a comment with that of the row if it shows one,
    /// so that prose is not taken for names; but commas may part them where blanks part the row. A mark before the
    /// first name is left out if they are not found with it.
    [[nodiscard]] std::pair<HeaderLine, Lookup> find_names(const Fields& line, const Fields& row) const {
        const bool shows_delimiter = line.is_comment && &row != &line && row.fields.size() > 1;
        const auto delimiter = shows_delimiter ? std::optional(row.delimiter) : options_.delimiter;
        const std::string_view text = line.line.text.substr(line.is_comment ? options_.comment.size() : 0);
        std::vector<Delimiter> tried{delimiter.value_or(Delimiter::blanks())};
        if (delimiter && delimiter->is_blanks() && line.is_comment) {
            tried.insert(tried.begin(), Delimiter::character(','));
        }
        for (const char c : {';', '\t', ','}) {
            if (!delimiter && text.find(c) != std::string_view::npos) {
                tried.push_back(Delimiter::character(c));
            }
        }
        for (;; tried.pop_back()) {
            const HeaderLine header(line.line, tried.back(), options_.comment);
            const bool has_mark = header.begins_with_mark();
            for (const bool is_without : {has_mark, !has_mark}) {
                HeaderLine each = is_without ? header.without_mark() : header;
                auto found =
                    options_.columns.positions(each.is_remark(true) ? std::vector<std::string>() : each.names());
                if (has_all(found) || (tried.size() == 1 && is_without != has_mark)) {
                    return {std::move(each), std::move(found)};
                }
            }
        }
    }

    /// The line as a header that has the selected names, and where they are; or an error, if these are not clear.
    [[nodiscard]] std::optional<Beginning> named(const Fields& line, const Fields& row) const {
        auto [header, found] = find_names(line, row);
        if (!has_all(found)) {
            return std::nullopt;
        }
        if (const auto* wrong = std::get_if<ColumnError>(&found)) {
            return error({.what = StreamError::What::columns, .column = *wrong}, line);
        }
        return Beginning{.header = std::move(header), .positions = std::get<Positions>(std::move(found))};
    }

    /// What a line lacks of the selected names; a comment is parted as the rows are.
    [[nodiscard]] ColumnError lacked(const Fields& line) const {
        const HeaderLine header(line.line, (line.is_comment ? all_[first_] : line).delimiter, options_.comment);
        const bool has_names = header.is_closed && !header.is_remark(true);
        auto found = options_.columns.positions(has_names ? header.names() : std::vector<std::string>());
        if (!std::holds_alternative<ColumnError>(found)) {
            return {};
        }
        auto column = std::get<ColumnError>(std::move(found));
        column.text = line.line.text;
        if (has_names && std::ranges::none_of(header.names(), is_number)) {
            column.header = header.names();
        }
        return column;
    }

    /// The error about the line that has most of the selected names.
    [[nodiscard]] Beginning lacking() const {
        const auto present = [this](const Fields& each) { return lacked(each).present.size(); };
        const auto best = std::ranges::max_element(all_, {}, present);
        const Fields& line = present(*best) > 0 ? *best : all_[first_];
        return error({.what = StreamError::What::columns, .column = lacked(line)}, line);
    }

    const InputOptions& options_;
    bool is_end_;
    std::vector<Fields> all_; ///< the lines that are not blank
    std::size_t first_ = 0;   ///< the first of them that is no comment
};

} // namespace

std::optional<Beginning> decide(std::span<const Line> lines, const InputOptions& options, bool is_end) {
    return Decision(lines, options, is_end)();
}

} // namespace rotconv::stream
