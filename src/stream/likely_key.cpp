#include "likely_key.hpp"

#include <algorithm>

namespace rotconv::stream {

LikelyKey::LikelyKey(const std::array<const Layout*, 2>& layouts) : layouts_(layouts) {
    const auto is_free = [this](std::size_t side, std::size_t at) {
        const std::vector<std::size_t>& positions = layouts_.at(side)->positions;
        return !positions.empty() && std::ranges::count(positions, at) == 0;
    };
    const std::vector<std::string>& names = layouts[0]->names;
    const std::vector<std::string>& others = layouts[1]->names;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto j = static_cast<std::size_t>(std::ranges::find(others, names[i]) - others.begin());
        if (j < others.size() && !names[i].empty() && is_free(0, i) && is_free(1, j)) {
            columns_.push_back({.text = names[i], .at = {i, j}});
        }
    }
    if (columns_.empty() && is_free(0, 0) && is_free(1, 0)) {
        columns_.push_back({.text = "1"});
    }
}

std::string_view LikelyKey::field(std::size_t side, std::string_view row, std::size_t at) {
    const Delimiter delimiter = layouts_.at(side)->delimiter;
    if (at == 0 && !row.empty() && row.front() != '"' && row.front() != ' ') { // as most keys stand
        const auto ends = [delimiter](char c) { return c == delimiter.text() || (c == '\t' && delimiter.is_blanks()); };
        return {row.begin(), std::ranges::find_if(row, ends)};
    }
    fields_.clear();
    static_cast<void>(delimiter.split(row, fields_));
    return at < fields_.size() ? fields_[at] : std::string_view();
}

void LikelyKey::add(const std::array<std::string_view, 2>& rows) {
    if (columns_.empty() || (++pairs_ > close_pairs && pairs_ % 16 != 0)) {
        return;
    }
    std::erase_if(columns_, [this, &rows](Column& column) {
        const std::array texts{field(0, rows[0], column.at[0]), field(1, rows[1], column.at[1])};
        if (pairs_ > first_pairs && texts[0] == texts[1]) {
            return false;
        }
        bool increases = true;
        for (const std::size_t side : {0U, 1U}) {
            const ReadKey time = read_key(layouts_.at(side)->delimiter.text_of(texts.at(side)));
            increases = increases && time.error == KeyError::none && (pairs_ == 1 || time.value > column.last.at(side));
            column.last.at(side) = time.value;
        }
        if (increases && pairs_ > 1 && column.last[0] != column.last[1]) {
            found_ = found_.value_or(column.text);
        }
        return !increases;
    });
    if (found_) {
        columns_.clear();
    }
}

} // namespace rotconv::stream
