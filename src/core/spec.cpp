#include <rotconv/spec.hpp>

#include <algorithm>
#include <functional>

#include "enum_table.hpp"

namespace rotconv {
namespace {

constexpr std::array<bool, all_modifiers.size()> plain{true, false, false, false};
constexpr std::array<bool, all_modifiers.size()> with_angles{true, true, false, false};
constexpr std::array<bool, all_modifiers.size()> matrix{true, false, true, false};
constexpr std::array<bool, all_modifiers.size()> scalar_and_vector{true, false, false, true};

constexpr auto table = std::to_array<Representation>({
    {RepresentationId::dcm,
     "dcm",
     {"matrix"},
     9,
     {"r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"},
     matrix},
    {RepresentationId::two_column, "6d", {"two-column"}, 6, {"r11", "r21", "r31", "r12", "r22", "r32"}, plain},
    {RepresentationId::five_d, "5d", {"hopf"}, 5, {"y1", "y2", "y3", "y4", "y5"}, plain},
    {RepresentationId::quat, "quat", {"quaternion"}, 4, {"qw", "qx", "qy", "qz"}, scalar_and_vector},
    {RepresentationId::axis_angle, "axis-angle", {"axang"}, 4, {"ax", "ay", "az", "angle"}, with_angles},
    {RepresentationId::rotvec, "rotvec", {"exp"}, 3, {"rx", "ry", "rz"}, with_angles},
    {RepresentationId::euler, "euler", {}, 3, {"e1", "e2", "e3"}, with_angles},
    {RepresentationId::rpy, "rpy", {}, 3, {"roll", "pitch", "yaw"}, with_angles},
    {RepresentationId::cayley, "cayley", {"gibbs", "rodrigues"}, 3, {"cx", "cy", "cz"}, plain},
    {RepresentationId::mrp, "mrp", {}, 3, {"mx", "my", "mz"}, plain},
});
static_assert(is_indexed(table, representation_count, &Representation::name));

constexpr std::array matrices{RepresentationId::dcm, RepresentationId::two_column, RepresentationId::five_d};
constexpr std::array all_but_euler{RepresentationId::dcm,    RepresentationId::two_column, RepresentationId::five_d,
                                   RepresentationId::quat,   RepresentationId::axis_angle, RepresentationId::rotvec,
                                   RepresentationId::cayley, RepresentationId::mrp};
constexpr std::array stuelpnagel_sets{RepresentationId::dcm, RepresentationId::two_column, RepresentationId::five_d,
                                      RepresentationId::quat, RepresentationId::cayley};

template <std::size_t Count>
constexpr Preset preset(std::string_view text, const std::array<RepresentationId, Count>& passive, bool scalar_last) {
    Preset made{text, {}, Count, scalar_last};
    std::copy(passive.begin(), passive.end(), made.passive_on.begin());
    return made;
}

constexpr std::array<Preset, 10> preset_table{{
    preset<0>("scipy", {}, true),
    preset<0>("ros", {}, true),
    preset<0>("tum", {}, true),
    preset("matlab", matrices, false),
    preset("basilisk", matrices, false),
    preset("spice", all_but_euler, false),
    preset("bunge", all_but_euler, false),
    preset("baruh", matrices, true),
    preset("trawny", matrices, true),
    preset("stuelpnagel", stuelpnagel_sets, false),
}};

void apply(Modifier modifier, Spec& spec) noexcept {
    switch (modifier) {
    case Modifier::passive: spec.passive = true; break;
    case Modifier::deg: spec.unit = AngleUnit::degrees; break;
    case Modifier::col: spec.column_major = true; break;
    case Modifier::xyzw: spec.scalar_last = true; break;
    }
}

void apply(const Preset& preset, Spec& spec) noexcept {
    if (std::ranges::count(preset.passive(), spec.name) != 0) {
        spec.passive = true;
    }
    if (preset.scalar_last && spec.name == RepresentationId::quat) {
        spec.scalar_last = true;
    }
}

/// Cuts the text up to the next colon off `rest`.
std::string_view next_part(std::string_view& rest) noexcept {
    const auto colon = rest.find(':');
    const auto part = rest.substr(0, colon);
    rest = colon == std::string_view::npos ? std::string_view{} : rest.substr(colon + 1);
    return part;
}

template <class Range> const auto* find_text(const Range& range, std::string_view text) noexcept {
    const auto found = std::ranges::find(range, text, [](const auto& entry) { return entry.text; });
    return found == range.end() ? nullptr : &*found;
}

} // namespace

std::span<const Representation> representations() noexcept { return table; }

std::span<const Preset> presets() noexcept { return preset_table; }

const Representation& representation(RepresentationId name) noexcept { return table[static_cast<std::size_t>(name)]; }

std::string_view name_of(Modifier modifier) noexcept {
    static constexpr std::array<std::string_view, all_modifiers.size()> names{"passive", "deg", "col", "xyzw"};
    static_assert(is_indexed(all_modifiers, names.size(), std::identity()) && !names.back().empty());
    return names[static_cast<std::size_t>(modifier)];
}

std::array<std::uint8_t, 9> Spec::order() const noexcept {
    if (name == RepresentationId::dcm && column_major) {
        return {0, 3, 6, 1, 4, 7, 2, 5, 8};
    }
    if (name == RepresentationId::quat && scalar_last) {
        return {1, 2, 3, 0, 4, 5, 6, 7, 8};
    }
    return {0, 1, 2, 3, 4, 5, 6, 7, 8};
}

std::array<std::string_view, 9> Spec::columns() const noexcept {
    std::array<std::string_view, 9> names;
    const auto places = order();
    std::ranges::transform(places, names.begin(), [this](auto place) { return representation(name).columns[place]; });
    return names;
}

Spec Spec::in_degrees() const noexcept {
    Spec spec = *this;
    if (representation(name).has_angles()) {
        spec.unit = AngleUnit::degrees;
    }
    return spec;
}

std::variant<Spec, SpecError> parse_spec(std::string_view text) {
    using What = SpecError::What;
    std::string_view rest = text;
    const std::string_view name = next_part(rest);
    const auto* found = std::ranges::find_if(table, [name](const Representation& entry) {
        return !name.empty() && (name == entry.text || std::ranges::count(entry.aliases, name) != 0);
    });
    if (found == table.end()) {
        return SpecError{What::unknown_name, std::string(name)};
    }
    Spec spec;
    spec.name = found->name;
    bool more = name.size() < text.size();
    if (found->name == RepresentationId::euler) {
        if (!more) {
            return SpecError{What::no_sequence, std::string(text), found};
        }
        more = rest.find(':') != std::string_view::npos;
        const auto letters = next_part(rest);
        const auto sequence = EulerSequence::parse(letters);
        if (!sequence) {
            return SpecError{What::unknown_sequence, std::string(letters), found};
        }
        spec.sequence = *sequence;
    }
    const Preset* used_preset = nullptr;
    while (more) {
        more = rest.find(':') != std::string_view::npos;
        const std::string_view part = next_part(rest);
        if (const Preset* preset = find_text(preset_table, part)) {
            if (used_preset != nullptr && used_preset != preset) {
                return SpecError{What::second_preset, std::string(part), found};
            }
            used_preset = preset;
            apply(*preset, spec);
            continue;
        }
        const auto* modifier = std::ranges::find(all_modifiers, part, [](Modifier m) { return name_of(m); });
        if (modifier == all_modifiers.end()) {
            return SpecError{What::unknown_modifier, std::string(part), found};
        }
        if (!found->accepts(*modifier)) {
            return SpecError{What::meaningless_modifier, std::string(part), found};
        }
        apply(*modifier, spec);
    }
    return spec;
}

} // namespace rotconv
