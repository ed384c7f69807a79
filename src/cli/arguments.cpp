#include "arguments.hpp"

#include <algorithm>
#include <optional>

#include "../stream/fmt.hpp"
#include "../stream/number_text.hpp"

namespace rotconv::cli {
namespace {

bool begins_with_number(std::string_view word) {
    const auto text = word.substr(0, word.find_first_of(",;\t ", word.find_first_not_of(" \t")));
    return stream::is_number(text);
}

/// What a word that begins with a dash says: `--long`, `--long=argument`, `-x` or `-x` with its argument behind it, or
/// a cluster of flags `-ab` whose last may be such an option.
struct OptionWord {
    const Option* option = nullptr;        ///< null: unknown, or nothing but flags
    std::string flags{};                   ///< of a cluster, those before it, with their dash
    std::optional<std::size_t> argument{}; ///< where in the same word it begins
};

OptionWord read_option(const OptionSet& options, const std::string& word) {
    if (word.starts_with("--")) {
        const auto equals = word.find('=');
        const bool has_argument = equals != std::string::npos;
        return {.option = options.find(word.substr(0, equals)),
                .argument = has_argument ? std::optional(equals + 1) : std::nullopt};
    }
    for (std::size_t i = 1; i < word.size(); ++i) {
        const Option* option = options.find(std::string{'-', word[i]});
        if (option != nullptr && option->takes_argument()) {
            return {.option = option,
                    .flags = i > 1 ? word.substr(0, i) : std::string(),
                    .argument = i + 1 < word.size() ? std::optional(i + 1) : std::nullopt};
        }
    }
    return {};
}

} // namespace

Arguments sort_arguments(const OptionSet& options, const std::vector<std::string>& words, std::size_t begin,
                         const std::function<bool(std::string_view)>& is_command) {
    Arguments sorted{.end = words.size()};
    std::vector<const Option*> given;
    bool only_operands = false;
    for (std::size_t i = begin; i < words.size(); ++i) {
        const std::string& word = words[i];
        const bool is_value = begins_with_number(word);
        if (options.takes_operands()) {
            sorted.options.push_back(word);
            continue;
        }
        if (only_operands || is_value || word.empty() || word[0] != '-' || word == "-") {
            if (!only_operands && !is_value && sorted.values.empty() && sorted.files.empty() && is_command(word)) {
                sorted.end = i;
                break;
            }
            (is_value ? sorted.values : sorted.files).push_back(word);
            if (!is_value) {
                sorted.file_words.push_back({i, 0});
            }
            continue;
        }
        if (word == "--") {
            only_operands = true;
            continue;
        }
        const OptionWord read = read_option(options, word);
        if (read.option == nullptr) {
            sorted.options.push_back(word);
        } else if (!read.option->takes_argument()) {
            if (read.argument) {
                sorted.error = read.option->name() + " takes no argument";
            }
            sorted.options.push_back(read.option->name());
        } else {
            const std::string name = read.option->name();
            if (!read.flags.empty()) {
                sorted.options.push_back(read.flags);
            }
            if (!read.argument && i + 1 == words.size()) {
                sorted.error = name + " awaits its argument";
                break;
            }
            const FileWord place = read.argument ? FileWord{i, *read.argument} : FileWord{++i, 0};
            const std::string argument = words[place.word].substr(place.begin);
            if (std::ranges::count(given, read.option) != 0) {
                sorted.error = name + " is given twice";
            } else if (argument.empty()) {
                sorted.error = name + " has an empty argument";
            }
            if (name == "--input") {
                sorted.file_words.push_back(place);
            }
            given.push_back(read.option);
            sorted.options.push_back(fmt::format("{}={}", name, argument));
        }
    }
    return sorted;
}

} // namespace rotconv::cli
