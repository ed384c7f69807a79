#include "arguments.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include <CLI/CLI.hpp>

#include "../stream/fmt.hpp"
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

bool takes_argument(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

/// What a word that begins with a dash says: `--long`, `--long=argument`, `-x` or `-x` with its argument behind it, or
/// a cluster of flags `-ab` whose last may be such an option.
struct OptionWord {
    const CLI::Option* option = nullptr; ///< null: unknown, or nothing but flags
    std::string flags;                   ///< of a cluster, those before it, with their dash
    std::optional<std::string> argument; ///< in the same word
};

OptionWord read_option(const CLI::App& app, const std::string& word) {
    if (word.starts_with("--")) {
        const auto equals = word.find('=');
        OptionWord read{.option = app.get_option_no_throw(word.substr(0, equals)), .flags = {}, .argument = {}};
        if (equals != std::string::npos) {
            read.argument = word.substr(equals + 1);
        }
        return read;
    }
    for (std::size_t i = 1; i < word.size(); ++i) {
        const CLI::Option* option = app.get_option_no_throw(std::string{'-', word[i]});
        if (option != nullptr && takes_argument(*option)) {
            OptionWord read{.option = option, .flags = i > 1 ? word.substr(0, i) : std::string(), .argument = {}};
            if (i + 1 < word.size()) {
                read.argument = word.substr(i + 1);
            }
            return read;
        }
    }
    return {};
}

} // namespace

// NOLINTNEXTLINE(misc-no-recursion): likewise
Arguments sort_arguments(const CLI::App& app, int argc, const char* const* argv, const AddCommand& add_command) {
    Arguments sorted;
    std::vector<const CLI::Option*> given;
    const auto add_option = [&](const CLI::Option& option, const std::string& argument) {
        const std::string name = option.get_name();
        if (std::ranges::count(given, &option) != 0) {
            sorted.error = name + " is given twice";
        } else if (argument.empty()) {
            sorted.error = name + " has an empty argument";
        }
        given.push_back(&option);
        sorted.options.push_back(fmt::format("{}={}", name, argument));
    };
    bool only_operands = false;
    for (int i = 1; i < argc; ++i) {
        std::string word = argv[i];
        const bool is_value = begins_with_number(word);
        if (only_operands || is_value || word.empty() || word[0] != '-' || word == "-") {
            const bool may_name = add_command && sorted.values.empty() && sorted.files.empty() && !only_operands;
            const CLI::App* command = may_name && !is_value ? add_command(word) : nullptr;
            if (command != nullptr) {
                Arguments after = sort_command(*command, argc - i, argv + i);
                after.options.insert(after.options.begin(), sorted.options.begin(), sorted.options.end());
                after.error = sorted.error.empty() ? after.error : sorted.error;
                return after;
            }
            (is_value ? sorted.values : sorted.files).push_back(std::move(word));
            continue;
        }
        if (word == "--") {
            only_operands = true;
            continue;
        }
        const OptionWord read = read_option(app, word);
        if (read.option == nullptr) {
            sorted.options.push_back(std::move(word));
        } else if (!takes_argument(*read.option)) {
            if (read.argument) {
                sorted.error = read.option->get_name() + " takes no argument";
            }
            sorted.options.push_back(read.option->get_name());
        } else {
            if (!read.flags.empty()) {
                sorted.options.push_back(read.flags);
            }
            if (!read.argument && i + 1 == argc) {
                sorted.error = read.option->get_name() + " awaits its argument";
                break;
            }
            add_option(*read.option, read.argument ? *read.argument : argv[++i]);
        }
    }
    return sorted;
}

} // namespace rotconv::cli
