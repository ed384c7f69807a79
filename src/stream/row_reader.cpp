#include "row_reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "delimiter.hpp"
#include "scan_number.hpp"

namespace rotconv::stream {

bool RowReader::read(std::string_view row, RowParts& to, bool needs_fields) const {
    if (options_->width == 0) {
        return read_text(row, to, needs_fields || has_other_fields());
    }
    read_binary(row, to);
    return true;
}

bool RowReader::read_text(std::string_view text, RowParts& to, bool needs_fields) const {
    using What = RowError::What;
    if (!needs_fields && read_plain(text, to.numbers)) {
        return true;
    }
    const std::size_t needed = layout_->count;
    const std::size_t first_field = to.fields.size();
    if (!layout_->delimiter.split(text, to.fields)) {
        to.error = {.what = What::open_quote, .text = std::string(text)};
        return false;
    }
    const std::size_t count = to.fields.size() - first_field;
    if (layout_->positions.empty() && count != needed) {
        to.error = {.what = What::wrong_count, .text = std::string(text), .found = count, .expected = needed};
        return false;
    }
    if (!layout_->positions.empty() && layout_->in_row_order.back() >= count) {
        const auto missing = std::ranges::lower_bound(layout_->in_row_order, count);
        to.error = {.what = What::missing_column, .text = std::string(text), .found = count, .expected = *missing + 1};
        return false;
    }
    const std::size_t first_number = to.numbers.size();
    for (std::size_t i = 0; i < needed; ++i) {
        const std::string_view field = to.fields[first_field + position(i)];
        double& number = to.numbers.emplace_back();
        NumberError error = read_number(field, number);
        if (error == NumberError::not_a_number) { // or quoted
            error = read_number(layout_->delimiter.text_of(field), number);
        }
        if (error != NumberError::none) {
            to.error = {.what = error == NumberError::too_large ? What::too_large : What::not_a_number,
                        .text = std::string(field)};
            to.numbers.resize(first_number);
            return false;
        }
    }
    for (std::size_t i = 0; i < options_->numbers.kept; ++i) {
        to.kept.push_back(layout_->delimiter.text_of(to.fields[first_field + position(i)]));
    }
    return true;
}

bool RowReader::read_plain(std::string_view text, std::vector<double>& numbers) const {
    const std::size_t first = numbers.size();
    numbers.resize(first + layout_->count);
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t i = first; i < numbers.size(); ++i) {
        const char* const stop = scan_number(at, end, numbers[i]);
        const bool is_last = i + 1 == numbers.size();
        if (stop == nullptr || !std::isfinite(numbers[i]) || (stop == end) != is_last ||
            (!is_last && *stop != layout_->delimiter.text())) {
            numbers.resize(first);
            return false;
        }
        at = is_last ? end : stop + 1;
    }
    return true;
}

void RowReader::read_binary(std::string_view row, RowParts& to) const {
    for (std::size_t i = 0; i < layout_->count; ++i) {
        std::memcpy(&to.numbers.emplace_back(), row.data() + position(i) * sizeof(double), sizeof(double));
    }
}

std::string RowReader::selected_text(std::string_view row) const {
    if (options_->width == 0 && layout_->positions.empty()) {
        return std::string(row);
    }
    const char character = layout_->delimiter.text();
    const std::string_view delimiter(&character, 1);
    RowParts parts;
    if (options_->width > 0) {
        read_binary(row, parts);
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
