#include "option_set.hpp"

#include <algorithm>
#include <optional>

#include "../stream/fmt.hpp"
#include "../stream/number_text.hpp"

namespace rotconv::cli {
namespace {

bool begins_with_number(std::string_view word) {
    return stream::is_number(word.substr(0, word.find_first_of(",;\t ", word.find_first_not_of(" \t"))));
}

} // namespace

std::vector<std::string> Option::each_name() const {
    const auto comma = names.find(',');
    return comma == std::string::npos ? std::vector{names}
                                      : std::vector{names.substr(0, comma), names.substr(comma + 1)};
}

void OptionSet::add(std::string_view names, std::string& value, std::string_view argument, std::string_view about) {
    options_.push_back({std::string(names), std::string(argument), std::string(about), group_, &value});
}

void OptionSet::add(std::string_view names, bool& value, std::string_view about) {
    options_.push_back({std::string(names), {}, std::string(about), group_, &value});
}

void OptionSet::describe(std::string_view name, std::string_view about) {
    std::ranges::find(options_, name, &Option::name)->about = about;
}

const Option* OptionSet::find(std::string_view name) const {
    const auto found = std::ranges::find_if(
        options_, [&](const Option& option) { return std::ranges::count(option.each_name(), name) > 0; });
    return found == options_.end() ? nullptr : &*found;
}

std::string OptionSet::help() const {
    constexpr const char* line = "  {:<28}{}\n";
    std::string text = takes_names() ? fmt::format("\nPositionals:\n  {:<28}{}\n", "NAME ...", names_) : "";
    std::vector<std::string> groups;
    for (const Option& option : options_) {
        if (std::ranges::count(groups, option.group) == 0) {
            groups.push_back(option.group);
        }
    }
    for (const std::string& group : groups) {
        text += fmt::format("\n{}:\n", group);
        for (const Option& option : options_) {
            if (option.group == group) {
                text +=
                    fmt::format(fmt::runtime(line), fmt::format("{} {}", option.names, option.argument), option.about);
            }
        }
    }
    return text;
}

Arguments OptionSet::read(const std::vector<std::string>& words, std::size_t begin,
                          const std::function<bool(std::string_view)>& is_command) const {
    Arguments read;
    std::vector<const Option*> given;
    std::size_t at = begin;
    /// Sets the value of an option; `joined`: the argument that stands in the same word.
    const auto set = [&](const Option& option, std::optional<FileWord> joined) {
        const std::string name = option.name();
        read.first_option = read.first_option.empty() ? name : read.first_option;
        if (!option.takes_argument()) {
            *std::get<bool*>(option.value) = true;
            read.error = joined ? name + " takes no argument" : read.error;
            return;
        }
        if (!joined && at + 1 == words.size()) {
            read.error = name + " awaits its argument";
            return;
        }
        const FileWord place = joined ? *joined : FileWord{++at, 0};
        std::string& argument = *std::get<std::string*>(option.value);
        argument = words[place.word].substr(place.begin);
        if (std::ranges::count(given, &option) != 0) {
            read.error = name + " is given twice";
        } else if (argument.empty()) {
            read.error = name + " has an empty argument";
        }
        if (name == "--input") {
            read.file_words.push_back(place);
        }
        given.push_back(&option);
    };
    const auto miss = [&read](const std::string& word) { read.unknown = read.unknown.empty() ? word : read.unknown; };

    bool only_operands = false;
    for (; at < words.size(); ++at) {
        const std::string& word = words[at];
        const bool is_number = begins_with_number(word);
        if (only_operands || is_number || !word.starts_with('-') || word == "-") {
            const bool is_value = is_number && !takes_names();
            if (!only_operands && !is_value && read.values.empty() && read.files.empty() && is_command(word)) {
                break;
            }
            (is_value ? read.values : read.files).push_back(word);
            if (!is_value) {
                read.file_words.push_back({at, 0});
            }
        } else if (word == "--") {
            only_operands = true;
        } else if (word.starts_with("--")) {
            const auto equals = word.find('=');
            const Option* option = find(word.substr(0, equals));
            option != nullptr
                ? set(*option, equals == std::string::npos ? std::nullopt : std::optional(FileWord{at, equals + 1}))
                : miss(word);
        } else { // flags, of which the last may be an option with its argument
            bool is_flag = true;
            for (std::size_t i = 1; is_flag && i < word.size(); ++i) {
                const Option* option = find(std::string{'-', word[i]});
                is_flag = option == nullptr || !option->takes_argument();
                const bool has_argument = !is_flag && i + 1 < word.size();
                option != nullptr ? set(*option, has_argument ? std::optional(FileWord{at, i + 1}) : std::nullopt)
                                  : miss("-" + word.substr(i));
            }
        }
    }
    read.end = std::min(at, words.size());
    return read;
}

} // namespace rotconv::cli
