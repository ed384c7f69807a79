#include "list.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include <rotconv/method.hpp>
#include <rotconv/spec.hpp>

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
    const bool passive = std::ranges::count(preset.passive(), entry.name) != 0;
    const bool scalar_last = preset.scalar_last && entry.name == RepresentationId::quat;
    if (passive && scalar_last) {
        return "passive, xyzw";
    }
    return passive ? "passive" : scalar_last ? "xyzw" : "as it is";
}

std::string error_of(const Worst& worst) { return worst.where.empty() ? "-" : fmt::format("{:.2g}", worst.error); }

} // namespace

std::string list_all() {
    std::string text = fmt::format("{:<10}  {:<16}  {:>1}  {:<35}  {:<65}  {}\n", "NAME", "also", "n", "numbers",
                                   "range on output", "singular at");
    for (const Representation& entry : representations()) {
        const auto about = messages::about(entry.name);
        const std::string name = entry.name == RepresentationId::euler ? "euler:SEQ" : std::string(entry.text);
        text += fmt::format("{:<10}  {:<16}  {:>1}  {:<35}  {:<65}  {}\n", name, aliases_of(entry), entry.size,
                            columns_of(entry), about.range, about.singular);
    }
    text += "\nrotconv list NAME explains one: its formula, modifiers and presets.\n";
    return text;
}

std::optional<std::string> list_one(std::string_view name) {
    const auto table = representations();
    const auto found = std::ranges::find_if(table, [name](const Representation& entry) {
        return !name.empty() && (entry.text == name || std::ranges::count(entry.aliases, name) != 0);
    });
    if (found == table.end()) {
        return std::nullopt;
    }
    const auto about = messages::about(found->name);
    const std::string aliases = aliases_of(*found);
    std::string text = fmt::format("{}{}\n", found->text, aliases.empty() ? "" : " (also " + aliases + ")");
    const auto line = [&text](std::string_view label, std::string_view what) {
        text += fmt::format("  {:<10} {}\n", label, what);
    };
    line("formula", about.formula);
    line("numbers", columns_of(*found));
    line("range", about.range);
    line("singular", about.singular);
    if (found->name == RepresentationId::euler) {
        line("sequences", "three letters, neighbours different: upper case XYZ turns about the body's own");
        line("", "moving axes (intrinsic), lower case xyz about the fixed axes (extrinsic)");
    }
    line("modifiers", messages::modifiers_of(*found));
    for (const Preset& preset : presets()) {
        line(&preset == presets().data() ? "presets" : "",
             fmt::format("{:<12} {:<14} {}", preset.text, effect_of(preset, *found),
                         messages::about_preset(preset.text)));
    }
    return text;
}

std::string list_methods() {
    std::string text = fmt::format("{:<6}  {:<6}  {:<16}  {:>7}  {:<14}  {:>7}  {:<14}  {:<40}  {}\n", "FROM", "TO",
                                   "METHOD", "clean", "worst at", "hostile", "worst at", "holds for", "reference");
    for (const Method& method : methods()) {
        text += fmt::format("{:<6}  {:<6}  {:<16}  {:>7}  {:<14}  {:>7}  {:<14}  {:<40}  {}\n",
                            representation(method.from).text, representation(method.to).text, method.name,
                            error_of(method.clean), method.clean.where, error_of(method.hostile), method.hostile.where,
                            method.domain, method.reference);
    }
    text +=
        "\nWorst errors are in eps = 2.2e-16 rad, 1.4e+16 a half-turn, nan where a result is not finite; clean rows\n"
        "describe an attitude exactly, hostile ones are matrices off by up to 5e-4, quaternions and vectors of any "
        "size.\n";
    return text;
}

std::string help_footer() {
    std::string text = "Representations (rotconv list explains them):\n ";
    for (const Representation& entry : representations()) {
        text += fmt::format(" {}", entry.name == RepresentationId::euler ? "euler:SEQ" : entry.text);
    }
    text += "\n\nExamples:\n"
            "  rotconv -f euler:ZYX:deg -t quat 30 20 10\n"
            "  rotconv -f quat:xyzw -t rpy:deg 0 0 0.7071067811865476 0.7071067811865476\n"
            "  rotconv -f quat:tum -t rpy -d --columns 5-8 < trajectory.txt\n";
    return text;
}

} // namespace rotconv::cli
