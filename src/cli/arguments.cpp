#include "arguments.hpp"

#include <string_view>

#include <fmt/format.h>

#include "../stream/number_text.hpp"

namespace rotconv::cli {
namespace {

bool begins_with_number(std::string_view word) {
    const auto text = word.substr(0, word.find_first_of(",;\t ", word.find_first_not_of(" \t")));
    return stream::is_number(text);
}

/// The words of a command, of which the first is its name. Where it names its arguments itself they are no VALUEs.
// NOLINTNEXTLINE(misc-no-recursion): a command has no commands
Arguments sort_command(const CLI::App& command, int argc, const char* const* argv) {
    const auto named = command.get_options([](const CLI::Option* option) { return option->get_positional(); });
    Arguments sorted;
    if (named.empty()) {
        sorted = sort_arguments(command, argc, argv, {});
    } else {
        sorted.options.assign(argv + 1, argv + argc);
    }
    sorted.options.insert(sorted.options.begin(), argv[0]);
    sorted.command = argv[0];
    return sorted;
}

bool takes_argument(const CLI::App& app, const std::string& name) {
    const CLI::Option* option = app.get_option_no_throw(name);
    return option != nullptr && option->get_items_expected_max() > 0;
}

/// For `-x` or a cluster `-ab`: the last letter, where it is an option that awaits an argument; "" otherwise.
std::string awaiting_short(const CLI::App& app, const std::string& word) {
    for (std::size_t i = 1; i < word.size(); ++i) {
        const std::string name{'-', word[i]};
        if (takes_argument(app, name)) {
            return i + 1 == word.size() ? name : std::string();
        }
    }
    return {};
}

} // namespace

// NOLINTNEXTLINE(misc-no-recursion): likewise
Arguments sort_arguments(const CLI::App& app, int argc, const char* const* argv, const AddCommand& add_command) {
    Arguments sorted;
    bool only_values = false;
    for (int i = 1; i < argc; ++i) {
        std::string word = argv[i];
        const bool is_value = only_values || begins_with_number(word) || word.empty() || word[0] != '-' || word == "-";
        if (is_value) {
            const bool may_name = add_command && sorted.values.empty() && !only_values;
            const CLI::App* command = may_name ? add_command(word) : nullptr;
            if (command != nullptr) {
                Arguments after = sort_command(*command, argc - i, argv + i);
                after.options.insert(after.options.begin(), sorted.options.begin(), sorted.options.end());
                return after;
            }
            sorted.values.push_back(std::move(word));
            continue;
        }
        if (word == "--") {
            only_values = true;
            continue;
        }
        const bool is_long = word.starts_with("--");
        if (is_long && word.find('=') + 1 == word.size()) {
            sorted.empty_option = word.substr(0, word.size() - 1);
        }
        const std::string name =
            is_long ? (takes_argument(app, word) ? word : std::string()) : awaiting_short(app, word);
        if (name.empty() || i + 1 == argc) {
            sorted.options.push_back(std::move(word));
            continue;
        }
        if (!is_long && word.size() > 2) {
            sorted.options.push_back(word.substr(0, word.size() - 1)); // the flags of the cluster
        }
        const std::string long_name = "--" + app.get_option(name)->get_lnames().front();
        const std::string argument = argv[++i];
        if (argument.empty()) {
            sorted.empty_option = long_name;
        }
        sorted.options.push_back(fmt::format("{}={}", long_name, argument));
    }
    return sorted;
}

} // namespace rotconv::cli
