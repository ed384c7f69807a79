#include "header_reader.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "row_text.hpp"

namespace rotconv::stream {
namespace {

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

/// A remark in the manner of other programs, a keyword with its value, or a description of rows: no header.
bool is_preamble(std::string_view row, const std::vector<std::string_view>& fields) noexcept {
    const std::string_view first = fields.empty() ? "" : trimmed(fields.front());
    return row.starts_with("//") || row.starts_with('%') || first == "FMT" || first == "COMMENT" ||
           std::ranges::any_of(fields, [](auto field) { return trimmed(field) == "="; });
}

/// Not one of the names was missing, whatever else is wrong with them.
bool has_all(const std::variant<std::vector<std::size_t>, ColumnError>& found) noexcept {
    const auto* error = std::get_if<ColumnError>(&found);
    return error == nullptr || error->what != ColumnError::What::missing;
}

/// The names of the result's columns, parted by the delimiter.
void append_result_names(Buffer& to, const Options& options, char delimiter) {
    fmt::format_to(std::back_inserter(to), "{}", fmt::join(result_columns(options), std::string_view(&delimiter, 1)));
}

} // namespace

HeaderReader::HeaderReader(const Options& options)
    : options_(&options), header_done_(options.header == HeaderMode::no || options.header == HeaderMode::add) {
    if (options.columns.empty()) {
        layout_.select_all(options.operation.inputs, options.operation.kept);
    } else if (!options.columns.has_names()) {
        layout_.select(options.columns.positions(), options.operation.kept);
    }
}

bool HeaderReader::read(std::string_view& rest, std::size_t& line, Output& output) {
    if (options_->width > 0) {
        layout_.delimiter = options_->delimiter.value_or(Delimiter::character(','));
        if (options_->header == HeaderMode::add) {
            write_added_header(options_->width, output);
        }
        tell_selected();
        return true;
    }
    while (!rest.empty() && !error_) {
        std::string_view after = rest;
        const Line current = next_line(after);
        if (is_data(current, line, output)) {
            settle(current, output);
            tell_selected();
            return true;
        }
        rest = after;
        ++line;
    }
    return false;
}

void HeaderReader::tell_selected() const {
    if (options_->operation.selected) {
        options_->operation.selected(layout_.positions);
    }
}

void HeaderReader::finish(Output& output, bool at_end) {
    if (at_end && options_->columns.has_names()) {
        take_named({}, output);
    }
    release(output);
    if (at_end && options_->header == HeaderMode::add && options_->format == Format::csv && options_->columns.empty()) {
        const char delimiter = options_->delimiter.value_or(Delimiter::character(',')).text();
        for (std::size_t i = 0; i < options_->operation.kept; ++i) {
            fmt::format_to(std::back_inserter(output.bytes), "{}{}", i + 1, delimiter);
        }
        append_result_names(output.bytes, *options_, delimiter);
        output.bytes.push_back('\n');
    }
}

std::string HeaderReader::Header::name(std::size_t at) const {
    return std::string(trimmed(delimiter.unquoted(trimmed(fields[at]))));
}

std::vector<std::string> HeaderReader::Header::names() const {
    std::vector<std::string> names;
    names.reserve(fields.size());
    for (std::size_t i = 0; i < fields.size(); ++i) {
        names.push_back(name(i));
    }
    return names;
}

HeaderReader::Header HeaderReader::header_of(const Line& line, Delimiter delimiter) {
    const std::size_t prefix =
        is_comment(line.text) ? std::min(line.text.find_first_not_of(" \t", 1), line.text.size()) : 0;
    Header header{line, line.text.substr(0, prefix), delimiter, {}, true};
    header.is_closed = delimiter.split(line.text.substr(prefix), header.fields);
    return header;
}

Delimiter HeaderReader::delimiter_of(std::string_view row) const noexcept {
    return options_->delimiter.value_or(Delimiter::of_row(row));
}

bool HeaderReader::is_data(const Line& line, std::size_t number, Output& output) {
    if (is_blank(line.text)) {
        pass(line, output);
        return false;
    }
    const bool is_first = !std::exchange(met_row_, true);
    const bool by_name = options_->columns.has_names() && !header_done_;
    if (by_name && has_all(find_names(line, {}).second)) {
        if (held_.empty()) {
            held_line_ = number;
        }
        hold(line, output);
        return false;
    }
    if (is_comment(line.text)) {
        if (by_name) {
            comment_ = line.text;
        }
        if (by_name || header_done_) {
            pass(line, output);
        } else {
            release(output);
            hold(line, output);
        }
        return false;
    }
    if (is_first && is_json(line)) {
        error_ = StreamError{.what = StreamError::What::json, .line = number};
        return false;
    }
    if (by_name) {
        const Header row = header_of(line, delimiter_of(line.text));
        const bool is_cut = row.fields.size() > 1; // else it does not tell what delimits
        if (!take_named(is_cut ? std::optional(row.delimiter) : std::nullopt, output) && !error_) {
            auto column = std::get<ColumnError>(find_names(line, row.delimiter).second);
            column.text = line.text;
            column.header = names_near(row);
            error_ = StreamError{StreamError::What::columns, number, 0, std::move(column)};
        }
        return !error_;
    }
    return header_done_ || !is_header_line(line, output);
}

bool HeaderReader::is_header_line(const Line& line, Output& output) {
    const Header row = header_of(line, delimiter_of(line.text));
    const bool must_be = options_->header == HeaderMode::yes;
    const bool may_be = is_header(row);
    if ((must_be || !may_be) && take_comment(row, output)) {
        return false;
    }
    release(output);
    header_done_ = true;
    if (must_be || may_be) {
        take(row, output);
    }
    return must_be || may_be;
}

void HeaderReader::write(std::string_view text, Output& output) const {
    if (options_->format == Format::csv) {
        append(output.bytes, text);
    }
}

void HeaderReader::pass(const Line& line, Output& output) {
    if (!held_.empty()) {
        hold(line, output);
        return;
    }
    write(line.text, output);
    write(line.end, output);
}

void HeaderReader::hold(const Line& line, Output& output) {
    if (held_.empty()) {
        held_first_ = line.text.size() + line.end.size();
    }
    held_ += line.text;
    held_ += line.end;
    if (held_.size() - held_first_ > most_held) {
        if (options_->columns.has_names()) {
            take_named({}, output);
        } else {
            release(output);
        }
    }
}

void HeaderReader::release(Output& output) { write(std::exchange(held_, {}), output); }

void HeaderReader::settle(const Line& row, Output& output) {
    layout_.delimiter = delimiter_of(row.text);
    layout_.line_end = row.end.empty() ? "\n" : std::string(row.end);
    if (options_->header == HeaderMode::add) {
        write_added_header(header_of(row, layout_.delimiter).fields.size(), output);
    }
    if (!names_.empty()) {
        layout_.keys = JsonKeys(std::exchange(names_, {}), result_columns(*options_), [this](std::size_t at) {
            return options_->append || !std::ranges::binary_search(layout_.replaced, at);
        });
    }
}

bool HeaderReader::has_selected(const Header& header) const noexcept {
    return layout_.positions.empty() ? header.fields.size() == options_->operation.inputs
                                     : layout_.in_row_order.back() < header.fields.size();
}

std::vector<std::string> HeaderReader::selected(const Header& header) const {
    if (layout_.positions.empty()) {
        return header.names();
    }
    std::vector<std::string> texts;
    std::ranges::transform(layout_.positions, std::back_inserter(texts),
                           [&header](std::size_t at) { return header.name(at); });
    return texts;
}

bool HeaderReader::is_header(const Header& header) const {
    return header.is_closed && has_selected(header) && !is_preamble(header.line.text, header.fields) &&
           std::ranges::none_of(selected(header), [](const auto& text) {
               return is_number(text) || is_missing(text) || has_decimal_comma(text);
           });
}

std::vector<std::string> HeaderReader::names_near(const Header& row) const {
    const Header comment = header_of({comment_, {}}, row.delimiter);
    const auto is_named = [&row](const Header& header) {
        return header.is_closed && header.fields.size() == row.fields.size() &&
               !is_preamble(header.line.text, header.fields) && std::ranges::none_of(header.names(), is_number);
    };
    return is_named(row) ? row.names() : is_named(comment) ? comment.names() : std::vector<std::string>();
}

bool HeaderReader::is_json(const Line& row) const {
    const char first = trimmed(row.text).front();
    if ((first != '{' && first != '[') || options_->header == HeaderMode::yes) {
        return false;
    }
    const Header fields = header_of(row, delimiter_of(row.text));
    return !has_selected(fields) || !std::ranges::all_of(selected(fields), is_number);
}

bool HeaderReader::take_comment(const Header& row, Output& output) {
    if (held_.empty()) {
        return false;
    }
    std::string_view rest = held_;
    const Header header = header_of(next_line(rest), row.delimiter);
    if (!header.is_closed || header.fields.size() != row.fields.size() || !has_selected(header) ||
        std::ranges::any_of(header.names(), is_number)) {
        return false;
    }
    if (row.delimiter.is_blanks()) { // then a remark may well have as many words
        const auto kept = static_cast<std::ptrdiff_t>(options_->operation.kept);
        auto names = selected(header);
        std::ranges::for_each(names, [](std::string& name) {
            constexpr std::string_view unit = "_deg_s";
            name.resize(name.size() - (name.ends_with(unit) ? unit.size() : 0));
        });
        const auto& own = options_->operation.input_names;
        if (!std::is_permutation(names.begin() + kept, names.end(), own.begin() + kept, own.end())) {
            return false;
        }
    }
    take(header, output);
    write(rest, output);
    held_.clear();
    return true;
}

std::pair<HeaderReader::Header, HeaderReader::Lookup>
HeaderReader::find_names(const Line& line, std::optional<Delimiter> delimiter) const {
    if (!delimiter) {
        delimiter = options_->delimiter;
    }
    const auto look_up = [this](const Header& header) {
        return options_->columns.positions(is_preamble(header.line.text, header.fields) ? std::vector<std::string>()
                                                                                        : header.names());
    };
    for (const char c : {',', '\t', ';'}) {
        if (!delimiter && line.text.find(c) != std::string_view::npos) {
            Header header = header_of(line, Delimiter::character(c));
            auto found = look_up(header);
            if (has_all(found)) {
                return {std::move(header), std::move(found)};
            }
        }
    }
    Header header = header_of(line, delimiter.value_or(Delimiter::blanks()));
    auto found = look_up(header);
    return {std::move(header), std::move(found)};
}

bool HeaderReader::take_named(std::optional<Delimiter> delimiter, Output& output) {
    std::optional<std::pair<Header, Lookup>> last;
    std::size_t line = 0;
    std::size_t number = held_line_;
    for (std::string_view rest = held_; !rest.empty(); ++number) {
        const Line held = next_line(rest);
        auto found = find_names(held, is_comment(held.text) ? delimiter : std::nullopt);
        if (has_all(found.second)) {
            last = std::move(found);
            line = number;
        }
    }
    if (!last) {
        return false;
    }
    auto& [header, found] = *last;
    if (const auto* error = std::get_if<ColumnError>(&found)) {
        error_ = StreamError{StreamError::What::columns, line, 0, *error};
        return false;
    }
    layout_.select(std::get<std::vector<std::size_t>>(std::move(found)), options_->operation.kept);
    if (delimiter && header.fields.size() == 1 && header_of(header.line, *delimiter).fields.size() == 1) {
        header.delimiter = *delimiter; // a name alone does not tell what delimits
    }
    const std::string_view held = held_;
    const auto begin = static_cast<std::size_t>(header.line.text.data() - held.data());
    write(held.substr(0, begin), output);
    take(header, output);
    write(held.substr(begin + header.line.text.size() + header.line.end.size()), output);
    held_.clear();
    return true;
}

void HeaderReader::take(const Header& header, Output& output) {
    header_done_ = true;
    if (options_->format == Format::csv) {
        write_header(header, output);
    } else if (options_->format == Format::json) {
        names_ = header.names();
    }
}

void HeaderReader::write_header(const Header& header, Output& output) const {
    const char delimiter = header.delimiter.text();
    Buffer& to = output.bytes;
    const auto write_result = [&] { append_result_names(to, *options_, delimiter); };
    if (options_->append) {
        write_appended(to, header.line.text, delimiter, write_result);
    } else {
        append(to, header.prefix);
        write_fields(to, layout_, header.fields, delimiter, write_result);
    }
    append(to, header.line.end.empty() ? std::string_view("\n") : header.line.end);
}

void HeaderReader::write_added_header(std::size_t field_count, Output& output) const {
    if (options_->format != Format::csv) {
        return;
    }
    const char delimiter = layout_.delimiter.text();
    std::string indices;
    for (std::size_t i = 0; i < field_count; ++i) {
        if (i > 0) {
            indices += delimiter;
        }
        indices += std::to_string(i + 1);
    }
    write_header(header_of({indices, layout_.line_end}, layout_.delimiter), output);
}

} // namespace rotconv::stream
