#include "column_list.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>

#include "number_text.hpp"

namespace rotconv::stream {
namespace {

using What = ColumnError::What;

bool is_digits(std::string_view text) noexcept {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// A 1-based index, at most what a line can hold.
std::optional<std::size_t> read_index(std::string_view text) noexcept {
    std::size_t value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    constexpr std::size_t most = std::size_t{4} << 20U;
    if (result.ec != std::errc{} || value < 1 || value > most) {
        return std::nullopt;
    }
    return value;
}

/// The item that stands twice in `positions`, as an index.
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
    std::string_view rest = list;
    for (bool more = true; more;) {
        const auto comma = rest.find(',');
        more = comma != std::string_view::npos;
        const std::string_view item = trimmed(rest.substr(0, comma));
        rest = more ? rest.substr(comma + 1) : std::string_view{};
        const auto dash = item.find('-');
        const bool is_range =
            dash != std::string_view::npos && is_digits(item.substr(0, dash)) && is_digits(item.substr(dash + 1));
        if (!is_range && !is_digits(item)) {
            if (item.empty()) {
                return ColumnError{What::not_an_item, std::string(item)};
            }
            if (++counted <= count) {
                if (std::ranges::count(made.items_, item, &Item::name) != 0) {
                    return ColumnError{What::twice, std::string(item)};
                }
                made.items_.push_back({std::string(item)});
            }
            continue;
        }
        const auto first = read_index(item.substr(0, is_range ? dash : item.size()));
        const auto last = is_range ? read_index(item.substr(dash + 1)) : first;
        if (!first || !last || *first > *last) {
            return ColumnError{What::not_an_item, std::string(item)};
        }
        counted += *last - *first + 1;
        for (std::size_t index = *first; index <= *last && made.items_.size() <= count; ++index) {
            made.items_.push_back({{}, index - 1});
        }
    }
    if (counted != count) {
        return ColumnError{What::wrong_count, std::string(list), counted};
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
        // The whole name goes before the part up to its first blank.
        const auto whole = [&item](std::string_view name) { return name == item.name; };
        const auto part = [&item](std::string_view name) {
            return name.substr(0, name.find_first_of(" \t")) == item.name;
        };
        const auto look = [&header](const auto& matches) {
            return std::pair{std::ranges::count_if(header, matches), std::ranges::find_if(header, matches)};
        };
        auto [count, found] = look(whole);
        if (count == 0) {
            std::tie(count, found) = look(part);
        }
        (count == 0 ? missing.lacking : missing.present).push_back(item.name);
        if (count > 1 && !ambiguous) {
            ambiguous = ColumnError{What::ambiguous, item.name};
            for (std::size_t i = 0; i < header.size(); ++i) {
                if (whole(header[i]) || (!whole(*found) && part(header[i]))) {
                    ambiguous->indices.push_back(i + 1);
                }
            }
        }
        positions.push_back(static_cast<std::size_t>(found - header.begin()));
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
