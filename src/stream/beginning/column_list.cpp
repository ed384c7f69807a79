#include "column_list.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>

#include "../../core/text.hpp"
#include "../numbers/number_text.hpp"

namespace rotconv::stream {
namespace {

using What = ColumnError::What;

/// Reads digits as a 1-based index, at most the number of fields that a line can hold; 0 if it is none.
std::size_t index_of(std::string_view digits) noexcept {
    constexpr std::size_t most = std::size_t{4} << 20U;
    std::size_t value = 0; // it stays 0 where there are too many digits
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value <= most ? value : 0;
}

/// The index of the item that stands twice in `positions`.
std::optional<ColumnError> find_twice(const std::vector<std::size_t>& positions) {
    for (auto at = positions.begin(); at != positions.end(); ++at) {
        if (std::find(positions.begin(), at, *at) != at) {
            return ColumnError{What::twice, std::to_string(*at + 1)};
        }
    }
    return std::nullopt;
}

} // namespace

std::variant<ColumnList, ColumnError> ColumnList::parse(std::string_view list, std::size_t count) {
    ColumnList made;
    std::size_t counted = 0;
    for (const std::string_view part : split(list, ',')) {
        const std::string_view item = trimmed(part);
        const auto dash = item.find('-');
        const std::string_view from = item.substr(0, dash);
        const std::string_view to = dash == std::string_view::npos ? from : item.substr(dash + 1);
        if (item.empty()) {
            return ColumnError{What::not_an_item, {}};
        }
        if (!is_digits(from) || !is_digits(to)) {
            if (++counted <= count) {
                if (std::ranges::count(made.items_, item, &Item::name) != 0) {
                    return ColumnError{What::twice, std::string(item)};
                }
                made.items_.push_back({std::string(item)});
            }
            continue;
        }
        const std::size_t first = index_of(from);
        const std::size_t last = index_of(to);
        if (first == 0 || first > last) {
            return ColumnError{What::not_an_item, std::string(item)};
        }
        counted += last - first + 1;
        for (std::size_t index = first; index <= last && made.items_.size() <= count; ++index) {
            made.items_.push_back({{}, index - 1});
        }
    }
    if (counted != count) {
        return ColumnError{.what = What::wrong_count, .text = std::string(list), .count = counted, .wanted = count};
    }
    std::vector<std::size_t> indices;
    for (const Item& item : made.items_) {
        if (item.name.empty()) {
            indices.push_back(item.position);
        }
    }
    if (auto error = find_twice(indices)) {
        return *error;
    }
    return made;
}

bool ColumnList::has_names() const noexcept {
    return std::ranges::any_of(items_, [](const Item& item) { return !item.name.empty(); });
}

std::vector<std::string_view> ColumnList::names() const {
    std::vector<std::string_view> names;
    std::ranges::transform(items_, std::back_inserter(names), &Item::name);
    return names;
}

std::vector<std::size_t> ColumnList::positions() const {
    std::vector<std::size_t> positions;
    std::ranges::transform(items_, std::back_inserter(positions), &Item::position);
    return positions;
}

std::variant<std::vector<std::size_t>, ColumnError>
ColumnList::positions(const std::vector<std::string>& header) const {
    std::vector<std::size_t> positions;
    ColumnError missing{What::missing, {}};
    std::optional<ColumnError> ambiguous;
    for (const Item& item : items_) {
        if (item.name.empty()) {
            positions.push_back(item.position);
            continue;
        }
        std::vector<std::size_t> found;
        const auto look_up = [&](std::string_view end_of_name) {
            for (std::size_t i = 0; i < header.size(); ++i) {
                const std::string_view name = header[i];
                if (name.substr(0, name.find_first_of(end_of_name)) == item.name) {
                    found.push_back(i);
                }
            }
        };
        look_up({});
        if (found.empty()) {
            look_up(" \t");
        }
        (found.empty() ? missing.lacking : missing.present).push_back(item.name);
        positions.push_back(found.empty() ? 0 : found.front());
        if (found.size() > 1 && !ambiguous) {
            ambiguous = ColumnError{What::ambiguous, item.name};
            std::ranges::transform(found, std::back_inserter(ambiguous->indices), [](auto at) { return at + 1; });
        }
    }
    if (!missing.lacking.empty()) {
        return missing;
    }
    if (auto error = ambiguous ? ambiguous : find_twice(positions)) {
        return *error;
    }
    return positions;
}

} // namespace rotconv::stream
