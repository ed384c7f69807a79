#include <rotconv/spec.hpp>

#include <algorithm>
#include <ostream>

#include "projects.hpp"
#include "representations/codec.hpp"
#include "text.hpp"

namespace rotconv {

const Representation& representation(RepresentationId name) noexcept { return codec_of(name).representation; }

const Representation* find_representation(std::string_view text) noexcept {
    const std::string name = plain_name(text);
    const auto* const found = std::ranges::find_if(all_representations, [&name](RepresentationId id) {
        return name == plain_name(representation(id).text) ||
               std::ranges::count(representation(id).aliases, name, plain_name) != 0;
    });
    return name.empty() || found == all_representations.end() ? nullptr : &representation(*found);
}

PresetMeaning meaning_of(std::string_view preset, const Representation& entry) noexcept {
    const auto found = std::ranges::find(entry.presets, preset, &PresetMeaning::preset);
    return found == entry.presets.end() ? PresetMeaning{} : *found;
}

std::string_view name_of(Modifier modifier) noexcept {
    static constexpr std::array<std::string_view, all_modifiers.size()> names{"passive", "deg",  "col",
                                                                              "xyzw",    "wxyz", "positive"};
    static_assert(!names.back().empty());
    return names[static_cast<std::size_t>(modifier)];
}

ModifierSet Spec::modifiers() const noexcept {
    ModifierSet set{Modifier::passive, passive};
    set |= {Modifier::deg, unit == AngleUnit::degrees};
    set |= {Modifier::col, column_major};
    set |= {Modifier::xyzw, scalar_last};
    set |= {Modifier::positive, positive};
    return set;
}

void Spec::apply(const ModifierSet& modifiers) noexcept {
    passive = passive || modifiers.has(Modifier::passive);
    unit = modifiers.has(Modifier::deg) ? AngleUnit::degrees : unit;
    column_major = column_major || modifiers.has(Modifier::col);
    scalar_last = scalar_last || modifiers.has(Modifier::xyzw);
    positive = positive || modifiers.has(Modifier::positive);
}

std::string Spec::text() const {
    const Representation& entry = representation(name);
    std::string text(entry.text);
    const auto add = [&text](std::string_view word) { text.append(1, ':').append(word); };
    if (entry.takes_sequence) {
        add(sequence.text());
    }
    for (const Modifier modifier :
         {Modifier::col, Modifier::xyzw, Modifier::deg, Modifier::positive, Modifier::passive}) {
        if (modifiers().has(modifier)) {
            add(name_of(modifier));
        }
    }
    return text;
}

std::ostream& operator<<(std::ostream& out, const Spec& spec) { return out << spec.text(); }

std::array<std::uint8_t, 9> Spec::order() const noexcept {
    return is_reordered() ? representation(name).other_order : std::array<std::uint8_t, 9>{0, 1, 2, 3, 4, 5, 6, 7, 8};
}

std::array<std::string_view, 9> Spec::columns() const noexcept {
    auto own = representation(name).columns;
    if (has_own_columns) {
        std::ranges::copy(split(project->columns, ' '), own.begin());
    }
    std::array<std::string_view, 9> names;
    const auto places = order();
    std::ranges::transform(places, names.begin(), [&own](auto place) { return own[place]; });
    return names;
}

Spec Spec::in_degrees() const noexcept {
    Spec spec = *this;
    spec.unit = representation(name).has_angles() ? AngleUnit::degrees : unit;
    return spec;
}

std::string message(const SpecError& error) {
    using What = SpecError::What;
    const std::string text = "'" + error.text + "'";
    const std::string in(error.in == nullptr ? "" : error.in->text);
    switch (error.what) {
    case What::unknown_name: return text + " is not a known representation";
    case What::no_sequence: return in + " needs its sequence, as in " + in + ":ZYX";
    case What::unknown_sequence: return text + " is not a known Euler sequence";
    case What::unknown_modifier: return text + " is not a known modifier of " + in;
    case What::meaningless_modifier: return text + " has no meaning for " + in;
    case What::second_preset: return text + " is a second preset; at most one is allowed";
    case What::two_orders: return text + " has the scalar first and last";
    }
    return {};
}

namespace {

const Project* find_preset(std::string_view word) noexcept {
    const auto found =
        std::ranges::find(presets(), plain_name(word), [](const Project& each) { return plain_name(each.text); });
    return found == presets().end() ? nullptr : &*found;
}

/// Reads a SPEC whose name is that of a representation.
// NOLINTNEXTLINE(misc-no-recursion): once, where digits are joined to the name
std::variant<Spec, SpecError> parse_plain(std::string_view text) {
    using What = SpecError::What;
    const std::vector<std::string_view> parts = split(text, ':');
    const Representation* const found = find_representation(parts[0]);
    const auto wrong = [found](What what, std::string_view part) { return SpecError{what, std::string(part), found}; };
    if (found == nullptr) {
        const auto digits = parts[0].find_first_of("123");
        const bool is_joined = digits != std::string_view::npos && plain_name(parts[0].substr(0, digits)) == "euler" &&
                               EulerSequence::parse(parts[0].substr(digits));
        return is_joined ? parse_plain(std::string("euler:").append(text.substr(digits)))
                         : wrong(What::unknown_name, parts[0]);
    }
    Spec spec{.name = found->name};
    auto following = std::span(parts).subspan(1);
    if (found->takes_sequence) {
        if (following.empty()) {
            return wrong(What::no_sequence, text);
        }
        const Project* const preset = find_preset(following[0]);
        const auto of_preset = preset == nullptr ? std::nullopt : meaning_of(preset->text, *found).sequence;
        const auto sequence = of_preset ? of_preset : EulerSequence::parse(following[0]);
        if (!sequence) {
            return wrong(What::unknown_sequence, following[0]);
        }
        spec.sequence = *sequence;
        spec.has_own_columns = of_preset.has_value();
        following = following.subspan(of_preset ? 0 : 1); // the word is read once more, as a preset
    }
    for (const std::string_view part : following) {
        if (const Project* const preset = find_preset(part)) {
            if (spec.project != nullptr && spec.project != preset) {
                return wrong(What::second_preset, part);
            }
            spec.project = preset;
            spec.apply(meaning_of(preset->text, *found).modifiers);
            continue;
        }
        const auto* const modifier =
            std::ranges::find(all_modifiers, plain_name(part), [](Modifier each) { return name_of(each); });
        if (modifier == all_modifiers.end() || !found->modifiers.has(*modifier)) {
            return wrong(modifier == all_modifiers.end() ? What::unknown_modifier : What::meaningless_modifier, part);
        }
        spec.apply({*modifier});
        spec.has_given_order =
            spec.has_given_order || ModifierSet{Modifier::xyzw, Modifier::wxyz, Modifier::col}.has(*modifier);
    }
    if (spec.scalar_last && std::ranges::count(following, name_of(Modifier::wxyz), plain_name) != 0) {
        return wrong(What::two_orders, text);
    }
    return spec;
}

} // namespace

std::variant<Spec, SpecError> parse_spec(std::string_view text) {
    const auto name = text.substr(0, text.find(':'));
    const Project* const project = find_project(name);
    const bool is_spec = project != nullptr && project->is_spec();
    auto parsed = parse_plain(
        is_spec ? std::string(project->specs.substr(0, project->specs.find(' '))).append(text.substr(name.size()))
                : std::string(text));
    if (auto* const spec = std::get_if<Spec>(&parsed); spec != nullptr && is_spec) {
        spec->project = project;
        spec->has_own_columns = !project->columns.empty();
    }
    return parsed;
}

} // namespace rotconv
