#include "column_names.hpp"

#include <algorithm>
#include <array>
#include <map>

#include <rotconv/euler.hpp>

#include "words.hpp"

namespace rotconv::cli {
namespace {

/// deg or rad, also of a rate, or a unit of time, as headers write it; empty for others.
std::string_view unit_of(std::string_view text) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> units{
        {{"deg", " deg degree degrees dps \u00B0 "},
         {"rad", " rad radian radians rps "},
         {"s", " s sec secs second seconds "},
         {"ms", " ms msec millisecond milliseconds "},
         {"us", " us usec \u00B5s \u03BCs microsecond microseconds "},
         {"ns", " ns nsec nsecs nanosecond nanoseconds "}}};
    std::string unit = lower(text);
    std::erase_if(unit, [](char c) { return c == ' ' || c == '\t' || c == '_'; });
    for (const std::string_view per_second : {"", "/sec", "/s", "s^-1", "s-1", "pers", "s"}) {
        const std::string word = ' ' + unit.substr(0, unit.size() - std::min(unit.size(), per_second.size())) + ' ';
        for (const auto& [name, words] : units) {
            const bool fits = per_second.empty() || name == "deg" || name == "rad";
            if (fits && unit.ends_with(per_second) && word.size() > 2 && words.find(word) != std::string_view::npos) {
                return name;
            }
        }
    }
    return {};
}

/// The canonical names of a project's numbers, quat, dcm, or roll, pitch and yaw, in the SPEC's order; none for other
/// SPECs.
std::vector<std::string_view> name_order(const Spec& spec) {
    if (spec.has_own_columns || spec.name == RepresentationId::quat || spec.name == RepresentationId::dcm) {
        const auto columns = spec.columns();
        return {columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(spec.size())};
    }
    std::vector<std::string_view> order;
    // Roll is about x and pitch about y: not in Metashape's -ZXY of yaw, pitch and roll, for example.
    const bool has_usual_axes = !spec.sequence.has_signs() || spec.sequence.axis(1) == 1;
    if (spec.name == RepresentationId::rpy ||
        (spec.name == RepresentationId::euler && !spec.sequence.proper() && has_usual_axes)) {
        for (std::size_t i = 0; i < spec.size(); ++i) {
            order.push_back(
                representation(RepresentationId::rpy).columns.at(static_cast<std::size_t>(spec.sequence.axis(i))));
        }
    }
    return order;
}

/// The SPECs with the same modifiers whose numbers have those names in an order of their own.
std::array<Spec, 2> alike(const Spec& like) {
    std::array<Spec, 2> specs{like, like};
    auto& [first, second] = specs;
    if (like.name == RepresentationId::quat) {
        second.scalar_last = !like.scalar_last;
    } else if (like.name == RepresentationId::dcm) {
        second.column_major = !like.column_major;
    } else { // yaw, pitch, roll about the body's axes are roll, pitch, yaw about the fixed ones
        std::array<bool, 3> is_negative{};
        for (std::size_t i = 0; i < 3; ++i) {
            is_negative.at(static_cast<std::size_t>(like.sequence.axis(i))) = like.sequence.sign(i) < 0.0;
        }
        const auto [x, y, z] = is_negative;
        first.name = x || y || z ? RepresentationId::euler : RepresentationId::rpy;
        first.sequence = roll_pitch_yaw.with_signs(x, y, z);
        second.name = RepresentationId::euler;
        second.sequence = EulerSequence("ZYX").with_signs(z, y, x);
    }
    return specs;
}

/// What the names of a SPEC's numbers may be, without what they share.
struct Spelling {
    std::vector<std::string> names; ///< in the order of the SPEC
    bool is_numbered = false;
};
std::vector<Spelling> usual_spellings(const Spec& spec) {
    const auto order = name_order(spec);
    if (spec.name == RepresentationId::dcm) {
        return {{mapped(order, [](auto name) { return std::string(name.substr(1)); })},
                {mapped(order, [](auto name) { return fmt::format("{:c}{:c}", name[1] - 1, name[2] - 1); })}};
    }
    if (spec.name != RepresentationId::quat) {
        return {{{order.begin(), order.end()}}};
    }
    std::vector<Spelling> made;
    for (const std::string_view scalar : {"w", "s", "scalar", "0"}) {
        const bool is_numbered = scalar == "0";
        made.push_back({mapped(order,
                               [&](auto name) {
                                   return name == "qw"  ? std::string(scalar)
                                          : is_numbered ? std::string(1, static_cast<char>(name[1] - 'x' + '1'))
                                                        : std::string(name.substr(1));
                               }),
                        is_numbered});
    }
    return made;
}

/// The names of the project come first.
std::vector<Spelling> spellings(const Spec& spec) {
    Spec usual = spec;
    usual.has_own_columns = false;
    auto made = name_order(usual).empty() ? std::vector<Spelling>() : usual_spellings(usual);
    if (spec.has_own_columns) {
        made.insert(made.begin(), {mapped(name_order(spec), lower)});
    }
    return made;
}

/// The places of a spelling among names, which may share a prefix and a suffix; none if not all of it is there.
std::vector<std::size_t> places_of(const std::vector<std::string>& spelling, const std::vector<std::string>& names) {
    std::map<std::string_view, std::size_t> place_of;
    for (std::size_t i = 0; i < names.size(); ++i) {
        place_of.emplace(names[i], i);
    }
    for (const std::string& name : names) {
        for (auto at = name.find(spelling.front()); at != std::string::npos; at = name.find(spelling.front(), at + 1)) {
            std::vector<std::size_t> places;
            for (const std::string& each : spelling) {
                const auto found = place_of.find(std::string(name).replace(at, spelling.front().size(), each));
                if (found == place_of.end()) {
                    break;
                }
                places.push_back(found->second);
            }
            if (places.size() == spelling.size()) {
                return places;
            }
        }
    }
    return {};
}

/// The first spelling of which all names are there.
std::optional<KnownNames> find_spelling(const std::vector<Spelling>& spellings, std::span<const std::string> names) {
    const auto texts = mapped(names, [](const std::string& name) { return lower(name); });
    const auto without_units = mapped(names, [](const std::string& name) { return name_and_unit(name).first; });
    for (const Spelling& spelling : spellings) {
        for (const auto* each : {&texts, &without_units}) {
            if (auto places = places_of(spelling.names, *each); !places.empty()) {
                return KnownNames{std::move(places), spelling.is_numbered};
            }
        }
    }
    return std::nullopt;
}

} // namespace

/// The name and the unit that a text of a header holds: "yaw [deg]", "w_x_rad_s".
std::pair<std::string, std::string_view> name_and_unit(const std::string& text) {
    const auto bracket = text.ends_with(']')   ? text.rfind('[')
                         : text.ends_with(')') ? text.rfind('(')
                                               : std::string::npos;
    if (bracket != std::string::npos) {
        return {lower(stream::trimmed(text.substr(0, bracket))),
                unit_of(std::string_view(text).substr(bracket + 1, text.size() - bracket - 2))};
    }
    for (auto at = text.find('_', 1); at != std::string::npos; at = text.find('_', at + 1)) {
        if (const auto unit = unit_of(std::string_view(text).substr(at)); !unit.empty()) {
            return {lower(text.substr(0, at)), unit};
        }
    }
    return {lower(text), {}};
}

bool KnownNames::are_in_order() const noexcept {
    std::size_t next = 0;
    return std::ranges::all_of(places, [&next](std::size_t place) { return place == next++; });
}

std::optional<KnownNames> find_names(const Spec& spec, std::span<const std::string> names) {
    return find_spelling(spellings(spec), names);
}

std::optional<KnownNames> find_names(std::span<const std::string> own, std::span<const std::string> names) {
    return find_spelling({{{own.begin(), own.end()}}}, names);
}

std::string wrong_order(std::span<const std::string> own, std::span<const std::string> names) {
    const auto known = find_names(own, names);
    return !known || known->are_in_order()
               ? ""
               : fmt::format("{} is not the order of {}", quoted(fmt::format("{}", fmt::join(names, ","))),
                             fmt::join(own, ","));
}

std::string wrong_order(const Spec& spec, std::span<const std::string> names) {
    const auto known = find_names(spec, names);
    if (!known || known->are_in_order()) {
        return {};
    }
    const auto specs = alike(spec);
    const auto* const right =
        std::ranges::find_if(specs, [&](const Spec& each) { return find_names(each, names)->are_in_order(); });
    return fmt::format("{} is not the order of {}, which is {}{}", quoted(fmt::format("{}", fmt::join(names, ","))),
                       spec.text(), fmt::join(name_order(spec), ","),
                       right == specs.end() ? "" : fmt::format("; it is the order of {}", right->text()));
}

} // namespace rotconv::cli
