#include "labelled_lines.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <span>
#include <utility>

#include "../../stream/numbers/number_text.hpp"
#include "../grammar/column_names.hpp"
#include "../grammar/value_text.hpp"
#include "../grammar/values.hpp"
#include "../grammar/words.hpp"
#include "meanings.hpp"
#include "messages.hpp"

namespace rotconv::cli {
namespace {

constexpr std::string_view numbers_filter =
    "sed -E 's/(^|[^0-9.])[A-Za-z_][A-Za-z_0-9]*/ /g; s/[^-+0-9.eE]/ /g; s/[-+]( |$)/ /g'";
constexpr std::string_view all_digits = "0123456789";

bool is_digit(char c) { return all_digits.find(c) != std::string_view::npos; }
bool is_letter(char c) { return c == '_' || (is_alphanumeric(c) && !is_digit(c)); }

/// What the filter makes of a line: the answer is tried on it. A word may have digits, a number an exponent.
std::string numbers_alone(std::string_view line) {
    std::string made(line);
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (is_letter(line[i]) && (i == 0 || (!is_digit(line[i - 1]) && line[i - 1] != '.'))) {
            made[i > 0 ? i - 1 : 0] = ' ';
            for (; i < line.size() && (is_letter(line[i]) || is_digit(line[i])); ++i) {
                made[i] = ' ';
            }
        }
    }
    std::ranges::replace_if(
        made, [](char c) { return !is_digit(c) && std::string_view("-+.eE").find(c) == std::string_view::npos; }, ' ');
    for (std::size_t i = 0; i < made.size(); ++i) { // signs of nothing
        const bool is_sign = made[i] == '-' || made[i] == '+';
        made[i] = is_sign && (i + 1 == made.size() || made[i + 1] == ' ') ? ' ' : made[i];
    }
    return made;
}

using Places = std::vector<std::size_t>;

/// Whether a word may make another attitude of the numbers beside it.
bool may_change_meaning(const std::string& word) { return is_operation(word) || !unit_of_word(word).empty(); }

/// The words of a line.
std::vector<std::string> words_of_line(std::string line) {
    std::ranges::replace_if(
        line, [](char c) { return !is_letter(c) && !is_digit(c); }, ' ');
    return filtered(words_in(line), [](const std::string& word) { return is_letter(word[0]); });
}

/// The numbers of a line, and the words before them; empty where there is none.
struct NumbersOfLine {
    std::vector<std::string> labels{};
    std::vector<std::string> texts{};
    std::vector<std::size_t> groups{}; ///< where the brackets begin in which they stand

    explicit NumbersOfLine(const std::string& line) {
        const std::string alone = numbers_alone(line);
        std::vector<std::size_t> open{std::string::npos};
        std::size_t seen = 0;
        for (auto at = alone.find_first_not_of(' '); at < alone.size(); at = alone.find_first_not_of(' ', at)) {
            for (; seen < at; ++seen) {
                if (std::string_view("[({").find(line[seen]) != std::string_view::npos) {
                    open.push_back(seen);
                } else if (std::string_view("])}").find(line[seen]) != std::string_view::npos && open.size() > 1) {
                    open.pop_back();
                }
            }
            labels.push_back(label_before(line, at));
            texts.push_back(alone.substr(at, alone.find(' ', at) - at));
            groups.push_back(open.back());
            at = std::min(alone.find(' ', at), alone.size());
        }
    }
    /// Of those whose labels are names, as those of a header are; empty where they are none, or several sets.
    [[nodiscard]] Places places_of(const stream::RowNumbers& numbers) const {
        const auto sets = sets_of_row(parts_of(numbers), labels, "").rows;
        const auto is_in_group = [&](std::size_t place) { return groups[place] == groups[sets[0][0]]; };
        return sets.size() == 1 && std::ranges::all_of(sets[0], is_in_group) ? sets[0] : Places();
    }

private:
    static std::string label_before(const std::string& line, std::size_t at) {
        const std::size_t end = at > 0 ? line.find_last_not_of(" :=", at - 1) + 1 : 0;
        std::size_t begin = end;
        while (begin > 0 && (is_letter(line[begin - 1]) || is_digit(line[begin - 1]) || line[begin - 1] == '.' ||
                             line[begin - 1] == '-')) {
            --begin;
        }
        std::size_t word = begin; // before, after a blank: rate roll
        while (word > 0 && (line[word - 1] == ' ' || is_letter(line[word - 1]))) {
            --word;
        }
        begin = std::min(line.find_first_not_of(".-", begin), end);
        const bool is_label = begin < end && is_letter(line[begin]) &&
                              !is_of_other_quantity(std::string_view(line).substr(word, begin - word));
        return is_label ? line.substr(begin, end - begin) : "";
    }
};

/// A part of a line that may be an attitude.
struct LinePart {
    std::size_t begin;
    std::string text;
    std::string label{}; ///< up to the next
};

/// All of a line, and what is in its brackets, perhaps with a name before.
std::vector<LinePart> parts_of_line(const std::string& line) {
    constexpr std::size_t most_parts = 16;
    std::vector<LinePart> parts{{0, line}};
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < line.size() && parts.size() < most_parts; ++i) {
        if (std::string_view("[({").find(line[i]) != std::string_view::npos) {
            open.push_back(i);
        } else if (std::string_view("])}").find(line[i]) != std::string_view::npos && !open.empty()) {
            std::size_t begin = open.back();
            open.pop_back();
            parts.push_back({begin, line.substr(begin, i + 1 - begin)});
            while (begin > 0 && is_letter(line[begin - 1])) {
                --begin;
            }
            parts.push_back({begin, line.substr(begin, i + 1 - begin)});
        }
    }
    for (std::size_t end = line.size(), i = line.size(); i-- > 0 && parts.size() < most_parts;) {
        if (line[i] == ':' || line[i] == '=') {
            std::size_t begin = i;
            while (begin > 0 && (is_letter(line[begin - 1]) || is_digit(line[begin - 1]))) {
                --begin;
            }
            const std::string text = line.substr(begin, end - begin);
            const std::size_t before = begin > 0 ? line.find_last_not_of(' ', begin - 1) : std::string::npos;
            const bool is_alone =
                before == std::string::npos ||
                (!is_letter(line[before]) && (before + 1 < begin || (line[before] != '.' && line[before] != '-')));
            if (is_alone) {
                parts.push_back(
                    {begin, text.substr(0, text.find_last_not_of(" ,;") + 1), line.substr(begin, i - begin)});
            }
            end = begin;
        }
    }
    return parts;
}

/// Whether a line has a word, as grep -w asks; digits, if there is none.
bool is_with(std::string_view line, std::string_view word) {
    const auto is_part = [&line](std::size_t at) {
        return at < line.size() && (is_letter(line[at]) || is_digit(line[at]));
    };
    std::size_t at = word.empty() ? line.find_first_of(all_digits) : line.find(word);
    while (!word.empty() && at != std::string_view::npos &&
           ((at > 0 && is_part(at - 1)) || is_part(at + word.size()))) {
        at = line.find(word, at + 1);
    }
    return at != std::string_view::npos;
}

class Lines {
public:
    Lines(const std::vector<std::string_view>& lines, const stream::RowNumbers& numbers, const std::string& from,
          bool by_labels)
        : lines_(&lines), numbers_(&numbers), from_(&from), by_labels_(by_labels) {}

    [[nodiscard]] std::optional<LabelledLines> found() const {
        std::size_t tried = 0;
        std::optional<LabelledLines> best;
        for (const std::string_view line : *lines_) {
            const bool has_marks = line.find_first_of("[](){}<>:=") != std::string_view::npos;
            const auto columns = has_marks && ++tried <= most_tried ? columns_in(line) : std::nullopt;
            auto made = columns ? of_words(line, *columns) : std::nullopt;
            if (made && (!best || std::ranges::count(made->text, '\n') > std::ranges::count(best->text, '\n'))) {
                best = std::move(made);
            }
        }
        return best;
    }

private:
    static constexpr std::size_t most_tried = 20;
    static constexpr std::size_t longest = 1000;

    /// Of numbers with labels, if no other word says something of them.
    [[nodiscard]] Places labelled_places(const std::string& line, const NumbersOfLine& numbers) const {
        return std::ranges::any_of(words_of_line(line), may_change_meaning) ? Places() : numbers.places_of(*numbers_);
    }

    /// Which of the numbers of a line are those of an attitude that it holds, as a LIST.
    [[nodiscard]] std::optional<std::string> columns_in(std::string_view text) const {
        const std::string line(text.substr(0, longest));
        const bool is_ascii = std::ranges::all_of(line, [](char c) { return static_cast<unsigned char>(c) < 128; });
        if (const auto named =
                is_ascii && line.size() < longest ? labelled_places(line, NumbersOfLine(line)) : Places();
            !named.empty() || by_labels_) {
            return named.empty() ? std::nullopt : std::optional(list_of_columns(named));
        }
        const auto parts = is_ascii && line.size() < longest ? parts_of_line(line) : std::vector<LinePart>();
        const auto is_named = [this](const LinePart& part) {
            const auto spec = messages::spec_of(lower(part.label));
            return spec && numbers_->attitude && spec->name == numbers_->attitude->name;
        };
        const bool is_only = std::ranges::count_if(parts, is_named) == 1;
        for (const LinePart& part : parts) {
            if (!part.label.empty() && !(is_only && is_named(part))) {
                continue;
            }
            const std::size_t before = words_in(numbers_alone(line.substr(0, part.begin))).size();
            const std::string alone = numbers_alone(part.text);
            std::string probe; // each number is its index
            std::size_t count = 0;
            for (std::size_t i = 0; i < alone.size(); ++i) {
                if (alone[i] == ' ') {
                    probe += part.text[i];
                } else if (i == 0 || alone[i - 1] == ' ') {
                    probe += fmt::format("{}", before + ++count);
                }
            }
            bool means_other = false;
            auto values = attitude_in(probe, *numbers_, *from_, means_other);
            if (means_other) { // what stands before a bracket counts
                return std::nullopt;
            }
            // in the middle of a line only a pose, or the SPEC's own name, tells what it is
            const bool is_known = part.text == line || !part.label.empty() || count > numbers_->names.size();
            if (values && !values->has_other_label && is_known) {
                std::ranges::replace(values->row, ' ', ',');
                return values->row;
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<LabelledLines> of_words(std::string_view line, const std::string& columns) const {
        constexpr std::size_t most_words = 20;
        const std::string text(line.substr(0, longest));
        const NumbersOfLine numbers(text);
        const Places named = labelled_places(text, numbers);
        const std::string label = named.empty() ? "" : numbers.labels[named[0]]; // in all lines that count
        auto words = words_of_line(text);
        words.resize(std::min(words.size(), most_words));
        words.emplace_back();
        std::map<std::string_view, std::optional<std::string>> known;
        const auto is_alike = [&](std::string_view each) {
            const auto [place, is_new] = known.try_emplace(each);
            place->second = is_new ? columns_in(each) : place->second;
            return place->second == columns;
        };
        std::string best;
        std::vector<std::string_view> most;
        for (const std::string& word : words) {
            auto lines = filtered(*lines_, [&word](std::string_view each) { return is_with(each, word); });
            const bool has_all = label.empty() || std::ranges::none_of(*lines_, [&](std::string_view each) {
                                     return is_with(each, label) && !is_with(each, word);
                                 });
            if (lines.size() > most.size() && has_all && std::ranges::all_of(lines, is_alike)) {
                most = std::move(lines);
                best = word;
            }
        }
        if (most.empty()) {
            return std::nullopt;
        }
        const auto rows = mapped(most, numbers_alone);
        const std::size_t width = words_in(rows[0]).size();
        const bool is_even =
            std::ranges::all_of(rows, [width](const std::string& row) { return words_in(row).size() == width; });
        return LabelledLines{best.empty() ? "grep '[0-9]'" : "grep -w " + best,
                             fmt::format(" | {}", numbers_filter),
                             joined(rows, "\n") + "\n",
                             std::string(line),
                             !is_even,
                             columns,
                             !named.empty()};
    }

    const std::vector<std::string_view>* lines_;
    const stream::RowNumbers* numbers_;
    const std::string* from_;
    bool by_labels_;
};

/// A name and what stands behind it, as the pattern of sed in named_lines() parts a line; without a mark no name.
struct NamedText {
    std::string name{};
    std::string text{};

    explicit NamedText(std::string_view line) {
        line.remove_prefix(std::min(line.find_first_not_of("- "), line.size()));
        const std::size_t mark = std::min(line.find_first_of(":="), line.size());
        const auto is_plain = [](char c) { return is_letter(c) || is_digit(c) || c == ' '; };
        if (mark < line.size() && std::ranges::all_of(line.substr(0, mark), is_plain)) {
            name = line.substr(0, line.substr(0, mark).find_last_not_of(' ') + 1);
            text = line.substr(std::min(line.find_first_not_of(' ', mark + 1), line.size()));
        }
    }
    [[nodiscard]] bool is_number() const { return !name.empty() && stream::is_number(text); }
};

/// What stands behind these names, in rows; nothing if the names come in another order.
std::string rows_of_names(std::span<const NamedText> lines, const std::vector<std::string>& names, bool is_cut) {
    std::string rows;
    std::size_t next = 0;
    for (const NamedText& each : lines) {
        if (std::ranges::count(names, each.name) > 0) {
            if (each.name != names[next]) {
                return {};
            }
            next = (next + 1) % names.size();
            rows += each.text + (next == 0 ? '\n' : ' ');
        }
    }
    return next == 0 ? rows : is_cut ? rows.substr(0, rows.rfind('\n') + 1) : "";
}

} // namespace

std::vector<LabelledLines> named_lines(const std::vector<std::string_view>& lines, const Spec& spec, bool is_cut) {
    constexpr std::size_t most_sets = 2;
    constexpr std::size_t most_known = 16; // each looks at all lines
    const std::size_t size = spec.size();
    const auto texts = mapped(lines, [](std::string_view line) { return NamedText(line); });
    std::vector<LabelledLines> sets;
    std::vector<std::vector<std::string>> known_sets;
    for (std::size_t at = 0; at + size <= texts.size() && sets.size() < most_sets && known_sets.size() < most_known;
         ++at) {
        const auto block = std::span(texts).subspan(at, size);
        const auto names = mapped(block, [](const NamedText& each) { return each.name; });
        const bool is_new =
            std::ranges::all_of(block, &NamedText::is_number) && std::ranges::count(known_sets, names) == 0;
        const auto known = is_new ? find_names(spec, names) : std::nullopt;
        if (!known) {
            continue;
        }
        known_sets.push_back(names);
        std::string paste = " | paste -d ' '";
        for (std::size_t i = 0; i < size; ++i) {
            paste += " -";
        }
        const std::string sed = fmt::format("sed -n -E 's/^[- ]*({}) *[:=] *//p'", joined(names, "|"));
        LabelledLines made{sed, paste, rows_of_names(texts, names, is_cut), {}, false, list_of_columns(known->places)};
        const std::string above = at > 0 && texts[at - 1].text.empty() ? texts[at - 1].name : "";
        const bool is_aside = lower(above) == "header" || lower(above) == "stamp" || is(vocabulary::aside, above);
        if (made.text.empty() && !above.empty()) { // others have these names too
            std::vector<NamedText> found;
            for (std::size_t i = 0; i < texts.size(); ++i) {
                const std::size_t end = is_with(lines[i], above) ? std::min(i + size + 1, texts.size()) : i;
                found.insert(found.end(), texts.begin() + static_cast<std::ptrdiff_t>(i),
                             texts.begin() + static_cast<std::ptrdiff_t>(end));
            }
            made.command = fmt::format("grep -w -A {} {}", size, in_shell(above));
            made.others.insert(0, " | " + sed);
            made.text = rows_of_names(found, names, is_cut);
        }
        if (!is_aside && !made.text.empty()) {
            sets.push_back(made);
        }
    }
    return sets;
}

std::vector<std::string> labelled_numbers(const std::string& text, const stream::RowNumbers& numbers) {
    constexpr std::string_view known = "_.,;:=(){}[]<>$ \n+-"; // beside letters and digits
    const NumbersOfLine line(text);
    const Places places = line.places_of(numbers);
    bool is_clear = !places.empty() && std::ranges::all_of(text, [&](char c) {
        return is_alphanumeric(c) || known.find(c) != std::string_view::npos;
    });
    for (const std::size_t place : places) {
        is_clear = is_clear && stream::is_number(line.texts[place]);
    }
    for (std::size_t i = 0; i < line.labels.size(); ++i) { // a number without a label may belong to these
        is_clear = is_clear && (!line.labels[i].empty() || !stream::is_number(line.texts[i]));
    }
    // words before brackets, and labels, are no more than that
    for (std::size_t i = 0; i < text.size() && is_clear; ++i) {
        if (!is_letter(text[i])) {
            is_clear = text[i] != '-' || (i + 1 < text.size() && (is_digit(text[i + 1]) || text[i + 1] == '.'));
            continue;
        }
        std::size_t end = i;
        while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) {
            ++end;
        }
        const std::string word = text.substr(i, end - i);
        const std::size_t next = std::min(text.find_first_not_of(" =:", end), text.size());
        const bool is_exponent = word.starts_with('e') && i > 0 && is_digit(text[i - 1]);
        const bool is_before = next < text.size() && end < text.size() && text[end] != '.' &&
                               std::string_view("([{0123456789+-.").find(text[next]) != std::string_view::npos;
        const Meaning* const meaning = find_meaning(word);
        const bool is_modifier =
            messages::is_spec("quat:" + word) || (meaning != nullptr && meaning->instead.starts_with(':'));
        const bool is_label = std::ranges::count(line.labels, word) > 0;
        is_clear = is_exponent || is_label || (is_before && !is_modifier && !may_change_meaning(word));
        i = end - 1;
    }
    return mapped(is_clear ? places : Places(),
                  [&line](std::size_t place) { return fmt::format("{}={}", line.labels[place], line.texts[place]); });
}

std::optional<LabelledLines> labelled_lines(const std::vector<std::string_view>& lines,
                                            const stream::RowNumbers& numbers, const std::string& from,
                                            bool by_labels) {
    return Lines(lines, numbers, from, by_labels).found();
}

} // namespace rotconv::cli
