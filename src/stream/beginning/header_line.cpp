#include "header_line.hpp"

#include <algorithm>

#include "../../core/text.hpp"
#include "../numbers/number_text.hpp"

namespace rotconv::stream {
namespace {

/// Whether a character may be part of a mark before the first name. Letters beyond ASCII may not.
bool is_mark(char c) noexcept {
    return (static_cast<unsigned char>(c) & 0x80U) == 0U && !is_alphanumeric(c) && c != '_' && c != '"' && c != '\'';
}

/// Whether a text is a name followed by a number: "roll 0.1", "x: 0", "x=0".
/// "Joint 1" is a name.
bool is_name_with_number(std::string_view text) noexcept {
    const auto end_of_name = text.find_last_of(" \t:=");
    if (end_of_name == std::string_view::npos) {
        return false;
    }
    const std::string_view number = text.substr(end_of_name + 1);
    const bool is_index = number.find_first_not_of("0123456789") == std::string_view::npos &&
                          text.find_first_of(":=") == std::string_view::npos;
    return is_number(number) && !is_index && !is_number(text.substr(0, end_of_name));
}

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
    const std::string_view text = line.text.substr(prefix.size());
    const auto is_part = [this](char c) { return is_mark(c) && (delimiter.is_blanks() || c != delimiter.text()); };
    auto size = static_cast<std::size_t>(std::ranges::find_if_not(text, is_part) - text.begin());
    if (const auto blank = text.find(' '); size == 0 && blank != std::string_view::npos && text[blank - 1] == ':') {
        size = std::min(text.find_first_not_of(' ', blank), text.size()); // a title: "COLUMN_HEADERS: phi1, PHI"
    }
    made.prefix = line.text.substr(0, prefix.size() + size);
    made.fields.clear();
    made.is_closed = delimiter.split(line.text.substr(made.prefix.size()), made.fields);
    return made;
}

bool HeaderLine::is_remark(bool has_names) const {
    const std::string_view first = fields.empty() ? "" : trimmed(fields.front());
    const auto all = names();
    const auto is_before_number = [](const auto& name, const auto& next) {
        return !is_number(name) && is_number(next);
    };
    const bool is_assignment = !has_names && delimiter.is_blanks() && std::ranges::count(all, "=") > 0; // KEY = value
    return first == "FMT" || first == "COMMENT" || is_assignment || std::ranges::any_of(all, is_name_with_number) ||
           (delimiter.is_blanks() && std::ranges::adjacent_find(all, is_before_number) != all.end());
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

std::optional<std::vector<std::string>> HeaderLine::names_at(const std::vector<std::size_t>& positions) const {
    std::vector<std::string> found;
    if (positions.empty()) {
        found = names();
        found.resize(width().filled);
    }
    for (const std::size_t position : positions) {
        if (position >= fields.size()) {
            return std::nullopt;
        }
        found.push_back(name(position));
    }
    return found;
}

} // namespace rotconv::stream
