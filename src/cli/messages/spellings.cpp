#include "spellings.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <variant>

#include "../../operations/operations.hpp"
#include "../grammar/value_text.hpp"
#include "meanings.hpp"
#include "messages.hpp"

namespace rotconv::cli::messages {
namespace {

/// Edits (insert, delete, replace) that lead from one text to the other.
std::size_t edit_distance(std::string_view from, std::string_view to) {
    std::vector<std::size_t> row(to.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < from.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < to.size(); ++j) {
            const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

/// Whether two letters that follow each other have changed places: qaut.
bool are_swapped(std::string_view one, std::string_view other) {
    const auto at = static_cast<std::size_t>(std::ranges::mismatch(one, other).in1 - one.begin());
    return one.size() == other.size() && at + 1 < one.size() && one[at] == other[at + 1] && one[at + 1] == other[at] &&
           one.substr(at + 2) == other.substr(at + 2);
}

/// The SPECs of a sequence in other ways of writing: eulerZYX, euler-zyx, z-y'-x'', and Gohlke's rzyx (rotating axes)
/// and sxyz (static ones). Letters in lower case have two meanings.
Words sequences_in(std::string_view text) {
    std::string letters = without_marks(text);
    letters.erase(0, lower(letters).starts_with("euler") ? 5 : 0);
    const char kind = letters.size() == 4 ? letters[0] : ' ';
    letters.erase(0, kind == 'r' || kind == 's' ? 1 : 0);
    std::string moving = letters;
    std::ranges::transform(moving, moving.begin(),
                           [](char c) { return c >= 'x' && c <= 'z' ? static_cast<char>(c - 'x' + 'X') : c; });
    if (!EulerSequence::parse(letters) || text.starts_with('-')) {
        return {};
    }
    const bool is_moving = kind == 'r' || text.find('\'') != std::string_view::npos || letters == moving;
    Words specs{"euler:" + (is_moving ? moving : letters)};
    if (!is_moving && kind != 's') {
        specs.push_back("euler:" + moving);
    }
    return specs;
}

/// The SPECs whose columns are listed, as in "roll pitch yaw".
Words specs_of_columns(const std::string& text) {
    Words specs;
    auto names = all_names();
    names.insert(names.begin(), {"quat", "quat:xyzw"});
    for (const std::string_view each : names) {
        const auto spec = spec_of(each);
        const auto columns = spec ? operations::names_of(*spec) : Words();
        if (columns.size() > 2 && lower(without_marks(joined(columns, ""))) == lower(without_marks(text)) &&
            std::ranges::none_of(specs,
                                 [&](const std::string& known) { return spec_of(known)->text() == spec->text(); })) {
            specs.emplace_back(each);
            if (spec->unit == AngleUnit::radians) { // no robot's
                break;
            }
        }
    }
    return specs;
}

/// The SPECs of a project that are of a kind, or have these numbers, as in unity-euler and kuka-abc.
Words specs_of_kind(std::string_view text) {
    const auto begin = text.find_first_of("-_ ");
    const Project* const project = find_project(text.substr(0, begin));
    if (begin == std::string_view::npos || project == nullptr) {
        return {};
    }
    const std::string kind = lower(text.substr(begin + 1));
    if (project->is_spec() && !project->columns.empty() && kind == lower(without_marks(project->columns))) {
        return {std::string(project->text)};
    }
    const bool is_euler = kind == "euler";
    const auto named = named_representation(kind);
    const Words all = project->is_spec() ? Words{std::string(project->text)} : specs_of(*project);
    return filtered(all, [&](const std::string& each) {
        const auto spec = spec_of(each.substr(0, each.find(' ')));
        return spec && (is_euler ? representation(spec->name).has_gimbal_lock : named && spec->name == *named);
    });
}

/// The SPECs whose parts are joined in another way, as in eulZYX, quat_xyzw and "euler 3-1-3 deg".
Words specs_of_parts(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return std::string_view("-,/").find(c) != std::string_view::npos; }, ' ');
    Words parts;
    bool was_single = false;
    for (const std::string& part : parts_of_label(text)) { // 3-1-3 is one
        const bool is_single = part.size() == 1;
        if (is_single && was_single) {
            parts.back() += part;
        } else {
            parts.push_back(part);
        }
        was_single = is_single;
    }
    std::string name;
    Words sequences;
    std::string modifiers;
    for (const std::string& part : parts) {
        const Meaning* const meaning = find_meaning(part);
        const bool is_euler = meaning != nullptr && meaning->instead.find("euler:") != std::string_view::npos;
        const std::string said = is_euler ? "euler" : convention_in(part);
        const auto named = named_representation(said);
        const std::string own = said.empty()              ? part
                                : named && !is_spec(said) ? std::string(representation(*named).text)
                                                          : said;
        if (EulerSequence::parse(said) && sequences.empty()) {
            sequences = sequences_in(said);
        } else if (is_euler || is_spec(own)) {
            name = name.empty() || name == "euler" ? own : "none";
        } else {
            name =
                name.empty() && is_spec(fmt::format("quat:{}", own)) && own.size() == 4 ? "quat" : name; // of an order
            modifiers.append(":").append(own);
        }
    }
    sequences = sequences.empty() ? Words{name} : name.empty() || name == "euler" ? sequences : Words();
    const Words specs = filtered(mapped(sequences, [&](const std::string& each) { return each + modifiers; }), is_spec);
    return specs.empty() && text.find(' ') != std::string::npos ? specs_of_columns(text) : specs;
}

/// With the project as its modifier, where that means the same, for it says more.
std::string with_project(const std::string& spec, const Project& project) {
    const auto own = spec_of(spec);
    const auto other = spec_of(fmt::format("{}:{}", spec.substr(0, spec.find(':')), project.text));
    const bool is_same = own && other && own->text() == other->text();
    return is_same ? fmt::format("{}:{}", representation(own->name).text, project.text) : spec;
}

} // namespace

Words choose_nearest(std::string_view text, const Legal& legal) {
    Words best;
    const std::string word = lower(without_marks(text));
    std::size_t least = word.size() < 5 ? 2 : 3;
    for (const std::string_view each : legal) {
        const std::size_t distance = word == lower(without_marks(each))      ? 0
                                     : are_swapped(lower(text), lower(each)) ? 1
                                                                             : edit_distance(lower(text), lower(each));
        if (distance < least) {
            least = distance;
            best = {std::string(each)};
        }
    }
    return best;
}

// NOLINTNEXTLINE(misc-no-recursion): once for each side
Words meant(std::string_view word, const Legal& legal) {
    Words texts;
    const Meaning* const meaning = find_meaning(word);
    for (const std::string_view each : split(meaning == nullptr ? "" : meaning->instead, '|')) {
        texts.push_back(joined(words_in(each), " "));
    }
    const std::string bare(word.substr(std::min(word.find_first_not_of('-'), word.size())));
    const Project* const project = find_project(bare);
    if (!texts.front().empty()) {
        return texts;
    }
    texts = is_spec(bare) ? Words{bare} : sequences_in(bare);
    for (const std::string side : {"to", "from", "as"}) { // --to-euler, and those of SciPy
        const bool has_side = bare.starts_with(side + "-") || bare.starts_with(side + "_");
        const std::string name = has_side ? bare.substr(side.size() + 1) : "";
        auto specs = has_side ? meant(name, {}) : Words();
        if (name == "euler") { // --as-euler xyz
            specs.insert(specs.begin(), "euler:ARG");
        } else if (name == "quat" && side != "to") {
            specs.insert(specs.begin(), "quat:scipy");
        }
        for (const std::string& spec : specs) {
            texts.push_back(fmt::format("-{} {}", side == "from" ? 'f' : 't', spec));
        }
    }
    if (!texts.empty()) {
        return texts;
    }
    if (is_spec("quat:" + bare) || (project != nullptr && is_preset(project->text))) { // a modifier
        texts.push_back(":" + (project != nullptr ? std::string(project->text) : bare));
    }
    if (project != nullptr && !project->specs.empty()) { // one of several
        texts.push_back(fmt::format("-f {}", project->text));
    }
    texts = texts.empty() ? specs_of_kind(bare) : texts;
    texts = texts.empty() ? specs_of_parts(bare) : texts;
    if (!texts.empty()) {
        return texts;
    }
    std::string plain = bare;
    std::erase(plain, ' '); // axis angle
    return is_spec(plain) ? Words{plain} : choose_nearest(word, legal);
}

Words with_modifier(const std::string& spec, const std::string& modifier) {
    const auto parts = split(spec, ':');
    const bool is_case = modifier == "upper" || modifier == "lower";
    auto sequences = sequences_in(is_case && parts.size() > 1 ? parts[1] : std::string_view(modifier));
    if (plain_name(parts[0]) != "euler" || sequences.empty()) {
        return is_case ? Words() : Words{spec + ":" + modifier};
    }
    const std::string rest = spec.substr(parts[0].size() + (is_case ? parts[1].size() + 1 : 0));
    if (is_case) {
        sequences = {modifier == "upper" ? sequences.back() : "euler:" + lower(sequences[0].substr(6))};
    }
    return mapped(sequences, [&rest](const std::string& each) { return each + rest; });
}

Words meant_specs(const std::string& text, const SpecError& error) {
    using What = SpecError::What;
    auto others = split(text, ':');
    const auto wrong = std::ranges::find(others, error.text);
    if (error.what == What::no_sequence || wrong == others.end()) {
        return error.what == What::no_sequence ? Words{"rpy", "euler:ZYX"} : Words();
    }
    if (text == fmt::format("euler:{}", error.text) && is_spec(fmt::format("rpy:{}", error.text))) { // euler:deg
        return {fmt::format("rpy:{}", error.text), fmt::format("euler:ZYX:{}", error.text)};
    }
    const bool is_name = wrong == others.begin();
    others.erase(wrong);
    const std::string name(is_name ? "quat" : others[0]);
    const std::string rest = joined(std::span(others).subspan(is_name ? 0 : 1), ":");
    const auto with_rest = [&rest](const std::string& spec) { return spec + (rest.empty() ? "" : ":") + rest; };
    auto legal = is_name ? all_names() : words_of(error.in->modifiers);
    if (!is_name) {
        std::ranges::copy(all_presets(), std::back_inserter(legal));
    }
    Words specs;
    if (const Project* const project = is_name ? nullptr : find_project(error.text); project != nullptr) {
        for (const std::string& each : specs_of(*project)) {
            if (each.substr(0, each.find(':')) == name && each.find(' ') == std::string::npos && !project->is_spec()) {
                specs.push_back(with_rest(each)); // of several, one whose numbers stand in its order
            }
        }
    }
    const bool is_known = !specs.empty();
    for (const std::string& each : is_known                                   ? Words()
                                   : error.what == What::meaningless_modifier ? Words{"-"}
                                                                              : meant(error.text, legal)) {
        if (each == ":ARG" || each.starts_with("-f ")) { // of an option
            continue;
        }
        const bool is_modifier = each.starts_with(':') || (!is_name && !is_spec(each) && each != "-");
        const bool has_sequence = is_name && each.starts_with("euler:") && is_spec("euler:" + rest); // eul:ZYX
        const Words made = has_sequence  ? Words{"euler:" + rest}
                           : each == "-" ? Words{is_name ? "" : with_rest(name)}
                           : is_modifier ? with_modifier(with_rest(name), each.substr(each.starts_with(':') ? 1 : 0))
                                         : Words{with_rest(each)};
        specs.insert(specs.end(), made.begin(), made.end());
    }
    if (std::ranges::any_of(specs, is_spec)) {
        std::erase_if(specs, [](const std::string& spec) { return !is_spec(spec); });
    }
    const std::string modifier = plain_name(error.text);
    const bool may_go = modifier == "deg" || modifier == "positive"; // as if it were not there
    return error.what == What::meaningless_modifier && !may_go ? Words() : specs;
}

Words specs_of(const Project& project) {
    Words specs;
    for (std::string_view rest = project.specs; !rest.empty();) {
        const std::string_view item = rest.substr(0, rest.find("; "));
        rest.remove_prefix(std::min(item.size() + 2, rest.size()));
        const std::string_view columns = item.substr(std::min(item.find(" --columns "), item.size()));
        specs.push_back(with_project(std::string(item.substr(0, item.find(' '))), project).append(columns));
    }
    return specs;
}

} // namespace rotconv::cli::messages
