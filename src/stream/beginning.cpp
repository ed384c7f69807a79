#include "beginning.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "../core/text.hpp"
#include "number_text.hpp"

namespace rotconv::stream {
namespace {

using Lookup = std::variant<std::vector<std::size_t>, ColumnError>;

/// Whether a text is a word for a missing number, in any case.
bool is_missing(std::string_view text) {
    constexpr std::array<std::string_view, 9> words{"", "na", "n/a", "null", "none", "nil", "-", "?", "."};
    return std::ranges::count(words, lower(text)) != 0;
}

/// Whether a text is a number with a comma for its point.
bool has_decimal_comma(std::string text) noexcept {
    const auto comma = text.find(',');
    if (comma == std::string::npos) {
        return false;
    }
    text[comma] = '.';
    return is_number(text);
}

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

/// The decision on one list of lines.
class Decision {
public:
    Decision(std::span<const Line> lines, const InputOptions& options) : lines_(lines), options_(options) {}

    /// The last line is the header where it is_header(), or where the options want one. Otherwise, or where a wanted
    /// one has numbers for names, the last comment before it is, if it may be one: see comment_of().
    [[nodiscard]] Beginning by_index() const {
        const Line& row = lines_.back();
        if (is_json(row)) {
            return error({.what = StreamError::What::json}, row);
        }
        HeaderLine fields(row, delimiter_of(row.text));
        const bool is_wanted = options_.header == HeaderMode::yes;
        const bool looks_like_one = is_header(fields);
        if (is_wanted ? are_numbers(fields) : !looks_like_one) {
            if (auto comment = comment_of(fields)) {
                return {.header = std::move(comment), .is_data = true};
            }
        }
        if (is_wanted || looks_like_one) {
            return {.header = fields.begins_with_mark() ? fields.without_mark() : fields};
        }
        return {.is_data = true};
    }

    /// The header is the last line that has all names. The last line itself may be the header with `is_end`, and is
    /// otherwise the first data row.
    [[nodiscard]] std::optional<Beginning> by_name(bool is_end) const {
        const Line& row = lines_.back();
        std::optional<Delimiter> delimiter;
        if (!is_end) {
            if (has_all(find_names(row, {}).second)) {
                return std::nullopt;
            }
            const Delimiter own = delimiter_of(row.text);
            if (HeaderLine(row, own).fields.size() > 1) { // otherwise it does not show the delimiter
                delimiter = own;
            }
        }
        for (std::size_t i = lines_.size() - (is_end ? 0 : 1); i-- > 0;) {
            const Line& line = lines_[i];
            // A comment is split by the delimiter of the data, so that prose is not taken for names.
            auto [header, found] = find_names(line, options_.is_comment(line.text) ? delimiter : std::nullopt);
            if (const auto* positions = std::get_if<std::vector<std::size_t>>(&found)) {
                return Beginning{.header = std::move(header), .is_data = !is_end, .positions = *positions};
            }
            if (has_all(found)) {
                return error({.what = StreamError::What::columns, .column = std::get<ColumnError>(found)}, line,
                             is_end);
            }
        }
        if (is_end) {
            return std::nullopt;
        }
        return is_json(row) ? error({.what = StreamError::What::json}, row) : lacking(row);
    }

private:
    static Beginning error(StreamError error, const Line& line, bool is_end = false) {
        return {.is_data = !is_end, .error = std::move(error), .error_line = line};
    }

    [[nodiscard]] Delimiter delimiter_of(std::string_view row) const noexcept {
        return options_.delimiter.value_or(Delimiter::of_row(row));
    }

    /// Whether no name is missing, whatever else is wrong with them.
    static bool has_all(const Lookup& found) noexcept {
        const auto* error = std::get_if<ColumnError>(&found);
        return error == nullptr || error->what != ColumnError::What::missing;
    }

    [[nodiscard]] std::size_t count() const noexcept { return options_.numbers.names.size(); }

    /// The texts of the selected fields; nothing if a field is missing.
    [[nodiscard]] std::optional<std::vector<std::string>> selected(const HeaderLine& header) const {
        auto texts = header.names_at(options_.columns.positions());
        const bool are_all = !options_.columns.empty() || count() == 0 || texts->size() == count();
        return are_all ? texts : std::nullopt;
    }

    [[nodiscard]] bool are_numbers(const HeaderLine& row) const {
        const auto texts = selected(row);
        return texts && std::ranges::all_of(*texts, is_number);
    }

    /// Whether none of the selected fields is a number or stands for one, and the line is not a remark.
    [[nodiscard]] bool is_header(const HeaderLine& header) const {
        const auto texts = selected(header);
        const std::string_view text = header.prefix.empty() ? header.line.text : "";
        const bool has_mark = text.starts_with("//") || text.starts_with('%'); // a remark, unless it has the names
        return header.is_closed && texts && !has_mark && !header.is_remark() &&
               std::ranges::none_of(*texts, [](const auto& name) {
                   return is_number(name) || is_missing(name) || has_decimal_comma(name);
               });
    }

    /// Whether the row begins JSON and cannot be converted.
    [[nodiscard]] bool is_json(const Line& row) const {
        if (!begins_json(trimmed(row.text)) || !options_.refuses_json || options_.header != HeaderMode::automatic) {
            return false;
        }
        return options_.columns.has_names() || !are_numbers(HeaderLine(row, delimiter_of(row.text)));
    }

    /// The last comment, or an empty line, split as the row is. If blanks part the row, it is split at its commas if
    /// that gives as many fields.
    [[nodiscard]] HeaderLine above(const HeaderLine& row) const {
        const auto found = std::find_if(lines_.rbegin(), lines_.rend(),
                                        [this](const Line& line) { return options_.is_comment(line.text); });
        const Line comment = found == lines_.rend() ? Line{} : *found;
        HeaderLine with_commas(comment, Delimiter::character(','), options_.comment);
        return row.delimiter.is_blanks() && with_commas.width().fits(row.width())
                   ? with_commas
                   : HeaderLine(comment, row.delimiter, options_.comment);
    }

    /// The last comment, if it is the header of the row; with HeaderMode::yes an equal number of fields is enough.
    [[nodiscard]] std::optional<HeaderLine> comment_of(const HeaderLine& row) const {
        HeaderLine header = above(row);
        const auto names = selected(header);
        if (header.line.text.empty() || !header.is_closed || !header.width().fits(row.width()) || !names) {
            return std::nullopt;
        }
        if (options_.header == HeaderMode::yes) {
            return header;
        }
        if (header.is_remark() || std::ranges::any_of(header.names(), is_number)) {
            return std::nullopt;
        }
        if (row.delimiter.is_blanks() && count() > 0) { // a remark may have as many words
            if (!options_.order_of || !options_.order_of(*names).are_known) {
                return std::nullopt;
            }
        }
        return header;
    }

    /// Looks the names up with each delimiter, or the given one, until all are found. In a comment commas may part them
    /// although blanks part the rows. A mark before the first name is left out if they are not found with it.
    [[nodiscard]] std::pair<HeaderLine, Lookup> find_names(const Line& line, std::optional<Delimiter> delimiter) const {
        if (!delimiter) {
            delimiter = options_.delimiter;
        }
        const bool is_comment = options_.is_comment(line.text);
        const std::string_view text = line.text.substr(is_comment ? options_.comment.size() : 0);
        std::vector<Delimiter> tried{delimiter.value_or(Delimiter::blanks())};
        if (delimiter && delimiter->is_blanks() && is_comment) {
            tried.insert(tried.begin(), Delimiter::character(','));
        }
        for (const char c : {';', '\t', ','}) {
            if (!delimiter && text.find(c) != std::string_view::npos) {
                tried.push_back(Delimiter::character(c));
            }
        }
        for (;; tried.pop_back()) {
            const HeaderLine header(line, tried.back(), options_.comment);
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

    /// The error that says which names a row has and lacks, and how the columns are called.
    [[nodiscard]] Beginning lacking(const Line& line) const {
        const HeaderLine row(line, delimiter_of(line.text));
        ColumnError column = std::get<ColumnError>(find_names(line, row.delimiter).second);
        column.text = line.text;
        const HeaderLine comment = above(row);
        for (const HeaderLine* header : {&row, &comment}) {
            if (header->is_closed && header->width().fits(row.width()) && !header->is_remark() &&
                std::ranges::none_of(header->names(), is_number)) {
                column.header = header->names();
                break;
            }
        }
        return error({.what = StreamError::What::columns, .column = std::move(column)}, line);
    }

    std::span<const Line> lines_;
    const InputOptions& options_;
};

} // namespace

std::optional<Beginning> decide(std::span<const Line> lines, const InputOptions& options, bool is_end) {
    const Decision decision(lines, options);
    if (lines.empty() || (is_end && !options.columns.has_names())) {
        return std::nullopt;
    }
    return options.columns.has_names() ? decision.by_name(is_end) : decision.by_index();
}

} // namespace rotconv::stream
