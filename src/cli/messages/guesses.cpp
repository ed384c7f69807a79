#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "../../core/projects.hpp"
#include "../../methods/method.hpp"
#include "../../stream/bytes/file.hpp"
#include "../command.hpp"
#include "../grammar/column_names.hpp"
#include "../grammar/value_text.hpp"
#include "../grammar/values.hpp"
#include "answers.hpp"
#include "meanings.hpp"
#include "messages.hpp"
#include "spellings.hpp"

namespace rotconv::cli::messages {
namespace {

void add(std::vector<Mend>& mends, const std::vector<Mend>& more) {
    mends.insert(mends.end(), more.begin(), more.end());
}

bool are_same(std::string_view a, std::string_view b) {
    const auto first = spec_of(a);
    const auto second = spec_of(b);
    return first && second && first->text() == second->text();
}

/// A word of the command line, an option or an operand, and the edits that put others in its place.
class Replaced {
public:
    Replaced(const OptionSet& options, std::size_t at) : options_(&options), at_(at), word_(options.words[at]) {
        const auto equals = word_.starts_with("--") ? word_.find('=') : std::string::npos;
        is_joined_ = equals != std::string::npos;
        argument_ = is_joined_ ? word_.substr(equals + 1) : at + 1 < options.words.size() ? options.words[at + 1] : "";
    }

    /// What is given to it; the next word, if it takes none.
    [[nodiscard]] const std::string& argument() const { return argument_; }
    /// How many words it is with its argument.
    [[nodiscard]] std::size_t size() const { return is_joined_ ? 1 : 2; }
    /// @param text one alternative, as Meaning::instead says it
    [[nodiscard]] std::vector<Mend> by(const std::string& text) const {
        const auto has = [&text](std::string_view part) { return text.find(part) != std::string::npos; };
        const Option* const from = options_->given("--from");
        const bool is_reference = text == "REFERENCE";
        const bool takes_argument = has("ARG") || is_reference || text == "tail" || text == "awk" || text == "- -";
        if ((text.starts_with("-t ") && options_->given("--to") != nullptr) ||
            ((is_reference || text == "ARG") && !word_.starts_with('-')) || // only an option has an argument
            (has("euler:ARG") && !EulerSequence::parse(argument_)) || (takes_argument && argument_.empty()) ||
            (has("FROM") && from == nullptr) || (is_command(text.substr(0, text.find(' '))) && options_->begin > 0)) {
            return {};
        }
        const bool is_of_rotate = options_->command_name() == "rotate";
        const Option* const columns = options_->given("--columns");
        if (text == "@ARG" && is_of_rotate && columns != nullptr && !is_value(argument_)) { // names
            return {{{{{at_}, size()}, OptionSet::changing(*columns, columns->text() + "," + argument_)}}};
        }
        const std::size_t listed = has("@ARG") ? size_of_list() : 1;
        if (is_spec(text) && argument_.find(',') != std::string::npos && !holds_number(argument_)) { // --quat a,b,c,d
            return {{{{{at_}, size(), {"-f", text, "--columns", argument_}}}}};
        }
        if (is_spec(text) && word_.starts_with('-') && options_->has("--from") && !is_joined_) {
            return {{{{{at_}, 1, {from != nullptr ? "-t" : "-f", text}}}}};
        }
        if (listed == 0 || (text == "- -" && argument_.size() != 1) || (text == "-o ARG" && is_spec(argument_)) ||
            (text == "@ARG" && !is_of_rotate)) {
            return {};
        }
        Mend mend{{{{at_}, takes_argument && listed < 2 && !is_joined_ ? std::size_t{2} : 1}}};
        if (is_reference) {
            return as_reference(mend);
        }
        if (text == "tail" || text == "awk") {
            return text == "tail" ? skipping(mend) : with_times(mend);
        }
        return by_words(std::move(mend), text, takes_argument, listed);
    }

private:
    /// The words of `text` in the place of its own. @param listed how many VALUEs stand behind it
    [[nodiscard]] std::vector<Mend> by_words(Mend mend, const std::string& text, bool takes_argument,
                                             std::size_t listed) const {
        const Option* const from = options_->find("--from");
        std::string modifier;
        for (std::string word : words_in(text)) {
            const bool is_values = word == "@ARG";
            if (is_values && listed > 1) { // they stay where they are
                continue;
            }
            replace(word, "FROM", from != nullptr ? from->text() : "");
            replace(word, "ARG", argument_);
            replace(word, "~", " ");
            if (is_values) {
                std::ranges::replace(word, ',', ' ');
                mend.edits.push_back({{Edit::at_end}, 0, words_in(word.substr(1))});
            } else if (word.starts_with(':')) {
                modifier = word.substr(1);
            } else if (is_command(word) && at_ > 0) {
                mend.edits.push_back({{0}, 0, {word}});
            } else if (word != "-") {
                mend.edits.front().by.push_back(word);
            }
        }
        auto& by = mend.edits.front().by;
        if (is_joined_ && !takes_argument && !by.empty()) {
            by.back() += "=" + argument_;
        }
        const std::string_view unit = unit_of(modifier);                                     // also of rates
        if (unit == "deg" && options_->missing("--initial") != nullptr && from == nullptr) { // of propagate
            by.emplace_back("-d");
            return {mend};
        }
        if (unit == "rad") { // which they are without -d and :deg
            const bool are_degrees = std::ranges::any_of(options_->words, [](const std::string& word) {
                return word == "-d" || word == "--degrees" || word.find(":deg") != std::string::npos;
            });
            return are_degrees ? std::vector<Mend>() : std::vector<Mend>{mend};
        }
        return modifier.empty() ? std::vector<Mend>{mend} : with(mend, modifier);
    }

    /// Its argument as REFERENCE, which comes last; FILE may be stdin.
    [[nodiscard]] std::vector<Mend> as_reference(Mend mend) const {
        const bool is_piped = options_->files.size() == (is_joined_ ? 0 : 1) && options_->values.empty();
        const bool has_end = std::ranges::count(options_->words, "--") > 0; // of options
        mend.edits.push_back(
            {{Edit::at_end}, 0, is_piped ? std::vector<std::string>{"-", argument_} : std::vector{argument_}});
        return has_end ? std::vector<Mend>() : std::vector{std::move(mend)};
    }
    static void replace(std::string& text, std::string_view part, const std::string& by) {
        if (const auto at = text.find(part); at != std::string::npos) {
            text.replace(at, part.size(), by);
        }
    }
    /// How many numbers, each a word, are behind the option, if they are the last ones behind others; 1: a word of
    /// numbers; 0: neither.
    [[nodiscard]] std::size_t size_of_list() const {
        const auto& words = options_->words;
        if (is_joined_ || argument_.find_first_of(", ") != std::string::npos) {
            return 1;
        }
        const auto first = words.begin() + static_cast<std::ptrdiff_t>(at_) + 1;
        const auto end = std::find_if_not(first, words.end(), is_value);
        const bool are_last = std::none_of(end, words.end(), is_value) && std::any_of(words.begin(), first, is_value);
        return are_last && end - first == 3 ? 3 : 0;
    }
    /// The number that is given to it, if it stands beside at most one FILE.
    [[nodiscard]] std::optional<double> number_beside_file() const {
        double number = 0.0;
        const std::size_t own = is_joined_ ? 0 : 1; // which is a VALUE as long as the option is unknown
        const bool is_number = stream::read_number(argument_, number) == stream::NumberError::none;
        return is_number && options_->values.size() == own && options_->files.size() < 2 ? std::optional(number)
                                                                                         : std::nullopt;
    }
    [[nodiscard]] Mend reading(Mend mend, const std::string& command) const {
        mend.pipe = command;
        for (const WordEnd& file : options_->file_words) {
            mend.edits.push_back({file});
            mend.pipe += " " + file_in_shell(options_->words[file.word]);
        }
        return mend;
    }
    [[nodiscard]] std::vector<Mend> skipping(const Mend& mend) const {
        const auto lines = number_beside_file();
        return lines ? std::vector{reading(mend, fmt::format("tail -n +{:.0f}", *lines + 1.0))} : std::vector<Mend>();
    }
    /// With times before the rows, where they are read.
    [[nodiscard]] std::vector<Mend> with_times(const Mend& mend) const {
        const std::string_view command = options_->command_name();
        const auto step = number_beside_file();
        const auto bytes = options_->files.size() == 1 ? first_bytes(options_->files[0]) : std::nullopt;
        const auto rows = bytes ? simple_rows(*bytes) : std::nullopt;
        if (!step || !rows || (command != "rates" && command != "propagate")) {
            return {};
        }
        if (std::ranges::any_of(rows->names, is_name_of_time)) {
            return {};
        }
        const std::size_t first = rows->has_header() ? 1 : 0;
        const std::string header =
            rows->has_header() ? fmt::format(R"(NR == 1 {{print "t{}" $0; next}} )", rows->mark) : "";
        const std::string program =
            fmt::format(R"({}{{printf "%.9f{}%s\n", (NR-{}) * {}, $0}})", header, rows->mark, first + 1, argument_);
        Mend made = reading(mend, fmt::format("awk '{}' <", program));
        made.text = filtered_lines(*bytes, [&](std::size_t index, const std::string& line) {
            return index < first
                       ? "t" + rows->mark + line
                       : fmt::format("{:.9f}{}{}", static_cast<double>(index - first) * *step, rows->mark, line);
        });
        return {made};
    }
    /// Also with a modifier of one of the SPECs, but an inverse of the one that is written.
    [[nodiscard]] std::vector<Mend> with(const Mend& mend, std::string modifier) const {
        const Meaning* const meaning = find_meaning(modifier);
        if (meaning != nullptr && meaning->instead.starts_with(':') && meaning->instead != ":ARG") { // --scalar last
            modifier = meaning->instead.substr(1);
        }
        const bool is_inverse = modifier == "passive";
        const Option* const own = options_->given("--from");
        const bool lacks_own = options_->missing("--from") != nullptr;
        const bool is_order = is_spec("quat:" + modifier) && modifier.size() == 4;
        if ((is_order && (options_->has("--within") || options_->has("--by") || // of which of the attitudes?
                          options_->has("--initial"))) ||
            (is_preset(modifier) && lacks_own)) { // it is said of the numbers that are read
            return {};
        }
        std::vector<Mend> mends;
        const bool is_of_result = is_inverse && !options_->has("--by"); // of FILE's attitudes, not the product
        for (const char* name : {is_of_result ? "--to" : "--from", is_of_result ? "--from" : "--to"}) {
            const Option* const option = options_->given(name);
            if (option == nullptr || (is_inverse && !mends.empty())) {
                continue;
            }
            for (const std::string& spec : filtered(with_modifier(name_of_angles(*option), modifier), is_spec)) {
                const bool is_of_project = own != nullptr && find_project(own->text()) != nullptr;
                if (is_inverse && (are_same(option->text(), spec) || (is_of_project && are_same(own->text(), spec)))) {
                    return {}; // its numbers are inverses already
                }
                mends.push_back(mend);
                mends.back().edits.push_back(OptionSet::setting(*option, spec));
            }
        }
        if (mends.empty() && lacks_own && EulerSequence::parse(modifier)) {
            for (const std::string& spec : with_modifier("euler", modifier)) {
                mends.push_back(mend);
                mends.back().edits.front().by = {"-f", spec};
            }
        }
        return mends;
    }
    /// The option's SPEC; euler for a word that means angles of any sequence.
    static std::string name_of_angles(const Option& option) {
        const Meaning* const meaning = find_meaning(option.text());
        return meaning != nullptr && meaning->instead.starts_with("euler:") ? "euler" : option.text();
    }

    const OptionSet* options_;
    std::size_t at_;
    std::string word_;
    std::string argument_;
    bool is_joined_ = false;
};

/// The option that has the SPEC of the second attitudes, if the command reads such.
std::string_view option_of_second_spec(const OptionSet& options) {
    return options.has("--by") ? "--by" : "--to"; // compose's -t is the result's
}

/// A word such as rpy2quat or px4-to-ros.
std::vector<Mend> converter_meant(const std::string& word, const Replaced& replaced) {
    const std::string_view mark = word.find("-to-") != std::string::npos ? "-to-" : "2";
    const auto two = word.find(mark);
    std::vector<Mend> mends;
    if (two == std::string::npos || two == 0 || (mark == "2" && !std::ranges::all_of(word, is_alphanumeric))) {
        return mends;
    }
    const auto names_of_one = [](const std::string& name) {
        return find_project(name) != nullptr                                   ? Words{name}
               : name == "e" || lower(name) == "angle" || lower(name) == "eul" ? Words{"euler:ZYX"}
                                                                               : meant(name, {});
    };
    const auto of_matlab = [mark](const std::string& spec) {
        return mark == "2" && spec == "dcm" ? "dcm:passive" : spec;
    };
    for (const std::string& first : names_of_one(word.substr(0, two))) {
        for (const std::string& second : names_of_one(word.substr(two + mark.size()))) {
            add(mends, replaced.by(fmt::format("-f {} -t {}", of_matlab(first), of_matlab(second))));
            add(mends, replaced.by(fmt::format("-f {} -t {}", first, second))); // the same but for matrices
        }
    }
    return mends;
}

} // namespace

std::optional<Spec> spec_of(std::string_view text) {
    const auto parsed = parse_spec(text);
    const auto* const spec = std::get_if<Spec>(&parsed);
    return spec == nullptr ? std::nullopt : std::optional(*spec);
}

bool is_spec(std::string_view word) { return spec_of(word).has_value(); }

bool is_preset(std::string_view word) { return std::ranges::count(presets(), word, &Project::text) != 0; }

Usage no_such_word(std::string_view what, const Option& option, std::string_view text, const Legal& legal) {
    std::vector<Mend> mends;
    for (std::size_t i = 0; i < 2 && option.place.begin == 0 && stream::File::is_regular(option.text().c_str()); ++i) {
        mends.push_back({{{option.place, 0, {std::string(legal[i])}}}}); // the argument was forgotten
    }
    for (const std::string& word : mends.empty() ? choose_nearest(text, legal) : Words()) {
        std::string argument = option.text();
        argument.replace(argument.find(text), text.size(), word);
        mends.push_back({{{option.place, 1, {argument}}}});
    }
    return Usage("{} is not a known {} (legal: {})", quoted(text), what, joined(legal, " ")).with(std::move(mends));
}

namespace {

/// Numbers that are given to options of their names, as VALUEs: --roll 10 --pitch 20 --yaw 30 as roll=10 pitch=20
/// yaw=30. All names must be those of an attitude's numbers, of --from if that is given.
std::vector<Mend> with_labels(const OptionSet& options) {
    Mend mend;
    Words labels;
    Words values;
    for (std::size_t at = options.begin; at < options.words.size() && options.words[at] != "--"; ++at) {
        const Replaced option(options, at);
        const std::string name = options.words[at].substr(0, options.words[at].find('='));
        const std::string& argument = option.argument();
        if (name.starts_with("--") && is_value(argument) && !options.knows(name)) {
            labels.push_back(name.substr(2));
            const bool is_list = argument.find(',') != std::string::npos;
            values.push_back(labels.back() + (is_list ? "=[" : "=") + argument + (is_list ? "]" : ""));
            mend.edits.push_back({{at}, option.size()});
        }
    }
    if (labels.size() < 2) {
        return {};
    }
    const Option* const from = options.given("--from");
    const auto is_named = [&labels](std::string_view name) {
        const auto spec = spec_of(name);
        const auto known = spec ? find_names(*spec, labels) : std::nullopt;
        return known && known->decides && known->places.size() == labels.size();
    };
    const bool are_axis_and_angle = labels == Words{"axis", "angle"} || labels == Words{"angle", "axis"};
    if (!are_axis_and_angle &&
        !(from != nullptr ? is_named(from->text()) : std::ranges::any_of(all_names(), is_named))) {
        return {};
    }
    mend.edits.push_back({{Edit::at_end}, 0, {joined(values, " ")}});
    return {mend};
}

} // namespace

Usage no_such_option(const OptionSet& options) {
    const std::string name = options.unknown.substr(0, options.unknown.find('='));
    const std::string bare = name.substr(std::min(name.find_first_not_of('-'), name.size()));
    Words others; // commands that have the option
    for (const CommandEntry& each : command_table()) {
        if (each.options()->has(name)) {
            others.emplace_back(each.name.empty() ? "the conversion" : each.name);
        }
    }
    std::vector<Mend> mends = with_labels(options);
    if (mends.empty() && options.words[options.unknown_place.word].starts_with(name)) { // no letter among others
        const Replaced replaced(options, options.unknown_place.word);
        const auto names = mapped(options.all(), &Option::name);
        const bool has_spec = is_spec(replaced.argument());             // --out quat
        const auto begun = filtered(names, [&](std::string_view each) { // --inv, not --time of --time-unit
            return !has_spec && each.size() > name.size() && each.starts_with(name) && each[name.size()] != '-';
        });
        const Words near = begun.size() == 1  ? Words{std::string(begun[0])}
                           : is_command(bare) ? Words{bare}
                                              : choose_nearest(name, names);
        const Words told = find_meaning(name) == nullptr ? Words() : meant(name, names);
        const bool is_told = std::ranges::any_of(told, [&names](const std::string& each) { // --tol is --within
            return std::ranges::count(names, each.substr(0, each.find(' '))) > 0;
        });
        const Words first =
            begun.size() == 1 && !is_told ? near : meant(others.empty() && bare.size() == 1 ? bare : name, names);
        for (const Words& texts : {first, near}) {
            for (const std::string& each : mends.empty() ? texts : Words()) {
                add(mends, each == name ? std::vector<Mend>() : replaced.by(each));
            }
        }
        if (mends.empty()) {
            mends = converter_meant(bare, replaced);
        }
    }
    const std::string told = meaning_of_word(name);
    const std::string_view command = options.begin > 0 ? options.command_name() : "the conversion";
    const std::string said =
        others.empty() ? fmt::format("{} is not a known option", quoted(name))
                       : fmt::format("{} has no {}: it is an option of {}", command, shown(name), joined(others, ", "));
    return Usage(said + told).with(std::move(mends), others.empty() && told.empty() ? "; see rotconv --help" : "");
}

Usage no_such_method(RepresentationId from, RepresentationId to, const Option& option) {
    const std::string pair = fmt::format("{} to {}", representation(from).text, representation(to).text);
    const auto rows = methods_of(from, to);
    std::string said = fmt::format("{} {}", option.name(), quoted(option.text()));
    if (rows.empty()) {
        return Usage("{}: from {} only default, fast and all are known", said, pair);
    }
    said += fmt::format(" is not a known method from {}; legal:\n  {:<18} {}", pair, default_method, every_input);
    std::vector<Mend> mends;
    for (const std::string& name : choose_nearest(option.text(), mapped(rows, &Method::name))) {
        mends.push_back({{OptionSet::changing(option, name)}});
    }
    for (const Method& method : rows) {
        said += fmt::format("\n  {:<18} {}", method.name, method.domain);
    }
    said +=
        fmt::format("\n  {:<18} {}\n  {:<18} each of these, one line for each", fast_method, every_input, all_methods);
    return Usage(said).with(std::move(mends));
}

std::vector<Mend> with_specs_of_others(const OptionSet& options) {
    std::vector<const Option*> missing;
    for (const char* name : {"--from", "--to"}) {
        if (const Option* const option = options.missing(name)) {
            missing.push_back(option);
        }
    }
    Mend mend;
    const Option* const output = options.given("--output");
    if (output != nullptr && stream::File::is_regular(output->text().c_str())) {
        return {}; // perhaps it is what was to be read
    }
    for (const char* name : {"--output", "--input", "--format"}) {
        const Option* const other = options.given(name);
        if (other == nullptr || missing.empty() || stream::File::is_regular(other->text().c_str()) ||
            !(is_spec(other->text()) || find_project(other->text()) != nullptr)) {
            continue;
        }
        const auto right = mend.edits.empty() && other == output ? missing.end() - 1 : missing.begin();
        mend.edits.push_back(OptionSet::instead_of(*other, (*right)->names.substr(0, 2), other->text()));
        missing.erase(right);
    }
    return Mend::unless_empty(mend);
}

std::vector<Mend> with_second_options(const OptionSet& options) {
    Mend mend;
    for (const auto& [name, of_reference] :
         {std::pair<std::string_view, std::string_view>{"--columns", "--reference-columns"},
          {"--from", option_of_second_spec(options)},
          {"--key", "--reference-key"},
          {"--time-unit", "--reference-time-unit"}}) {
        const Option* const option = options.given(name);
        const Option* const second = options.missing(of_reference);
        if (option != nullptr && option->texts.size() == 2 && second != nullptr && options.has("--reference-columns") &&
            (name != "--from" || is_spec(option->texts[1]))) {
            mend.edits.push_back(OptionSet::instead_of(*option, second->name(), option->texts[1]));
        }
    }
    return Mend::unless_empty(mend);
}

std::vector<Mend> with_specs_of_words(const OptionSet& options, const std::vector<WordEnd>& words) {
    std::vector<std::string_view> names{"--from", option_of_second_spec(options)};
    if (!options.has("--by") && !options.has("--within")) {
        names.pop_back(); // one attitude is read
    }
    Mend mend;
    for (std::size_t i = 0; i < words.size() && i < names.size(); ++i) {
        const std::string& word = options.words[words[i].word];
        auto parts = words_in(word);
        const Option* const option = options.missing(names[i]);
        if (parts.size() < 2 || option == nullptr) {
            return {};
        }
        parts[0].resize(parts[0].size() - (parts[0].ends_with(':') ? 1 : 0));
        if (!is_spec(parts[0]) || !std::all_of(parts.begin() + 1, parts.end(), is_value)) {
            return {};
        }
        parts.insert(parts.begin(), std::string(option->name()));
        mend.edits.push_back({words[i], 1, parts});
    }
    return words.size() > names.size() ? std::vector<Mend>() : Mend::unless_empty(mend);
}

std::vector<Mend> meant_by_operand(const OptionSet& options, std::size_t at) {
    const std::string& word = options.words[at];
    const Replaced replaced(options, at);
    if (std::string made = word; word.find('\\') != std::string::npos) { // of DICOM
        std::ranges::replace(made, '\\', ' ');
        const auto numbers = words_in(made.substr(made.find(':') + 1));
        return std::ranges::all_of(numbers, stream::is_number) ? std::vector<Mend>{{{{{at}, 1, {made}}}}}
                                                               : std::vector<Mend>();
    }
    if (auto specs = with_specs_of_words(options, {{at, 0}}); !specs.empty()) {
        return specs;
    }
    std::vector<Mend> mends;
    const auto parsed = parse_spec(word);
    if (const auto* const error = std::get_if<SpecError>(&parsed); error != nullptr && options.takes_names()) {
        for (const std::string& spec : meant_specs(word, *error)) {
            add(mends, replaced.by(spec));
        }
        return mends;
    }
    if (word.size() == 1 && !is_alphanumeric(word[0]) && at > 0 && options.words[at - 1] == "-d") { // as in cut
        return {{{{{at - 1}, 2, {"--delimiter", word}}}}};
    }
    if (auto converter = converter_meant(word, replaced); !converter.empty()) {
        return converter;
    }
    const auto table = command_table();
    for (const std::string& each : meant(word, mapped(std::span(table).subspan(1), &CommandEntry::name))) {
        const bool is_from = options.missing("--from") != nullptr;
        const bool is_behind =
            !options.value_words.empty() && options.value_words[0].word < at; // perhaps of the result
        if (!is_spec(each)) {
            add(mends, replaced.by(each));
        } else if (is_from) {
            add(mends, replaced.by("-f " + each));
        }
        if (is_spec(each) && (!is_from || is_behind) && options.missing("--to") != nullptr) {
            add(mends, replaced.by("-t " + each));
        }
    }
    return mends;
}

std::string meaning_of_word(std::string_view word) {
    const Meaning* const meaning = find_meaning(word);
    return word.find('2') != std::string_view::npos && word.find("dcm") != std::string_view::npos
               ? "; MATLAB's matrices are dcm:passive, from reference to body axes"
           : meaning == nullptr || meaning->about.empty() ? ""
                                                          : fmt::format("; {}", meaning->about);
}

std::string explain(const SpecError& error) {
    using What = SpecError::What;
    const Project* const project = find_project(error.text);
    std::string said = message(SpecError{error.what, shortened(error.text), error.in});
    if (error.what == What::unknown_name && project != nullptr) {
        const std::string_view mark = project->specs.empty() || project->remark.empty() ? "" : "; ";
        return fmt::format("{} {}{}{}{}", project->text,
                           project->specs.empty() ? "has no SPEC: " : "has several SPECs: ", project->specs, mark,
                           project->remark);
    }
    if (error.what == What::meaningless_modifier) {
        return fmt::format("{} (legal: {} and the presets of rotconv list presets)", said,
                           fmt::join(words_of(error.in->modifiers), " "));
    }
    return said + (project != nullptr ? fmt::format("; {} is {}", project->text, project->specs)
                                      : meaning_of_word(error.what == What::no_sequence ? "euler" : error.text));
}

namespace {

/// The SPEC whose numbers a list names; in another order those of columns, where no header names them.
std::vector<Mend> meant_by_names(const Option& option) {
    std::string text = option.text();
    std::ranges::replace(text, ',', ' ');
    const auto names = words_in(text);
    std::optional<Mend> moved;
    if (text.find_first_of("_:[]()") != std::string::npos) { // units and modifiers
        return {};
    }
    for (const char* const each : {"quat", "quat:xyzw", "rpy", "ypr"}) {
        const auto known = find_names(*spec_of(each), names);
        if (!known || !known->decides || !known->prefix.empty() || !known->suffix.empty() ||
            known->places.size() != names.size()) {
            continue;
        }
        if (std::ranges::is_sorted(known->places)) {
            return {{{OptionSet::changing(option, each)}}};
        }
        if (option.name() == "--from" && !moved) {
            moved = Mend{{OptionSet::changing(option, each)}};
            moved->order.push_back({{Edit::at_end}, 0, {"--columns", list_of_columns(known->places)}});
        }
    }
    return moved ? std::vector{*moved} : std::vector<Mend>();
}

} // namespace

Usage no_such_spec(const Option& option, const std::string& item, const SpecError& error) {
    using What = SpecError::What;
    const Project* const project = error.what == What::unknown_name ? find_project(error.text) : nullptr;
    const std::string rest = item.substr(std::min(item.find(':'), item.size()));
    const bool is_list = option.text().find(',') != std::string::npos;
    const Words specs = project != nullptr ? specs_of(*project) : meant_specs(item, error);
    std::vector<Mend> mends = is_list || specs.empty() ? meant_by_names(option) : std::vector<Mend>();
    for (const std::string& spec : mends.empty() ? specs : Words()) {
        const auto words = words_in(spec);
        std::string text = option.text();
        text.replace(text.find(item), item.size(), words.empty() ? "" : words[0] + (project != nullptr ? rest : ""));
        mends.push_back({{OptionSet::changing(option, text)}});
        if (words.size() > 1 && option.name() == "--from") { // columns are those that are read
            mends.back().order.push_back({{Edit::at_end}, 0, {words.begin() + 1, words.end()}});
        }
    }
    const bool is_known = find_project(error.text) != nullptr || find_meaning(error.text) != nullptr;
    const std::string where =
        project != nullptr                     ? fmt::format("; see rotconv list {}", project->text)
        : is_known                             ? ""
        : error.what == What::unknown_name     ? "; rotconv list has them, rotconv list projects those of programs"
        : error.what == What::unknown_sequence ? "; it has three letters, neighbours different; rotconv list euler "
                                                 "explains them"
        : error.what == What::unknown_modifier ? "; rotconv list NAME and rotconv list presets have them"
                                               : "";
    Usage usage =
        Usage("{} {}: {}", option.name(), quoted(option.text()), explain(error)).with(std::move(mends), where);
    usage.is_choice = project != nullptr && option.name() == "--from";
    return usage;
}

std::string fix_hint(std::string_view text) {
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
        const bool is_one = first != nullptr && !first->in_spec && !first->is_verb &&
                            (first->instead.empty() || first->instead == "-" || first->instead[0] == ':') &&
                            std::ranges::count(meanings, first) == std::ranges::ssize(meanings);
        return is_one ? meaning_of_word(words.front()) : "";
    }
    bool has_blank = false; // that does not follow a comma
    for (std::size_t i = 1; i < text.size(); ++i) {
        has_blank = has_blank || ((text[i] == ' ' || text[i] == '\t') && text[i - 1] != ',' && text[i - 1] != ' ');
    }
    return has_blank && text.find(',') != std::string_view::npos
               ? "; only blanks may be between numbers, or only commas (and no decimal commas)"
               : "";
}

std::string fix_hint(const stream::RowError& error) {
    using What = stream::RowError::What;
    const bool is_count = error.what == What::wrong_count;
    const std::string mended = is_count || error.what == What::not_a_number ? fix_hint(error.text) : "";
    const bool may_be_decimal = is_count && error.found == 2 * error.expected && !error.text.ends_with(',') &&
                                error.text.find(',') != std::string::npos && error.text.find('.') == std::string::npos;
    return mended.empty() && may_be_decimal ? "; if these are decimal commas: write points" : mended;
}

bool is_verb(std::string_view word) {
    const Meaning* const meaning = find_meaning(word);
    return meaning != nullptr && meaning->is_verb;
}

} // namespace rotconv::cli::messages
