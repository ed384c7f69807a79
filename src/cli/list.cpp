#include "list.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <rotconv/spec.hpp>

#include "../methods/method.hpp"
#include "messages.hpp"

namespace rotconv::cli {
namespace {

std::string aliases_of(const Representation& entry) {
    std::string text;
    for (const std::string_view alias : entry.aliases) {
        text += text.empty() || alias.empty() ? "" : " ";
        text += alias;
    }
    return text;
}

std::string columns_of(const Representation& entry) {
    return fmt::format("{}",
                       fmt::join(entry.columns.begin(), entry.columns.begin() + static_cast<int>(entry.size), " "));
}

/// What a preset makes of a representation.
std::string effect_of(const Preset& preset, const Representation& entry) {
    const std::string effect = messages::words_of(modifiers_of(preset.text, entry), ", ");
    return effect.empty() ? "as it is" : effect;
}

/// What a preset makes of all of them, such as "passive on dcm, 6d, 5d; xyzw on quat".
std::string effects_of(const Preset& preset) {
    std::vector<std::pair<std::string, std::string>> effects;
    for (const RepresentationId id : all_representations) {
        const Representation& entry = representation(id);
        const std::string effect = messages::words_of(modifiers_of(preset.text, entry), ", ");
        const auto found = std::ranges::find(effects, effect, &std::pair<std::string, std::string>::first);
        if (effect.empty()) {
            continue;
        }
        if (found != effects.end()) {
            found->second += fmt::format(", {}", entry.text);
        } else {
            effects.emplace_back(effect, entry.text);
        }
    }
    std::string text;
    for (const auto& [effect, names] : effects) {
        text += fmt::format("{}{} on {}", text.empty() ? "" : "; ", effect, names);
    }
    return text;
}

std::string_view name_of(const Representation& entry) { return entry.takes_sequence ? "euler:SEQ" : entry.text; }

} // namespace

std::string list_all() {
    std::string text = fmt::format("{:<10}  {:<16}  {:>1}  {:<35}  {:<65}  {}\n", "NAME", "also", "n", "numbers",
                                   "range on output", "singular at");
    for (const RepresentationId id : all_representations) {
        const Representation& entry = representation(id);
        text += fmt::format("{:<10}  {:<16}  {:>1}  {:<35}  {:<65}  {}\n", name_of(entry), aliases_of(entry),
                            entry.size, columns_of(entry), entry.range, entry.singular);
    }
    text += "\nrotconv list NAME explains one: its formula, modifiers and presets.\n";
    return text;
}

std::optional<std::string> list_one(std::string_view name) {
    const Representation* const found = find_representation(name);
    if (found == nullptr) {
        return std::nullopt;
    }
    const std::string aliases = aliases_of(*found);
    std::string text = fmt::format("{}{}\n", found->text, aliases.empty() ? "" : " (also " + aliases + ")");
    const auto line = [&text](std::string_view label, std::string_view what) {
        text += fmt::format("  {:<10} {}\n", label, what);
    };
    line("formula", found->formula);
    line("numbers", columns_of(*found));
    line("range", found->range);
    line("singular", found->singular);
    if (found->takes_sequence) {
        line("sequences", "three letters, neighbours different: upper case XYZ turns about the body's own");
        line("", "moving axes (intrinsic), lower case xyz about the fixed axes (extrinsic)");
    }
    line("modifiers", messages::words_of(found->modifiers, " "));
    for (const Preset& preset : presets()) {
        line(&preset == presets().data() ? "presets" : "",
             fmt::format("{:<12} {:<14} {}", preset.text, effect_of(preset, *found), preset.about));
    }
    return text;
}

std::optional<std::string> list_preset(std::string_view name) {
    const auto all = presets();
    const auto found = std::ranges::find(all, name, &Preset::text);
    if (found == all.end()) {
        return std::nullopt;
    }
    return fmt::format("{}: {}\n  sets       {}\n  leaves     all else as it is\n", name, found->about,
                       effects_of(*found));
}

std::string list_presets() {
    std::string text = fmt::format("{:<12}  {:<53}  {}\n", "PRESET", "of", "sets");
    for (const Preset& preset : presets()) {
        text += fmt::format("{:<12}  {:<53}  {}\n", preset.text, preset.about, effects_of(preset));
    }
    return text + "\nA preset goes behind a name, as in quat:tum; it leaves all else as it is.\n";
}

std::string list_methods() {
    constexpr const char* line = "{:<6}  {:<6}  {:<16}  {:<40}  {}\n";
    std::string text = fmt::format(line, "FROM", "TO", "METHOD", "holds for", "reference");
    text += fmt::format(line, "any", "any", fast_method, "every input that describes an attitude",
                        "rotconv, in plain double arithmetic: right to a few eps");
    for (const Method& method : methods()) {
        text += fmt::format(line, representation(method.from).text, representation(method.to).text, method.name,
                            method.domain, method.reference);
    }
    return text;
}

std::string help_footer() {
    std::string text = "Representations (rotconv list explains them):\n ";
    for (const RepresentationId id : all_representations) {
        text += fmt::format(" {}", name_of(representation(id)));
    }
    text += "\n\nModifiers, NAME:MODIFIER...:\n ";
    for (const Modifier modifier : all_modifiers) {
        text += fmt::format(" {}", rotconv::name_of(modifier));
    }
    text += "\n\nPresets, NAME:PRESET (rotconv list presets explains them):\n ";
    for (const Preset& preset : presets()) {
        text += fmt::format(" {}", preset.text);
    }
    text += "\n\nExit status:\n"
            "  0  every row is done\n"
            "  1  ran to the end, but rows failed, --strict met a diagnostic, or a check did not hold\n"
            "  2  did not run to the end: usage, a row error under --on-error stop, a file\n"
            "\nExamples:\n"
            "  rotconv -f euler:ZYX:deg -t quat 30 20 10\n"
            "  rotconv -f quat:xyzw -t rpy:deg 0 0 0.7071067811865476 0.7071067811865476\n"
            "  rotconv -f quat:tum -t rpy -d --columns 5-8 trajectory.txt\n"
            "  rotconv compare -f quat:tum --columns 5-8 --within 1e-6 new.txt old.txt\n";
    return text;
}

} // namespace rotconv::cli
