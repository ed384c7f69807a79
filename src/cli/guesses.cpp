#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>
#include <system_error>
#include <variant>

#include "../methods/method.hpp"
#include "messages.hpp"

namespace rotconv::cli::messages {
namespace {

/// What a user may have meant by a word that rotconv does not know: its meaning elsewhere counts before its spelling.
struct Guess {
    std::string text; ///< a legal text; empty: nothing needs to be written
    std::string said = fmt::format(" did you mean {}?", text);
};

/// What words of other programs are called here.
struct Meaning {
    std::string_view text;  ///< empty: it needs no modifier
    std::string_view words; ///< each between blanks, in lower case, without marks
};

constexpr auto other_names = std::to_array<Meaning>({
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

constexpr auto other_modifiers = std::to_array<Meaning>({
    {"xyzw", " scalarlast last "},
    {"wxyz", " scalarfirst first hamilton "},
    {"passive", " inverse inv transpose transposed t conjugate conj "},
    {"col", " columnmajor colmajor columns "},
    {"basilisk", " bn schaub "},
    {"ros", " ros2 tf tf2 "},
    {"spice", " naif "},
    {"", " nb active rad radians rowmajor row numpy euroc kitti px4 gtsam "},
});

constexpr auto other_options = std::to_array<Meaning>({
    {"--format json", " json "},
    {"--format pretty", " pretty "},
    {"--diagnostics off", " quiet q "},
    {"--precision", " digits "},
    {"--decimals", " round places "},
    {"--delimiter", " sep separator "},
    {"--header no", " noheader "},
    {"--on-error skip", " skiperrors "},
    {"--columns", " fields "},
    {"rotconv list", " list l representations formats "},
    {"no option (radians are what angles are in without :deg or -d)", " radians radian rad r "},
    {"-t SPEC:passive", " inverse inv invert conjugate transpose "},
});

/// What rotconv does in another way, or not at all.
constexpr auto verbs = std::to_array<Meaning>({
    {":passive on one side inverts, as in rotconv -f quat -t quat:passive", " inverse inv invert conjugate transpose "},
    {"--left and --right multiply by one attitude; two streams A and B are multiplied by rotconv compose -f SPEC -t "
     "SPEC A B",
     " mul multiply mult product concat concatenate combine chain "},
    {"rotconv compare -f SPEC FILE REFERENCE prints angles; the attitudes between them: rotconv compose -f "
     "SPEC:passive --by SPEC -t SPEC REFERENCE FILE",
     " diff difference delta subtract sub relative angle distance check verify "},
    {"not here: rotconv does not interpolate; SciPy's Slerp", " slerp squad interpolate interp lerp resample "},
    {"not here: rotconv takes each row by itself; SciPy's Rotation.mean()", " average mean avg median filter smooth "},
    {"every conversion does, with --tolerance inf", " normalize normalise norm unit orthogonalize orthonormalize "},
    {"rotconv sample -t SPEC --kind uniform", " random rand generate samples "},
    {"not here: rotconv writes numbers; --format pretty is for people", " plot draw show view visualize "},
    {"rotconv rotate -f SPEC", " apply transform "},
    {"it has no name: rotconv -f SPEC -t SPEC", " convert conversion conv "},
    {"rotconv propagate", " integrate "},
    {"rotconv rates --differences", " derivative differentiate velocity "},
    {"NED to ENU is --reference-axes ned:enu, FRD to FLU --body-axes frd:flu, an OpenCV camera to OpenGL --body-axes "
     "rdf:rub: three letters say where x, y and z point",
     " axes frame frames ned enu frd flu rdf rub fru ruf luf nwu esu "},
    {"--continuous, as in rotconv -f SPEC -t SPEC --continuous", " unwrap continuous "},
});

/// What to write for words of numbers that have nothing else but one of these, or it several times.
constexpr auto marks = std::to_array<Meaning>({
    {"write the minus sign as -, the one of the keyboard", " − – — － "},
    {"write the number alone, and :deg after the name of the SPEC or -d", " ° º deg degree degrees "},
    {"write the number alone: angles are in radians, unless the SPEC has :deg", " rad radian radians "},
    {"write pi as 3.141592653589793, or angles in degrees, with :deg after the name of the SPEC",
     " pi π nppi mathpi M_PI "},
    {"write the number alone", " f F "},
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

/// Only the letters and digits.
std::string without_marks(std::string_view text) {
    std::string result(text);
    std::erase_if(result, [](char c) { return !is_alphanumeric(c); });
    return result;
}

/// The meaning that a table has for a word.
std::optional<Guess> find(std::span<const Meaning> table, std::string_view text) {
    const std::string word = fmt::format(" {} ", lower(without_marks(text)));
    const auto found = std::ranges::find_if(
        table, [&word](const Meaning& meaning) { return meaning.words.find(word) != std::string_view::npos; });
    return found == table.end() ? std::nullopt : std::optional(Guess{std::string(found->text)});
}

/// A project by one of its names, in any case and with other marks.
const Project* project_called(std::string_view word) {
    const auto plain = [](std::string_view text) { return lower(without_marks(text)); };
    const auto found = std::ranges::find_if(projects(), [&](const Project& each) {
        return std::ranges::count(words_in(fmt::format("{} {}", each.text, each.others)), plain(word), plain) != 0;
    });
    return word.empty() || found == projects().end() ? nullptr : &*found;
}

/// What the numbers of a project are, in the place of a word that cannot name them there.
std::optional<Guess> guess_project(std::string_view word) {
    const Project* const project = project_called(word);
    if (project == nullptr) {
        return std::nullopt;
    }
    if (project->is_spec()) {
        return Guess{std::string(project->text),
                     fmt::format(" {} is a SPEC itself, {}", project->text, project->specs)};
    }
    const std::string_view mark = project->specs.empty() || project->remark.empty() ? "" : "; ";
    return Guess{{}, fmt::format(" {}: {}{}{}", project->text, project->specs, mark, project->remark)};
}

/// The SPEC of a sequence in other ways of writing: 321, eulerZYX, euler-zyx, z-y'-x'', and Gohlke's rzyx (rotating
/// axes) and sxyz (static ones).
std::optional<Guess> guess_sequence(std::string_view text) {
    std::string letters = without_marks(text);
    const auto exchange = [&letters](char from, char to) { // three letters or digits from these on
        for (char& c : letters) {
            c = c >= from && c <= from + 2 ? static_cast<char>(to + (c - from)) : c;
        }
    };
    if (text.find('\'') != std::string_view::npos) {
        exchange('x', 'X');
    }
    if (lower(letters).starts_with("euler")) {
        letters.erase(0, 5);
    }
    if (letters.size() == 4 && (letters[0] == 'r' || letters[0] == 's')) {
        exchange('x', letters[0] == 'r' ? 'X' : 'x');
        letters.erase(0, 1);
    }
    exchange('1', 'X');
    return EulerSequence::parse(letters) ? std::optional(Guess{"euler:" + letters}) : std::nullopt;
}

bool is_preset(std::string_view word) { return std::ranges::count(presets(), word, &Project::text) != 0; }

bool is_modifier(std::string_view word) {
    return std::ranges::count(all_modifiers, word, [](Modifier modifier) { return name_of(modifier); }) != 0;
}

bool has_modifier(const Representation& entry, std::string_view word) {
    return std::ranges::count(words_of(entry.modifiers), word) != 0;
}

/// The SPEC of the first representation that has the word as a preset that changes it, a modifier or a column.
std::optional<Guess> guess_owner(std::string_view word) {
    const std::string_view kind = is_preset(word) ? "preset" : is_modifier(word) ? "modifier" : "column";
    const auto has = [word, kind](RepresentationId id) {
        const Representation& entry = representation(id);
        return kind == "preset"     ? !words_of(meaning_of(word, entry).modifiers).empty()
               : kind == "modifier" ? has_modifier(entry, word)
                                    : std::ranges::count(std::span(entry.columns.data(), entry.size), word) > 0;
    };
    const auto owners = mapped(filtered(all_representations, has), [](auto id) { return representation(id).text; });
    if (owners.empty()) {
        return std::nullopt;
    }
    const std::string spec = fmt::format("{}{}", owners[0] == "euler" ? "euler:ZYX" : owners[0],
                                         kind == "column" ? "" : fmt::format(":{}", word));
    return Guess{spec, fmt::format(" {} is a {} of {}: did you mean {}?", word, kind, fmt::join(owners, ", "), spec)};
}

std::optional<Guess> guess_name(std::string_view word, const std::vector<std::string_view>& legal) {
    if (auto guess = guess_owner(word)) {
        return guess;
    }
    for (const std::string_view name : legal) {
        if (without_marks(lower(name)) == without_marks(lower(word))) {
            return Guess{std::string(name)};
        }
    }
    const auto meaning = find(other_names, word);
    return meaning ? meaning : guess_sequence(word);
}

std::optional<Guess> guess_modifier(std::string_view word, const Representation& entry) {
    auto meaning = find(other_modifiers, word);
    if (meaning && meaning->text.empty()) {
        return Guess{{}, fmt::format(" {} needs no modifier: leave it out", quoted(word))};
    }
    if (meaning && (is_preset(meaning->text) || has_modifier(entry, meaning->text))) {
        return meaning;
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
    const auto meaning = find(other_names, word);
    return meaning && meaning->text.starts_with("euler:") ? meaning : guess_sequence(word);
}

/// The legal word that begins with the text; otherwise the nearest.
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

/// `legal`: the words that could stand in the place of the one at fault.
std::optional<Guess> guess_spec(const SpecError& error, const std::vector<std::string_view>& legal) {
    using What = SpecError::What;
    const Project* const project = project_called(error.text);
    if (project != nullptr && !is_preset(project->text)) {
        return guess_project(error.text);
    }
    auto guess = error.what == What::unknown_name       ? guess_name(error.text, legal)
                 : error.what == What::unknown_sequence ? guess_letters(error.text)
                                                        : guess_modifier(error.text, *error.in);
    guess = guess ? guess : guess_project(error.text);
    return guess ? guess : guess_by_spelling(error.text, legal);
}

/// A word that is neither an option nor a number nor a FILE; `commands`: the words that could stand in its place.
std::optional<Guess> guess_operand(std::string_view word, const std::vector<std::string_view>& commands) {
    if (std::holds_alternative<Spec>(parse_spec(word))) {
        return Guess{fmt::format("-f {} or -t {}", word, word)};
    }
    if (const auto at = word.find('2'); at != std::string_view::npos) { // such as rpy2quat
        const auto from = guess_name(word.substr(0, at), all_names());
        const auto to = guess_name(word.substr(at + 1), all_names());
        if (from && to && !from->text.empty() && !to->text.empty()) {
            return Guess{fmt::format("-f {} -t {}", from->text, to->text)};
        }
    }
    return guess_by_spelling(word, commands);
}

std::optional<Guess> guess_option(std::string_view text, const std::vector<std::string_view>& legal) {
    const std::string_view word = text.substr(std::min(text.find_first_not_of('-'), text.size()));
    if (word.size() > 2 && std::ranges::any_of(legal, [text](auto name) { return name.starts_with(text); })) {
        return guess_by_spelling(text, legal);
    }
    if (is_preset(word) || is_modifier(word)) {
        return Guess{fmt::format("-f SPEC:{} or -t SPEC:{}", word, word)};
    }
    const auto meaning = find(other_options, text);
    return meaning ? meaning : guess_by_spelling(text, legal);
}

std::string suggestion(const std::optional<Guess>& guess) { return guess ? ";" + guess->said : ""; }

/// A word that is not one of the legal ones.
std::string unknown(std::string_view what, std::string_view text, const std::vector<std::string_view>& legal,
                    const std::optional<Guess>& guess) {
    return fmt::format("{} is not a known {} (legal: {}){}", quoted(text), what, fmt::join(legal, " "),
                       suggestion(guess));
}

} // namespace

std::string no_such_word(std::string_view what, std::string_view text, const std::vector<std::string_view>& legal) {
    return unknown(what, text, legal, guess_by_spelling(text, legal));
}

std::string no_such_option(std::string_view text, const std::vector<std::string_view>& legal) {
    const std::string_view name = text.substr(0, text.find('='));
    return unknown("option", name, legal, guess_option(name, legal));
}

std::string no_such_method(RepresentationId from, RepresentationId to, std::string_view text) {
    const std::string pair = fmt::format("{} to {}", representation(from).text, representation(to).text);
    const auto rows = methods_of(from, to);
    if (rows.empty()) {
        return fmt::format("{}: from {} only default, fast and all are known", quoted(text), pair);
    }
    auto legal = mapped(rows, &Method::name);
    legal.insert(legal.begin(), default_method);
    legal.insert(legal.end(), {fast_method, all_methods});
    std::string message = fmt::format("{} is not a known method from {}{}; legal:\n  {:<18} {}", quoted(text), pair,
                                      suggestion(guess_by_spelling(text, legal)), default_method, every_input);
    for (const Method& method : rows) {
        message += fmt::format("\n  {:<18} {}", method.name, method.domain);
    }
    message +=
        fmt::format("\n  {:<18} {}\n  {:<18} each of these, one line for each", fast_method, every_input, all_methods);
    return message;
}

std::string no_operand(std::string_view word, int error, const std::vector<std::string_view>& commands) {
    const std::string mended = mend(word);
    return fmt::format("argument: {} is not a number, and cannot be read as a FILE: {}{}", quoted(word),
                       std::generic_category().message(error),
                       mended.empty() ? suggestion(guess_operand(word, commands)) : mended);
}

std::string explain(const SpecError& error) {
    using What = SpecError::What;
    const auto not_known = [&error](std::string_view what, const std::vector<std::string_view>& legal) {
        return unknown(what, error.text, legal, guess_spec(error, legal));
    };
    const auto sequences = all_sequences();
    switch (error.what) {
    case What::unknown_name: return not_known("representation", all_names());
    case What::no_sequence:
        return fmt::format("euler needs its sequence, as in euler:ZYX (legal: {})", fmt::join(sequences, " "));
    case What::unknown_sequence: return not_known("Euler sequence", {sequences.begin(), sequences.end()});
    case What::unknown_modifier: {
        auto legal = words_of(error.in->modifiers);
        std::ranges::copy(all_presets(), std::back_inserter(legal));
        return not_known(fmt::format("modifier of {}", error.in->text), legal);
    }
    case What::meaningless_modifier:
        return fmt::format("{} has no meaning for {} (legal: {} and one of the presets {})", quoted(error.text),
                           error.in->text, fmt::join(words_of(error.in->modifiers), " "),
                           fmt::join(all_presets(), " "));
    case What::second_preset: return fmt::format("{} is a second preset; at most one is allowed", quoted(error.text));
    case What::two_orders: return fmt::format("{} has the scalar first and last", quoted(error.text));
    }
    return {};
}

std::string mend(std::string_view text) {
    std::string rest(text);
    std::erase_if(rest, [](char c) {
        return std::string_view("0123456789+-.*/,; \t\r\n[](){}").find(c) != std::string_view::npos;
    });
    for (const Meaning& mark : marks) {
        for (std::string_view words = mark.words.substr(1); !words.empty(); words.remove_prefix(words.find(' ') + 1)) {
            std::string repeated;
            while (repeated.size() < rest.size()) {
                repeated += words.substr(0, words.find(' '));
            }
            if (!rest.empty() && repeated == rest) {
                return fmt::format("; {}", mark.text);
            }
        }
    }
    const std::size_t bracket = text.find_first_of("[](){}");
    if (rest.ends_with('=') || rest.ends_with("\":") || rest == "dtype=float") {
        return "; write only the numbers, in the order of the SPEC (rotconv list shows it)";
    }
    const std::size_t inside = text.find_first_not_of("[](){} \t\r\n+-.", bracket);
    if (!rest.empty() && text.starts_with(rest[0]) && inside != std::string_view::npos &&
        is_alphanumeric(text[inside]) && text.find_first_of("0123456789", bracket) == inside) {
        return fmt::format("; numbers in brackets are read, but without {}", quoted(text.substr(0, bracket)));
    }
    if (rest.empty() && bracket == 0 && text.find_first_of("0123456789") == std::string_view::npos) {
        return "; put brackets and numbers in one pair of quotes";
    }
    bool parts_both = false; // commas, and blanks that do not follow one
    for (std::size_t i = 1; i < text.size(); ++i) {
        parts_both = parts_both || ((text[i] == ' ' || text[i] == '\t') && text[i - 1] != ',' && text[i - 1] != ' ');
    }
    return rest.empty() && parts_both ? "; only blanks may be between numbers, or only commas (and no decimal commas)"
                                      : "";
}

std::string mend(const stream::RowError& error) {
    using What = stream::RowError::What;
    const bool has_comma = error.text.find(',') != std::string::npos && !error.text.ends_with(',');
    const bool is_count = error.what == What::wrong_count && has_comma;
    const std::string mended = is_count || error.what == What::not_a_number ? mend(error.text) : "";
    const bool may_be_decimal = error.found == 2 * error.expected && error.text.find('.') == std::string::npos;
    return mended.empty() && is_count && may_be_decimal ? "; decimal commas must be points" : mended;
}

std::string answer_to_verb(std::string_view word) { return find(verbs, word).value_or(Guess{}).text; }

} // namespace rotconv::cli::messages
