#include "preamble.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>
#include <variant>

#include "row_writer.hpp"

namespace rotconv::stream {
namespace {

using Lookup = std::variant<std::vector<std::size_t>, ColumnError>;

/// A word for a missing number, in any case.
bool is_missing(std::string_view text) noexcept {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; };
    constexpr std::array<std::string_view, 9> words{"", "na", "n/a", "null", "none", "nil", "-", "?", "."};
    return std::ranges::any_of(words, [&](std::string_view word) { return std::ranges::equal(text, word, {}, lower); });
}

/// A number with a comma for its point.
bool has_decimal_comma(std::string text) noexcept {
    const auto comma = text.find(',');
    if (comma == std::string::npos) {
        return false;
    }
    text[comma] = '.';
    return is_number(text);
}

/// Lines of other programs that may look like a header: COMMENT, KEY = value, FMT.
bool is_remark(const HeaderLine& row) noexcept {
    const std::string_view first = row.fields.empty() ? "" : trimmed(row.fields.front());
    return first == "FMT" || first == "COMMENT" ||
           std::ranges::any_of(row.fields, [](auto field) { return trimmed(field) == "="; });
}

/// An object with keys, or an array of objects or of numbers between commas; not "[INFO]" or a matrix of NumPy.
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

/// A character of a mark before the first name. Letters beyond ASCII are not.
bool is_mark(char c) noexcept {
    return (static_cast<unsigned char>(c) & 0x80U) == 0U && (c < '0' || c > '9') && (c < 'A' || c > 'Z') &&
           (c < 'a' || c > 'z') && c != '_' && c != '"' && c != '\'';
}

/// The decision on one list of lines.
class Decision {
public:
    Decision(const std::vector<Line>& lines, const InputOptions& options) : lines_(lines), options_(options) {}

    [[nodiscard]] Beginning by_index() const {
        const Line& row = lines_.back();
        if (is_json(row)) {
            return error({.what = StreamError::What::json}, lines_.size() - 1);
        }
        HeaderLine fields(row, delimiter_of(row.text));
        const bool must_be = options_.header == HeaderMode::yes;
        const bool may_be = is_header(fields);
        if (must_be ? are_numbers(fields) : !may_be) {
            if (auto comment = comment_of(fields)) {
                return {.is_decided = true, .header = std::move(comment), .is_data = true};
            }
        }
        if (must_be || may_be) {
            return {.is_decided = true, .header = fields.begins_with_mark() ? fields.without_mark() : fields};
        }
        return {.is_decided = true, .is_data = true};
    }

    /// The header is the last line that has all names. With `is_end` the last line may be it, otherwise that is the
    /// first data row.
    [[nodiscard]] Beginning by_name(bool is_end) const {
        const Line& row = lines_.back();
        std::optional<Delimiter> delimiter;
        if (!is_end) {
            if (has_all(find_names(row, {}).second)) {
                return {};
            }
            const Delimiter own = delimiter_of(row.text);
            if (HeaderLine(row, own).fields.size() > 1) { // else it does not tell what delimits
                delimiter = own;
            }
        }
        std::optional<std::pair<HeaderLine, Lookup>> last;
        std::size_t at = 0;
        for (std::size_t i = 0; i + (is_end ? 0 : 1) < lines_.size(); ++i) {
            if (is_blank(lines_[i].text)) {
                continue;
            }
            // A comment is split by the delimiter of the data, so that prose is not taken for names.
            auto found = find_names(lines_[i], options_.is_comment(lines_[i].text) ? delimiter : std::nullopt);
            if (has_all(found.second)) {
                last = std::move(found);
                at = i;
            }
        }
        if (!last) {
            if (is_end) {
                return {};
            }
            return is_json(row) ? error({.what = StreamError::What::json}, lines_.size() - 1) : lacking(row);
        }
        auto& [header, found] = *last;
        if (const auto* ambiguous = std::get_if<ColumnError>(&found)) {
            return error({.what = StreamError::What::columns, .column = *ambiguous}, at, is_end);
        }
        return {.is_decided = true,
                .header = std::move(header),
                .is_data = !is_end,
                .positions = std::get<std::vector<std::size_t>>(std::move(found))};
    }

private:
    static Beginning error(StreamError error, std::size_t line, bool is_end = false) {
        error.line = line;
        return {.is_data = !is_end, .error = std::move(error)};
    }

    [[nodiscard]] Delimiter delimiter_of(std::string_view row) const noexcept {
        return options_.delimiter.value_or(Delimiter::of_row(row));
    }

    /// Not one of the names is missing, whatever else is wrong with them.
    static bool has_all(const Lookup& found) noexcept {
        const auto* error = std::get_if<ColumnError>(&found);
        return error == nullptr || error->what != ColumnError::What::missing;
    }

    [[nodiscard]] std::size_t count() const noexcept { return options_.numbers.names.size(); }

    /// The texts of the selected fields; nothing if one is not there.
    [[nodiscard]] std::optional<std::vector<std::string>> selected(const HeaderLine& header) const {
        if (options_.columns.empty()) {
            auto names = header.names();
            names.resize(header.width());
            return count() == 0 || names.size() == count() ? std::optional(std::move(names)) : std::nullopt;
        }
        std::vector<std::string> texts;
        for (const std::size_t position : options_.columns.positions()) {
            if (position >= header.fields.size()) {
                return std::nullopt;
            }
            texts.push_back(header.name(position));
        }
        return texts;
    }

    [[nodiscard]] bool are_numbers(const HeaderLine& row) const {
        const auto texts = selected(row);
        return texts && std::ranges::all_of(*texts, is_number);
    }

    /// None of the selected fields is a number or a word for a missing one.
    [[nodiscard]] bool is_header(const HeaderLine& header) const {
        const auto texts = selected(header);
        const std::string_view text = header.prefix.empty() ? header.line.text : "";
        const bool has_mark = text.starts_with("//") || text.starts_with('%'); // a remark, unless it has the names
        return header.is_closed && texts && !has_mark && !is_remark(header) &&
               std::ranges::none_of(*texts, [](const auto& name) {
                   return is_number(name) || is_missing(name) || has_decimal_comma(name);
               });
    }

    /// The row is the beginning of JSON, and nothing that can be converted.
    [[nodiscard]] bool is_json(const Line& row) const {
        if (!begins_json(trimmed(row.text)) || !options_.refuses_json || options_.header != HeaderMode::automatic) {
            return false;
        }
        return options_.columns.has_names() || !are_numbers(HeaderLine(row, delimiter_of(row.text)));
    }

    /// The last comment; an empty line where there is none.
    [[nodiscard]] Line last_comment() const {
        const auto found = std::find_if(lines_.rbegin(), lines_.rend(),
                                        [this](const Line& line) { return options_.is_comment(line.text); });
        return found == lines_.rend() ? Line{} : *found;
    }

    /// The last comment, split as the row is, or at its commas where blanks part the row and then the width is the
    /// same.
    [[nodiscard]] HeaderLine above(const HeaderLine& row) const {
        const Line comment = last_comment();
        HeaderLine with_commas(comment, Delimiter::character(','), options_.comment);
        return row.delimiter.is_blanks() && with_commas.width() == row.width()
                   ? with_commas
                   : HeaderLine(comment, row.delimiter, options_.comment);
    }

    /// The last comment, if it is the header of a row; under HeaderMode::yes as many fields are enough.
    [[nodiscard]] std::optional<HeaderLine> comment_of(const HeaderLine& row) const {
        HeaderLine header = above(row);
        auto names = selected(header);
        if (header.line.text.empty() || !header.is_closed || header.width() != row.width() || !names) {
            return std::nullopt;
        }
        if (options_.header == HeaderMode::yes) {
            return header;
        }
        if (std::ranges::any_of(header.names(), is_number)) {
            return std::nullopt;
        }
        if (row.delimiter.is_blanks() && count() > 0) { // then a remark may well have as many words
            const auto kept = static_cast<std::ptrdiff_t>(options_.numbers.kept);
            names = options_.own_names ? options_.own_names(std::move(*names)) : names;
            const auto& own = options_.numbers.names;
            if (!std::is_permutation(names->begin() + kept, names->end(), own.begin() + kept, own.end())) {
                return std::nullopt;
            }
        }
        return header;
    }

    /// Looks the names up under each delimiter, or the one given, until they are all there; commas may part those of a
    /// comment where blanks part the rows. A mark before the first name is no part of it where they are not there as
    /// they stand.
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
                auto found = options_.columns.positions(is_remark(each) ? std::vector<std::string>() : each.names());
                if (has_all(found) || (tried.size() == 1 && is_without != has_mark)) {
                    return {std::move(each), std::move(found)};
                }
            }
        }
    }

    /// Which names a row has and lacks, with what the columns are called.
    [[nodiscard]] Beginning lacking(const Line& line) const {
        const HeaderLine row(line, delimiter_of(line.text));
        ColumnError column = std::get<ColumnError>(find_names(line, row.delimiter).second);
        column.text = line.text;
        const HeaderLine comment = above(row);
        for (const HeaderLine* header : {&row, &comment}) {
            if (header->is_closed && header->width() == row.width() && !is_remark(*header) &&
                std::ranges::none_of(header->names(), is_number)) {
                column.header = header->names();
                break;
            }
        }
        return error({.what = StreamError::What::columns, .column = std::move(column)}, lines_.size() - 1);
    }

    const std::vector<Line>& lines_;
    const InputOptions& options_;
};

} // namespace

HeaderLine::HeaderLine(const Line& line_, Delimiter delimiter_, std::string_view comment)
    : line(line_), delimiter(delimiter_) {
    const bool is_comment = !comment.empty() && line.text.starts_with(comment);
    const std::size_t size =
        is_comment ? std::min(line.text.find_first_not_of(" \t", comment.size()), line.text.size()) : 0;
    prefix = line.text.substr(0, size);
    is_closed = delimiter.split(line.text.substr(size), fields);
}

bool HeaderLine::begins_with_mark() const {
    return !fields.empty() && !fields.front().empty() && std::ranges::all_of(fields.front(), is_mark);
}

HeaderLine HeaderLine::without_mark() const {
    HeaderLine made = *this;
    const std::string_view rest = line.text.substr(prefix.size());
    const auto is_part = [this](char c) { return is_mark(c) && (delimiter.is_blanks() || c != delimiter.text()); };
    auto size = static_cast<std::size_t>(std::ranges::find_if_not(rest, is_part) - rest.begin());
    if (const auto blank = rest.find(' '); size == 0 && blank != std::string_view::npos && rest[blank - 1] == ':') {
        size = std::min(rest.find_first_not_of(' ', blank), rest.size()); // a title: "COLUMN_HEADERS: phi1, PHI"
    }
    made.prefix = line.text.substr(0, prefix.size() + size);
    made.fields.clear();
    made.is_closed = delimiter.split(line.text.substr(made.prefix.size()), made.fields);
    return made;
}

std::string HeaderLine::name(std::size_t at) const {
    return std::string(trimmed(delimiter.unquoted(trimmed(fields[at]))));
}

std::vector<std::string> HeaderLine::names() const {
    std::vector<std::string> names;
    names.reserve(fields.size());
    for (std::size_t i = 0; i < fields.size(); ++i) {
        names.push_back(name(i));
    }
    return names;
}

Beginning decide(const std::vector<Line>& lines, const InputOptions& options, bool is_end) {
    if (lines.empty()) {
        return {};
    }
    const Decision decision(lines, options);
    if (options.columns.has_names()) {
        return decision.by_name(is_end);
    }
    return is_end ? Beginning{} : decision.by_index();
}

Preamble::Preamble(const InputOptions& options, const Options* written)
    : options_(&options), written_(written),
      header_done_(options.header == HeaderMode::no || options.header == HeaderMode::add) {
    layout_.appends = written != nullptr && written->append;
    if (!options.columns.has_names()) {
        layout_.select(options.columns.positions(), options.numbers.names.size(), options.numbers.kept);
    }
}

bool Preamble::read(std::string_view& rest, std::size_t& line, Output& output) {
    if (!has_row_ && options_->width > 0 && !rest.empty()) {
        layout_.delimiter = options_->delimiter.value_or(Delimiter::character(','));
        layout_.field_count = options_->width;
        begin_rows(output);
    }
    while (!has_row_ && !rest.empty()) {
        std::string_view after = rest;
        const Line current = next_line(after);
        const std::string_view whole = rest.substr(0, rest.size() - after.size());
        bool is_data = options_->is_row(current.text);
        if (is_data) {
            std::erase_if(layout_.notes, [](const Note& note) { return note.kind == Note::Kind::comments; });
            only_comments_ = false;
        } else if (only_comments_ && layout_.notes.empty() && options_->is_comment(current.text)) {
            hear({.comment = current.text}, line);
        }
        if (!header_done_) {
            hold(whole);
            is_data = is_data && follow(decide(lines(), *options_, false), output);
            limit(output);
        } else if (!is_data) {
            pass(whole, output);
        }
        if (is_data) {
            take_layout(current, line);
        }
        if (error_) {
            rest = {};
        } else if (is_data) {
            begin_rows(output);
        } else {
            rest = after;
            ++line;
        }
    }
    return has_row_;
}

void Preamble::finish(Output& output, bool at_end) {
    if (has_row_) {
        return;
    }
    if (at_end && !header_done_ && !held_.empty()) {
        follow(decide(lines(), *options_, true), output);
    }
    release(held_.size(), output);
    if (at_end && header_line_ > 0) {
        hear({.only_header = true}, header_line_);
    }
    if (at_end && !error_) {
        layout_.delimiter = options_->delimiter.value_or(Delimiter::character(','));
        layout_.field_count = options_->width > 0 ? options_->width : options_->columns.empty() ? layout_.count : 0;
        if (written_ != nullptr && layout_.field_count > 0) {
            write_added_header(output.bytes, *written_, layout_);
        }
    }
}

void Preamble::hold(std::string_view line) {
    const std::size_t begin = held_.size();
    held_.append(line);
    if (const std::string_view text = line.substr(0, line.find_last_not_of("\r\n") + 1); is_blank(text)) {
        blank_ += line.size();
    } else if (options_->is_comment(text)) {
        blank_ = 0;
        comment_begin_ = begin;
        comment_end_ = held_.size();
    }
}

std::vector<Line> Preamble::lines() const {
    std::vector<Line> lines;
    for (std::string_view rest = held_; !rest.empty();) {
        if (const Line line = next_line(rest); !is_blank(line.text)) {
            lines.push_back(line);
        }
    }
    return lines;
}

std::size_t Preamble::number_of(const Line& line) const {
    return held_line_ + static_cast<std::size_t>(std::count(held_.data(), line.text.data(), '\n'));
}

bool Preamble::follow(const Beginning& beginning, Output& output) {
    if (!beginning.is_decided && !beginning.error) {
        return false;
    }
    if (beginning.error) {
        error_ = beginning.error;
        error_->line = number_of(lines()[error_->line]);
    }
    if (!beginning.positions.empty()) {
        layout_.select(beginning.positions, options_->numbers.names.size(), options_->numbers.kept);
    }
    if (beginning.is_data) { // the row is converted, not copied
        const auto last = lines().back();
        held_.resize(held_.size() - last.text.size() - last.end.size());
    }
    if (beginning.header) {
        const HeaderLine& header = *beginning.header;
        const auto begin = static_cast<std::size_t>(header.line.text.data() - held_.data());
        header_line_ = number_of(header.line);
        hear_names(header, header_line_);
        if (error_) {
            held_.clear();
            return false;
        }
        pass(std::string_view(held_).substr(0, begin), output);
        keep_names(header);
        if (is_written()) {
            write_header(output.bytes, *written_, layout_, header);
        }
        names_ = header.names();
        name_count_ = header.width();
        held_.erase(0, begin + header.line.text.size() + header.line.end.size());
    }
    if (beginning.is_decided) {
        header_done_ = true;
        release(held_.size(), output);
    }
    return beginning.is_data && !error_;
}

void Preamble::pass(std::string_view text, Output& output) const {
    if (is_written()) {
        append(output.bytes, text);
    }
}

void Preamble::release(std::size_t bytes, Output& output) {
    const std::string_view released = std::string_view(held_).substr(0, bytes);
    pass(released, output);
    held_line_ += static_cast<std::size_t>(std::ranges::count(released, '\n'));
    held_.erase(0, bytes);
    comment_begin_ -= std::min(comment_begin_, bytes);
    comment_end_ -= std::min(comment_end_, bytes);
    blank_ = std::min(blank_, held_.size());
}

void Preamble::limit(Output& output) {
    constexpr std::size_t most_held = std::size_t{64} << 10U;
    constexpr std::size_t most_blank = std::size_t{1} << 20U;
    const auto is_too_much = [this](std::size_t size) { return size - blank_ > most_held || blank_ > most_blank; };
    if (header_done_ || error_ || !is_too_much(held_.size() - (comment_end_ - comment_begin_))) {
        return;
    }
    if (options_->columns.has_names()) {
        follow(decide(lines(), *options_, true), output);
    }
    if (!header_done_ && !error_) {
        release(is_too_much(held_.size() - comment_end_) ? held_.size() : comment_begin_, output);
    }
}

void Preamble::hear(const Said& said, std::size_t line) {
    if (!options_->notes_of) {
        return;
    }
    for (Note& note : options_->notes_of(said)) {
        note.line = line;
        if (note.ends_run) {
            error_ = StreamError{.what = StreamError::What::names, .line = line, .wrong = std::move(note.text)};
        } else {
            layout_.notes.push_back(std::move(note));
        }
    }
}

void Preamble::hear_names(const HeaderLine& header, std::size_t line) {
    Said said{.header = header.names()};
    if (layout_.positions.empty()) {
        said.names.assign(said.header.begin(), said.header.begin() + static_cast<std::ptrdiff_t>(header.width()));
    }
    for (const std::size_t position : layout_.positions) {
        if (position < header.fields.size()) {
            said.names.push_back(header.name(position));
        }
    }
    if (said.names.size() == layout_.count) {
        hear(said, line);
    }
}

void Preamble::keep_names(const HeaderLine& header) {
    if (written_ == nullptr || !written_->operation->keeps_names) {
        return;
    }
    const std::size_t count = written_->operation->names.size();
    for (std::size_t i = layout_.count - count; i < layout_.count; ++i) {
        const std::size_t at = layout_.positions.empty() ? i : layout_.positions[i];
        layout_.kept_names.emplace_back(at < header.fields.size() ? trimmed(header.fields[at]) : "");
    }
    std::set<std::string> keys;
    for (const std::string_view column : result_columns(*written_, layout_)) {
        if (!keys.insert(json_string(header.delimiter.unquoted(column))).second && written_->format == Format::json) {
            layout_.kept_names.clear(); // no key twice
            return;
        }
    }
}

void Preamble::take_layout(const Line& row, std::size_t number) {
    layout_.delimiter = options_->delimiter.value_or(Delimiter::of_row(row.text));
    layout_.line_end = row.end.empty() ? "\n" : std::string(row.end);
    layout_.field_count = HeaderLine(row, layout_.delimiter).fields.size();
    if (options_->take_count) {
        const auto taken = options_->take_count(layout_.field_count);
        if (const auto* wrong = std::get_if<std::string>(&taken)) {
            error_ = StreamError{.what = StreamError::What::count,
                                 .line = number,
                                 .column = {.text = std::string(row.text)},
                                 .wrong = *wrong};
        } else {
            layout_.select({}, std::get<std::size_t>(taken), options_->numbers.kept);
        }
    }
}

void Preamble::begin_rows(Output& output) {
    has_row_ = true;
    if (written_ == nullptr || !written_->writes_rows) {
        return;
    }
    write_added_header(output.bytes, *written_, layout_);
    if (written_->format == Format::json) {
        std::vector<std::string> taken;
        for (const std::string_view column : result_columns(*written_, layout_)) {
            taken.push_back(layout_.delimiter.unquoted(column));
        }
        layout_.keys =
            JsonKeys(names_, {taken.begin(), taken.end()}, [this](std::size_t at) { return !layout_.replaces(at); });
    }
}

} // namespace rotconv::stream
