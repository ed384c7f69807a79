#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../grammar/column_names.hpp"
#include "answers.hpp"
#include "messages.hpp"

namespace rotconv::cli::messages {
namespace {

constexpr std::string_view all_digits = "0123456789";

bool is_index(std::string_view text) {
    return !text.empty() && text.find_first_not_of(all_digits) == std::string_view::npos;
}

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
    const bool are_indices = is_index(from) && is_index(to) && to.size() < 3;
    const bool are_letters = from.size() == 1 && to.size() == 1 && is_alphanumeric(from[0]) && is_alphanumeric(to[0]);
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
    std::vector<std::string> names;
    for (const std::string_view item : items) {
        std::vector<std::string> between;
        for (auto at = item.find_first_of("-:"); at != std::string_view::npos && between.empty();
             at = item.find_first_of("-:", at + 1)) {
            between = is_index(item.substr(0, at))
                          ? between
                          : names_between(std::string(item.substr(0, at)), std::string(item.substr(at + 1)));
        }
        between = between.empty() ? std::vector<std::string>{std::string(item)} : between;
        names.insert(names.end(), between.begin(), between.end());
    }
    return names;
}

/// Those of the names that are the numbers of a row; empty if these are not all there.
std::vector<std::string> names_of_numbers(const std::vector<std::string>& names, const stream::RowNumbers& numbers) {
    std::vector<std::string> chosen;
    for (const Part& part : parts_of(numbers)) {
        const auto time = std::ranges::find_if(names, is_name_of_time);
        const auto known = part.is_kept ? std::nullopt : find_names(part, names);
        if (part.is_kept ? time == names.end() : !known) {
            return {};
        }
        const auto own = part.is_kept ? std::vector{*time} : known->of(names);
        chosen.insert(chosen.end(), own.begin(), own.end());
    }
    return chosen;
}

/// The column of times in the FILE: the only one with such a name, or else the first; empty if that is not known.
std::string column_of_time(const CommandOptions& options, bool are_indices) {
    const auto bytes = first_bytes(options.files.empty() ? options.input.text() : options.files[0]);
    const auto rows = bytes ? simple_rows(*bytes) : std::nullopt;
    const auto times = rows ? filtered(rows->names, is_name_of_time) : std::vector<std::string>();
    return are_indices ? "1" : times.size() == 1 ? times[0] : "";
}

} // namespace

std::vector<Mend> with_other_columns(const CommandOptions& options, const Option& option,
                                     const stream::RowNumbers& numbers, std::size_t count) {
    const auto items = split(option.text(), ',');
    const auto names = without_ranges(items);
    const auto with = [&option](const std::vector<std::string>& list) {
        return std::vector<Mend>{{{OptionSet::changing(option, joined(list))}}};
    };
    if (names.size() != items.size()) {
        return with(names);
    }
    const bool has_indices = std::ranges::any_of(items, is_index);
    if (count > numbers.names.size()) { // also those of other numbers
        const auto own = has_indices ? std::vector<std::string>() : names_of_numbers(names, numbers);
        return own.empty() ? std::vector<Mend>() : with(own);
    }
    const Option* const differences = options.find("--differences");
    if (differences != nullptr && !differences->given() && numbers.attitude && count <= numbers.attitude->size() + 1) {
        return {{{{{Edit::at_end}, 0, {"--differences"}}}}};
    }
    const bool are_indices =
        std::ranges::all_of(items, [](std::string_view item) { return is_index(item.substr(0, 1)); });
    const std::string time = numbers.kept + count == numbers.names.size() ? column_of_time(options, are_indices) : "";
    if (time.empty() || std::ranges::count(names, time) > 0) {
        return {};
    }
    auto longer = names;
    longer.insert(longer.begin(), time);
    return with(longer);
}

} // namespace rotconv::cli::messages
