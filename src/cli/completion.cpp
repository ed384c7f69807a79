#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../core/projects.hpp"
#include "command.hpp"

namespace rotconv::cli {

namespace {

/// What may follow the last colon of a SPEC: its sequence, or modifiers.
std::vector<std::string> words_behind_colon(std::string_view spec) {
    const std::string_view name = spec.substr(0, spec.find(':'));
    const Representation* const named = find_representation(name);
    const auto project = messages::spec_of(name);
    if (named != nullptr && named->takes_sequence && std::ranges::count(spec, ':') == 1) {
        return messages::all_sequences();
    }
    auto words = messages::words_of(named != nullptr ? named->modifiers
                                    : project        ? representation(project->name).modifiers
                                                     : ModifierSet());
    std::ranges::copy(messages::all_presets(), std::back_inserter(words));
    return {words.begin(), words.end()};
}

} // namespace

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
    } else if (is_spec && word.find(':') != std::string::npos) {
        const auto following = words_behind_colon(word);
        split_behind(word.rfind(':'));
        add(following);
    } else if (is_spec || awaited->argument == "NAME" || awaited->argument == "SET") {
        add(messages::all_names());
    }
    return kind + "\n" + lines;
}

} // namespace rotconv::cli
