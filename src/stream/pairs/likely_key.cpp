#include "likely_key.hpp"

#include <algorithm>
#include <variant>

#include "../../core/text.hpp"

namespace rotconv::stream {
namespace {

bool is_letter(char c) noexcept { return is_alphanumeric(c) && (c < '0' || c > '9'); }

/// Whether the last word of a name, its unit aside, is t, time, stamp or ends with one of these two: timestamp,
/// "timestamp [ns]", t_s, header.stamp.
bool is_time(std::string_view name) {
    constexpr std::array<std::string_view, 9> units{"s", "sec", "secs", "ms", "msec", "us", "usec", "ns", "nsec"};
    for (const bool may_be_unit : {true, false}) {
        name = name.substr(
            0, static_cast<std::size_t>(std::find_if(name.rbegin(), name.rend(), is_letter).base() - name.begin()));
        const auto* const begin = std::find_if_not(name.rbegin(), name.rend(), is_letter).base();
        const std::string word = lower({begin, name.end()});
        if (!may_be_unit || std::ranges::count(units, word) == 0) {
            return word == "t" || word.ends_with("time") || word.ends_with("stamp");
        }
        name = {name.begin(), begin};
    }
    return false;
}

/// Whether --key takes a text as a name.
bool is_name(std::string_view text) {
    const auto list = ColumnList::parse(text, 1);
    return std::holds_alternative<ColumnList>(list) && std::get<ColumnList>(list).has_names();
}

} // namespace

LikelyKey::LikelyKey(const std::array<const Layout*, 2>& layouts) : layouts_(layouts) {
    const auto is_free = [this](std::size_t side, std::size_t at) {
        const std::vector<std::size_t>& positions = layouts_.at(side)->positions;
        return !positions.empty() && std::ranges::count(positions, at) == 0;
    };
    const std::vector<std::string>& names = layouts[0]->names;
    const std::vector<std::string>& others = layouts[1]->names;
    const auto add = [&](std::size_t at) { // --key takes no name that stands twice
        const auto other = static_cast<std::size_t>(std::ranges::find(others, names[at]) - others.begin());
        if (std::ranges::count(names, names[at]) == 1 && std::ranges::count(others, names[at]) == 1 && is_free(0, at) &&
            is_free(1, other) && is_name(names[at])) {
            columns_.push_back({.text = names[at], .at = {at, other}});
        }
    };
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (is_time(names[i])) {
            add(i);
        }
    }
    if (!names.empty() && !is_time(names[0])) {
        add(0);
    }
    if (columns_.empty() && is_free(0, 0) && is_free(1, 0)) {
        columns_.push_back({.text = "1"});
    }
}

void LikelyKey::add(const std::array<std::string_view, 2>& rows) {
    if (columns_.empty() || pairs_ == most_pairs) {
        return;
    }
    for (std::size_t side = 0; side < rows.size(); ++side) {
        fields_.at(side).clear();
        static_cast<void>(layouts_.at(side)->delimiter.split(rows.at(side), fields_.at(side)));
    }
    std::erase_if(columns_, [this](Column& column) {
        const std::array last = column.last;
        for (std::size_t side = 0; side < last.size(); ++side) {
            const auto& fields = fields_.at(side);
            const std::size_t at = column.at.at(side);
            const Delimiter delimiter = layouts_.at(side)->delimiter;
            const ReadKey key = read_key(at < fields.size() ? delimiter.text_of(fields[at]) : std::string_view());
            if (key.error != KeyError::none || (pairs_ > 0 && key.value <= last.at(side))) {
                return true;
            }
            column.last.at(side) = key.value;
        }
        column.differs = column.differs || column.last[0] != column.last[1];
        return false;
    });
    ++pairs_;
}

std::optional<std::string> LikelyKey::found() const {
    const auto column = std::ranges::find(columns_, true, &Column::differs);
    return pairs_ > 1 && column != columns_.end() ? std::optional(column->text) : std::nullopt;
}

} // namespace rotconv::stream
