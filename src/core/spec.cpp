#include <rotconv/spec.hpp>

#include <algorithm>
#include <ostream>

#include "representations/codec.hpp"

namespace rotconv {
namespace {

void apply(const ModifierSet& modifiers, Spec& spec) noexcept {
    spec.passive = spec.passive || modifiers.has(Modifier::passive);
    spec.unit = modifiers.has(Modifier::deg) ? AngleUnit::degrees : spec.unit;
    spec.column_major = spec.column_major || modifiers.has(Modifier::col);
    spec.scalar_last = spec.scalar_last || modifiers.has(Modifier::xyzw);
    spec.positive = spec.positive || modifiers.has(Modifier::positive);
}

/// Cuts the text up to the next mark off `rest`.
std::string_view next_part(std::string_view& rest, char mark = ':') noexcept {
    const auto end = rest.find(mark);
    const auto part = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
    return part;
}

} // namespace

const Representation& representation(RepresentationId name) noexcept { return codec_of(name).representation; }

const Representation* find_representation(std::string_view text) noexcept {
    for (const RepresentationId id : all_representations) {
        const Representation& entry = representation(id);
        if (!text.empty() && (text == entry.text || std::ranges::count(entry.aliases, text) != 0)) {
            return &entry;
        }
    }
    return nullptr;
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

std::string Spec::text() const {
    const Representation& entry = representation(name);
    std::string text(entry.text);
    const auto add = [&text](std::string_view word) { text.append(1, ':').append(word); };
    if (entry.takes_sequence) {
        add(sequence.text());
    }
    for (const auto& [modifier, is_set] :
         {std::pair(Modifier::col, column_major), std::pair(Modifier::xyzw, scalar_last),
          std::pair(Modifier::deg, unit == AngleUnit::degrees), std::pair(Modifier::positive, positive),
          std::pair(Modifier::passive, passive)}) {
        if (is_set) {
            add(name_of(modifier));
        }
    }
    return text;
}

std::ostream& operator<<(std::ostream& out, const Spec& spec) { return out << spec.text(); }

std::array<std::uint8_t, 9> Spec::order() const noexcept {
    if (column_major || scalar_last) {
        return representation(name).other_order;
    }
    return {0, 1, 2, 3, 4, 5, 6, 7, 8};
}

std::array<std::string_view, 9> Spec::columns() const noexcept {
    auto own = representation(name).columns;
    if (has_own_columns) {
        std::string_view rest = project->columns;
        std::ranges::generate(own, [&rest] { return next_part(rest, ' '); });
    }
    std::array<std::string_view, 9> names;
    const auto places = order();
    std::ranges::transform(places, names.begin(), [&own](auto place) { return own[place]; });
    return names;
}

Spec Spec::in_degrees() const noexcept {
    Spec spec = *this;
    if (representation(name).has_angles()) {
        spec.unit = AngleUnit::degrees;
    }
    return spec;
}

namespace {

/// Reads a SPEC whose name is that of a representation.
std::variant<Spec, SpecError> parse_plain(std::string_view text) {
    using What = SpecError::What;
    std::string_view rest = text;
    const std::string_view name = next_part(rest);
    const Representation* const found = find_representation(name);
    if (found == nullptr) {
        return SpecError{What::unknown_name, std::string(name)};
    }
    Spec spec;
    spec.name = found->name;
    bool more = name.size() < text.size();
    if (found->takes_sequence) {
        if (!more) {
            return SpecError{What::no_sequence, std::string(text), found};
        }
        const std::string_view letters = rest.substr(0, rest.find(':'));
        const auto of_preset = meaning_of(letters, *found).sequence;
        const auto sequence = of_preset ? of_preset : EulerSequence::parse(letters);
        if (!sequence) {
            return SpecError{What::unknown_sequence, std::string(letters), found};
        }
        spec.sequence = *sequence;
        spec.has_own_columns = of_preset.has_value();
        if (!of_preset) { // else the word is read once more, as a preset
            more = rest.find(':') != std::string_view::npos;
            next_part(rest);
        }
    }
    std::string_view used_preset;
    bool scalar_first = false;
    while (more) {
        more = rest.find(':') != std::string_view::npos;
        const std::string_view part = next_part(rest);
        if (const auto preset = std::ranges::find(presets(), part, &Project::text); preset != presets().end()) {
            if (!used_preset.empty() && used_preset != part) {
                return SpecError{What::second_preset, std::string(part), found};
            }
            used_preset = part;
            spec.project = &*preset;
            apply(meaning_of(part, *found).modifiers, spec);
            continue;
        }
        const auto* modifier = std::ranges::find(all_modifiers, part, [](Modifier m) { return name_of(m); });
        if (modifier == all_modifiers.end()) {
            return SpecError{What::unknown_modifier, std::string(part), found};
        }
        if (!found->modifiers.has(*modifier)) {
            return SpecError{What::meaningless_modifier, std::string(part), found};
        }
        apply({*modifier}, spec);
        scalar_first = scalar_first || *modifier == Modifier::wxyz;
    }
    if (scalar_first && spec.scalar_last) {
        return SpecError{What::two_orders, std::string(text), found};
    }
    return spec;
}

} // namespace

std::variant<Spec, SpecError> parse_spec(std::string_view text) {
    const auto name = text.substr(0, text.find(':'));
    const Project* const project = find_project(name);
    if (project == nullptr || !project->is_spec()) {
        return parse_plain(text);
    }
    auto parsed = parse_plain(std::string(project->specs).append(text.substr(name.size())));
    if (auto* const spec = std::get_if<Spec>(&parsed)) {
        spec->project = project;
        spec->has_own_columns = !project->columns.empty();
    }
    return parsed;
}

} // namespace rotconv
