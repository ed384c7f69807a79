#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <system_error>
#include <variant>

#include "../core/projects.hpp"
#include "../methods/method.hpp"
#include "command.hpp"
#include "meanings.hpp"
#include "messages.hpp"

namespace rotconv::cli::messages {
namespace {

using Legal = std::vector<std::string_view>;

/// What a user may have meant by a word that rotconv does not know.
struct Guess {
    std::string text;     ///< a legal text; empty: nothing needs to be written
    std::string before{}; ///< what is said before it, and after
    std::string after{};
};

/// Where the word stands.
enum class Place : std::uint8_t { command_line, name, sequence, modifier };

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

/// The word is the same except for marks and capitals.
bool is_alike(std::string_view one, std::string_view other) {
    return without_marks(lower(one)) == without_marks(lower(other));
}

bool is_modifier(std::string_view word) {
    return std::ranges::count(all_modifiers, word, [](Modifier modifier) { return name_of(modifier); }) != 0;
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

/// What the table of words says.
std::optional<Guess> guess_meaning(std::string_view word) {
    const Meaning* const meaning = find_meaning(word);
    return meaning == nullptr ? std::nullopt
                              : std::optional(Guess{std::string(meaning->instead), "", std::string(meaning->about)});
}

/// What the numbers of a project are, by one of its names, in any case and with other marks.
std::optional<Guess> guess_project(std::string_view word) {
    const auto has_name = [word](const Project& each) {
        const auto names = words_in(fmt::format("{} {}", each.text, each.others));
        return std::ranges::any_of(names, [word](const std::string& name) { return is_alike(name, word); });
    };
    const auto project = std::ranges::find_if(projects(), has_name);
    if (project == projects().end()) {
        return std::nullopt;
    }
    if (project->is_spec()) {
        return Guess{std::string(project->text), "", fmt::format("(a SPEC itself, {})", project->specs)};
    }
    return Guess{std::string(is_preset(project->text) ? project->text : ""),
                 fmt::format("{}: {}{}{}", project->text, project->specs,
                             project->specs.empty() || project->remark.empty() ? "" : "; ", project->remark)};
}

/// The SPEC of a sequence in other ways of writing: 321, eulerZYX, euler-zyx, z-y'-x'', and Gohlke's rzyx (rotating
/// axes) and sxyz (static ones).
std::optional<Guess> guess_sequence(std::string_view text) {
    std::string letters = without_marks(text);
    if (lower(letters).starts_with("euler")) {
        letters.erase(0, 5);
    }
    const char kind = letters.size() == 4 ? letters[0] : ' ';
    letters.erase(0, kind == 'r' || kind == 's' ? 1 : 0);
    const bool is_primed = text.find('\'') != std::string_view::npos;
    const auto upper = [](char c) { return c >= 'x' && c <= 'z' ? static_cast<char>(c - 'x' + 'X') : c; };
    for (char& c : letters) {
        c = c >= '1' && c <= '3' ? static_cast<char>(c - '1' + 'X') : kind == 'r' || is_primed ? upper(c) : c;
    }
    if (!EulerSequence::parse(letters)) {
        return std::nullopt;
    }
    Guess guess{"euler:" + letters};
    if (letters == lower(letters) && kind != 's') {
        std::ranges::transform(letters, letters.begin(), upper);
        guess.after = fmt::format("(about the fixed axes; about the body's own axes: euler:{})", letters);
    }
    return guess;
}

/// The rule for every word: what it means elsewhere, a project, another way of writing what is known, and then a legal
/// word that is spelled nearly so. Never the nearest that is not near.
std::optional<Guess> guess_word(std::string_view text, const Legal& legal) {
    const std::string_view word = text.substr(std::min(text.find_first_not_of('-'), text.size()));
    if (is_modifier(word)) {
        return Guess{std::string(word)};
    }
    for (const auto guess_in : {guess_meaning, guess_project, guess_sequence}) {
        if (auto guess = guess_in(word)) {
            return guess;
        }
    }
    std::string spec(word); // such as quat_xyzw
    std::ranges::replace_if(
        spec, [](char c) { return c == '_' || c == '-'; }, ':');
    return is_spec(spec) ? Guess{spec} : guess_by_spelling(text, legal);
}

/// The guess as it is written in the place of the word; nothing for a modifier that has no meaning there.
std::optional<Guess> in_place(std::optional<Guess> guess, Place place, const Representation* entry = nullptr) {
    if (!guess || guess->text.empty()) {
        return guess;
    }
    std::string& text = guess->text;
    const bool has_modifier = is_modifier(text);
    const auto takes = [&text](const Representation& each) {
        return std::ranges::count(words_of(each.modifiers), text) != 0;
    };
    const auto spec_with = [&text](std::string_view name) {
        return fmt::format("{}:{}", name == "euler" ? "euler:ZYX" : name, text);
    };
    if (place == Place::modifier) {
        guess->before.clear();
        return has_modifier && !takes(*entry) ? std::nullopt : guess;
    }
    if (place == Place::command_line && is_spec(text)) {
        text = fmt::format("-f {} or -t {}", text, text);
    } else if (!has_modifier && !is_preset(text)) {
        return guess;
    } else if (place == Place::command_line) {
        text = fmt::format("-f {} or -t {}", spec_with("SPEC"), spec_with("SPEC"));
    } else if (place == Place::sequence) {
        text = spec_with("euler");
    } else if (has_modifier) { // of the first representation that takes it
        text = spec_with(representation(*std::ranges::find_if(all_representations, [&takes](RepresentationId id) {
                             return takes(representation(id));
                         })).text);
    } else { // of the project's first SPEC
        const std::string_view specs = find_project(text)->specs;
        const std::string_view name = specs.substr(0, specs.find_first_of(": ;"));
        text = fmt::format("{}:{}", name, text);
    }
    return guess;
}

/// A word in the place of the name in a SPEC.
std::optional<Guess> guess_name(std::string_view word) { return in_place(guess_word(word, all_names()), Place::name); }

/// A word that is neither an option nor a number nor a FILE; `commands`: the words that could stand in its place.
std::optional<Guess> guess_operand(std::string_view word, const Legal& commands) {
    if (const auto at = word.find('2'); at != std::string_view::npos) { // such as rpy2quat
        const auto from = guess_name(word.substr(0, at));
        const auto to = guess_name(word.substr(at + 1));
        if (from && to && !from->text.empty() && !to->text.empty()) {
            return Guess{fmt::format("-f {} -t {}", from->text, to->text)};
        }
    }
    return in_place(guess_word(word, commands), Place::command_line);
}

std::optional<Guess> guess_option(std::string_view text, const Legal& legal) {
    auto guess = guess_meaning(text);
    if (guess && !guess->text.empty() && !is_modifier(guess->text) && guess->text != text) {
        return in_place(guess, Place::command_line);
    }
    std::vector<std::string_view> others; // commands that have the option
    for (const CommandEntry& each : command_table()) {
        if (each.options()->find(text) != nullptr) {
            others.push_back(each.name.empty() ? "the conversion" : each.name);
        }
    }
    if (!others.empty()) {
        return Guess{"", fmt::format("it is an option of {}", fmt::join(others, ", ")), guess ? guess->after : ""};
    }
    const auto begun = filtered(legal, [text](std::string_view name) { return name.starts_with(text); });
    return text.size() > 4 && begun.size() == 1 // such as --prec
               ? Guess{std::string(begun[0])}
               : in_place(guess_word(text, legal), Place::command_line);
}

std::string suggestion(const std::optional<Guess>& guess) {
    if (!guess) {
        return "";
    }
    std::string said = guess->before.empty() ? "" : "; " + guess->before;
    said += guess->text.empty()     ? ""
            : guess->before.empty() ? fmt::format("; did you mean {}?", guess->text)
                                    : fmt::format("; for example {}", guess->text);
    return said + (guess->after.empty() ? "" : (guess->text.empty() ? "; " : " ") + guess->after);
}

/// What `said` that a word is unknown: with the legal ones, if they are few, and the guess, or where they are listed.
std::string unknown(const std::string& said, const Legal& legal, const std::optional<Guess>& guess,
                    std::string_view where = "see rotconv --help") {
    constexpr std::size_t few = 8;
    const std::string list = legal.size() > few ? "" : fmt::format(" (legal: {})", fmt::join(legal, " "));
    return said + list + (guess || legal.size() <= few ? suggestion(guess) : fmt::format("; {}", where));
}

} // namespace

bool is_spec(std::string_view word) { return std::holds_alternative<Spec>(parse_spec(word)); }

bool is_preset(std::string_view word) { return std::ranges::count(presets(), word, &Project::text) != 0; }

std::string no_such_word(std::string_view what, std::string_view text, const std::vector<std::string_view>& legal) {
    return unknown(fmt::format("{} is not a known {}", quoted(text), what), legal, guess_by_spelling(text, legal));
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
    std::string said = message(SpecError{error.what, shortened(error.text), error.in});
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
        return unknown(said, letters, in_place(guess_word(error.text, letters), Place::sequence),
                       "it has three letters, neighbours different; rotconv list euler explains them");
    }
    case What::unknown_modifier: {
        auto words = legal;
        std::ranges::copy(all_presets(), std::back_inserter(words));
        return unknown(said, words, in_place(guess_word(error.text, words), Place::modifier, error.in), list);
    }
    case What::meaningless_modifier: return fmt::format("{} ({})", said, list);
    case What::second_preset:
    case What::two_orders: break;
    }
    return said;
}

std::string mend(std::string_view text) {
    constexpr std::string_view of_numbers = "0123456789+-.*/,; \t\r\n[](){}<>";
    if (text.find('\\') != std::string_view::npos) { // of DICOM
        return "; write blanks for backslashes";
    }
    std::string rest(text);
    std::ranges::replace_if(
        rest, [of_numbers](char c) { return of_numbers.find(c) != std::string_view::npos; }, ' ');
    const auto words = words_in(rest);
    const auto meanings = mapped(words, [](const std::string& word) { return find_meaning(word); });
    if (!words.empty()) { // nothing but one thing, perhaps several times: 90deg, 0.8 + 0.6i
        const Meaning* const first = meanings.front();
        const bool is_one = first != nullptr && first->instead.empty() && !first->in_spec &&
                            std::ranges::count(meanings, first) == std::ranges::ssize(meanings);
        return is_one ? fmt::format("; {}", first->about) : "";
    }
    bool has_blank = false; // that does not follow a comma
    for (std::size_t i = 1; i < text.size(); ++i) {
        has_blank = has_blank || ((text[i] == ' ' || text[i] == '\t') && text[i - 1] != ',' && text[i - 1] != ' ');
    }
    return has_blank && text.find(',') != std::string_view::npos
               ? "; only blanks may be between numbers, or only commas (and no decimal commas)"
               : "";
}

std::string mend(const stream::RowError& error) {
    using What = stream::RowError::What;
    const bool is_count = error.what == What::wrong_count;
    const std::string mended = is_count || error.what == What::not_a_number ? mend(error.text) : "";
    const bool may_be_decimal = is_count && error.found == 2 * error.expected && !error.text.ends_with(',') &&
                                error.text.find(',') != std::string::npos && error.text.find('.') == std::string::npos;
    return mended.empty() && may_be_decimal ? "; if these are decimal commas: write points" : mended;
}

std::string meaning_of_verb(std::string_view word) {
    const Meaning* const meaning = find_meaning(word);
    return meaning != nullptr && meaning->is_verb ? suggestion(guess_meaning(word)).substr(2) : "";
}

} // namespace rotconv::cli::messages
