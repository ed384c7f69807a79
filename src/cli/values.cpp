#include "values.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "../operations/operations.hpp"
#include "../stream/fmt.hpp"
#include "../stream/number_text.hpp"
#include "column_names.hpp"
#include "messages.hpp"
#include "option_set.hpp"
#include "value_text.hpp"
#include "words.hpp"

namespace rotconv::cli {
namespace {

using Indices = std::vector<std::size_t>; ///< of numbers or groups of a text

constexpr std::string_view brackets = "[](){}<>";

template <class... Arguments>
[[noreturn]] void refuse(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    throw Usage("argument: {}", fmt::format(format, std::forward<Arguments>(arguments)...));
}

bool is_one_of(std::string_view word, std::string_view list) {
    const auto words = words_in(list);
    return std::ranges::count(words, word) > 0;
}

/// Whether the numbers under a label are never those of the attitude.
bool is_never_read(const std::vector<std::string>& parts) {
    return is_one_of(parts.back(),
                     "position translation pos xyz origin scale center size t tvec time covariance angular "
                     "linear omega gyro gyr") ||
           std::ranges::any_of(parts, [](const std::string& part) {
               const auto beginnings = words_in("rate speed spd dps vel acc std sigma cov var err cmd setpoint target "
                                                "ref delta reset offset bias");
               return is_one_of(part, "dot sp des desired") ||
                      std::ranges::any_of(beginnings,
                                          [&part](const std::string& each) { return part.starts_with(each); });
           });
}

/// Whether a label says that something is to be done to the numbers.
bool is_operation(std::string_view label, const std::vector<std::string>& parts) {
    return label.ends_with(".T") || label.ends_with("_T") || std::ranges::any_of(parts, [](const std::string& part) {
               return is_one_of(part, "inv inverse inverted conj conjugate transpose transposed neg negative minus");
           });
}

/// deg or rad at the end of a label: roll_deg, "yaw [rad]", rollDeg.
std::string_view unit_in(const std::string& label) {
    const std::string last = parts_of_label(label).back();
    const std::string_view unit = name_and_unit(label).second;
    return is_one_of(last, "deg degree degrees")   ? "deg"
           : is_one_of(last, "rad radian radians") ? "rad"
           : unit == "deg" || unit == "rad"        ? unit
                                                   : "";
}

std::string with_modifier(const Spec& spec, Modifier modifier) {
    Spec meant = spec;
    meant.apply({modifier});
    return meant.text();
}

/// The attitude among the numbers of a text.
class Attitude {
public:
    Attitude(const ValueText& text, const Spec& spec, std::string_view from) : text_(text), spec_(spec), from_(from) {}

    /// The numbers in the order of the SPEC.
    std::vector<ValueNumber> numbers() {
        group_ = choose();
        auto numbers = numbers_in(group_);
        leave_out_lengths(numbers);
        add_components(numbers);
        numbers = by_labels(std::move(numbers));
        for (std::size_t group = group_;; group = text_.groups[group].parent) {
            refuse_operation(group);
            for (const ValueWord& word : text_.words) {
                if (word.group == group) {
                    hold(word.text, word.is_order, numbers);
                }
            }
            const std::string& label = text_.groups[group].label;
            const std::string_view last = std::string_view(label).substr(label.find_last_of("_.: ") + 1);
            if (last.size() > 1) {
                hold_label(last, numbers);
            }
            for (ValueNumber& number : numbers) {
                number.unit = number.unit.empty() ? text_.groups[group].unit : number.unit;
            }
            if (group == 0) {
                break;
            }
        }
        hold_units(numbers);
        return spec_.name == RepresentationId::dcm && numbers.size() == 16 ? of_pose(numbers) : numbers;
    }
    [[nodiscard]] std::vector<stream::Note> notes() { return std::move(notes_); }

private:
    void note(std::string text) { notes_.push_back({.kind = stream::Note::Kind::order, .text = std::move(text)}); }

    [[nodiscard]] Part part() const { return {operations::names_of(spec_), 0, spec_}; }
    [[nodiscard]] std::vector<ValueNumber> numbers_in(std::size_t group) const {
        return filtered(text_.numbers, [group](const ValueNumber& each) { return each.group == group; });
    }
    [[nodiscard]] std::vector<std::string> labels_in(std::size_t group) const {
        return mapped(numbers_in(group), &ValueNumber::label);
    }
    [[nodiscard]] std::vector<std::string> parts_of(std::size_t group) const {
        return parts_of_label(text_.groups[group].label);
    }
    [[nodiscard]] bool is_left_out(std::size_t group) const {
        bool is_out = group != 0 && is_never_read(name_parts_of(group));
        for (; group != 0 && !is_out; group = text_.groups[group].parent) {
            const std::string last = parts_of(group).back();
            is_out = last == "header" || last == "stamp";
        }
        return is_out;
    }

    /// The parts of a label without a unit and an order at its end.
    [[nodiscard]] std::vector<std::string> name_parts_of(std::size_t group) const {
        auto parts = parts_of(group);
        const auto says_how = [](const std::string& part) {
            return is_one_of(part, "deg degree degrees rad radian radians xyzw wxyz") ||
                   std::ranges::any_of(messages::all_sequences(),
                                       [&](const auto& each) { return lower(each) == part; });
        };
        while (parts.size() > 1 && says_how(parts.back())) {
            parts.pop_back();
        }
        return parts;
    }
    [[nodiscard]] std::string name_in(std::size_t group) const { return name_parts_of(group).back(); }

    /// Refuses a label that says more than a name.
    void refuse_operation(std::size_t group) const {
        if (const std::string& label = text_.groups[group].label; is_operation(label, parts_of(group))) {
            refuse("{} says that something is done to the numbers, which is not", quoted(label));
        }
    }
    /// The same, and refuses one that names one number before several.
    void check_label(std::size_t group) const {
        const std::string& label = text_.groups[group].label;
        refuse_operation(group);
        const auto names = part().names;
        const bool is_name_of_one =
            is_one_of(lower(label), "w x y z i j k") || std::ranges::count(names, lower(label)) > 0;
        if (is_name_of_one && !is_called_by_name(group)) {
            refuse("{} is the name of one number, and several follow it", quoted(label));
        }
    }
    [[nodiscard]] bool is_called_by_name(std::size_t group) const {
        return named_representation(name_in(group)) == spec_.name ||
               named_representation(text_.groups[group].label) == spec_.name;
    }

    /// The group whose numbers are the attitude's.
    [[nodiscard]] std::size_t choose() {
        Indices groups;
        for (std::size_t i = 0; i < text_.groups.size(); ++i) {
            const bool has_numbers = std::ranges::count(text_.numbers, i, &ValueNumber::group) > 0;
            if (has_numbers && (i == 0 || !is_operation(text_.groups[i].label, parts_of(i))) && is_left_out(i)) {
                continue;
            }
            if (has_numbers) {
                check_label(i);
                groups.push_back(i);
            }
        }
        const auto is_only_aside = [this](std::size_t group) { // single numbers whose labels are never read
            const auto labels = labels_in(group);
            return group == 0 && std::ranges::all_of(labels, [](const std::string& label) {
                       return !label.empty() && is_never_read(parts_of_label(label));
                   });
        };
        if (groups.size() > 1) {
            std::erase_if(groups, is_only_aside);
        }
        if (groups.empty()) {
            refuse("the numbers after {} are not those of an attitude",
                   quoted(text_.groups[text_.numbers.front().group].label));
        }
        const auto has_names = [this](std::size_t group) {
            const auto labels = labels_in(group);
            return std::ranges::count(labels, "") == 0 && find_names(part(), labels).has_value();
        };
        const auto has_own_name = [this](std::size_t group) {
            return !text_.groups[group].label.empty() && is_called_by_name(group);
        };
        const auto is_called_attitude = [this](std::size_t group) {
            return is_one_of(name_in(group), "rotation orientation attitude rot ori");
        };
        for (const auto& is_right :
             {std::function<bool(std::size_t)>(has_names), std::function<bool(std::size_t)>(has_own_name),
              std::function<bool(std::size_t)>(is_called_attitude)}) {
            auto found = filtered(groups, is_right);
            if (found.size() > 1) { // of two that differ in the unit the SPEC's
                const std::string_view unit = spec_.unit == AngleUnit::degrees ? "deg" : "rad";
                const auto in_unit =
                    filtered(found, [&](std::size_t group) { return text_.groups[group].unit == unit; });
                found = in_unit.size() == 1 ? in_unit : found;
            }
            if (found.size() == 1) {
                note_left_out(groups, found[0]);
                return found[0];
            }
        }
        if (groups.size() > 1) {
            const auto labels = mapped(groups, [this](std::size_t group) { return text_.groups[group].label; });
            refuse("more than one set of numbers, with the labels {}: none of them alone is that of {}",
                   quoted_list(filtered(labels, [](const std::string& label) { return !label.empty(); })),
                   spec_.text());
        }
        const std::string& label = text_.groups[groups[0]].label;
        if (label.find('.') != std::string::npos && !named_representation(name_in(groups[0]))) {
            refuse("{} is not understood as the name of an attitude", quoted(label));
        }
        if (!label.empty() && !named_representation(name_in(groups[0])) && !is_convention_label(label)) {
            note(fmt::format("the numbers after {} are read as {}", quoted(label), spec_.text()));
        }
        return groups[0];
    }

    [[nodiscard]] static bool is_convention_label(std::string_view label) {
        const std::string last = parts_of_label(label).back();
        return is_one_of(last, "rpy ypr deg rad degrees radians xyzw wxyz");
    }

    void note_left_out(const Indices& groups, std::size_t chosen) {
        const auto others = filtered(groups, [chosen](std::size_t group) { return group != chosen; });
        const auto labels = mapped(others, [this](std::size_t group) {
            return text_.groups[group].label.empty()
                       ? joined(filtered(labels_in(group), [](const auto& each) { return !each.empty(); }))
                       : text_.groups[group].label;
        });
        if (!labels.empty()) {
            note(fmt::format("the numbers after {} are left out", quoted_list(labels)));
        }
    }

    /// Numbers in a unit of length are a position's.
    static void leave_out_lengths(std::vector<ValueNumber>& numbers) {
        const auto is_length = [](const ValueNumber& number) { return number.unit == "m"; };
        const auto length = std::ranges::find_if(numbers, is_length);
        if (length == numbers.end()) {
            return;
        }
        const bool others_are_named = std::ranges::all_of(numbers, [&](const ValueNumber& each) {
            return is_length(each) || !each.label.empty() || !each.unit.empty();
        });
        if (!others_are_named || std::ranges::all_of(numbers, is_length)) {
            refuse("{} has a unit of length", quoted(length->text));
        }
        std::erase_if(numbers, is_length);
    }

    /// The sum of a quaternion as its four numbers.
    void add_components(std::vector<ValueNumber>& numbers) const {
        if (std::ranges::none_of(numbers, [](const ValueNumber& each) { return each.component != '\0'; })) {
            return;
        }
        if (spec_.name != RepresentationId::quat) {
            refuse("a sum with i, j and k is a quaternion, not {}", spec_.text());
        }
        for (const ValueNumber& each : numbers) {
            if (!each.label.empty()) {
                refuse("{} is not understood before a sum", quoted(each.label));
            }
        }
        std::vector<ValueNumber> sum;
        for (const char component : {'\0', 'i', 'j', 'k'}) {
            const auto has = [component](const ValueNumber& each) { return each.component == component; };
            if (std::ranges::count_if(numbers, has) > 1) {
                refuse("two terms of the sum are of one kind");
            }
            const auto found = std::ranges::find_if(numbers, has);
            ValueNumber& number = sum.emplace_back(found == numbers.end() ? ValueNumber{.text = "0"} : *found);
            number.label = component == '\0' ? "w" : component == 'i' ? "x" : component == 'j' ? "y" : "z";
        }
        numbers = std::move(sum);
    }

    /// The numbers in the order of their labels, which are held against the SPEC.
    [[nodiscard]] std::vector<ValueNumber> by_labels(std::vector<ValueNumber> numbers) {
        for (ValueNumber& number : numbers) {
            if (const std::string_view unit = unit_in(number.label); !unit.empty() && number.unit.empty()) {
                number.unit = unit;
            }
        }
        auto labels = mapped(numbers, &ValueNumber::label);
        const auto named =
            static_cast<std::size_t>(std::ranges::count_if(labels, [](const auto& label) { return !label.empty(); }));
        if (named == 0) {
            return numbers;
        }
        for (const std::string& label : labels) {
            if (!label.empty() && std::ranges::count(labels, label) > 1) {
                refuse("two of the numbers are called {}", quoted(label));
            }
        }
        if (spec_.name == RepresentationId::quat) { // i j k w
            auto letters = labels;
            for (std::string& each : letters) {
                each = each == "i" ? "x" : each == "j" ? "y" : each == "k" ? "z" : each;
            }
            labels = find_names(part(), labels) ? labels : letters;
        }
        std::optional<KnownNames> known = find_names(part(), labels);
        if (!known && named == labels.size()) {
            known = components_in(labels);
        }
        if (known && !known->decides) {
            note(fmt::format("the labels {} do not say which number of {} each is: they are read as they stand",
                             joined(labels), spec_.text()));
            return numbers;
        }
        if (!known) {
            refuse_labels(labels, named);
        }
        if (named < labels.size()) {
            refuse("{} numbers without a label stand beside those of {}", labels.size() - named, spec_.text());
        }
        return mapped(known->places, [&numbers](std::size_t place) {
            ValueNumber number = numbers[place];
            number.is_joined = false;
            return number;
        });
    }

    /// Bare x y z, or after r, rot and the like: components of a vector along the axes, or angles about them.
    [[nodiscard]] std::optional<KnownNames> components_in(const std::vector<std::string>& labels) const {
        const bool is_vector = is_one_of(representation(spec_.name).text, "rotvec cayley mrp");
        const bool is_euler = (spec_.name == RepresentationId::euler || spec_.name == RepresentationId::rpy) &&
                              spec_.project == nullptr && !spec_.sequence.proper();
        const auto found =
            labels.size() == 3 && (is_vector || is_euler) ? find_names({{"x", "y", "z"}, 0, {}}, labels) : std::nullopt;
        if (!found) {
            return std::nullopt;
        }
        const std::string& x = labels[found->places[0]];
        std::string prefix = lower(x.substr(0, x.size() - 1));
        prefix.erase(0, prefix.find_first_not_of('_'));
        prefix.resize(prefix.find_last_not_of('_') + 1);
        if (!prefix.empty() && !is_one_of(prefix, "r rot rotvec rvec angle")) {
            return std::nullopt;
        }
        KnownNames ordered = *found;
        for (std::size_t i = 0; is_euler && i < 3; ++i) {
            ordered.places[i] = found->places[static_cast<std::size_t>(spec_.sequence.axis(i))];
        }
        return ordered;
    }

    [[noreturn]] void refuse_labels(const std::vector<std::string>& labels, std::size_t named) const {
        const auto given = filtered(labels, [](const std::string& label) { return !label.empty(); });
        if (named < labels.size()) {
            refuse("{} not understood: the other numbers have no label",
                   quoted_list(given) + (named == 1 ? " is" : " are"));
        }
        std::vector<std::string> others;
        for (const Project& project : projects()) {
            if (project.is_spec() && find_names(std::get<Spec>(parse_spec(project.text)), labels) &&
                words_in(project.columns).size() == labels.size()) {
                others.emplace_back(project.text);
            }
        }
        for (const RepresentationId id : all_representations) {
            if (id != RepresentationId::euler && find_names(Spec{.name = id}, labels)) {
                others.emplace_back(representation(id).text);
            }
        }
        refuse("the labels {} are not those of {}{}", quoted_list(given), spec_.text(),
               others.empty() ? std::string() : fmt::format(": they are those of {}", joined(others, ", ")));
    }

    /// What a label says at its end: q_xyzw, euler_xyz, rpy_deg.
    void hold_label(std::string_view last, std::vector<ValueNumber>& numbers) {
        const std::string low = lower(last);
        if (is_one_of(low, "deg degree degrees rad radian radians")) {
            for (ValueNumber& number : numbers) {
                number.unit = number.unit.empty() ? low.substr(0, 3) : number.unit;
            }
        } else if (is_one_of(low, "rpy ypr xyzw wxyz passive col positive")) {
            hold(low, false, numbers);
        } else if (std::ranges::count(messages::all_sequences(), last) > 0 || named_representation(last)) {
            hold(std::string(last), false, numbers);
        }
    }

    /// Holds a word of convention against the SPEC, and applies an order that FROM leaves open.
    void hold(const std::string& word, bool is_order, std::vector<ValueNumber>& numbers) {
        const bool is_sequence = std::ranges::count(messages::all_sequences(), word) > 0;
        if (is_order) {
            std::string upper = word;
            std::ranges::transform(upper, upper.begin(),
                                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
            refuse("order {} has two meanings: euler:{} about the body's axes (three.js), euler:{} about fixed ones "
                   "(Blender)",
                   quoted(word), upper, lower(word));
        }
        if (word == "xyzw" || word == "wxyz") {
            hold_order(word, numbers);
        } else if (word == "deg" || word == "rad") {
            for (ValueNumber& number : numbers) {
                if (!number.unit.empty() && number.unit != word) {
                    refuse("{} is in {} and in {}", quoted(number.text), number.unit, word);
                }
                number.unit = word;
            }
        } else if (is_sequence || word == "rpy" || word == "ypr") {
            const std::string sequence = word == "rpy" ? "xyz" : word == "ypr" ? "ZYX" : word;
            const bool is_euler = spec_.name == RepresentationId::euler || spec_.name == RepresentationId::rpy;
            if (!is_euler || spec_.sequence.text() != sequence) {
                Spec meant{.name = RepresentationId::euler,
                           .sequence = EulerSequence::parse(sequence).value_or(roll_pitch_yaw),
                           .unit = spec_.unit};
                meant.name = word == "rpy" ? RepresentationId::rpy : meant.name;
                refuse("{} is {}, not {}", quoted(word), meant.text(), spec_.text());
            }
        } else if (const auto named = named_representation(word)) {
            const bool is_open = is_one_of(lower(word), "matrix euler");
            if (*named != spec_.name && !is_open) {
                refuse("{} is {}, not {}", quoted(word), representation(*named).text, spec_.text());
            }
        } else {
            for (const Modifier modifier : all_modifiers) {
                if (name_of(modifier) == word && !spec_.modifiers().has(modifier)) {
                    const bool has_meaning = representation(spec_.name).modifiers.has(modifier);
                    refuse("{} is {}", quoted(word),
                           has_meaning ? with_modifier(spec_, modifier)
                                       : fmt::format("no modifier of {}", spec_.text()));
                }
            }
        }
    }

    void hold_order(const std::string& word, std::vector<ValueNumber>& numbers) {
        const bool is_last = word == "xyzw";
        if (spec_.name != RepresentationId::quat) {
            refuse("{} is an order of quat, not of {}", quoted(word), spec_.text());
        }
        const bool is_named =
            spec_.scalar_last || spec_.project != nullptr || from_.find("wxyz") != std::string_view::npos;
        const bool are_labelled =
            std::ranges::none_of(numbers, [](const ValueNumber& each) { return each.label.empty(); });
        if (are_labelled || spec_.scalar_last == is_last || numbers.size() != 4 || std::exchange(is_ordered_, true)) {
            return;
        }
        if (is_named) {
            refuse("{} contradicts {}", quoted(word), from_);
        }
        std::rotate(numbers.begin(), numbers.begin() + 3, numbers.end());
        note(fmt::format("{} is applied, as quat:xyzw does", quoted(word)));
    }

    /// Holds the units of numbers against those of the SPEC.
    void hold_units(const std::vector<ValueNumber>& numbers) const {
        const Representation& entry = representation(spec_.name);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const std::string& unit = numbers[i].unit;
            const bool is_angle = entry.has_angles() && i >= entry.first_angle;
            const std::string_view own = spec_.unit == AngleUnit::degrees ? "deg" : "rad";
            if (unit.empty() || (is_angle && unit == own) || (entry.has_angles() && i < entry.first_angle)) {
                continue;
            }
            Spec meant = spec_;
            meant.unit = unit == "deg" ? AngleUnit::degrees : AngleUnit::radians;
            refuse("{} is in {}, but {} {}", quoted(numbers[i].text), unit, spec_.text(),
                   entry.has_angles() ? fmt::format("is in {}: {}", own, meant.text()) : "has no angles");
        }
    }

    /// The rotation of a pose of 4x4.
    [[nodiscard]] std::vector<ValueNumber> of_pose(const std::vector<ValueNumber>& numbers) {
        const auto is = [&numbers](std::size_t at, double expected) {
            double value = 0.0;
            return stream::read_number(numbers[at].text, value) == stream::NumberError::none && value == expected;
        };
        const bool by_rows = is(12, 0.0) && is(13, 0.0) && is(14, 0.0) && is(15, 1.0);
        const bool by_columns = is(3, 0.0) && is(7, 0.0) && is(11, 0.0) && is(15, 1.0);
        const auto shows_row = [&numbers](std::size_t row) {
            const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(4 * row);
            return std::all_of(first, first + 4,
                               [&](const ValueNumber& each) { return each.bracket == first->bracket; });
        };
        const bool shows_rows =
            shows_row(0) && shows_row(1) && shows_row(2) && shows_row(3) && numbers[0].bracket != numbers[4].bracket;
        if (spec_.column_major ? !by_columns : !by_rows && !by_columns) {
            if (spec_.column_major) {
                refuse("16 numbers under {} need 0 0 0 1 in their last column", spec_.text());
            }
            refuse("16 numbers are a 4x4 with 0 0 0 1 in its last row, or by columns (dcm:col) in its last column: "
                   "these have neither");
        }
        const bool takes_columns = !spec_.column_major && !by_rows;
        if (takes_columns) {
            note("the 4x4 is read by columns, as dcm:col does: its last column is 0 0 0 1");
        } else if (!spec_.column_major && by_columns && !shows_rows) {
            note("the 4x4 is read by rows; if it is listed by columns: dcm:col");
        }
        constexpr std::array<std::size_t, 9> rows{0, 1, 2, 4, 5, 6, 8, 9, 10};
        constexpr std::array<std::size_t, 9> columns{0, 4, 8, 1, 5, 9, 2, 6, 10};
        return mapped(takes_columns ? columns : rows, [&numbers](std::size_t place) {
            ValueNumber number = numbers[place];
            number.is_joined = false;
            return number;
        });
    }

    const ValueText& text_;
    const Spec& spec_;
    std::string_view from_;
    std::size_t group_ = 0;
    bool is_ordered_ = false; ///< by a word
    std::vector<stream::Note> notes_;
};

/// All numbers of a text, those of each part in the order of their labels.
std::vector<ValueNumber> of_parts(const ValueText& text, const stream::RowNumbers& row) {
    const bool has_names = row.attitude.has_value(); // identify reads numbers as they stand
    auto numbers = text.numbers;
    for (const ValueWord& word : text.words) {
        const auto named = named_representation(word.text);
        if (has_names && !(named && (named == row.attitude->name || (row.second && named == row.second->name)))) {
            refuse("{} is not understood beside several sets of numbers", quoted(word.text));
        }
    }
    for (const ValueGroup& group : text.groups) {
        const auto label = parts_of_label(group.label);
        if (has_names && (is_operation(group.label, label) || !unit_in(group.label).empty() || !group.unit.empty() ||
                          is_one_of(label.back(), "xyzw wxyz passive ypr col"))) {
            refuse("{} is not understood beside several sets of numbers", quoted(group.label));
        }
    }
    if (!has_names || numbers.size() != row.names.size()) {
        return numbers;
    }
    const auto labels = mapped(numbers, &ValueNumber::label);
    const std::vector<Part> parts = parts_of(row);
    const RowNames names = names_of_row(parts, labels);
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const bool is_degrees = parts[k].attitude && parts[k].attitude->unit == AngleUnit::degrees;
        for (std::size_t i = parts[k].begin; i < parts[k].begin + parts[k].names.size(); ++i) {
            const std::string unit(numbers[i].unit.empty() ? unit_in(labels[i]) : numbers[i].unit);
            if (!unit.empty() && (!parts[k].attitude || unit != (is_degrees ? "deg" : "rad"))) {
                refuse("{} is in {}, which is not the unit of these numbers", quoted(numbers[i].text), unit);
            }
        }
        const auto own = parts[k].of(labels);
        if (!names.sets[k] && std::ranges::any_of(own, [](const std::string& label) { return !label.empty(); })) {
            refuse("the labels {} are not those of {}", joined(own),
                   parts[k].attitude ? parts[k].attitude->text() : joined(parts[k].names));
        }
    }
    numbers = mapped(names.places, [&numbers](std::size_t place) { return numbers[place]; });
    return numbers;
}

} // namespace

bool is_value(std::string_view word) {
    const std::size_t first = std::min(word.find_first_not_of("[](){}<> \t\r\n"), word.size());
    const bool has_bracket = word.substr(0, first).find_first_of(brackets) != std::string_view::npos;
    word.remove_prefix(first);
    return stream::is_number(word.substr(0, word.find_first_of(",; \t\r\n[](){}<>"))) ||
           (has_bracket && word.find_first_of("0123456789+-.") == 0);
}

Values values_of(const std::vector<std::string>& words, std::optional<stream::Delimiter> given,
                 const stream::RowNumbers& numbers, std::string_view from, bool are_selected) {
    std::string text = joined(words, " ");
    if (!given || words.size() > 1) {
        given = text.find(',') != std::string::npos ? stream::Delimiter::character(',') : stream::Delimiter::blanks();
    }
    std::vector<std::string_view> fields;
    static_cast<void>(given->split(text, fields));
    const bool is_row = text.find_first_of("[](){}<>:=;|\"'\r\n") == std::string::npos &&
                        (are_selected || std::ranges::all_of(fields, [](std::string_view field) {
                             return std::ranges::all_of(words_in(field), stream::is_number);
                         }));
    const bool may_be_pose = numbers.attitude && numbers.attitude->name == RepresentationId::dcm && fields.size() == 16;
    if (is_row && (are_selected || !may_be_pose)) {
        return {std::move(text), *given, {}};
    }
    const ValueText read = parse_values(text);
    Values values{.delimiter = *given};
    std::vector<ValueNumber> chosen = read.numbers;
    const bool is_one = numbers.attitude && numbers.names.size() == numbers.attitude->size();
    if (!chosen.empty() && !are_selected && is_one) {
        Attitude attitude(read, *numbers.attitude, from);
        chosen = attitude.numbers();
        values.notes = attitude.notes();
    } else if (!are_selected) {
        chosen = of_parts(read, numbers);
    }
    for (const ValueNumber& number : chosen) {
        if (&number != chosen.data()) {
            values.row += number.is_joined ? ' ' : given->text();
        }
        values.row += number.text;
    }
    return values;
}

} // namespace rotconv::cli
