#include "row_reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "delimiter.hpp"
#include "scan_number.hpp"

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
template <bool has_others>
[[gnu::flatten]] const char* scan_numbers(const char* at, const char* line_end, const char* end, Delimiter delimiter,
                                          std::span<const std::size_t> order, std::span<double> numbers) noexcept {
    for (auto next = order.begin();; ++at) {
        if (has_others && *next == Layout::no_number) {
            at = end_of_field(at, line_end, delimiter);
        } else {
            double& number = numbers[*next];
            at = scan_number(at, end, number);
            if (at == nullptr || !std::isfinite(number)) {
                return nullptr;
            }
        }
        if (at == nullptr || ++next == order.end()) {
            return at;
        }
        if (at == end || *at != delimiter.text()) {
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

} // namespace

std::optional<ScannedRow> RowReader::scan(std::string_view text, RowParts& to) const {
    const std::size_t first = to.numbers.size();
    if (options_->width > 0) {
        const Line row = next_row(text, options_->width);
        add_doubles(row.text, to.numbers);
        for (std::size_t i = 0; i < options_->numbers.kept; ++i) {
            to.keep(first);
        }
        return ScannedRow{row, row.text};
    }
    if (layout_->number_of_field.empty()) {
        return std::nullopt;
    }
    const Delimiter delimiter = layout_->delimiter;
    const bool has_other_fields = !layout_->is_whole;
    const char* begin = text.data();
    const char* const text_end = begin + text.size();
    const char* end = text_end;
    Line line;
    if (has_other_fields) {
        line = next_line(text);
        end = begin + line.text.size();
        if (line.text.find('"') != std::string_view::npos) { // quicker than std::find
            return std::nullopt;
        }
        for (std::size_t i = 0; i < layout_->first_field; ++i) {
            const char* const stop = end_of_field(begin, end, delimiter);
            if (stop == nullptr || stop == end) {
                return std::nullopt;
            }
            begin = stop + 1;
        }
    }
    std::span<const std::size_t> order = layout_->number_of_field;
    const char* first_number = begin;
    if (by_key_) {
        const std::string_view key = line.text.substr(static_cast<std::size_t>(begin - line.text.data()));
        const std::size_t size = key.find(delimiter.text());
        if (size >= key.size() || size == 0 || trimmed(key.substr(0, size)).size() < size ||
            (delimiter.is_blanks() && key.substr(0, size).find('\t') != std::string_view::npos)) {
            return std::nullopt;
        }
        first_number += size;
        ++first_number;
        order = order.subspan(1);
    }
    to.numbers.resize(first + layout_->count);
    to.numbers[first] = 0.0;
    const auto numbers = std::span(to.numbers).subspan(first);
    const char* const at = layout_->is_scattered
                               ? scan_numbers<true>(first_number, end, text_end, delimiter, order, numbers)
                               : scan_numbers<false>(first_number, end, text_end, delimiter, order, numbers);
    bool is_plain = at != nullptr;
    if (is_plain && has_other_fields) {
        is_plain = at == end || *at == delimiter.text();
        if (is_plain && (width_.line > 0 || delimiter.is_blanks())) {
            const auto behind = count_behind(at, end, delimiter);
            const std::size_t fields = layout_->first_field + layout_->number_of_field.size() + behind.value_or(0);
            // a row that fits without its empty fields is not plain
            is_plain = behind && (width_.line == 0 || fields == width_.fields.all || fields == width_.fields.filled);
        }
    } else if (is_plain) {
        const char* const newline = at != end && *at == '\r' ? at + 1 : at;
        is_plain = at == end || (newline != end && *newline == '\n');
        line = {{begin, at}, {at, newline == end ? end : newline + 1}};
    }
    if (!is_plain) {
        to.numbers.resize(first);
        return std::nullopt;
    }
    for (std::size_t i = 0; i < options_->numbers.kept; ++i) {
        const char* const stop = std::find(begin, at, delimiter.text());
        to.keys.emplace_back(begin, stop);
        to.keep(first);
        begin = stop + 1;
    }
    for (auto field = options_->numbers.kept;
         layout_->is_scattered && layout_->number_of_field[field] == Layout::no_number; ++field) {
        begin = std::find(begin, at, delimiter.text()) + 1;
    }
    return ScannedRow{line, {begin, at}};
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
