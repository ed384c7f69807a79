#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>

#include "../stream/fmt.hpp"
#include "messages.hpp"

namespace rotconv::cli::messages {
namespace {

/// What words of other programs are called here.
struct Meaning {
    std::string_view text;  ///< empty: it needs no modifier
    std::string_view words; ///< each between blanks, in lower case, without marks
};

constexpr auto names = std::to_array<Meaning>({
    {"axis-angle", " aa angleaxis "},
    {"dcm", " rotmat rotationmatrix rotation rot mat r so3 "},
    {"quat", " q ep eulerparameters "},
    {"euler:ZYX", " ypr yawpitchroll taitbryan "},
    {"euler:XYZ", " cardan "},
    {"rpy", " rollpitchyaw "},
    {"rotvec", " rotationvector rvec rv prv expmap "},
    {"cayley", " crp "},
    {"6d", " rot6d "},
});

constexpr auto modifiers = std::to_array<Meaning>({
    {"xyzw", " scalarlast last "},
    {"wxyz", " scalarfirst first hamilton "},
    {"passive", " inverse inv transpose transposed t conjugate conj "},
    {"col", " columnmajor colmajor columns "},
    {"basilisk", " bn schaub "},
    {"ros", " ros2 tf tf2 "},
    {"spice", " naif "},
    {"", " nb active rad radians rowmajor row euroc kitti px4 gtsam "},
});

constexpr auto options = std::to_array<Meaning>({
    {"--format json", " json "},
    {"--format pretty", " pretty "},
    {"--diagnostics off", " quiet q "},
    {"--precision", " digits "},
    {"--decimals", " round places "},
    {"--delimiter", " sep separator "},
    {"--header no", " noheader "},
    {"--on-error skip", " skiperrors "},
    {"--columns", " fields "},
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

/// Only the letters and digits.
std::string without_marks(std::string_view text) {
    std::string result(text);
    std::erase_if(result, [](char c) { return !is_alphanumeric(c); });
    return result;
}

const Meaning* find(std::span<const Meaning> table, std::string_view text) {
    const std::string word = fmt::format(" {} ", lower(without_marks(text)));
    const auto found = std::ranges::find_if(
        table, [&word](const Meaning& meaning) { return meaning.words.find(word) != std::string_view::npos; });
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
    return Guess{"euler:" + letters};
}

/// A word that some representations have, as their `kind`: which they are, and the SPEC of the first.
template <class Has>
std::optional<Guess> guess_kind(std::string_view kind, const Has& has, const std::string& ending = {}) {
    Guess guess{.text = {}, .kind = kind};
    for (const RepresentationId id : all_representations) {
        const Representation& entry = representation(id);
        if (has(entry)) {
            const std::string name = entry.takes_sequence ? "euler:ZYX" : std::string(entry.text);
            guess.text = guess.text.empty() ? name + ending : guess.text;
            guess.of += (guess.of.empty() ? "" : ", ") + std::string(entry.text);
        }
    }
    return guess.text.empty() ? std::nullopt : std::optional(guess);
}

bool is_preset(std::string_view word) { return std::ranges::count(presets(), word, &Preset::text) != 0; }

bool is_modifier(std::string_view word) {
    return std::ranges::any_of(all_modifiers, [word](Modifier modifier) { return name_of(modifier) == word; });
}

bool has_modifier(const Representation& entry, std::string_view word) {
    return std::ranges::any_of(
        all_modifiers, [&](Modifier modifier) { return name_of(modifier) == word && entry.modifiers.has(modifier); });
}

std::optional<Guess> guess_name(std::string_view word, const std::vector<std::string_view>& legal) {
    const std::string ending = fmt::format(":{}", word);
    if (is_preset(word)) {
        const auto is_changed = [word](const Representation& entry) {
            return !words_of(meaning_of(word, entry).modifiers, "").empty();
        };
        return guess_kind("preset", is_changed, ending);
    }
    if (is_modifier(word)) {
        return guess_kind(
            "modifier", [word](const auto& entry) { return has_modifier(entry, word); }, ending);
    }
    for (const std::string_view name : legal) {
        if (without_marks(lower(name)) == without_marks(lower(word))) {
            return Guess{std::string(name)};
        }
    }
    const auto has_column = [word](const Representation& entry) {
        return std::ranges::count(std::span(entry.columns.data(), entry.size), word) > 0;
    };
    if (auto guess = guess_kind("column", has_column)) {
        return guess;
    }
    const Meaning* meaning = find(names, word);
    return meaning != nullptr ? Guess{std::string(meaning->text)} : guess_sequence(word);
}

std::optional<Guess> guess_modifier(std::string_view word, const Representation& entry) {
    const Meaning* meaning = find(modifiers, word);
    if (meaning != nullptr &&
        (meaning->text.empty() || is_preset(meaning->text) || has_modifier(entry, meaning->text))) {
        return Guess{std::string(meaning->text)};
    }
    return entry.has_gimbal_lock ? guess_sequence(word) : std::nullopt;
}

/// A word in the place of the letters of an Euler sequence.
std::optional<Guess> guess_letters(std::string_view word) {
    if (is_preset(word) || is_modifier(word)) {
        return Guess{fmt::format("euler:ZYX:{}", word)};
    }
    if (word == representation(RepresentationId::rpy).text) {
        return Guess{std::string(word)};
    }
    const Meaning* meaning = find(names, word);
    const bool is_sequence = meaning != nullptr && meaning->text.starts_with("euler:");
    return is_sequence ? Guess{std::string(meaning->text)} : guess_sequence(word);
}

} // namespace

std::optional<Guess> guess_by_spelling(std::string_view text, const std::vector<std::string_view>& legal) {
    constexpr std::size_t shortest_beginning = 4; // such as --pr
    std::optional<Guess> best;
    std::size_t least = std::max<std::size_t>(2, text.size() / 2) + 1;
    for (const std::string_view word : legal) {
        const bool is_begun = text.size() >= shortest_beginning && word.starts_with(text);
        const std::size_t distance = is_begun ? 0 : edit_distance(lower(text), lower(word));
        if (distance < least) {
            least = distance;
            best = Guess{std::string(word)};
        }
    }
    return best;
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
    return meaning != nullptr ? Guess{std::string(meaning->text)} : guess_by_spelling(text, legal);
}

} // namespace rotconv::cli::messages
