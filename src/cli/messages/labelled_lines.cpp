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

namespace rotconv::cli {
namespace {

constexpr std::string_view numbers_filter = "sed -E 's/(^|[^0-9.])[A-Za-z_][A-Za-z_0-9]*/ /g; s/[^-+0-9.eE]/ /g'";
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
    return made;
}

/// A part of a line that may be an attitude.
struct LinePart {
    std::size_t begin;
    std::string text;
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
    Lines(const std::vector<std::string_view>& lines, const stream::RowNumbers& numbers, const std::string& from)
        : lines_(&lines), numbers_(&numbers), from_(&from) {}

    [[nodiscard]] std::optional<LabelledLines> found() const {
        std::size_t tried = 0;
        for (const std::string_view line : *lines_) {
            const bool has_marks = line.find_first_of("[](){}<>:=") != std::string_view::npos;
            const auto columns = has_marks && ++tried <= most_tried ? columns_in(line) : std::nullopt;
            if (columns) {
                return of_words(line, *columns);
            }
        }
        return std::nullopt;
    }

private:
    static constexpr std::size_t most_tried = 20;
    static constexpr std::size_t longest = 1000;

    /// Which of the numbers of a line are those of an attitude that it holds, as a LIST.
    [[nodiscard]] std::optional<std::string> columns_in(std::string_view text) const {
        const std::string line(text.substr(0, longest));
        const bool is_ascii = std::ranges::all_of(line, [](char c) { return static_cast<unsigned char>(c) < 128; });
        for (const LinePart& part : is_ascii&& line.size() < longest ? parts_of_line(line) : std::vector<LinePart>()) {
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
            // in the middle of a line only a pose tells what it is
            const bool is_known = part.text == line || count > numbers_->names.size();
            if (values && !values->has_other_label && is_known) {
                std::ranges::replace(values->row, ' ', ',');
                return values->row;
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<LabelledLines> of_words(std::string_view line, const std::string& columns) const {
        constexpr std::size_t most_words = 20;
        std::string text(line);
        std::ranges::replace_if(
            text, [](char c) { return !is_letter(c) && !is_digit(c); }, ' ');
        auto words = filtered(words_in(text), [](const std::string& word) { return is_letter(word[0]); });
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
            if (lines.size() > most.size() && std::ranges::all_of(lines, is_alike)) {
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
                             columns};
    }

    const std::vector<std::string_view>* lines_;
    const stream::RowNumbers* numbers_;
    const std::string* from_;
};

/// A line that is a name and a number; without a number, or without a name, it is neither.
struct NamedNumber {
    std::string name{};
    std::string number{};

    explicit NamedNumber(std::string_view line) {
        const std::size_t mark = std::min(line.find_first_of(":="), line.size());
        name = joined(words_in(line.substr(0, mark)), " ");
        name.erase(0, name.starts_with("- ") ? 2 : 0);
        number = joined(words_in(line.substr(std::min(mark + 1, line.size()))), " ");
        const bool is_plain = std::ranges::all_of(name, [](char c) { return is_letter(c) || is_digit(c) || c == ' '; });
        if (mark == line.size() || !is_plain || !(number.empty() || stream::is_number(number))) {
            name.clear();
        }
    }
    [[nodiscard]] bool is_whole() const { return !name.empty() && !number.empty(); }
};

/// The numbers of lines with these names, in rows; none if the names come in another order.
std::string rows_of_names(std::span<const NamedNumber> numbers, const std::vector<std::string>& names) {
    std::string rows;
    std::size_t next = 0;
    for (const NamedNumber& each : numbers) {
        if (each.is_whole() && std::ranges::count(names, each.name) > 0) {
            if (each.name != names[next]) {
                return {};
            }
            next = (next + 1) % names.size();
            rows += each.number + (next == 0 ? '\n' : ' ');
        }
    }
    return next == 0 ? rows : rows.substr(0, rows.rfind('\n') + 1); // the beginning of a file may end in a row
}

} // namespace

std::vector<LabelledLines> named_lines(const std::vector<std::string_view>& lines, const Spec& spec) {
    const std::size_t size = spec.size();
    const auto numbers = mapped(lines, [](std::string_view line) { return NamedNumber(line); });
    std::vector<LabelledLines> sets;
    for (std::size_t at = 0; at + size <= numbers.size(); ++at) {
        const auto block = std::span(numbers).subspan(at, size);
        const auto names = mapped(block, [](const NamedNumber& each) { return each.name; });
        const auto known = std::ranges::all_of(block, &NamedNumber::is_whole) ? find_names(spec, names) : std::nullopt;
        if (!known) {
            continue;
        }
        const std::string above = at > 0 && numbers[at - 1].number.empty() ? numbers[at - 1].name : "";
        const std::string sed = fmt::format("sed -n -E 's/^[- ]*({}) *[:=] *//p'", joined(names, "|"));
        const std::string command = above.empty() ? sed : fmt::format("grep -w -A {} {}", size, in_shell(above));
        const bool is_aside = lower(above) == "header" || lower(above) == "stamp" || is(WordKind::aside, above);
        if (is_aside || std::ranges::count(sets, command, &LabelledLines::command) > 0) {
            continue;
        }
        std::vector<NamedNumber> found;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (above.empty() || is_with(lines[i], above)) { // grep -A
                const std::size_t end = std::min(i + (above.empty() ? 1 : size + 1), numbers.size());
                found.insert(found.end(), numbers.begin() + static_cast<std::ptrdiff_t>(i),
                             numbers.begin() + static_cast<std::ptrdiff_t>(end));
            }
        }
        std::string paste = " | paste -d ' '";
        for (std::size_t i = 0; i < size; ++i) {
            paste += " -";
        }
        sets.push_back({.command = command,
                        .others = (above.empty() ? "" : " | " + sed) + paste,
                        .text = rows_of_names(found, names),
                        .line = {},
                        .is_ragged = false,
                        .columns = known->columns()});
    }
    return sets;
}

std::optional<LabelledLines> labelled_lines(const std::vector<std::string_view>& lines,
                                            const stream::RowNumbers& numbers, const std::string& from) {
    return Lines(lines, numbers, from).found();
}

} // namespace rotconv::cli
