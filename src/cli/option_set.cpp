#include "option_set.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include <CLI/CLI.hpp>

#include "../stream/file.hpp"
#include "values.hpp"

namespace rotconv::cli {
namespace {

/// Of the parts of CLI11's help those that it knows: the options.
class Formatter : public CLI::Formatter {
public:
    std::string make_usage(const CLI::App* /*app*/, std::string /*name*/) const override { return {}; }
};

/// CLI11 keeps in `option` what is given.
void define(CLI::App& app, Option& option) {
    app.option_defaults()->group(std::string(option.group));
    const std::string names(option.names);
    const std::string about(option.about);
    if (option.takes_argument()) {
        app.add_option(names, option.given, about)->type_name(std::string(option.argument));
    } else {
        app.add_flag_callback(
            names, [&option] { option.given = option.name(); }, about);
    }
}

/// Such as -90deg and -pi/2, which are not options.
bool resembles_number(std::string_view word) {
    return word.find_first_of("0123456789.") == 1 || word.starts_with("-pi");
}

} // namespace

Option* OptionSet::find(std::string_view name) {
    const auto found = std::ranges::find_if(
        options_, [&](const Option& option) { return std::ranges::count(items_of(option.names), name) > 0; });
    return found == options_.end() ? nullptr : &*found;
}

const std::string& OptionSet::text(std::string_view name) const {
    static const std::string none;
    const auto found = std::ranges::find(options_, name, &Option::name);
    return found == options_.end() ? none : found->given;
}

std::vector<std::string> OptionSet::texts(std::string_view name) const {
    const auto found = std::ranges::find(options_, name, &Option::name);
    if (found == options_.end() || found->given.empty()) {
        return {};
    }
    std::vector<std::string> all{found->given};
    all.insert(all.end(), found->more.begin(), found->more.end());
    return all;
}

std::string OptionSet::help() const {
    CLI::App app;
    app.set_help_flag();
    app.formatter(std::make_shared<Formatter>());
    auto options = options_;
    std::ranges::for_each(options, [&app](Option& option) { define(app, option); });
    std::vector<std::string> names;
    if (takes_names()) {
        app.add_option("NAME", names, std::string(names_))->type_name("");
    }
    std::string help = app.help();
    for (auto at = help.find("\n\n\n"); at != std::string::npos; at = help.find("\n\n\n")) {
        help.erase(at, 1); // CLI11 ends a group with two
    }
    help.erase(help.find_last_not_of('\n') + 2);
    return help;
}

Arguments OptionSet::read(const std::vector<std::string>& words, std::size_t begin,
                          const std::function<bool(std::string_view)>& is_command,
                          const std::function<bool(std::string_view)>& has_meaning) {
    Arguments read;
    std::vector<Option*> given;
    std::vector<std::string> option_words;
    std::size_t at = begin;
    /// Takes an option; `begin_of_argument`: where in the same word its argument stands, or npos.
    const auto take = [&](Option* option, const std::string& written, std::size_t begin_of_argument) {
        if (option == nullptr) {
            read.unknown = read.unknown.empty() ? written : read.unknown;
            return;
        }
        const std::string name(option->name());
        const bool is_joined = begin_of_argument != std::string::npos;
        read.first_option = read.first_option.empty() ? name : read.first_option;
        const bool is_second = std::ranges::count(given, option) != 0;
        if (!is_second) {
            given.push_back(option);
        }
        if (!option->takes_argument()) {
            option_words.push_back(name);
            read.error = is_joined ? name + " takes no argument" : read.error;
            return;
        }
        if (!is_joined && (at + 1 == words.size() || words[at + 1].starts_with("--"))) {
            throw Usage("{} needs {}: {}", name, option->argument, option->about);
        }
        const FileWord place = is_joined ? FileWord{at, begin_of_argument} : FileWord{++at, 0};
        const std::string argument = words[place.word].substr(place.begin);
        if (is_second && option->repeats) {
            option->more.push_back(argument);
        } else {
            option_words.push_back(name + "=" + argument);
        }
        if (is_second && !option->repeats) {
            read.error = name + " is given twice";
        } else if (argument.empty()) {
            read.error = name + " has an empty argument";
        }
        if (name == "--input") {
            read.file_words.push_back(place);
        }
    };

    std::vector<std::string> operands; // FILEs and VALUEs in their order
    bool only_operands = false;
    for (; at < words.size(); ++at) {
        const std::string& word = words[at];
        const bool is_number = is_value(word);
        if (only_operands || is_number || !word.starts_with('-') || word == "-" || resembles_number(word)) {
            const bool takes_value = is_number && !takes_names();
            if (!only_operands && !takes_value && read.values.empty() && read.files.empty() && is_command(word)) {
                break;
            }
            (takes_value ? read.values : read.files).push_back(word);
            operands.push_back(word);
            if (!takes_value) {
                read.file_words.push_back({at, 0});
            }
        } else if (word == "--") {
            only_operands = true;
        } else if (word.starts_with("--")) {
            const auto equals = word.find('=');
            take(find(word.substr(0, equals)), word, equals == std::string::npos ? equals : equals + 1);
        } else { // flags, of which the last may be an option with its argument
            bool is_flag = true;
            for (std::size_t i = 1; is_flag && i < word.size(); ++i) {
                Option* const option = find(std::string{'-', word[i]});
                is_flag = option == nullptr || !option->takes_argument();
                take(option, "-" + word.substr(i), is_flag || i + 1 == word.size() ? std::string::npos : i + 1);
            }
        }
    }
    read.end = at;
    const auto is_word = [&has_meaning](const std::string& file) {
        return stream::File::why_unreadable(file.c_str()) != 0 && !has_meaning(file);
    };
    if (!takes_names() && !only_operands && !read.files.empty() &&
        (!read.values.empty() || std::ranges::any_of(read.files, holds_number)) &&
        std::ranges::all_of(read.files, is_word)) {
        read.values = std::move(operands);
        read.files.clear();
    }
    if (read.error.empty()) {
        CLI::App app; // it knows the given ones alone: to define all of them took half of a start
        app.set_help_flag();
        std::ranges::for_each(given, [&app](Option* option) { define(app, *option); });
        std::ranges::reverse(option_words); // as CLI11 wants them
        try {
            app.parse(option_words);
        } catch (const CLI::ParseError& error) {
            read.error = error.what();
        }
    }
    return read;
}

} // namespace rotconv::cli
