#include "values.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "../../core/projects.hpp"
#include "../../operations/operations.hpp"
#include "../../stream/numbers/fmt.hpp"
#include "../../stream/numbers/number_text.hpp"
#include "../messages/messages.hpp"
#include "../option_set.hpp"
#include "column_names.hpp"
#include "value_text.hpp"
#include "words.hpp"

namespace rotconv::cli {
namespace {

using Indices = std::vector<std::size_t>; ///< of groups of a text
using Numbers = std::vector<ValueNumber>;

template <class... Arguments> Usage wrong(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    return Usage("{}{}", argument_error, fmt::format(format, std::forward<Arguments>(arguments)...));
}

std::vector<std::string> labels_of(const Numbers& numbers) { return mapped(numbers, &ValueNumber::label); }
std::vector<std::string> without_empty(const std::vector<std::string>& texts) {
    return filtered(texts, [](const std::string& text) { return !text.empty(); });
}

void refuse_operation(const std::string& label) {
    if (is_operation(label)) {
        throw wrong("{} names an operation, which is not carried out", quoted(label));
    }
}

/// Where a row of a project, such as a robot's pose, has the numbers of the SPEC; a 4x4 is read as one of any SPEC.
stream::ChosenColumns pose_columns(const Spec& spec, std::size_t count) {
    return spec.name == RepresentationId::dcm && count == 16 ? stream::ChosenColumns()
                                                             : columns_of_project(spec, count);
}

/// The numbers of an attitude, or of another part of a row, among those of a text, held against what the text says.
class Reading {
public:
    Reading(const ValueText& text, const Part& part, std::string_view from) : text_(text), part_(part), from_(from) {}

    /// The numbers of the attitude, which are some of the text's, in the order of the SPEC.
    Numbers chosen() {
        if (const auto columns = pose_columns(spec(), text_.numbers.size());
            columns.are_known && without_empty(labels_of(text_.numbers)).empty()) {
            add_note(columns.text);
            return held(mapped(columns.positions, [this](std::size_t at) { return text_.numbers[at]; }));
        }
        const std::size_t group = choose();
        return held(filtered(text_.numbers, [group](const ValueNumber& each) { return each.group == group; }));
    }

    /// Numbers of one group in the order of the part.
    Numbers held(Numbers numbers) {
        const std::size_t own = numbers.front().group;
        if (!std::ranges::all_of(numbers, [own](const ValueNumber& each) { return each.group == own; })) {
            refuse_groups(mapped(numbers, &ValueNumber::group));
        }
        leave_out_lengths(numbers);
        numbers = by_labels(numbers);
        for (const std::size_t group : with_parents(own)) {
            const std::string& label = text_.groups[group].label;
            refuse_operation(label);
            for (const ValueWord& word : text_.words) {
                if (word.group == group) {
                    hold(word.text, numbers);
                }
            }
            for (const std::string& word : conventions_in(label)) {
                if (part_.attitude || !EulerSequence::parse(word)) { // the xyz of a vector
                    hold(word, numbers);
                }
            }
        }
        hold_units(numbers);
        return part_.attitude && spec().name == RepresentationId::dcm && numbers.size() == 16 ? of_pose(numbers)
                                                                                              : numbers;
    }

    void check_aside(std::size_t group) const {
        if (part_.attitude && is_left_out(group)) {
            throw wrong("the numbers after {} are not those of an attitude", quoted(text_.groups[group].label));
        }
    }

    /// Adds what was chosen although the command line does not say it, in one line; the first that says anything
    /// counts.
    void tell(Values& values) const {
        values.has_other_label = has_other_label_;
        if (values.notes.empty() && !note_.empty()) {
            values.notes.push_back({.kind = stream::Note::Kind::order, .text = note_});
        }
    }

private:
    void add_note(std::string_view text) { note_ += (note_.empty() ? "" : "; ") + std::string(text); }

    [[nodiscard]] const Spec& spec() const { return *part_.attitude; }
    [[nodiscard]] std::string text_of_part() const { return part_.attitude ? spec().text() : joined(part_.names); }

    // Which group is read.

    [[nodiscard]] std::vector<std::string> labels_in(std::size_t group) const {
        return labels_of(filtered(text_.numbers, [group](const auto& each) { return each.group == group; }));
    }
    /// The group and those around it, of which the text as a whole says nothing of a vector.
    [[nodiscard]] Indices with_parents(std::size_t group) const {
        Indices groups;
        for (; group != 0; group = text_.groups[group].parent) {
            groups.push_back(group);
        }
        if (part_.attitude) {
            groups.push_back(0);
        }
        return groups;
    }
    [[nodiscard]] bool is_left_out(std::size_t group) const {
        const std::string& label = text_.groups[group].label;
        const auto is_of_other = [](const std::string& each) { return is_aside(each) || is(vocabulary::size, each); };
        return (is_aside(label) && !is_operation(label)) || std::ranges::all_of(labels_in(group), is_of_other) ||
               std::ranges::any_of(with_parents(group), [this](std::size_t each) {
                   return is(" header stamp ", parts_of_label(text_.groups[each].label).back());
               });
    }
    [[nodiscard]] bool has_names(std::size_t group) const {
        const auto labels = labels_in(group);
        return std::ranges::count(labels, "") == 0 && find_names(part_, labels);
    }
    [[nodiscard]] bool is_called_by_name(std::size_t group) const {
        const std::string& label = text_.groups[group].label;
        return named_representation(name_in(label)) == spec().name || named_representation(label) == spec().name;
    }
    [[nodiscard]] bool has_unit(std::size_t group) const {
        const std::string_view unit = spec().unit == AngleUnit::degrees ? "deg" : "rad";
        return unit_in(text_.groups[group].label) == unit || std::ranges::any_of(text_.words, [&](const auto& word) {
                   return word.group == group && word.text == unit;
               });
    }

    [[nodiscard]] std::size_t choose() {
        Indices groups = mapped(text_.numbers, &ValueNumber::group);
        std::ranges::sort(groups);
        groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
        const std::size_t first = groups.front();
        std::erase_if(groups, [this](std::size_t group) { return is_left_out(group); });
        if (groups.empty()) {
            throw wrong("the numbers after {} are not those of an attitude",
                        quoted(first == 0 ? text_.numbers.front().label : text_.groups[first].label));
        }
        for (const std::size_t group : groups) {
            const std::string& label = text_.groups[group].label;
            std::ranges::for_each(labels_in(group), refuse_operation);
            const bool is_of_one =
                is(vocabulary::number_of_a_set, label) || std::ranges::count(part_.names, lower(label)) > 0;
            if (is_of_one && !is_called_by_name(group)) {
                throw wrong("{} is the name of one number, and several follow it", quoted(label));
            }
        }
        const std::array<std::function<bool(std::size_t)>, 3> ranks{
            [this](std::size_t group) { return has_names(group); },
            [this](std::size_t group) { return is_called_by_name(group); },
            [this](std::size_t group) { return is(vocabulary::attitude, name_in(text_.groups[group].label)); }};
        for (const auto& is_right : ranks) {
            auto found = filtered(groups, is_right);
            if (found.size() > 1) { // two may differ in the unit
                const auto in_unit = filtered(found, [this](std::size_t group) { return has_unit(group); });
                found = in_unit.size() == 1 ? in_unit : found;
            }
            if (found.size() == 1) {
                leave_out(groups, found[0]);
                return found[0];
            }
        }
        if (groups.size() > 1) {
            refuse_groups(groups);
        }
        const std::string& label = text_.groups[groups[0]].label;
        refuse_operation(label);
        if (label.find('.') != std::string::npos && !named_representation(name_in(label))) {
            throw wrong("{} is not understood as the name of an attitude", quoted(label));
        }
        if (!label.empty() && !named_representation(name_in(label)) && conventions_in(label).empty()) {
            add_note(fmt::format("the numbers after {} are read as {}", quoted(label), spec().text()));
            has_other_label_ = true;
        }
        return groups[0];
    }

    /// Numbers beside those that are read must have a label.
    void leave_out(Indices groups, std::size_t chosen) {
        std::erase(groups, chosen);
        const auto is_unknown = [](const ValueNumber& each) { return each.group == 0 && each.label.empty(); };
        const auto unknown = std::ranges::find_if(text_.numbers, is_unknown);
        if (chosen != 0 && unknown != text_.numbers.end()) {
            throw wrong("{} has no label, beside the numbers after {}", quoted(unknown->text),
                        quoted(text_.groups[chosen].label));
        }
        if (!groups.empty()) {
            add_note(fmt::format("the numbers after {} are left out", quoted_list(labels_of_groups(groups))));
        }
    }
    [[nodiscard]] std::vector<std::string> labels_of_groups(const Indices& groups) const {
        return without_empty(mapped(groups, [this](std::size_t group) {
            return group == 0 ? joined(without_empty(labels_in(group))) : text_.groups[group].label;
        }));
    }
    [[noreturn]] void refuse_groups(Indices groups) const {
        groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
        throw wrong("more than one set of numbers, with the labels {}: none of them alone is that of {}",
                    quoted_list(labels_of_groups(groups)), text_of_part());
    }

    /// Numbers in a unit of length are a position's.
    static void leave_out_lengths(Numbers& numbers) {
        const auto is_length = [](const ValueNumber& number) { return number.unit == "m"; };
        const auto is_named = [](const ValueNumber& each) { return !each.label.empty() || !each.unit.empty(); };
        const auto length = std::ranges::find_if(numbers, is_length);
        if (length != numbers.end() &&
            (!std::ranges::all_of(numbers, is_named) || std::ranges::all_of(numbers, is_length))) {
            throw wrong("{} has a unit of length", quoted(length->text));
        }
        std::erase_if(numbers, is_length);
    }

    // What labels say.

    /// The numbers in the order of their labels, which are held against the part.
    [[nodiscard]] Numbers by_labels(Numbers numbers) {
        for (ValueNumber& number : numbers) {
            number.unit = number.unit.empty() ? unit_in(number.label) : number.unit;
        }
        const auto is_other = [](const ValueNumber& each) { return is_derived(each.label); };
        if (part_.attitude && !std::ranges::all_of(numbers, is_other)) {
            std::erase_if(numbers, is_other);
        }
        auto labels = labels_of(numbers);
        const auto given = without_empty(labels);
        if (given.empty()) {
            return numbers;
        }
        const auto is_twice = [&given](const std::string& label) { return std::ranges::count(given, label) > 1; };
        if (const auto twice = std::ranges::find_if(given, is_twice); twice != given.end()) {
            throw wrong("two of the numbers are called {}", quoted(*twice));
        }
        std::optional<KnownNames> known = find_names(part_, labels);
        if (!known && given.size() == labels.size() && part_.attitude) {
            for (std::string& each : labels) { // i j k are x y z
                each = each == "i" ? "x" : each == "j" ? "y" : each == "k" ? "z" : each;
            }
            Part of_labels = part_;
            of_labels.is_labelled = labels.size() == 3;
            known = find_names(of_labels, labels);
        }
        if (!known) {
            refuse_labels(given, labels.size() - given.size());
        }
        if (!known->decides) {
            add_note(fmt::format("the labels {} do not say which number of {} each is: they are read as they stand",
                                 joined(labels), text_of_part()));
            return numbers;
        }
        if (given.size() < labels.size()) {
            throw wrong("{} numbers without a label stand beside those of {}", labels.size() - given.size(),
                        text_of_part());
        }
        return in_order(numbers, known->places);
    }
    [[nodiscard]] static Numbers in_order(const Numbers& numbers, const auto& places) {
        return mapped(places, [&numbers](std::size_t place) {
            ValueNumber number = numbers[place];
            number.is_joined = false;
            return number;
        });
    }

    [[noreturn]] void refuse_labels(const std::vector<std::string>& given, std::size_t others) const {
        if (others > 0) {
            throw wrong("{} not understood: the other numbers have no label",
                        quoted_list(given) + (given.size() == 1 ? " is" : " are"));
        }
        std::vector<std::string_view> owners;
        for (const std::string_view name : messages::all_names()) {
            const auto parsed = parse_spec(name);
            const auto* const owner = std::get_if<Spec>(&parsed);
            if (owner != nullptr && (owner->project != nullptr || name == owner->text()) &&
                owner->size() == given.size() && find_names(*owner, given)) {
                owners.push_back(name);
            }
        }
        throw wrong("the labels {} are not those of {}{}", quoted_list(given), text_of_part(),
                    owners.empty() ? "" : fmt::format(": they are those of {}", joined(owners, ", ")))
            .of({owners.begin(), owners.end()});
    }

    // What words of convention say.

    /// Holds a word of convention against the SPEC, and applies an order that FROM leaves open.
    void hold(const std::string& word, Numbers& numbers) {
        const std::string_view unit = unit_of_word(word);
        for (ValueNumber& number : numbers) {
            if (!unit.empty() && !number.unit.empty() && number.unit != unit) {
                throw wrong("{} is in {} and in {}", quoted(number.text), number.unit, unit);
            }
            number.unit = unit.empty() ? number.unit : unit;
        }
        if (!unit.empty()) {
            return;
        }
        if (!part_.attitude) {
            throw wrong("{} is not understood before {}", quoted(word), text_of_part());
        }
        const auto* const modifier =
            std::ranges::find_if(all_modifiers, [&word](Modifier each) { return name_of(each) == word; });
        const auto sequence = EulerSequence::parse(word == "rpy" ? "xyz" : word == "ypr" ? "ZYX" : word);
        const auto named = named_representation(word);
        Spec meant = spec();
        if (word == "xyzw" || word == "wxyz") {
            hold_order(word, numbers);
        } else if (sequence) {
            const bool is_own = spec().sequence.text() == sequence->text() &&
                                (spec().name == RepresentationId::euler || spec().name == RepresentationId::rpy);
            meant.name = is_own ? spec().name : word == "rpy" ? RepresentationId::rpy : RepresentationId::euler;
            meant.sequence = *sequence;
        } else if (modifier != all_modifiers.end()) {
            meant.apply(ModifierSet{*modifier});
        } else if (named && named != spec().name && !is(vocabulary::open_name, word)) {
            meant = {.name = *named};
        }
        if (meant.text() != spec().text()) {
            throw wrong("{} is {}, not {}", quoted(word), meant.text(), spec().text()).of({meant.text()});
        }
    }

    void hold_order(const std::string& word, Numbers& numbers) {
        if (spec().name != RepresentationId::quat) {
            throw wrong("{} is an order of quat, not of {}", quoted(word), spec().text());
        }
        const bool is_labelled = !numbers.front().label.empty();
        if (is_labelled || spec().scalar_last == (word == "xyzw") || numbers.size() != 4 ||
            std::exchange(is_ordered_, true)) {
            return;
        }
        if (spec().scalar_last || spec().project != nullptr || from_.find("wxyz") != std::string_view::npos) {
            throw wrong("{} contradicts {}", quoted(word), from_);
        }
        numbers = in_order(numbers, std::array<std::size_t, 4>{3, 0, 1, 2});
        add_note(fmt::format("{} is applied, as quat:xyzw does", quoted(word)));
    }

    /// Holds the units of numbers against those of the SPEC; those of an axis are the angle's.
    void hold_units(const Numbers& numbers) const {
        const bool has_angles = part_.attitude && representation(spec().name).has_angles();
        const std::string_view own = has_angles && spec().unit == AngleUnit::degrees ? "deg" : "rad";
        for (const ValueNumber& number : numbers) {
            const bool is_angle = has_angles && (&number >= &numbers[representation(spec().name).first_angle]);
            if (!number.unit.empty() && !(has_angles && number.unit == (is_angle ? own : numbers.back().unit))) {
                Spec meant = part_.attitude.value_or(Spec());
                meant.unit = own == "deg" ? AngleUnit::radians : AngleUnit::degrees;
                throw wrong("{} is in {}, but {} {}", quoted(number.text), number.unit, text_of_part(),
                            has_angles ? fmt::format("is in {}: {}", own, meant.text()) : "has no angles")
                    .of(has_angles ? std::vector{meant.text()} : std::vector<std::string>());
            }
        }
    }

    /// The rotation of a pose of 4x4.
    [[nodiscard]] Numbers of_pose(const Numbers& numbers) {
        const auto has_end = [&numbers](const std::array<std::size_t, 4>& places) { // 0 0 0 1
            return std::ranges::all_of(places, [&](std::size_t place) {
                double value = 0.0;
                return stream::read_number(numbers[place].text, value) == stream::NumberError::none &&
                       value == (place == 15 ? 1.0 : 0.0);
            });
        };
        const bool by_rows = has_end({12, 13, 14, 15});
        const bool by_columns = has_end({3, 7, 11, 15});
        if (spec().column_major ? !by_columns : !by_rows && !by_columns) {
            throw wrong("16 numbers under {} are a 4x4 with 0 0 0 1 in its last {}: these are not", spec().text(),
                        spec().column_major ? "column" : "row, or by columns (dcm:col) in its last column");
        }
        bool shows_rows = true;
        for (std::size_t i = 1; i < numbers.size(); ++i) {
            shows_rows = shows_rows && (numbers[i].bracket == numbers[i - 1].bracket) == (i % 4 != 0);
        }
        const bool takes_columns = !spec().column_major && !by_rows;
        if (takes_columns || (!spec().column_major && by_columns && !shows_rows)) {
            add_note(takes_columns ? "the 4x4 is read by columns, as dcm:col does: its last column is 0 0 0 1"
                                   : "the 4x4 is read by rows; if it is listed by columns: dcm:col");
        }
        return in_order(numbers, takes_columns ? std::array<std::size_t, 9>{0, 4, 8, 1, 5, 9, 2, 6, 10}
                                               : std::array<std::size_t, 9>{0, 1, 2, 4, 5, 6, 8, 9, 10});
    }

    const ValueText& text_;
    const Part& part_;
    std::string_view from_;
    bool is_ordered_ = false; ///< by a word
    bool has_other_label_ = false;
    std::string note_;
};

/// Joins an axis and an angle, each behind its label, to one group of four numbers.
void join_axis(ValueText& text) {
    const auto label_of = [&text](std::size_t group) { return std::string_view(text.groups[group].label); };
    const auto is_angle = [&](const ValueNumber& each) {
        return is(" angle theta ", each.label.empty() ? label_of(each.group) : each.label);
    };
    const auto is_axis = [&](std::size_t group) { return is(" axis n ", label_of(group)); };
    const auto angle = std::ranges::find_if(text.numbers, is_angle);
    const auto belongs = [&](const ValueNumber& each) { return is_angle(each) || is_axis(each.group); };
    if (text.numbers.size() != 4 || std::ranges::count_if(text.numbers, is_angle) != 1 ||
        !std::ranges::all_of(text.numbers, belongs) ||
        std::ranges::any_of(text.words, [&](const ValueWord& word) { return is_axis(word.group); })) {
        return;
    }
    char name = 'x';
    for (ValueNumber& number : text.numbers) {
        number.label = &number == &*angle     ? "angle"
                       : number.label.empty() ? std::string("a") + name++
                                              : "a" + number.label;
        number.group = angle->group;
    }
}

/// The numbers of a text for the parts of a row.
Numbers numbers_of(const ValueText& text, const std::vector<Part>& parts, std::string_view from, Values& values) {
    if (parts.size() == 1 && !text.numbers.empty()) {
        Reading reading(text, parts[0], from);
        auto numbers = reading.chosen();
        reading.tell(values);
        return numbers;
    }
    const Part& last = parts.back();
    if (text.numbers.size() != last.begin + last.names.size()) {
        return text.numbers; // an error of the row
    }
    Numbers numbers = mapped(names_of_row(parts, labels_of(text.numbers)).places,
                             [&text](std::size_t place) { return text.numbers[place]; });
    for (const Part& part : parts) {
        const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(part.begin);
        Reading reading(text, part, from);
        reading.check_aside(begin->group);
        const auto own = reading.held({begin, begin + static_cast<std::ptrdiff_t>(part.names.size())});
        std::ranges::copy(own, begin);
        reading.tell(values);
    }
    return numbers;
}

} // namespace

bool is_value(std::string_view word) {
    word.remove_prefix(std::min(word.find_first_not_of("[](){}<> \t\r\n"), word.size()));
    return stream::is_number(word.substr(0, word.find_first_of(",; \t\r\n[](){}<>")));
}

Values values_of(const std::vector<std::string>& words, std::optional<stream::Delimiter> given,
                 const stream::RowNumbers& numbers, std::string_view from, bool are_selected) {
    const std::string text = joined(words, " ");
    if (!given || words.size() > 1) {
        given = text.find(',') != std::string::npos ? stream::Delimiter::character(',') : stream::Delimiter::blanks();
    }
    Values values{text, *given};
    const auto fields = values.fields();
    const bool is_row = text.find_first_of("[](){}<>:=;|\"'\r\n") == std::string::npos &&
                        (are_selected || std::ranges::all_of(fields, [](std::string_view field) {
                             return std::ranges::all_of(words_in(field), stream::is_number);
                         }));
    const bool may_be_pose = numbers.attitude && parts_of(numbers).size() == 1 &&
                             ((numbers.attitude->name == RepresentationId::dcm && fields.size() == 16) ||
                              pose_columns(*numbers.attitude, fields.size()).are_known);
    if (is_row && (are_selected || !may_be_pose)) {
        return values;
    }
    ValueText read = parse_values(text);
    if (numbers.attitude && numbers.attitude->name == RepresentationId::axis_angle) {
        join_axis(read);
    }
    const bool by_place = are_selected || !numbers.attitude; // identify reads numbers as they stand
    if (by_place && !read.words.empty()) {
        throw wrong("{} is not understood beside numbers that are read as they stand", quoted(read.words[0].text));
    }
    const Numbers chosen = by_place ? read.numbers : numbers_of(read, parts_of(numbers), from, values);
    const bool has_commas = std::ranges::any_of(chosen, &ValueNumber::after_comma); // blanks do not separate as they do
    values.row.clear();
    for (const ValueNumber& number : chosen) {
        values.row +=
            &number == chosen.data() ? "" : std::string(1, number.is_joined && has_commas ? ' ' : given->text());
        values.row += number.text;
    }
    return values;
}

std::optional<Values> attitude_in(const std::string& text, const stream::RowNumbers& numbers, std::string_view from,
                                  bool& means_other) {
    try {
        Values values = values_of({text}, std::nullopt, numbers, from, false);
        const auto fields = values.fields();
        const bool is_one = fields.size() == numbers.names.size() && std::ranges::all_of(fields, stream::is_number);
        return is_one ? std::optional(std::move(values)) : std::nullopt;
    } catch (const Usage& error) {
        means_other = !error.specs.empty();
        return std::nullopt;
    }
}

} // namespace rotconv::cli
