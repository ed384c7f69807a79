#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>
#include <system_error>
#include <variant>

#include "../methods/method.hpp"
#include "meanings.hpp"
#include "messages.hpp"

namespace rotconv::cli::messages {
namespace {

using Legal = std::vector<std::string_view>;

/// What a user may have meant by a word that rotconv does not know.
struct Guess {
    std::string text; ///< a legal text; empty: nothing needs to be written
    std::string said = fmt::format(" did you mean {}?", text);
};

/// What to write for words of numbers that have nothing else but one of these, or it several times.
struct Mark {
    std::string_view text;
    std::string_view words; ///< each between blanks
};
constexpr auto marks = std::to_array<Mark>({
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

/// The word is the same but for marks and capitals.
bool is_alike(std::string_view one, std::string_view other) {
    return without_marks(lower(one)) == without_marks(lower(other));
}

/// The legal word that is written alike, or at most two letters away (one, below five letters).
std::optional<Guess> guess_by_spelling(std::string_view text, const Legal& legal) {
    std::optional<Guess> best;
    std::size_t least = without_marks(text).size() < 5 ? 2 : 3;
    for (const std::string_view word : legal) {
        const std::size_t distance = is_alike(word, text) ? 0 : edit_distance(lower(text), lower(word));
        if (distance < least) {
            least = distance;
            best = Guess{std::string(word)};
        }
    }
    return best;
}

bool is_preset(std::string_view word) { return std::ranges::count(presets(), word, &Project::text) != 0; }

bool is_modifier(std::string_view word) {
    return std::ranges::count(all_modifiers, word, [](Modifier modifier) { return name_of(modifier); }) != 0;
}

bool has_modifier(const Representation& entry, std::string_view word) {
    return std::ranges::count(words_of(entry.modifiers), word) != 0;
}

/// What the table of words says.
std::optional<Guess> guess_meaning(std::string_view word) {
    const Meaning* const meaning = find_meaning(word);
    if (meaning == nullptr) {
        return std::nullopt;
    }
    Guess guess{std::string(meaning->instead)};
    guess.said = fmt::format("{}{}{}", meaning->instead.empty() ? "" : guess.said, meaning->about.empty() ? "" : " ",
                             meaning->about);
    return guess;
}

/// A project by one of its names, in any case and with other marks.
const Project* project_called(std::string_view word) {
    const auto found = std::ranges::find_if(projects(), [word](const Project& each) {
        return std::ranges::any_of(words_in(fmt::format("{} {}", each.text, each.others)),
                                   [word](const std::string& name) { return is_alike(name, word); });
    });
    return found == projects().end() ? nullptr : &*found;
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
    if (is_preset(project->text) && project->text != word) {
        return Guess{std::string(project->text)};
    }
    const std::string_view mark = project->specs.empty() || project->remark.empty() ? "" : "; ";
    return Guess{{}, fmt::format(" {}: {}{}{}", project->text, project->specs, mark, project->remark)};
}

/// The SPEC of a sequence in other ways of writing: 321, eulerZYX, euler-zyx, z-y'-x'', and Gohlke's rzyx (rotating
/// axes) and sxyz (static ones).
std::optional<Guess> guess_sequence(std::string_view text) {
    std::string letters = without_marks(text);
    bool is_clear = false;                                 // which axes are meant
    const auto exchange = [&letters](char from, char to) { // three letters or digits from these on
        for (char& c : letters) {
            c = c >= from && c <= from + 2 ? static_cast<char>(to + (c - from)) : c;
        }
    };
    if (text.find('\'') != std::string_view::npos) {
        exchange('x', 'X');
        is_clear = true;
    }
    if (lower(letters).starts_with("euler")) {
        letters.erase(0, 5);
    }
    if (letters.size() == 4 && (letters[0] == 'r' || letters[0] == 's')) {
        exchange('x', letters[0] == 'r' ? 'X' : 'x');
        letters.erase(0, 1);
        is_clear = true;
    }
    exchange('1', 'X');
    const auto sequence = EulerSequence::parse(letters);
    if (!sequence) {
        return std::nullopt;
    }
    Guess guess{"euler:" + letters};
    if (!is_clear && letters == lower(letters)) {
        exchange('x', 'X');
        guess.said += fmt::format(" (about the fixed axes; about the body's own axes: euler:{})", letters);
    }
    return guess;
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

/// The rule for every word: what the word means elsewhere, another way of writing what is known, and then a legal word
/// that is spelled nearly so. Never the nearest that is not near.
std::optional<Guess> guess_word(std::string_view word, const Legal& legal) {
    if (auto guess = guess_meaning(word)) {
        return guess;
    }
    if (auto guess = guess_project(word)) {
        return guess;
    }
    if (auto guess = guess_sequence(word)) {
        return guess;
    }
    std::string spec(word); // such as quat_xyzw
    std::ranges::replace_if(
        spec, [](char c) { return c == '_' || c == '-'; }, ':');
    return std::holds_alternative<Spec>(parse_spec(spec)) ? Guess{spec} : guess_by_spelling(word, legal);
}

/// A word in the place of the name in a SPEC.
std::optional<Guess> guess_name(std::string_view word) {
    const Project* const project = project_called(word);
    auto guess = guess_owner(project != nullptr && is_preset(project->text) ? project->text : word);
    return guess ? guess : guess_word(word, all_names());
}

/// A word in the place of the letters of an Euler sequence, or of a modifier.
std::optional<Guess> guess_in_spec(const SpecError& error, const Legal& legal) {
    const std::string& word = error.text;
    if (error.what == SpecError::What::unknown_sequence && (is_preset(word) || is_modifier(word))) {
        return Guess{fmt::format("euler:ZYX:{}", word)};
    }
    auto guess = guess_word(word, legal);
    return guess && is_modifier(guess->text) && !has_modifier(*error.in, guess->text) ? std::nullopt : guess;
}

/// A word that is neither an option nor a number nor a FILE; `commands`: the words that could stand in its place.
std::optional<Guess> guess_operand(std::string_view word, const Legal& commands) {
    if (std::holds_alternative<Spec>(parse_spec(word))) {
        return Guess{fmt::format("-f {} or -t {}", word, word)};
    }
    if (const auto at = word.find('2'); at != std::string_view::npos) { // such as rpy2quat
        const auto from = guess_name(word.substr(0, at));
        const auto to = guess_name(word.substr(at + 1));
        if (from && to && !from->text.empty() && !to->text.empty()) {
            return Guess{fmt::format("-f {} -t {}", from->text, to->text)};
        }
    }
    return guess_word(word, commands);
}

std::optional<Guess> guess_option(std::string_view text, const Legal& legal) {
    const std::string_view word = text.substr(std::min(text.find_first_not_of('-'), text.size()));
    const auto begun = std::ranges::find_if(legal, [text](std::string_view name) { return name.starts_with(text); });
    if (auto guess = guess_meaning(word); guess && !is_modifier(guess->text)) { // an option may be another command's
        return guess->text == text ? Guess{{}, fmt::format(" {}", find_meaning(word)->about)} : guess;
    }
    if (word.size() > 2 && begun != legal.end()) { // such as --prec
        return Guess{std::string(*begun)};
    }
    auto guess = is_preset(word) || is_modifier(word) ? Guess{fmt::format("-f SPEC:{} or -t SPEC:{}", word, word)}
                                                      : guess_word(text, legal);
    return guess && is_modifier(guess->text) ? std::nullopt : guess;
}

std::string suggestion(const std::optional<Guess>& guess) { return guess ? ";" + guess->said : ""; }

/// What `said` that a word is unknown: with the legal ones, if they are few, and the guess, or where they are listed.
std::string unknown(const std::string& said, const Legal& legal, const std::optional<Guess>& guess,
                    std::string_view where = "see rotconv --help") {
    constexpr std::size_t few = 8;
    const std::string list = legal.size() > few ? "" : fmt::format(" (legal: {})", fmt::join(legal, " "));
    return said + list + (guess || legal.size() <= few ? suggestion(guess) : fmt::format("; {}", where));
}

} // namespace

std::string no_such_word(std::string_view what, std::string_view text, const std::vector<std::string_view>& legal) {
    const auto guess = guess_by_spelling(text, legal);
    return unknown(fmt::format("{} is not a known {}", quoted(text), what), legal, guess ? guess : guess_meaning(text));
}

std::string no_such_option(std::string_view text, const std::vector<std::string_view>& legal) {
    const std::string_view name = text.substr(0, text.find('='));
    return unknown(quoted(name) + " is not a known option", legal, guess_option(name, legal));
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
    const std::string said = message(SpecError{error.what, shortened(error.text), error.in});
    const auto legal = error.in == nullptr ? Legal() : words_of(error.in->modifiers);
    const std::string list = fmt::format("legal: {} and the presets of rotconv list presets", fmt::join(legal, " "));
    switch (error.what) {
    case What::unknown_name:
        return unknown(said, all_names(), guess_name(error.text),
                       "rotconv list has them, rotconv list projects those of programs");
    case What::no_sequence: return fmt::format("{} (legal: {})", said, fmt::join(all_sequences(), " "));
    case What::unknown_sequence: {
        const auto sequences = all_sequences();
        Legal letters{sequences.begin(), sequences.end()};
        letters.push_back(representation(RepresentationId::rpy).text);
        return unknown(said, letters, guess_in_spec(error, letters),
                       "it has three letters, neighbours different; rotconv list euler explains them");
    }
    case What::unknown_modifier: {
        auto words = legal;
        std::ranges::copy(all_presets(), std::back_inserter(words));
        return unknown(said, words, guess_in_spec(error, words), list);
    }
    case What::meaningless_modifier: return fmt::format("{} ({})", said, list);
    case What::second_preset:
    case What::two_orders: break;
    }
    return said;
}

std::string mend(std::string_view text) {
    std::string rest(text);
    std::erase_if(rest, [](char c) {
        return std::string_view("0123456789+-.*/,; \t\r\n[](){}").find(c) != std::string_view::npos;
    });
    for (const Mark& mark : marks) {
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

std::string answer_to_verb(std::string_view word) {
    const Meaning* const meaning = find_meaning(word);
    return meaning != nullptr && meaning->is_verb ? guess_meaning(word)->said.substr(1) : "";
}

} // namespace rotconv::cli::messages
