#include "guesses.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>

#include "../stream/fmt.hpp"

namespace rotconv::cli {
namespace {

/// What a word is called here.
struct Meaning {
    std::string_view word; ///< letters and digits alone, in lower case
    std::string_view text; ///< empty: what is meant needs no word
};

constexpr auto names = std::to_array<Meaning>({
    {"aa", "axis-angle"},
    {"angleaxis", "axis-angle"},
    {"rotmat", "dcm"},
    {"rotationmatrix", "dcm"},
    {"rotation", "dcm"},
    {"rot", "dcm"},
    {"mat", "dcm"},
    {"r", "dcm"},
    {"so3", "dcm"},
    {"q", "quat"},
    {"ep", "quat"},
    {"eulerparameters", "quat"},
    {"ypr", "euler:ZYX"},
    {"yawpitchroll", "euler:ZYX"},
    {"taitbryan", "euler:ZYX"},
    {"cardan", "euler:XYZ"},
    {"rollpitchyaw", "rpy"},
    {"rotationvector", "rotvec"},
    {"rvec", "rotvec"},
    {"rv", "rotvec"},
    {"prv", "rotvec"},
    {"expmap", "rotvec"},
    {"crp", "cayley"},
    {"rot6d", "6d"},
});

constexpr auto modifiers = std::to_array<Meaning>({
    {"scalarlast", "xyzw"},
    {"last", "xyzw"},
    {"scalarfirst", "wxyz"},
    {"first", "wxyz"},
    {"hamilton", "wxyz"},
    {"inverse", "passive"},
    {"inv", "passive"},
    {"transpose", "passive"},
    {"transposed", "passive"},
    {"t", "passive"},
    {"conjugate", "passive"},
    {"conj", "passive"},
    {"columnmajor", "col"},
    {"colmajor", "col"},
    {"columns", "col"},
    {"bn", "basilisk"},
    {"schaub", "basilisk"},
    {"ros2", "ros"},
    {"tf", "ros"},
    {"tf2", "ros"},
    {"naif", "spice"},
    {"nb", ""},
    {"active", ""},
    {"rad", ""},
    {"radians", ""},
    {"rowmajor", ""},
    {"row", ""},
    {"euroc", ""},
    {"kitti", ""},
    {"px4", ""},
    {"gtsam", ""},
});

constexpr auto options = std::to_array<Meaning>({
    {"json", "--format json"},
    {"pretty", "--format pretty"},
    {"quiet", "--diagnostics off"},
    {"q", "--diagnostics off"},
    {"digits", "--precision"},
    {"round", "--decimals"},
    {"places", "--decimals"},
    {"sep", "--delimiter"},
    {"separator", "--delimiter"},
    {"noheader", "--header no"},
    {"skiperrors", "--on-error skip"},
    {"fields", "--columns"},
});

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

std::string lower(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return result;
}

/// Letters and digits alone.
std::string without_marks(std::string_view text) {
    std::string result(text);
    std::erase_if(result,
                  [](char c) { return !((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')); });
    return result;
}

const Meaning* find(std::span<const Meaning> table, std::string_view text) {
    const auto found = std::ranges::find(table, lower(without_marks(text)), &Meaning::word);
    return found == table.end() ? nullptr : &*found;
}

/// The SPEC of a sequence in other ways of writing: 321, eulerZYX, euler-zyx, and Gohlke's rzyx (rotating axes) and
/// sxyz (static ones).
std::optional<Guess> guess_sequence(std::string_view text) {
    std::string letters = without_marks(text);
    if (lower(letters).starts_with("euler")) {
        letters.erase(0, 5);
    }
    if (letters.size() == 4 && (letters[0] == 'r' || letters[0] == 's')) {
        const char base = letters[0] == 'r' ? 'X' : 'x';
        letters.erase(0, 1);
        std::ranges::transform(letters, letters.begin(), [base](char c) {
            return c >= 'x' && c <= 'z' ? static_cast<char>(base + (c - 'x')) : c;
        });
    }
    std::ranges::transform(letters, letters.begin(),
                           [](char c) { return c >= '1' && c <= '3' ? static_cast<char>('X' + (c - '1')) : c; });
    if (!EulerSequence::parse(letters)) {
        return std::nullopt;
    }
    return Guess{"euler:" + letters, {}, {}};
}

/// The word as a kind of thing that some representations have, and one of them with it.
template <class Has, class With>
std::optional<Guess> guess_kind(std::string_view kind, const Has& has, const With& with) {
    Guess guess{{}, kind, {}};
    for (const RepresentationId id : all_representations) {
        const Representation& entry = representation(id);
        if (has(entry)) {
            const std::string name = entry.takes_sequence ? "euler:ZYX" : std::string(entry.text);
            guess.text = guess.text.empty() ? with(name) : guess.text;
            guess.of += (guess.of.empty() ? "" : ", ") + std::string(entry.text);
        }
    }
    return guess.text.empty() ? std::nullopt : std::optional(guess);
}

bool is_preset(std::string_view word) { return std::ranges::count(presets(), word, &Preset::text) != 0; }

bool is_modifier(std::string_view word) {
    return std::ranges::any_of(all_modifiers, [word](Modifier modifier) { return name_of(modifier) == word; });
}

bool is_changed_by(const Representation& entry, std::string_view preset) {
    const ModifierSet set = modifiers_of(preset, entry);
    return std::ranges::any_of(all_modifiers, [&set](Modifier modifier) { return set.has(modifier); });
}

bool has_modifier(const Representation& entry, std::string_view word) {
    return std::ranges::any_of(
        all_modifiers, [&](Modifier modifier) { return name_of(modifier) == word && entry.modifiers.has(modifier); });
}

bool has_column(const Representation& entry, std::string_view word) {
    const auto* const end = entry.columns.begin() + static_cast<std::ptrdiff_t>(entry.size);
    return std::find(entry.columns.begin(), end, word) != end;
}

std::optional<Guess> guess_name(std::string_view word, const std::vector<std::string_view>& legal) {
    const auto with_word = [word](const std::string& name) { return fmt::format("{}:{}", name, word); };
    if (is_preset(word)) {
        return guess_kind(
            "preset", [word](const auto& entry) { return is_changed_by(entry, word); }, with_word);
    }
    if (is_modifier(word)) {
        return guess_kind(
            "modifier", [word](const auto& entry) { return has_modifier(entry, word); }, with_word);
    }
    for (const std::string_view name : legal) {
        if (without_marks(lower(name)) == without_marks(lower(word))) {
            return Guess{std::string(name), {}, {}};
        }
    }
    if (auto guess = guess_kind(
            "column", [word](const auto& entry) { return has_column(entry, word); },
            [](const std::string& name) { return name; })) {
        return guess;
    }
    if (const Meaning* meaning = find(names, word)) {
        return Guess{std::string(meaning->text), {}, {}};
    }
    return guess_sequence(word);
}

std::optional<Guess> guess_modifier(std::string_view word, const Representation& entry) {
    if (const Meaning* meaning = find(modifiers, word)) {
        if (meaning->text.empty() || is_preset(meaning->text) || has_modifier(entry, meaning->text)) {
            return Guess{std::string(meaning->text), {}, {}};
        }
    }
    return entry.has_gimbal_lock ? guess_sequence(word) : std::nullopt;
}

std::optional<Guess> guess_letters(std::string_view word) {
    if (is_preset(word) || is_modifier(word)) {
        return Guess{fmt::format("euler:ZYX:{}", word), {}, {}};
    }
    if (word == representation(RepresentationId::rpy).text) {
        return Guess{std::string(word), {}, {}};
    }
    const Meaning* meaning = find(names, word);
    if (meaning != nullptr && meaning->text.starts_with("euler:")) {
        return Guess{std::string(meaning->text), {}, {}};
    }
    return guess_sequence(word);
}

} // namespace

std::optional<Guess> guess_by_spelling(std::string_view text, const std::vector<std::string_view>& legal) {
    constexpr std::size_t begun = 4; // such as --pr
    std::string_view best;
    std::size_t least = std::max<std::size_t>(2, text.size() / 2) + 1;
    for (const std::string_view word : legal) {
        const bool is_begun = text.size() >= begun && word.starts_with(text);
        const std::size_t distance = is_begun ? 0 : edit_distance(lower(text), lower(word));
        if (distance < least) {
            least = distance;
            best = word;
        }
    }
    return best.empty() ? std::nullopt : std::optional(Guess{std::string(best), {}, {}});
}

std::optional<Guess> guess_spec(const SpecError& error, const std::vector<std::string_view>& legal) {
    using What = SpecError::What;
    const auto guess = error.what == What::unknown_name       ? guess_name(error.text, legal)
                       : error.what == What::unknown_sequence ? guess_letters(error.text)
                                                              : guess_modifier(error.text, *error.in);
    return guess ? guess : guess_by_spelling(error.text, legal);
}

std::optional<Guess> guess_option(std::string_view text, const std::vector<std::string_view>& legal) {
    const Meaning* meaning = find(options, text);
    return meaning != nullptr ? std::optional(Guess{std::string(meaning->text), {}, {}})
                              : guess_by_spelling(text, legal);
}

} // namespace rotconv::cli
