#include "option_set.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "../core/projects.hpp"
#include "../stream/bytes/file.hpp"
#include "grammar/value_text.hpp"
#include "grammar/values.hpp"
#include "messages/messages.hpp"

namespace rotconv::cli {
namespace {

/// Such as -90deg and -pi/2, which are not options, nor are dashes before a blank or line end: "---\nx: 0".
bool resembles_number(std::string_view word) {
    const auto after = word.find_first_not_of('-');
    return word.find_first_of("0123456789.") == 1 || word.starts_with("-pi") ||
           (after != std::string_view::npos && word.find_first_of(" \t\r\n") == after);
}

/// Other names of options, some with their argument.
struct SecondName {
    std::string_view text, option, argument;
};
constexpr auto second_names = std::to_array<SecondName>({{"--deg", "--degrees", ""},
                                                         {"--cols", "--columns", ""},
                                                         {"-c", "--columns", ""},
                                                         {"--prec", "--precision", ""},
                                                         {"--json", "--format", "json"},
                                                         {"--quiet", "--diagnostics", "off"},
                                                         {"-q", "--diagnostics", "off"}});

/// Whether a word that is no file is one of the program's language: a verb, a SPEC, rpy2quat.
bool has_meaning(std::string_view word) {
    if (word.size() < 2 || !std::ranges::all_of(word, [](char c) { return is_alphanumeric(c) || c == '-'; })) {
        return false; // the label of a number
    }
    return messages::is_verb(word) || messages::is_spec(word) || find_project(word) != nullptr ||
           (std::ranges::count(word, '2') == 1 && std::ranges::all_of(word, is_alphanumeric));
}

SecondName second_name(std::string_view name) {
    const auto* const found = std::ranges::find(second_names, name, &SecondName::text);
    return found == second_names.end() ? SecondName{name, name, ""} : *found;
}

} // namespace

const std::string& Option::text() const noexcept {
    static const std::string none;
    return texts.empty() ? none : texts.front();
}

Option* OptionSet::find(std::string_view name) const {
    const auto found = std::ranges::find_if(options_, [name](const Option* option) {
        return name == option->name() || name == option->names.substr(0, option->names.find(','));
    });
    return found == options_.end() ? nullptr : *found;
}

bool OptionSet::knows(std::string_view name) const { return find(second_name(name).option) != nullptr; }

Mend OptionSet::with_values(const std::vector<std::string>& instead) const {
    Mend mend{mapped(value_words, [](const WordEnd& word) { return Edit{word}; })};
    if (!instead.empty()) {
        mend.edits.push_back({{Edit::at_end}, 0, instead});
    }
    return mend;
}

Edit OptionSet::changing(const Option& option, const std::string& argument) {
    const bool is_joined = option.place.begin > 0;
    return argument.empty() ? Edit{{option.place.word - (is_joined ? 0 : 1)}, is_joined ? std::size_t{1} : 2}
                            : Edit{option.place, 1, {argument}};
}

std::string OptionSet::help(const OptionSet* other) const {
    const auto line = [](const std::string& names, std::string_view about) {
        return fmt::format("  {:<28}{}\n", names, about);
    };
    std::string text = takes_names() ? "\nPositionals:\n" + line("NAME ...", names_) : "";
    std::vector<std::string_view> groups; // in the order of their first options
    for (const Option* option : options_) {
        if (std::ranges::count(groups, option->group) == 0) {
            groups.push_back(option->group);
        }
    }
    for (const std::string_view group : groups) {
        text += fmt::format("\n{}:\n", group);
        std::string shared;
        for (const Option* option : filtered(options_, [group](const Option* each) { return each->group == group; })) {
            const Option* const same = other == nullptr ? nullptr : other->find(option->name());
            if (same != nullptr && option->name() != "--help" && same->argument == option->argument &&
                same->about == option->about) {
                shared += fmt::format(" {}", option->name());
            } else {
                text +=
                    line(fmt::format("{}{}{}", option->names, option->takes_argument() ? " " : "", option->argument),
                         option->about);
            }
        }
        text += shared.empty() ? "" : fmt::format("  shared:{}\n", shared);
    }
    return text;
}

std::size_t OptionSet::read(const std::vector<std::string>& all_words, std::size_t first,
                            const std::function<bool(std::string_view)>& is_command) {
    std::size_t at = first;
    words = all_words;
    begin = first;
    /// Takes an option; `begin_of_argument`: where in the same word its argument stands, or npos.
    const auto take = [&](const SecondName& known, const std::string& written, std::size_t begin_of_argument) {
        Option* const option = find(known.option);
        if (option == nullptr) {
            if (unknown.empty()) {
                unknown = written;
                unknown_place = {at, 0};
            }
            return;
        }
        const std::string name(option->name());
        const bool is_joined = begin_of_argument != std::string::npos;
        first_option = first_option.empty() ? name : first_option;
        if (!known.argument.empty()) {
            misuse = is_joined         ? fmt::format("{} takes no argument", known.text)
                     : option->given() ? name + " is given twice"
                                       : misuse;
            option->texts.emplace_back(known.argument);
            option->place = {at, 0};
            return;
        }
        if (!option->takes_argument()) {
            option->texts = {name};
            misuse = is_joined ? name + " takes no argument" : misuse;
            return;
        }
        if (!is_joined && (at + 1 == words.size() || words[at + 1].starts_with("--"))) {
            throw Usage("{} needs {}: {}", name, option->argument, option->about);
        }
        option->place = is_joined ? WordEnd{at, begin_of_argument} : WordEnd{++at, 0};
        const std::string argument = words[option->place.word].substr(option->place.begin);
        if (option->given() && !option->repeats) {
            misuse = name + " is given twice";
        } else if (argument.empty()) {
            misuse = name + " has an empty argument";
        }
        option->texts.push_back(argument);
    };

    std::vector<std::pair<std::size_t, bool>> operands; // words, and whether they are VALUEs
    bool only_operands = false;
    for (; at < words.size(); ++at) {
        const std::string& word = words[at];
        const bool is_number = is_value(word);
        if (only_operands || is_number || !word.starts_with('-') || word == "-" || resembles_number(word) ||
            (!word.starts_with("--") && word.find_first_of("([{") != std::string::npos)) { // -Quaternion(...)
            const bool takes_value = is_number && !takes_names();
            if (!only_operands && !takes_value && operands.empty() && is_command(word)) {
                break;
            }
            operands.emplace_back(at, takes_value);
        } else if (word == "--") {
            only_operands = true;
        } else if (word.starts_with("--")) {
            const auto equals = word.find('=');
            take(second_name(std::string_view(word).substr(0, equals)), word,
                 equals == std::string::npos ? equals : equals + 1);
        } else { // flags, of which the last may be an option with its argument
            bool is_flag = true;
            for (std::size_t i = 1; is_flag && i < word.size(); ++i) {
                const std::string letter{'-', word[i]};
                const SecondName known = second_name(letter);
                const Option* const option = find(known.option);
                is_flag = option == nullptr || !option->takes_argument() || !known.argument.empty();
                take(known, "-" + word.substr(i), is_flag || i + 1 == word.size() ? std::string::npos : i + 1);
            }
        }
    }
    const auto may_be_value = [&](const std::pair<std::size_t, bool>& operand) {
        const std::string& word = words[operand.first];
        return operand.second || (stream::File::why_unreadable(word.c_str()) != 0 && !has_meaning(word));
    };
    const auto holds_value = [this](const auto& each) { return each.second || holds_number(words[each.first]); };
    const bool are_values = !takes_names() && !only_operands && std::ranges::any_of(operands, holds_value) &&
                            std::ranges::all_of(operands, may_be_value);
    for (const auto& [place, is_own] : operands) {
        const bool is_one = is_own || are_values;
        (is_one ? values : files).push_back(words[place]);
        (is_one ? value_words : file_words).push_back({place, 0});
    }
    return at;
}

} // namespace rotconv::cli
