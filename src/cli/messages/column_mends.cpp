#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../grammar/column_names.hpp"
#include "answers.hpp"

namespace rotconv::cli {
namespace {

/// The names from one to another that differ in a number or a letter alone, such as q0-q3 and rvec_x:rvec_z.
std::vector<std::string> names_between(const std::string& first, const std::string& last) {
    constexpr int most = 16;
    const auto [differ, other] = std::ranges::mismatch(first, last);
    const auto begin = static_cast<std::size_t>(differ - first.begin());
    const std::string_view rest = std::string_view(first).substr(begin);
    const std::string_view rest_of_last = std::string_view(last).substr(begin);
    const auto [back, other_back] =
        std::mismatch(rest.rbegin(), rest.rend(), rest_of_last.rbegin(), rest_of_last.rend());
    const auto size = static_cast<std::size_t>(rest.rend() - back);
    const std::string from(rest.substr(0, size));
    const std::string to(rest_of_last.substr(0, static_cast<std::size_t>(rest_of_last.rend() - other_back)));
    const bool are_indices =
        is_digits(from) && is_digits(to) && from.size() < 3 && to.size() < 3 && (from[0] != '0' || from.size() == 1);
    const auto is_letter = [](const std::string& text) {
        return text.size() == 1 && is_alphanumeric(text[0]) && !is_digits(text);
    };
    const bool are_letters = is_letter(from) && is_letter(to);
    if ((!are_indices && !are_letters) || begin == 0) {
        return {};
    }
    const int lowest = are_indices ? std::stoi(from) : from[0];
    const int highest = are_indices ? std::stoi(to) : to[0];
    std::vector<std::string> names;
    for (int each = lowest; each <= highest && highest - lowest < most; ++each) {
        names.push_back(first.substr(0, begin) +
                        (are_indices ? fmt::to_string(each) : std::string(1, static_cast<char>(each))));
        names.back() += rest.substr(size);
    }
    return names;
}

/// A LIST with all names where it has a range of them; the same without.
std::vector<std::string> without_ranges(const std::vector<std::string_view>& items) {
    constexpr std::size_t longest = 200;
    std::vector<std::string> names;
    for (const std::string_view item : items) {
        std::vector<std::string> between;
        for (auto at = item.size() < longest ? item.find_first_of("-:") : std::string_view::npos;
             at != std::string_view::npos && between.empty(); at = item.find_first_of("-:", at + 1)) {
            between = is_digits(item.substr(0, at))
                          ? between
                          : names_between(std::string(item.substr(0, at)), std::string(item.substr(at + 1)));
        }
        between = between.empty() ? std::vector<std::string>{std::string(item)} : between;
        names.insert(names.end(), between.begin(), between.end());
    }
    return names;
}

/// Those of the names that are the numbers of a row; empty if these are not all there.
std::vector<std::string> names_of_numbers(std::vector<std::string> names, const stream::RowNumbers& numbers) {
    std::vector<std::string> chosen;
    for (const Part& part : parts_of(numbers)) {
        const auto time = std::ranges::find_if(names, is_name_of_time);
        auto known = find_names(part, names);
        if (part.is_kept && time != names.end()) {
            known = KnownNames{{static_cast<std::size_t>(time - names.begin())}};
        }
        if (!known) {
            return {};
        }
        for (const std::size_t place : known->places) {
            chosen.push_back(std::exchange(names[place], ""));
        }
    }
    return chosen;
}

/// The column of times in the FILE: the only one with such a name; without a header the first, if the others follow it.
std::string column_of_time(const CommandOptions& options, const std::vector<std::string_view>& items) {
    const auto bytes = first_bytes(options.file());
    const auto rows = bytes ? simple_rows(*bytes) : std::nullopt;
    if (!rows || (!rows->has_header() && !items[0].starts_with('2'))) {
        return "";
    }
    const auto time = std::ranges::find_if(rows->names, is_name_of_time);
    if (std::ranges::count_if(rows->names, is_name_of_time) > 1 || (rows->has_header() && time == rows->names.end())) {
        return "";
    }
    return is_digits(items[0].substr(0, 1)) ? fmt::to_string(time - rows->names.begin() + 1) : *time;
}

} // namespace

std::vector<Mend> column_mends(const CommandOptions& options, const Option& option, const stream::RowNumbers& numbers,
                               std::size_t count) {
    const auto items = split(option.text(), ',');
    const auto names = without_ranges(items);
    const auto with = [&option](const std::vector<std::string>& list) {
        return std::vector<Mend>{{{OptionSet::changing(option, joined(list))}}};
    };
    if (names.size() != items.size()) {
        return with(names);
    }
    const bool has_indices = std::ranges::any_of(items, is_digits);
    if (count > numbers.names.size()) { // also those of other numbers
        const auto own = has_indices ? std::vector<std::string>() : names_of_numbers(names, numbers);
        return own.empty() ? std::vector<Mend>() : with(own);
    }
    if (options.missing("--differences") != nullptr && numbers.attitude &&
        find_names(*numbers.attitude, names)) { // of attitudes alone, perhaps with a time
        return {{{{{Edit::at_end}, 0, {"--differences"}}}}};
    }
    const std::string time = numbers.kept + count == numbers.names.size() ? column_of_time(options, items) : "";
    if (time.empty() || std::ranges::count(names, time) > 0) {
        return {};
    }
    auto longer = names;
    longer.insert(longer.begin(), time);
    return with(longer);
}

} // namespace rotconv::cli
