#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "../core/projects.hpp"
#include "command.hpp"

namespace rotconv::cli {

std::string completions(std::span<const std::string> before, std::string word) {
    const auto table = command_table();
    auto options = table[0].options();
    const auto awaiting = [&options](const std::string& name) {
        const Option* const option = options->find(name);
        return option != nullptr && option->takes_argument() ? option : nullptr;
    };
    const Option* awaited = nullptr; // its argument is
    bool has_operand = false;
    for (const std::string& each : before) {
        if (awaited != nullptr) {
            awaited = nullptr;
        } else if (each.size() > 1 && each[0] == '-') {
            awaited = awaiting(each);
        } else if (!std::exchange(has_operand, true) && is_command(each)) {
            options = std::ranges::find(table, each, &CommandEntry::name)->options();
        }
    }
    std::string prefix; // of what is offered
    const auto split_behind = [&](std::size_t mark) {
        prefix += word.substr(0, mark + 1);
        word.erase(0, mark + 1);
    };
    if (const auto equals = word.find('=');
        awaited == nullptr && word.starts_with("--") && equals != std::string::npos) {
        awaited = awaiting(word.substr(0, equals));
        split_behind(equals);
    }
    if (awaited != nullptr && awaited->is_list) {
        split_behind(word.rfind(','));
    }

    const bool is_spec = awaited != nullptr && (awaited->argument == "SPEC" || awaited->argument == "KNOWN");
    const auto colons = std::ranges::count(word, ':');
    std::string kind = is_spec ? "open" : "words";
    std::string lines;
    const auto add = [&](const auto& words) {
        for (const std::string_view each : words) {
            lines += fmt::format("{}{} \n", prefix, each);
        }
    };
    if (awaited == nullptr && word.starts_with('-')) {
        for (const Option* option : options->all()) {
            for (const std::string_view name : split(option->names, ',')) {
                lines += fmt::format("{} {}\n", name, option->about);
            }
        }
    } else if (awaited == nullptr && options->takes_names()) {
        add(messages::all_names());
        add(mapped(filtered(projects(), [](const Project& project) { return !project.is_spec(); }), &Project::text));
        add(std::array<std::string_view, 3>{"methods", "presets", "projects"});
    } else if (awaited == nullptr) {
        kind = "files";
        for (const CommandEntry& each : has_operand ? std::span<const CommandEntry>() : std::span(table).subspan(1)) {
            lines += fmt::format("{} {}\n", each.name, each.about);
        }
    } else if (!awaited->choices.empty()) {
        add(awaited->choices);
    } else if (awaited->argument == "FILE") {
        kind = "files";
    } else if (is_spec && colons > 0) {
        const std::string name = word.substr(0, word.find(':'));
        const Representation* const named = find_representation(name);
        const auto project = parse_spec(name);
        const auto* const own = std::get_if<Spec>(&project);
        split_behind(word.rfind(':'));
        if (named != nullptr && named->takes_sequence && colons == 1) {
            add(messages::all_sequences());
        } else {
            add(messages::words_of(named != nullptr ? named->modifiers
                                   : own != nullptr ? representation(own->name).modifiers
                                                    : ModifierSet()));
            add(messages::all_presets());
        }
    } else if (is_spec || awaited->argument == "NAME" || awaited->argument == "SET") {
        add(messages::all_names());
    }
    return kind + "\n" + lines;
}

} // namespace rotconv::cli
