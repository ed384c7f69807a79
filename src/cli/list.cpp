#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>
#include <vector>

#include <rotconv/spec.hpp>

#include "../methods/method.hpp"
#include "../stream/fmt.hpp"
#include "commands.hpp"

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

std::string list_one(const Representation& entry) {
    const std::string aliases = aliases_of(entry);
    std::string text = fmt::format("{}{}\n", entry.text, aliases.empty() ? "" : " (also " + aliases + ")");
    const auto line = [&text](std::string_view label, std::string_view what) {
        text += fmt::format("  {:<10} {}\n", label, what);
    };
    line("formula", entry.formula);
    line("numbers", columns_of(entry));
    line("range", entry.range);
    line("singular", entry.singular);
    if (entry.takes_sequence) {
        line("sequences", "three letters, neighbours different: upper case XYZ turns about the body's own");
        line("", "moving axes (intrinsic), lower case xyz about the fixed axes (extrinsic)");
    }
    line("modifiers", messages::words_of(entry.modifiers, " "));
    for (const Preset& preset : presets()) {
        line(&preset == presets().data() ? "presets" : "",
             fmt::format("{:<12} {:<14} {}", preset.text, effect_of(preset, entry), preset.about));
    }
    return text;
}

/// A SPEC's numbers, and its representation.
std::string list_spec(const Spec& spec) {
    const auto columns = spec.columns();
    const auto end = columns.begin() + static_cast<std::ptrdiff_t>(spec.size());
    return fmt::format("{}: {}\n\n{}", spec.text(), fmt::join(columns.begin(), end, " "),
                       list_one(representation(spec.name)));
}

std::string list_preset(const Preset& preset) {
    return fmt::format("{}: {}\n  sets       {}\n  leaves     all else as it is\n", preset.text, preset.about,
                       effects_of(preset));
}

std::string list_presets() {
    std::string text = fmt::format("{:<12}  {:<53}  {}\n", "PRESET", "of", "sets");
    for (const Preset& preset : presets()) {
        text += fmt::format("{:<12}  {:<53}  {}\n", preset.text, preset.about, effects_of(preset));
    }
    return text + "\nA preset goes behind a name, as in quat:tum; it leaves all else as it is.\n";
}

/// Of a SPEC, so that those of a command line can be copied, or euler without its sequence.
RepresentationId named(const std::string& text) {
    if (const Representation* entry = find_representation(text)) {
        return entry->name;
    }
    const auto spec = parse_spec(text);
    if (const auto* error = std::get_if<SpecError>(&spec)) {
        throw Usage(messages::explain(*error));
    }
    return std::get<Spec>(spec).name;
}

/// A heading, rotconv's own two methods, and those published.
std::string list_pair(std::string_view from, std::string_view to, std::span<const Method> rows) {
    std::string text = fmt::format("{} to {}\n", from, to);
    const auto line = [&text](std::string_view name, std::string_view domain, std::string_view reference) {
        text += fmt::format("  {:<16}  {:<40}  {}\n", name, domain, reference);
    };
    line(default_method, every_input, own_reference);
    line(fast_method, every_input, "rotconv, in plain doubles");
    for (const Method& method : rows) {
        if (method.run != nullptr) {
            line(method.name, method.domain, method.reference);
        }
    }
    return text;
}

/// All pairs with published methods, those from the one name, or the pair of two.
std::string list_methods(const std::vector<std::string>& pair) {
    if (pair.size() == 2) {
        const RepresentationId from = named(pair[0]);
        const RepresentationId to = named(pair[1]);
        return list_pair(representation(from).text, representation(to).text, methods_of(from, to));
    }
    std::string text;
    for (const Method& method : methods()) {
        if (method.run == nullptr && (pair.empty() || named(pair[0]) == method.from)) {
            text += list_pair(representation(method.from).text, representation(method.to).text,
                              methods_of(method.from, method.to)) +
                    "\n";
        }
    }
    return text + list_pair(pair.empty() ? "any" : representation(named(pair[0])).text,
                            text.empty() ? "any" : "any other", {});
}

std::string list(const std::vector<std::string>& words) {
    const std::string first = words.empty() ? "" : words.front();
    const std::size_t most = first == "methods" ? 3 : 1;
    if (words.size() > most) {
        throw Usage("unexpected argument " + quoted(words[most]));
    }
    if (words.empty()) {
        return list_all();
    }
    if (first == "presets") {
        return list_presets();
    }
    if (first == "methods") {
        return list_methods({words.begin() + 1, words.end()});
    }
    const auto all = presets();
    const auto preset = std::ranges::find(all, first, &Preset::text);
    if (preset != all.end()) {
        return list_preset(*preset);
    }
    if (const Representation* entry = find_representation(first)) {
        return list_one(*entry);
    }
    const auto spec = parse_spec(first);
    if (const auto* error = std::get_if<SpecError>(&spec)) {
        throw Usage(messages::explain(*error));
    }
    return list_spec(std::get<Spec>(spec));
}

class ListOptions final : public CommandOptions {
public:
    ListOptions() { set.add_operands("NAME", words_, "A representation, a preset, presets, or methods [FROM [TO]]"); }
    [[nodiscard]] Command command(const Operands& /*operands*/) const override { return PrintCommand{list(words_)}; }

private:
    std::vector<std::string> words_;
};

} // namespace

std::unique_ptr<CommandOptions> list_options() { return std::make_unique<ListOptions>(); }

std::string help_footer() {
    std::string text =
        "A SPEC is a representation, with modifiers or a preset behind it: quat, quat:xyzw, euler:ZYX:deg.\n\n"
        "Representations (rotconv list explains them):\n ";
    for (const RepresentationId id : all_representations) {
        text += fmt::format(" {}", name_of(representation(id)));
    }
    text += "\n\nModifiers (rotconv list NAME has those of one representation):\n ";
    for (const Modifier modifier : all_modifiers) {
        text += fmt::format(" {}", rotconv::name_of(modifier));
    }
    text += "\n\nPresets set the modifiers of a project (rotconv list presets explains them):\n ";
    for (const Preset& preset : presets()) {
        text += fmt::format(" {}", preset.text);
    }
    text += "\n\nExit status:\n"
            "  0  all rows are done\n"
            "  1  it ran to the end, but rows failed, --strict met a diagnostic, or a check did not hold\n"
            "  2  it stopped: wrong usage, a bad row under --on-error stop, or a file that cannot be used\n"
            "\nExamples:\n"
            "  rotconv -f euler:ZYX:deg -t quat 30 20 10\n"
            "  rotconv -f quat:xyzw -t rpy:deg 0 0 0.7071067811865476 0.7071067811865476\n"
            "  rotconv -f quat:tum -t rpy -d --columns 5-8 trajectory.txt\n"
            "  rotconv compare -f quat:tum --columns 5-8 --within 1e-6 new.txt old.txt\n";
    return text;
}

} // namespace rotconv::cli
