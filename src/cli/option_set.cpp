#include "option_set.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include <CLI/CLI.hpp>

#include "../core/projects.hpp"
#include "../stream/bytes/file.hpp"
#include "grammar/value_text.hpp"
#include "grammar/values.hpp"
#include "messages/messages.hpp"

namespace rotconv::cli {
namespace {

/// Prints the part of CLI11's help that lists the options. Those that another help describes alike are only named.
class Formatter : public CLI::Formatter {
public:
    Formatter(const OptionSet& own, const OptionSet* other) : own_(&own), other_(other) {}

    std::string make_usage(const CLI::App* /*app*/, std::string /*name*/) const override { return {}; }
    std::string make_group(std::string group, bool is_positional,
                           std::vector<const CLI::Option*> options) const override {
        std::string shared;
        std::erase_if(options, [&](const CLI::Option* option) {
            const std::string name = option->get_name();
            const Option* const own = own_->find(name);
            const Option* const other = other_ == nullptr || name == "--help" ? nullptr : other_->find(name);
            const bool is_shared = other != nullptr && other->argument == own->argument && other->about == own->about;
            shared += is_shared ? " " + name : "";
            return is_shared;
        });
        return CLI::Formatter::make_group(std::move(group), is_positional, std::move(options)) +
               (shared.empty() ? "" : fmt::format("  shared:{}\n", shared));
    }

private:
    const OptionSet* own_;
    const OptionSet* other_;
};

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
           (std::ranges::count(word, '2') == 1 && std::ranges::all_of(word, is_alphanumeric)) ||
           word.find("-to-") != std::string_view::npos;
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
    CLI::App app; // it only prints: to define all options takes it as long as the rest of a start
    app.set_help_flag();
    app.formatter(std::make_shared<Formatter>(*this, other));
    std::string unused;
    for (const Option* option : options_) {
        app.option_defaults()->group(std::string(option->group));
        app.add_option(std::string(option->names), unused, std::string(option->about))
            ->type_name(std::string(option->argument));
    }
    if (takes_names()) {
        app.add_option("NAME", unused, std::string(names_))->type_name("")->expected(1, -1);
    }
    std::string help = app.help();
    for (auto at = help.find("\n\n\n"); at != std::string::npos; at = help.find("\n\n\n")) {
        help.erase(at, 1); // CLI11 ends a group with two
    }
    help.erase(help.find_last_not_of('\n') + 2);
    return help;
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
        const bool has_own = !known.argument.empty();
        first_option = first_option.empty() ? name : first_option;
        std::string argument = has_own ? std::string(known.argument) : name;
        if (has_own || !option->takes_argument()) {
            option->place = {at, 0};
            misuse = is_joined ? fmt::format("{} takes no argument", has_own ? known.text : name) : misuse;
        } else if (!is_joined && (at + 1 == words.size() || words[at + 1].starts_with("--"))) {
            throw Usage("{} needs {}: {}", name, option->argument, option->about);
        } else {
            option->place = is_joined ? WordEnd{at, begin_of_argument} : WordEnd{++at, 0};
            argument = words[option->place.word].substr(option->place.begin);
            misuse = argument.empty() ? name + " has an empty argument" : misuse;
        }
        if (option->given() && option->takes_argument() && !option->repeats && !(has_own && is_joined)) {
            misuse = name + " is given twice";
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
