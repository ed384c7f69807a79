#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <rotconv/spec.hpp>

#include "../../core/projects.hpp"
#include "../../core/representations/codec.hpp"
#include "../../methods/method.hpp"
#include "../../operations/operations.hpp"
#include "../command.hpp"

namespace rotconv::cli {
namespace {

std::string aliases_of(const Representation& entry) {
    const auto names = messages::names_of(entry);
    return joined(std::span(names).subspan(1), " ");
}

std::string columns_of(const Spec& spec) { return joined(operations::names_of(spec), " "); }

/// The modifiers, or the sequence, that a preset means for a representation.
std::string effect_of(const Project& preset, const Representation& entry) {
    const PresetMeaning meaning = meaning_of(preset.text, entry);
    return meaning.sequence ? meaning.sequence->text() : joined(messages::words_of(meaning.modifiers), ", ");
}

/// The effects of a preset on all representations, such as "passive on dcm, 6d, 5d; xyzw on quat", or "nothing".
std::string effects_of(const Project& preset) {
    std::vector<std::pair<std::string, std::string>> effects;
    for (const Representation& entry : mapped(all_representations, representation)) {
        const std::string effect = effect_of(preset, entry);
        const auto found = std::ranges::find(effects, effect, &std::pair<std::string, std::string>::first);
        if (found != effects.end()) {
            found->second += fmt::format(", {}", entry.text);
        } else if (!effect.empty()) {
            effects.emplace_back(effect, fmt::format("{} on {}", effect, entry.text));
        }
    }
    return effects.empty() ? "nothing" : joined(mapped(effects, &std::pair<std::string, std::string>::second), "; ");
}

std::string_view name_of(const Representation& entry) { return entry.takes_sequence ? "euler:SEQ" : entry.text; }

std::string list_all() {
    std::string text;
    const auto line = [&text](const auto&... cells) {
        text += fmt::format("{:<10}  {:<16}  {:>1}  {:<35}  {:<65}  {}\n", cells...);
    };
    line("NAME", "also", "n", "numbers", "range on output", "singular at");
    for (const Representation& entry : mapped(all_representations, representation)) {
        line(name_of(entry), aliases_of(entry), entry.size, columns_of({.name = entry.name}),
             codec_of(entry.name).range, codec_of(entry.name).singular);
    }
    return text + "\nrotconv list NAME explains one: its formula, modifiers and presets.\n";
}

std::string list_one(const Representation& entry) {
    const std::string aliases = aliases_of(entry);
    std::string text = fmt::format("{}{}\n", entry.text, aliases.empty() ? "" : " (also " + aliases + ")");
    const auto line = [&text](std::string_view label, std::string_view what) {
        text += fmt::format("  {:<10} {}\n", label, what);
    };
    line("formula", codec_of(entry.name).formula);
    line("numbers", columns_of({.name = entry.name}));
    line("range", codec_of(entry.name).range);
    line("singular", codec_of(entry.name).singular);
    if (entry.takes_sequence) {
        line("sequences", "three letters, neighbours different: upper case XYZ turns about the body's own");
        line("", "moving axes (intrinsic), lower case xyz about the fixed axes (extrinsic);");
        line("", "a minus sign before a letter negates that angle: Z-Y-X");
    }
    line("modifiers", joined(messages::words_of(entry.modifiers), " "));
    for (const Project& preset : presets()) {
        const std::string effect = effect_of(preset, entry);
        line(&preset == presets().data() ? "presets" : "",
             fmt::format("{:<12} {:<14} {}", preset.text, effect.empty() ? "unchanged" : effect, preset.source));
    }
    return text;
}

std::string list_presets() {
    std::string text = fmt::format("{:<12}  {:<53}  {}\n", "PRESET", "of", "sets");
    for (const Project& preset : presets()) {
        text += fmt::format("{:<12}  {:<53}  {}\n", preset.text, preset.source, effects_of(preset));
    }
    return text + "\nA preset follows a name, as in quat:tum; it leaves all else unchanged.\n";
}

/// The SPECs of a project, each with the names of its numbers or the words that follow it.
std::vector<std::pair<std::string, std::string>> specs_of(const Project& project) {
    std::vector<std::pair<std::string, std::string>> specs;
    for (std::string_view rest = project.specs; !rest.empty();) {
        const std::string_view item = rest.substr(0, rest.find("; "));
        rest.remove_prefix(std::min(item.size() + 2, rest.size()));
        const std::string spec(item.substr(0, item.find(' ')));
        specs.emplace_back(spec, item.substr(std::min(spec.size() + 1, item.size())));
    }
    if (project.is_spec() && !project.columns.empty()) {
        specs[0].second = columns_of(std::get<Spec>(parse_spec(project.text)));
    }
    return specs;
}

std::string axes_of(const Project& project) {
    const std::string reference = project.reference.empty() ? "" : fmt::format("reference {}", project.reference);
    return fmt::format("{}{}{}", reference, reference.empty() || project.body.empty() ? "" : ", ",
                       project.body.empty() ? "" : fmt::format("body {}", project.body));
}

std::string list_projects() {
    std::string text;
    const auto line = [&text](const auto&... cells) {
        text += fmt::format("{:<16}  {:<20}  {:<54}  {:<23}  {}", cells...);
        text.erase(text.find_last_not_of(' ') + 1);
        text += '\n';
    };
    line("PROJECT", "SPEC", "numbers", "axes", "source");
    for (const Project& project : projects()) {
        auto specs = specs_of(project);
        specs.resize(std::max<std::size_t>(specs.size(), 1), {"-", "rotconv list NAME says why"});
        for (const auto& [spec, numbers] : specs) {
            const bool is_first = &spec == &specs[0].first;
            line(is_first ? project.text : "", spec, numbers, is_first ? axes_of(project) : "",
                 is_first ? project.source : "");
        }
    }
    return text + "\nA project with one SPEC is a SPEC: -f kuka, -t ur.\n"
                  "rotconv list NAME says more about one.\n";
}

std::string list_project(const Project& project) {
    std::string text =
        fmt::format("{}{}\n", project.text, project.others.empty() ? "" : fmt::format(" (also {})", project.others));
    const auto line = [&text](std::string_view label, std::string_view what) {
        text += what.empty() ? "" : fmt::format("  {:<10} {}\n", label, what);
    };
    for (const auto& [spec, numbers] : specs_of(project)) {
        line("SPEC", fmt::format("{}{}{}", spec, numbers.empty() ? "" : "  ", numbers));
    }
    line("axes", axes_of(project));
    if (messages::is_preset(project.text)) {
        line("preset", "sets " + effects_of(project));
    }
    line("source", project.source);
    line("remark", project.remark);
    return text;
}

/// The representation of a SPEC, such as one copied from a command line; euler may lack its sequence.
Spec named(const std::string& text) {
    if (const Representation* entry = find_representation(text)) {
        return {.name = entry->name};
    }
    const auto spec = parse_spec(text);
    if (const auto* error = std::get_if<SpecError>(&spec)) {
        throw Usage(messages::explain(*error)).with({}, "; rotconv list has the names");
    }
    return std::get<Spec>(spec);
}

/// A heading, rotconv's own two methods, and those published.
std::string list_pair(std::string_view from, std::string_view to, std::span<const Method> rows) {
    std::string text = fmt::format("{} to {}\n", from, to);
    const auto line = [&text](std::string_view name, std::string_view domain, std::string_view reference) {
        text += fmt::format("  {:<16}  {:<40}  {}\n", name, domain, reference);
    };
    line(default_method, every_input, "rotconv, each number rounded once");
    line(fast_method, every_input, "rotconv, in plain doubles");
    for (const Method& method : rows) {
        line(method.name, method.domain, method.reference);
    }
    return text;
}

/// All pairs with published methods, the pairs from one name, or the pair of two names.
std::string list_methods(const std::vector<std::string>& pair) {
    const auto from = pair.empty() ? std::nullopt : std::optional(named(pair[0]).name);
    if (pair.size() == 2) {
        const RepresentationId to = named(pair[1]).name;
        return list_pair(representation(*from).text, representation(to).text, methods_of(*from, to));
    }
    std::string text;
    for (const Method& method : methods()) {
        const auto rows = methods_of(method.from, method.to);
        if (&method == &rows.front() && from.value_or(method.from) == method.from) {
            text += list_pair(representation(method.from).text, representation(method.to).text, rows) + "\n";
        }
    }
    return text + list_pair(from ? representation(*from).text : "any", text.empty() ? "any" : "any other", {});
}

std::string list_of(const std::vector<std::string>& words) {
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
    if (first == "projects") {
        return list_projects();
    }
    if (const Project* const project = find_project(first)) {
        return list_project(*project);
    }
    const Spec spec = named(first);
    const std::string about = list_one(representation(spec.name));
    return find_representation(first) != nullptr ? about
                                                 : fmt::format("{}: {}\n\n{}", spec.text(), columns_of(spec), about);
}

struct ListOptions final : CommandOptions {
    ListOptions() { take_names("A representation or project, presets, projects, or methods [FROM [TO]]"); }

    [[nodiscard]] Command command() const override {
        try {
            return list_of(files);
        } catch (Usage& error) {
            for (const WordEnd& word : file_words) {
                std::ranges::move(messages::meant_by_operand(*this, word.word), std::back_inserter(error.mends));
            }
            throw;
        }
    }
};

} // namespace

CommandEntry list_command() {
    return {"list", "List the representations, projects, presets or methods, or explain one",
            "Usage: rotconv list [NAME]\n       rotconv list methods [FROM [TO]]\n", make_options<ListOptions>};
}

std::string help_footer() {
    const auto names = mapped(all_representations, [](RepresentationId id) { return name_of(representation(id)); });
    const auto modifiers = mapped(all_modifiers, [](Modifier modifier) { return rotconv::name_of(modifier); });
    // presets that set nothing would fill a line
    const auto changing = filtered(presets(), [](const Project& preset) { return effects_of(preset) != "nothing"; });
    return fmt::format(
        "A SPEC is a representation, followed by modifiers or a preset: quat, quat:xyzw, euler:ZYX:deg.\n"
        "Representations (rotconv list): {}\n"
        "Modifiers (rotconv list NAME): {}\n"
        "Presets set the modifiers of a project (rotconv list presets explains them):\n  {}\n"
        "Names of other projects, such as kuka, are SPECs or answered with them: rotconv list projects.\n"
        "\nExit status:\n"
        "  0  finished\n"
        "  1  finished, but rows failed, --strict met a diagnostic, or a check did not hold\n"
        "  2  stopped: wrong usage, a row error with --on-error stop, or a file that cannot be used\n"
        "\nExamples:\n"
        "  rotconv -f euler:ZYX:deg -t quat 30 20 10\n"
        "  rotconv compare -f quat:tum --columns 5-8 --within 0.01deg new.txt old.txt\n",
        fmt::join(names, " "), fmt::join(modifiers, " "), fmt::join(mapped(changing, &Project::text), " "));
}

} // namespace rotconv::cli
