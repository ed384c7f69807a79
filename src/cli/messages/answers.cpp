#include "answers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <tuple>
#include <utility>
#include <variant>

#include "../../core/projects.hpp"
#include "../../stream/beginning/header_line.hpp"
#include "../../stream/bytes/file.hpp"
#include "../../stream/bytes/io_block.hpp"
#include "../../stream/numbers/number_text.hpp"
#include "../../stream/run.hpp"
#include "../grammar/column_names.hpp"
#include "../grammar/value_text.hpp"
#include "../row_options.hpp"
#include "messages.hpp"

namespace rotconv::cli {
namespace {

/// A command line, and what it reads.
struct Attempt {
    std::vector<std::string> words;
    std::string pipe{};                   ///< see Mend
    std::optional<std::string> text{};    ///< the beginning of its input; nothing: not at hand, or in the FILE
    bool may_read_pipe = false;           ///< nothing else will
    bool says_radians = false;            ///< as it was given
    bool has_guess = false;               ///< its SPEC is a guess
    std::vector<Edit> order{};            ///< see Mend: still to be made
    std::vector<std::string> axes{};      ///< options for those of the projects that it names, or that were named
    std::optional<std::size_t> letters{}; ///< which of the mends was taken that are a sequence in both cases

    [[nodiscard]] Attempt after(const Mend& mend) const {
        Attempt next = *this;
        next.order.insert(next.order.end(), mend.order.begin(), mend.order.end());
        auto edits = mend.edits;
        const auto end = std::ranges::find(words, "--") - words.begin();
        for (Edit& edit : edits) {
            edit.at.word = edit.at.word == Edit::at_end ? static_cast<std::size_t>(end) : edit.at.word;
        }
        std::ranges::stable_sort(edits, std::ranges::greater(), [](const Edit& edit) { return edit.at.word; });
        for (Edit& edit : edits) {
            const auto at = next.words.begin() + static_cast<std::ptrdiff_t>(edit.at.word);
            if (edit.at.begin > 0 && !edit.by.empty()) {
                edit.by.front().insert(0, at->substr(0, edit.at.begin));
            }
            next.words.insert(next.words.erase(at, at + static_cast<std::ptrdiff_t>(edit.count)), edit.by.begin(),
                              edit.by.end());
        }
        if (!mend.pipe.empty()) {
            next.pipe += (pipe.empty() ? "" : " | ") + mend.pipe;
            next.text = mend.text;
        }
        return next;
    }
    [[nodiscard]] Attempt in_order() const {
        Attempt next = *this;
        next.order.clear();
        return next.after(Mend{order});
    }
    [[nodiscard]] std::string command() const {
        const auto texts = mapped(words, [](const std::string& word) {
            return word.starts_with(raw_word) ? word.substr(raw_word.size()) : in_shell(word);
        });
        return fmt::format("{}{}rotconv {}", pipe, pipe.empty() ? "" : " | ", fmt::join(texts, " "));
    }
};

enum class RowNamesKind : std::uint8_t { none, others, own };

/// What names the rows have. That they are as many as the attitude's numbers proves nothing.
RowNamesKind names_of_rows(const stream::InputOptions& input, std::string_view text) {
    bool has_names = false;
    bool has_row = false;
    for (int left = 100; left > 0 && !text.empty() && input.columns.empty() && input.columns_of; --left) {
        const stream::Line line = stream::next_line(text);
        if (!input.is_row(line.text)) {
            continue;
        }
        const stream::HeaderLine header(line, input.delimiter.value_or(stream::Delimiter::of_row(line.text)));
        if (std::ranges::any_of(header.fields, stream::is_number)) {
            has_row = true;
        } else if (input.columns_of(header.names()).are_known) {
            return RowNamesKind::own;
        } else {
            has_names = has_names || !has_row;
        }
    }
    return has_names ? RowNamesKind::others : RowNamesKind::none;
}

/// What came of an attempt.
struct Outcome {
    bool serves = false;
    RowNamesKind names = RowNamesKind::none;
    bool is_tried = false;      ///< on the first rows
    bool is_of_project = false; ///< which has several SPECs
    bool is_of_values = false;  ///< which mean another SPEC
    bool guesses_spec = false;  ///< see Usage
    bool stops = false;         ///< at a row of another width, behind which there are more
    std::vector<Edit> better{}; ///< the units that the rows have
    MendGroups mends{};         ///< otherwise: the first group of which one serves counts
};

constexpr double most_tolerated = 0.05;

/// Typed, which people do not normalize.
bool is_quaternion_of_any_norm(const CommandOptions& options, const stream::RowError& error) {
    return !options.values.empty() && error.norm > 0.0 && error.defect >= most_tolerated;
}

/// Where the numbers may be a rotation: the tolerances that may take them.
MendGroups with_more_tolerance(const CommandOptions& options, const stream::RowError& error) {
    MendGroups mends;
    for (const char* each : {"0.01", "0.1", "inf"}) {
        if (may_be_tolerated(options, error) && is_quaternion_of_any_norm(options, error) == (each[0] == 'i')) {
            mends.push_back({{{OptionSet::setting(*options.find("--tolerance"), each)}}});
        }
    }
    return mends;
}

/// What a run tells of its rows.
struct Told {
    std::optional<stream::RowError> wrong{}; ///< the first
    std::vector<Edit> better{};
    std::vector<Edit> noted{};    ///< those that a note has
    bool has_other_order = false; ///< than the names say
    bool is_whole_text = false;   ///< which has no header
    std::size_t columns_line = 0; ///< of the row whose columns were taken by their names; 0: they were selected

    void take(const stream::Event& event, bool says_radians) {
        if (const auto* const diagnostic = std::get_if<stream::Diagnostic>(&event)) {
            if (diagnostic->kind == DiagnosticKind::large_angle && better.empty() && !says_radians) {
                better.push_back({{Edit::at_end}, 0, {"-d"}});
            }
        } else if (const auto* const note = std::get_if<stream::Note>(&event)) {
            has_other_order = has_other_order || note->kind == stream::Note::Kind::order;
            is_whole_text = is_whole_text || note->kind == stream::Note::Kind::text;
            columns_line = note->kind == stream::Note::Kind::columns ? note->place.line : columns_line;
            if (!note->words.empty()) {
                better.push_back({{Edit::at_end}, 0, note->words});
                noted.push_back(better.back());
            }
        } else if (const auto* const error = std::get_if<stream::RowError>(&event); error != nullptr && !wrong) {
            wrong = *error;
        }
    }
};

/// What may read the rows at which a run ended.
/// @param reference the beginning of the REFERENCE
MendGroups mends_of(const RowsCommand& command, const stream::RunResult& ending, const Told& told,
                    const std::string& text, const std::optional<std::string>& reference, bool has_guess) {
    using What = stream::RowError::What;
    const auto& [error, wrong] = std::tie(ending.error, told.wrong);
    if (wrong && wrong->what == What::attitude) {
        return told.has_other_order ? name_mends(command, text, wrong->place.line)
                                    : with_more_tolerance(*command.line, *wrong);
    }
    if (command.has_values || command.options.input.width > 0) {
        return wrong && wrong->what == What::wrong_count
                   ? messages::meant_by_values(*command.line, command.options.input.numbers)
                   : MendGroups();
    }
    if ((error && error->place.is_in_reference()) || (wrong && wrong->place.is_in_reference())) {
        return reference_mends(command, text, *reference);
    }
    if (error && error->what == stream::StreamError::What::json) {
        return json_mends(command, text, has_guess);
    }
    const std::size_t line = error ? error->place.line : wrong ? wrong->place.line : 0;
    return line > 0 ? row_mends(command, text, line, has_guess, ending.answered > 0) : MendGroups();
}

/// Runs the rows at hand, and tells nothing.
Outcome outcome_of(const RowsCommand& command, const Attempt& attempt, const std::string& text, bool whole,
                   bool needs_mends) {
    Told told;
    stream::Options options = command.options;
    options.threads = 1;
    options.writes_rows = false;
    stream::TextSource of_text{text};
    stream::Source& source = command.source ? *command.source : of_text;
    const auto bytes = first_bytes(command.reference);
    if (!command.reference.empty() && !bytes) {
        return {.serves = true};
    }
    stream::TextSource reference(bytes.value_or(""));
    const auto ending = stream::run(
        source, nullptr, options, [&](const auto& event) { told.take(event, attempt.says_radians); },
        bytes ? &reference : nullptr);
    using What = stream::RowError::What;
    const bool is_done = !ending.error && !told.wrong;
    Outcome outcome{.serves = ending.answered > 0 && (is_done || !whole)};
    outcome.stops = command.options.on_error == stream::OnError::stop && told.wrong &&
                    (told.wrong->what == What::wrong_count || told.wrong->what == What::other_width ||
                     told.wrong->what == What::missing_column) &&
                    told.wrong->place.line < static_cast<std::size_t>(std::ranges::count(text, '\n'));
    if (outcome.serves) {
        outcome.names = command.has_values || told.is_whole_text || options.input.width > 0
                            ? RowNamesKind::none
                            : names_of_rows(options.input, text);
        outcome.is_tried = outcome.names != RowNamesKind::others;
        outcome.better = told.better;
        if (command.strict && told.columns_line > 0) { // the note counts
            const auto named = name_mends(command, text, told.columns_line);
            const auto& more = named.empty() ? std::vector<Edit>() : named[0][0].edits;
            outcome.better.insert(outcome.better.end(), more.begin(), more.end());
        }
    }
    const bool is_of_number = outcome.serves && told.wrong && told.wrong->what == What::attitude;
    if (is_done || is_of_number || !needs_mends) {
        return outcome;
    }
    auto mends = mends_of(command, ending, told, text, bytes, attempt.has_guess);
    if (mends.empty() && !told.noted.empty()) {
        mends.push_back({Mend()});
    }
    for (auto& group : mends) {
        std::erase_if(group, [&](const Mend& mend) { return !mend.pipe.empty() && !attempt.pipe.empty(); });
    }
    for (auto& group : mends) { // and what a note says
        for (Mend& mend : group) {
            mend.edits.insert(mend.edits.end(), told.noted.begin(), told.noted.end());
        }
    }
    outcome.is_tried = outcome.is_tried || !outcome.serves;
    outcome.mends = std::move(mends);
    return outcome;
}

/// @param whole all rows at hand must be answered, not only the first
Outcome outcome_of(const Attempt& attempt, bool whole = false, bool needs_mends = false) {
    try {
        const Command command = read_command_line(mapped(attempt.words, [](const std::string& word) {
            return word.starts_with(raw_word) ? std::string("/dev/null") : word;
        }));
        const auto* const rows = std::get_if<RowsCommand>(&command);
        if (rows == nullptr) {
            return {.serves = true};
        }
        if (!attempt.pipe.empty() && stream::File::is_regular(rows->output.c_str())) {
            return {}; // it may be what the pipe reads
        }
        const bool is_read = rows->input == "-" && !rows->has_values && !rows->source;
        const bool is_pipe = attempt.may_read_pipe && is_read && !attempt.text && attempt.pipe.empty() &&
                             !stream::File::lines_of_pipe().empty();
        const auto text = attempt.text || !attempt.pipe.empty() ? attempt.text
                          : is_pipe                             ? std::optional(stream::File::lines_of_pipe())
                                                                : first_bytes(rows->input);
        return rows->has_values || text
                   ? outcome_of(*rows, attempt, text.value_or(""), whole || !attempt.pipe.empty(), needs_mends)
                   : Outcome{.serves = true};
    } catch (const Usage& error) {
        Outcome outcome{
            .is_of_project = error.is_choice, .is_of_values = !error.specs.empty(), .guesses_spec = error.guesses_spec};
        for (const Mend& mend : error.mends) { // each is a reading of its own
            outcome.mends.empty() ? outcome.mends.push_back({mend}) : outcome.mends.front().push_back(mend);
        }
        return outcome;
    }
}

/// The words with the name of the file that stdin is, if they name no input.
std::vector<std::string> with_input(std::vector<std::string> words) {
    const auto is_input = [&words](const std::string& word) {
        const bool is_argument = &word != words.data() && (&word)[-1].starts_with('-');
        return stream::File::is_regular(word.c_str()) || (!is_argument && stream::is_number(word));
    };
    const std::string name = stream::File::name_of_input();
    const auto dash = std::ranges::find(words, "-");
    if (name.empty() || !stream::File::is_regular(name.c_str())) {
        return words;
    }
    if (dash != words.end()) {
        *dash = name;
    } else if (std::ranges::none_of(words, is_input)) {
        words.insert(std::ranges::find(words, "--"), name);
    }
    return words;
}

/// The words with two dashes before options that have one: -from quat -to rpy -deg.
std::vector<std::string> with_dashes(std::vector<std::string> words) {
    const auto table = command_table();
    const auto entry = std::ranges::find(table, words.empty() ? "" : words.front(), &CommandEntry::name);
    const auto options = (entry == table.end() ? table.front() : *entry).options();
    for (std::string& word : words) {
        if (word.size() > 2 && word[0] == '-' && word[1] != '-' && options->knows('-' + word)) {
            word.insert(0, "-");
        }
    }
    return words;
}

/// Axes that people write as if they were a part of a SPEC: of navigation, with those of the body that go with them.
constexpr auto conventions_of_axes = std::to_array<Project>({{"ned", "", "", "", "ned", "frd", "", ""},
                                                             {"enu", "", "", "", "enu", "flu", "", ""},
                                                             {"frd", "", "", "", "", "frd", "", ""},
                                                             {"flu", "", "", "", "", "flu", "", ""}});

const Project* convention_of_axes(std::string_view name) {
    const auto* const found = std::ranges::find(conventions_of_axes, lower(name), &Project::text);
    return found == conventions_of_axes.end() ? nullptr : found;
}

/// The arguments of --from and --to: places among words, 0 for what is not given.
std::array<std::size_t, 2> specs_among(const std::vector<std::string>& words) {
    std::array<std::size_t, 2> places{};
    for (std::size_t i = 1; i < words.size(); ++i) {
        places[0] = words[i - 1] == "-f" || words[i - 1] == "--from" ? i : places[0];
        places[1] = words[i - 1] == "-t" || words[i - 1] == "--to" ? i : places[1];
    }
    return places;
}

std::vector<std::string> axes_of(const std::vector<std::string>& words) {
    const auto places = specs_among(words);
    return places[0] > 0 && places[1] > 0 ? axes_of_specs(words[places[0]], words[places[1]])
                                          : std::vector<std::string>();
}

/// The words without axes that are a part of both SPECs, or the whole of one.
std::vector<std::string> without_axes(std::vector<std::string> words) {
    const auto places = specs_among(words);
    std::array<std::string, 2> specs;
    for (std::size_t side = 0; side < 2; ++side) {
        const std::string spec = places.at(side) > 0 ? words[places.at(side)] : "";
        const auto parts = split(spec, ':');
        const auto others = filtered(parts, [](std::string_view part) { return convention_of_axes(part) == nullptr; });
        if (others.size() == parts.size()) {
            return words;
        }
        specs.at(side) = joined(others, ":");
    }
    for (const std::size_t side : {places[0] < places[1] ? 1U : 0U, places[0] < places[1] ? 0U : 1U}) {
        const auto word = words.begin() + static_cast<std::ptrdiff_t>(places.at(side));
        if (specs.at(side).empty()) {
            words.erase(word - 1, word + 1);
        } else {
            *word = specs.at(side);
        }
    }
    return words;
}

/// Follows mends, one after the other.
class Search {
public:
    explicit Search(const Attempt& wrong) {
        Attempt dashed = wrong;
        dashed.axes = axes_of(wrong.words);
        dashed.words = with_dashes(without_axes(wrong.words));
        follow(dashed, dashed.words == wrong.words ? 0 : 1);
    }

    [[nodiscard]] const std::vector<std::string>& found() const { return found_; } ///< commands

private:
    static constexpr std::size_t most_found = 2;
    static constexpr std::size_t longest = 500;
    static constexpr int deepest = 10;

    /// Whether they are a sequence with letters of both cases.
    static bool are_sequences(const std::vector<Mend>& group) {
        return group.size() == 2 && std::ranges::all_of(group, [](const Mend& mend) {
                   return !mend.edits.empty() && std::ranges::any_of(mend.edits[0].by, [](const std::string& word) {
                       return word.find("euler:") != std::string::npos;
                   });
               });
    }
    void keep(const Attempt& attempt, RowNamesKind names) {
        Attempt whole = attempt;
        whole.words.insert(std::ranges::find(whole.words, "--"), attempt.axes.begin(), attempt.axes.end());
        const bool has_axes = !attempt.axes.empty() && outcome_of(whole).serves;
        const std::string command = (has_axes ? whole : attempt).command();
        if (command.size() + std::string_view("try: ").size() <= longest && shown(command) == command &&
            std::ranges::count(found_, command) == 0) {
            found_.push_back(command);
            names_decide_ = names_decide_ || names == RowNamesKind::own;
        }
    }
    /// @param is_choice one of several mends was taken that are as good as each other
    // NOLINTNEXTLINE(misc-no-recursion): as deep as mends that follow each other
    void follow(const Attempt& attempt, int depth, bool is_choice = false) {
        if (depth > deepest || found_.size() >= most_ || --left_ < 0) {
            return;
        }
        Outcome outcome = outcome_of(attempt, depth == 0 || depth == deepest, depth < deepest);
        if (outcome.serves && !attempt.order.empty() && outcome.names != RowNamesKind::own) {
            follow(attempt.in_order(), depth, is_choice);
            return;
        }
        if (outcome.serves && depth > 0 && !outcome.better.empty()) {
            const Attempt better = attempt.after(Mend{outcome.better});
            if (outcome_of(better, true).serves) {
                follow(better, deepest, is_choice);
                return;
            }
        }
        is_of_project_ = is_of_project_ || outcome.is_of_project;
        // the SPECs of a project are not those that others write in the same words
        const bool is_done =
            depth == deepest || (outcome.is_of_values && (is_of_project_ || (attempt.has_guess && !found_.empty())));
        const std::size_t before = found_.size();
        for (auto group = outcome.mends.begin(); group != outcome.mends.end() && !is_done && found_.size() == before;
             ++group) {
            follow(attempt, depth, is_choice, outcome, *group);
        }
        if (outcome.serves && depth > 0 && found_.size() == before && // perhaps the first rows alone
            !(is_choice && outcome.names == RowNamesKind::others) && !(attempt.has_guess && outcome.stops)) {
            keep(attempt, outcome.names);
        }
    }
    /// Follows mends that are as good as each other: first for a command each, then for more.
    // NOLINTNEXTLINE(misc-no-recursion): see above
    void follow(const Attempt& attempt, int depth, bool is_choice, const Outcome& outcome, std::vector<Mend> group) {
        const std::size_t before = found_.size();
        const std::size_t most = most_;
        const bool has_letters = are_sequences(group);
        if (has_letters && attempt.letters == 1U) { // zyz to zyx is zyz to zyx, or ZYZ to ZYX
            std::swap(group.front(), group.back());
        }
        const bool is_first_choice = !is_choice && group.size() > 1;
        const auto is_decided = [&] { return outcome.guesses_spec && names_decide_; };
        for (const bool one_each : {true, false}) {
            if (!one_each && (is_decided() || (is_first_choice && found_.size() == before))) { // no more will be found
                break;
            }
            for (std::size_t i = 0; i < group.size() && (is_first_choice || !one_each); ++i) {
                if (one_each && is_decided()) {
                    break;
                }
                Attempt next = attempt.after(group[i]);
                next.has_guess = attempt.has_guess || outcome.guesses_spec;
                next.letters = has_letters && is_first_choice ? std::optional(i) : attempt.letters;
                next.axes = attempt.axes.empty() ? axes_of(next.words) : attempt.axes;
                most_ = one_each ? std::min(most, found_.size() + 1) : most;
                const bool is_last = outcome.is_tried && !group[i].keeps_lines; // rows have no second mend
                follow(next, is_last ? deepest : depth + 1, is_choice || group.size() > 1);
            }
        }
        most_ = most;
    }

    std::vector<std::string> found_{};
    std::size_t most_ = most_found; ///< of the commands, so far
    int left_ = 100;                ///< attempts
    bool names_decide_ = false;     ///< those of the rows are the SPEC's: no other is meant
    bool is_of_project_ = false;    ///< the command names a project that has several SPECs
};

} // namespace

std::vector<std::string> axes_of_specs(const std::string& from, const std::string& to) {
    const auto project_of = [](const std::string& specs) {
        const Project* found = nullptr;
        for (const std::string_view part : split(split(specs, ',').front(), ':')) { // all after -t have the same axes
            for (const std::string_view name : {part.substr(0, part.find_first_of("-_")), part}) { // unity-quat
                const Project* const project = find_project(name);
                const Project* const own = project != nullptr ? project : convention_of_axes(name);
                found = own != nullptr ? own : found;
            }
        }
        return found;
    };
    const Project* const own = project_of(from);
    const Project* const other = project_of(to);
    return words_in(own != nullptr && other != nullptr ? change_of_axes(*own, *other) : "");
}

bool may_be_tolerated(const CommandOptions& options, const stream::RowError& error) {
    return error.what == stream::RowError::What::attitude && error.error == Error::defect &&
           (error.defect < most_tolerated || is_quaternion_of_any_norm(options, error)) &&
           options.missing("--tolerance") != nullptr;
}

std::optional<std::string> first_bytes(const std::string& path) {
    if (!stream::File::is_regular(path.c_str())) {
        return std::nullopt;
    }
    stream::File file(path.c_str(), stream::File::Mode::read);
    std::string text(file.is_open() ? std::min(file.size(), most_first_bytes) : 0, '\0');
    const std::ptrdiff_t count = text.empty() ? 0 : file.read(text);
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    if (text.size() == most_first_bytes) { // its last line is cut
        text.resize(text.rfind('\n') + 1);
    }
    return text;
}

std::optional<SimpleRows> simple_rows(std::string_view text) {
    if (text.find_first_of("\"\r\xEF") != std::string_view::npos) {
        return std::nullopt;
    }
    const stream::Line line = stream::next_line(text);
    const stream::HeaderLine first(line, stream::Delimiter::of_row(line.text));
    const bool is_header = std::ranges::none_of(first.fields, stream::is_number);
    return SimpleRows{std::string(1, first.delimiter.text()), is_header ? first.names() : std::vector<std::string>()};
}

std::vector<std::size_t> rotation_places(const std::vector<std::string_view>& fields, const Spec& spec) {
    constexpr double most_off = 2e-2; // of few digits
    const bool is_matrix = spec.name == RepresentationId::dcm;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i + spec.size() <= fields.size() && (is_matrix || spec.name == RepresentationId::quat);
         ++i) {
        double square = 0.0;
        for (const std::string_view field : std::span(fields).subspan(i, spec.size())) {
            double number = 2.0; // of what is none
            square += stream::read_number(field, number) == stream::NumberError::none ? number * number : 4.0;
        }
        if (std::abs(square - (is_matrix ? 3.0 : 1.0)) < most_off) {
            places.push_back(i);
        }
    }
    return places;
}

std::string filtered_lines(std::string_view text,
                           const std::function<std::string(std::size_t, const std::string&)>& filter) {
    std::string made;
    for (std::size_t i = 0; !text.empty(); ++i) {
        made += filter(i, std::string(stream::next_line(text).text)) + "\n";
    }
    return made;
}

std::string answers(const std::vector<std::string>& words, std::optional<std::string_view> beginning) {
    std::string lines;
    if (std::ranges::any_of(words, [](const std::string& word) { return word.find(raw_word) != std::string::npos; })) {
        return lines;
    }
    Attempt wrong{with_input(words)};
    if (wrong.words == words && beginning) {
        wrong.text = std::string(*beginning);
    }
    wrong.may_read_pipe = !beginning;
    wrong.says_radians = std::ranges::any_of(words, [](const std::string& word) {
        const auto parts = parts_of_label(word);
        return std::ranges::any_of(parts, [](const std::string& part) {
            return unit_of(part.substr(std::min(part.find_first_not_of('-'), part.size()))) == "rad";
        });
    });
    const Search search(wrong);
    for (const std::string& command : search.found()) {
        lines += fmt::format("try: {}\n", command);
    }
    return lines;
}

std::string end_of_message(const RowsCommand& command, std::string_view beginning) {
    const bool is_text = beginning.find('\0') == std::string_view::npos;
    return fmt::format("{}\n{}",
                       is_text ? ""
                               : "; the input is not text: rows of numbers are read, as NumPy's savetxt or ros2 topic "
                                 "echo --csv write them",
                       answers(command.line->words, beginning));
}

std::optional<std::vector<std::string>> only_answer(const std::vector<std::string>& words,
                                                    const std::vector<Mend>& mends) {
    std::optional<std::vector<std::string>> only;
    for (const Mend& mend : mends) {
        const Attempt attempt = Attempt{words}.after(mend);
        Attempt tried = attempt;
        tried.words = with_input(tried.words);
        const Outcome outcome = outcome_of(tried);
        if (outcome.serves && outcome.is_tried) {
            if (only) {
                return std::nullopt;
            }
            only = (outcome.names == RowNamesKind::own ? attempt : attempt.in_order()).words;
        }
    }
    return only;
}

} // namespace rotconv::cli
