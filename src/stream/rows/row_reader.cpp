#include "row_reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "../beginning/delimiter.hpp"
#include "../numbers/scan_number.hpp"

namespace rotconv::stream {
namespace {

/// The end of the field that begins there; null where blanks delimit and it is empty, or a tab would end it.
const char* end_of_field(const char* at, const char* line_end, Delimiter delimiter) noexcept {
    const auto size = static_cast<std::size_t>(line_end - at);
    const auto* const found = static_cast<const char*>(std::memchr(at, delimiter.text(), size));
    const char* const end = found == nullptr ? line_end : found;
    return delimiter.is_blanks() && (end == at || std::find(at, end, '\t') != end) ? nullptr : end;
}

/// Flat, for fast_float is not inlined of itself where its callers stand in one source.
/// @param order of the numbers; with has_others other fields may stand between them, see Layout::number_of_field
/// @return the place after the last number; null if one is not finite, or something else stands in its field
template <bool has_others> [[gnu::flatten]] const char* scan_numbers(const char* at, const char* line_end,
                                                                     const char* text_end, Delimiter delimiter,
                                                                     std::span<const std::size_t> order,
                                                                     std::span<double> numbers) noexcept {
    for (auto next = order.begin();; ++at) {
        if (has_others && *next == Layout::no_number) {
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

/// The first field that may hold a number, or the key.
const char* first_field_of(const Layout& layout, std::string_view line) noexcept {
    const char* at = line.data();
    const char* const end = at + line.size();
    if (line.find('"') != std::string_view::npos) { // quicker than std::find
        return nullptr;
    }
    for (std::size_t i = 0; i < layout.first_field; ++i, ++at) {
        at = end_of_field(at, end, layout.delimiter);
        if (at == nullptr || at == end) {
            return nullptr;
        }
    }
    return at;
}

/// What follows the key with which the text begins.
const char* behind_key(Delimiter delimiter, std::string_view text) noexcept {
    const std::size_t size = text.find(delimiter.text());
    const std::string_view key = text.substr(0, size);
    const bool is_plain = size < text.size() && size > 0 && trimmed(key).size() == size &&
                          !(delimiter.is_blanks() && key.find('\t') != std::string_view::npos);
    return is_plain ? text.data() + size + 1 : nullptr;
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

/// Keeps the key, or what is kept of the numbers from that of the index on. @return the part of the other numbers
std::string_view keep_scanned(const Layout& layout, std::size_t kept, const char* begin, const char* end,
                              std::size_t first, RowParts& to) {
    const char delimiter = layout.delimiter.text();
    for (std::size_t i = 0; i < kept; ++i) {
        const char* const stop = std::find(begin, end, delimiter);
        to.keys.emplace_back(begin, stop);
        to.keep(first);
        begin = stop + 1;
    }
    for (std::size_t i = kept; layout.is_scattered && layout.number_of_field[i] == Layout::no_number; ++i) {
        begin = std::find(begin, end, delimiter) + 1;
    }
    return {begin, end};
}

} // namespace

bool RowReader::scan(std::string_view text, Row& row, RowParts& to) const {
    const std::size_t first = to.numbers.size();
    if (options_->width > 0) {
        row.line = next_row(text, options_->width);
        row.numbers = row.line.text;
        add_doubles(row.line.text, to.numbers);
        for (std::size_t i = 0; i < options_->numbers.kept; ++i) {
            to.keep(first);
        }
        return true;
    }
    const bool is_whole = layout_->is_whole;
    const char* const text_end = text.data() + text.size();
    Line line{text, {}};
    if (!is_whole) {
        line = next_line(text);
    }
    const char* const line_end = line.text.data() + line.text.size();
    const char* const begin = layout_->number_of_field.empty() ? nullptr
                              : is_whole                       ? text.data()
                                                               : first_field_of(*layout_, line.text);
    const char* const first_number =
        begin != nullptr && by_key_ ? behind_key(layout_->delimiter, {begin, line_end}) : begin;
    if (first_number == nullptr) {
        return false;
    }
    const auto order = std::span(layout_->number_of_field).subspan(by_key_ ? 1 : 0);
    to.numbers.resize(first + layout_->count);
    to.numbers[first] = 0.0;
    const auto numbers = std::span(to.numbers).subspan(first);
    const char* const last =
        layout_->is_scattered
            ? scan_numbers<true>(first_number, line_end, text_end, layout_->delimiter, order, numbers)
            : scan_numbers<false>(first_number, line_end, text_end, layout_->delimiter, order, numbers);
    bool is_plain = last != nullptr;
    if (is_plain && is_whole) {
        const char* const newline = last != line_end && *last == '\r' ? last + 1 : last;
        is_plain = last == line_end || (newline != line_end && *newline == '\n');
        line = {{begin, last}, {last, newline == line_end ? line_end : newline + 1}};
    } else if (is_plain) {
        is_plain = fits(*layout_, width_, last, line_end);
    }
    if (!is_plain) {
        to.numbers.resize(first);
        return false;
    }
    row.line = line;
    row.numbers = keep_scanned(*layout_, options_->numbers.kept, begin, last, first, to);
    return true;
}

bool RowReader::take_line(std::string_view& text, Row& row, RowParts& to) const {
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

bool RowReader::read(std::string_view row, RowParts& to) const {
    const std::size_t first_number = to.numbers.size();
    const std::size_t first_field = to.fields.size();
    if (!split(row, layout_->is_whole ? std::span<const std::size_t>() : layout_->positions, to)) {
        return false;
    }
    const FieldCount count = layout_->delimiter.count(std::span(to.fields).subspan(first_field));
    if (layout_->is_whole && count.filled != layout_->count) {
        to.error = {.what = RowError::What::wrong_count,
                    .text = std::string(row),
                    .found = count.filled,
                    .expected = layout_->count};
        return false;
    }
    for (std::size_t i = 0; i < layout_->count; ++i) {
        const std::string_view field = to.fields[first_field + layout_->position(i)];
        to.numbers.push_back(0.0);
        double& number = to.numbers[to.numbers.size() - 1];
        NumberError error = read_number(field, number);
        if (error == NumberError::not_a_number) { // or quoted
            error = read_number(layout_->delimiter.text_of(field), number);
        }
        KeyError key_error = KeyError::not_a_number;
        if (error == NumberError::not_a_number && i < options_->numbers.kept) {
            const ReadKey time = key_of(layout_->delimiter.text_of(field));
            number = time.value.rounded();
            key_error = time.error;
        }
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
    }
    if (!layout_->is_whole && width_.line > 0 && !count.fits(width_.fields)) {
        to.error = {.what = RowError::What::other_width, .text = std::string(row)};
        to.error.tell_width(count, width_);
        return false;
    }
    for (std::size_t i = 0; i < options_->numbers.kept; ++i) {
        to.keys.push_back(layout_->delimiter.text_of(to.fields[first_field + layout_->position(i)]));
        to.keep(first_number);
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

std::optional<std::string_view> RowReader::key(std::string_view row, RowParts& to) const {
    const std::size_t first = layout_->position(0);
    const std::size_t first_field = to.fields.size();
    if (first == 0 && !layout_->delimiter.is_blanks() && row.find('"') == std::string_view::npos) {
        return layout_->delimiter.text_of(row.substr(0, row.find(layout_->delimiter.text())));
    }
    if (!split(row, {&first, 1}, to)) {
        return std::nullopt;
    }
    return layout_->delimiter.text_of(to.fields[first_field + first]);
}

bool RowReader::split(std::string_view row, std::span<const std::size_t> needed, RowParts& to) const {
    const std::size_t first_field = to.fields.size();
    if (!layout_->delimiter.split(row, to.fields)) {
        to.error = {.what = RowError::What::open_quote, .text = std::string(row)};
        return false;
    }
    const std::size_t count = to.fields.size() - first_field;
    auto missing = std::numeric_limits<std::size_t>::max(); // the first
    for (const std::size_t at : needed) {
        missing = at >= count ? std::min(missing, at) : missing;
    }
    if (missing < std::numeric_limits<std::size_t>::max()) {
        to.error = {
            .what = RowError::What::missing_column, .text = std::string(row), .found = count, .expected = missing + 1};
        return false;
    }
    return true;
}

void RowReader::add_doubles(std::string_view row, Numbers& numbers) const {
    const std::size_t first = numbers.size();
    numbers.resize(first + layout_->count);
    for (std::size_t i = 0; i < layout_->count; ++i) {
        std::memcpy(&numbers[first + i], row.data() + layout_->position(i) * sizeof(double), sizeof(double));
    }
}

std::string RowReader::selected_text(std::string_view row) const {
    if (options_->width == 0 && layout_->is_whole) {
        return std::string(row);
    }
    const char character = layout_->delimiter.text();
    const std::string_view delimiter(&character, 1);
    RowParts parts;
    if (options_->width > 0) {
        add_doubles(row, parts.numbers);
        return fmt::format("{}", fmt::join(parts.numbers, delimiter));
    }
    static_cast<void>(layout_->delimiter.split(row, parts.fields));
    std::vector<std::string_view> selected;
    for (const std::size_t at : layout_->positions) {
        selected.push_back(parts.fields[at]);
    }
    return fmt::format("{}", fmt::join(selected, delimiter));
}

} // namespace rotconv::stream
