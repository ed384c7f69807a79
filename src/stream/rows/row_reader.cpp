#include "row_reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <span>

#include "../beginning/delimiter.hpp"
#include "../numbers/scan_number.hpp"

namespace rotconv::stream {
namespace {

/// The end of the field that begins there; null where blanks delimit and it is empty.
[[gnu::always_inline]] inline const char* end_of_field(const char* at, const char* line_end,
                                                       Delimiter delimiter) noexcept {
    const auto size = static_cast<std::size_t>(line_end - at);
    const auto* const found = static_cast<const char*>(std::memchr(at, delimiter.text(), size));
    const char* const end = found == nullptr ? line_end : found;
    return delimiter.is_blanks() && end == at ? nullptr : end;
}

/// Flat, for fast_float is not inlined of itself where its callers stand in one source.
/// @param order see Layout::number_of_field
/// @return the place after the last number; null if one is not finite, or something else stands in its field
[[gnu::flatten]] const char* scan_numbers(const char* at, const char* line_end, const char* text_end,
                                          Delimiter delimiter, std::span<const std::size_t> order,
                                          std::span<double> numbers) noexcept {
    for (auto next = order.begin();; ++at) {
        if (*next == Layout::no_number) {
            at = end_of_field(at, line_end, delimiter);
        } else {
            double& number = numbers[*next];
            at = scan_number(at, text_end, number);
            if (at == nullptr || !std::isfinite(number)) {
                return nullptr;
            }
        }
        if (at == nullptr || ++next == order.end()) {
            return at;
        }
        if (at == text_end || *at != delimiter.text()) {
            return nullptr;
        }
    }
}

/// How many fields stand behind the one that ends there; nothing where end_of_field() has none.
std::optional<std::size_t> count_behind(const char* at, const char* line_end, Delimiter delimiter) noexcept {
    if (!delimiter.is_blanks()) {
        return count_of(delimiter.text(), {at, line_end});
    }
    std::size_t count = 0;
    for (; at != nullptr && at != line_end; ++count) {
        at = *at == ' ' ? end_of_field(at + 1, line_end, delimiter) : nullptr;
    }
    return at == nullptr ? std::nullopt : std::optional(count);
}

// Parts of a scan, each in one place; null, or false, where the row is not plain.

/// What follows so many fields.
[[gnu::always_inline]] inline const char* behind_fields(const char* at, const char* line_end, Delimiter delimiter,
                                                        std::size_t count) noexcept {
    for (; at != nullptr && count > 0; --count) {
        at = end_of_field(at, line_end, delimiter);
        at = at == line_end || at == nullptr ? nullptr : at + 1;
    }
    return at;
}

/// Whether a row whose last number ends there has the right width. One that fits without its empty fields is not plain.
bool fits(const Layout& layout, const RowWidth& width, const char* last, const char* line_end) noexcept {
    const Delimiter delimiter = layout.delimiter;
    if (last != line_end && *last != delimiter.text()) {
        return false;
    }
    if (width.line == 0 && !delimiter.is_blanks()) {
        return true;
    }
    const auto behind = count_behind(last, line_end, delimiter);
    const std::size_t fields = layout.first_field + layout.number_of_field.size() + behind.value_or(0);
    return behind && (width.line == 0 || fields == width.fields.all || fields == width.fields.filled);
}

} // namespace

bool RowReader::scan(std::string_view text, Row& row, ReadRows& to) const {
    if (options_->width > 0) {
        row.line = next_row(text, options_->width);
        row.numbers = row.line.text;
        add_doubles(row.line.text, to);
        return true;
    }
    const Delimiter delimiter = layout_->delimiter;
    const std::size_t kept = options_->numbers.kept;
    const bool is_open = layout_->is_whole && kept == 0; // the last number shows where the line ends
    const char* const text_end = text.data() + text.size();
    Line line = is_open ? Line{text, {}} : next_line(text);
    const char* const line_end = line.text.data() + line.text.size();
    const bool has_quotes = !layout_->is_whole && line.text.find('"') != std::string_view::npos;
    const bool has_tabs = !is_open && delimiter.is_blanks() && line.text.find('\t') != std::string_view::npos;
    if (layout_->number_of_field.empty() || has_quotes || has_tabs) {
        return false;
    }
    const char* begin =
        behind_fields(line.text.data(), line_end, delimiter, kept > 0 ? layout_->position(0) : layout_->first_field);
    Kept key;
    if (kept > 0 && begin != nullptr) {
        const char* const end = end_of_field(begin, line_end, delimiter);
        key.text = end == nullptr ? std::string_view() : trimmed({begin, end});
        key.key = key_of(key.text);
        begin = key.key.error == KeyError::none
                    ? behind_fields(begin, line_end, delimiter, layout_->first_field - layout_->position(0))
                    : nullptr;
    }
    if (begin == nullptr) {
        return false;
    }
    const std::size_t first = to.numbers.size();
    to.numbers.resize(first + layout_->count - kept);
    const char* const last = scan_numbers(begin, line_end, text_end, delimiter, layout_->number_of_field,
                                          std::span(to.numbers).subspan(first));
    bool is_plain = last != nullptr;
    if (is_plain && is_open) {
        const char* const newline = last != line_end && *last == '\r' ? last + 1 : last;
        is_plain = last == line_end || (newline != line_end && *newline == '\n');
        line = {{begin, last}, {last, newline == line_end ? line_end : newline + 1}};
    } else if (is_plain) {
        is_plain = layout_->is_whole ? last == line_end : fits(*layout_, width_, last, line_end);
    }
    if (!is_plain) {
        to.numbers.resize(first);
        return false;
    }
    if (kept > 0) {
        to.kept.push_back(key);
    }
    row.line = line;
    row.numbers = {begin, last};
    return true;
}

bool RowReader::take_line(std::string_view& text, Row& row, ReadRows& to) const {
    row.line = next_line(text);
    row.passes = !options_->is_row(row.line.text);
    if (row.passes) {
        return false;
    }
    const std::size_t first_number = to.numbers.size();
    row.first_field = to.fields.size();
    const bool is_read = read(row.line.text, to);
    row.field_count = to.fields.size() - row.first_field;
    if (!is_read) {
        to.numbers.resize(first_number);
    }
    return is_read;
}

bool RowReader::read(std::string_view row, ReadRows& to) const {
    const std::size_t first_field = to.fields.size();
    if (!layout_->delimiter.split(row, to.fields)) {
        to.error = {.what = RowError::What::open_quote, .text = std::string(row)};
        return false;
    }
    const auto fields = std::span(to.fields).subspan(first_field);
    const FieldCount count = layout_->delimiter.count(fields);
    if (layout_->is_whole && count.filled != layout_->count) {
        to.error = {.what = RowError::What::wrong_count,
                    .text = std::string(row),
                    .found = count.filled,
                    .expected = layout_->count};
        return false;
    }
    Kept* kept = nullptr;
    if (options_->numbers.kept > 0 && layout_->position(0) < fields.size()) {
        kept = &to.kept.emplace_back();
        kept->text = layout_->delimiter.text_of(fields[layout_->position(0)]);
        kept->key = key_of(kept->text);
    }
    auto missing = std::numeric_limits<std::size_t>::max(); // the first
    for (const std::size_t at : layout_->positions) {
        missing = at >= fields.size() ? std::min(missing, at) : missing;
    }
    if (missing < std::numeric_limits<std::size_t>::max()) {
        to.error = {.what = RowError::What::missing_column,
                    .text = std::string(row),
                    .found = fields.size(),
                    .expected = missing + 1};
        return false;
    }
    for (std::size_t i = 0; i < layout_->count; ++i) {
        const bool is_kept = i < options_->numbers.kept;
        const std::string_view field = fields[layout_->position(i)];
        double number = 0.0;
        NumberError error = read_number(field, number);
        if (error == NumberError::not_a_number) { // or quoted
            error = read_number(layout_->delimiter.text_of(field), number);
        }
        const bool may_be_time = is_kept && error == NumberError::not_a_number;
        const KeyError key_error = may_be_time ? kept->key.error : KeyError::not_a_number;
        if (error != NumberError::none && key_error != KeyError::none) {
            to.error = {.what = error == NumberError::too_large       ? RowError::What::too_large
                                : key_error == KeyError::not_a_number ? RowError::What::not_a_number
                                                                      : RowError::What::key,
                        .text = std::string(field),
                        .key = key_error};
            if (options_->columns.has_names()) {
                to.error.tell_width(count, layout_->header);
            }
            return false;
        }
        if (is_kept) {
            kept->number = number;
        } else {
            to.numbers.push_back(number);
        }
    }
    if (!layout_->is_whole && width_.line > 0 && !count.fits(width_.fields)) {
        to.error = {.what = RowError::What::other_width, .text = std::string(row)};
        to.error.tell_width(count, width_);
        return false;
    }
    return true;
}

ReadKey RowReader::key_of(std::string_view text) const {
    ReadKey key = read_key(text, options_->key_power);
    if (key.error == KeyError::none && options_->numbers.has_unit && !is_number(text)) {
        key.error = KeyError::has_unit;
    }
    key.value.units += options_->key_offset.units;
    return key;
}

void RowReader::add_doubles(std::string_view row, ReadRows& to) const {
    for (std::size_t i = 0; i < layout_->count; ++i) {
        double number = 0.0;
        std::memcpy(&number, row.data() + layout_->position(i) * sizeof(double), sizeof(double));
        if (i < options_->numbers.kept) {
            to.kept.push_back({.number = number});
        } else {
            to.numbers.push_back(number);
        }
    }
}

std::string RowReader::selected_text(std::string_view row) const {
    if (options_->width == 0 && layout_->is_whole) {
        return std::string(row);
    }
    const char character = layout_->delimiter.text();
    const std::string_view delimiter(&character, 1);
    ReadRows parts;
    if (options_->width > 0) {
        add_doubles(row, parts);
        const std::string kept = parts.kept.empty() ? "" : fmt::format("{}{}", parts.kept[0].number, delimiter);
        return fmt::format("{}{}", kept, fmt::join(parts.numbers, delimiter));
    }
    static_cast<void>(layout_->delimiter.split(row, parts.fields));
    std::vector<std::string_view> selected;
    for (const std::size_t at : layout_->positions) {
        selected.push_back(parts.fields[at]);
    }
    return fmt::format("{}", fmt::join(selected, delimiter));
}

} // namespace rotconv::stream
