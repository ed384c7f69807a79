#include <algorithm>
#include <array>
#include <initializer_list>
#include <memory>
#include <span>
#include <utility>
#include <variant>

#include "../stream/number_text.hpp"
#include "column_names.hpp"
#include "row_options.hpp"

namespace rotconv::cli {
namespace {

using Kind = stream::Note::Kind;

bool is_angle(std::string_view unit) { return unit == "rad" || unit == "deg"; }

/// The notes on one stream.
class Notes {
public:
    Notes(const RowOptions& options, const Option& time_option, bool refuses, const stream::InputOptions& input)
        : degrees_(options.degrees.given()), time_option_(time_option.name()),
          time_unit_((time_option.given() ? time_option : options.time_unit).text()),
          refuses_(refuses && input.columns.empty()),
          is_by_index_(!input.columns.empty() && !input.columns.has_names()), parts_(parts_of(input.numbers)) {}

    [[nodiscard]] std::vector<std::string> own_names(std::vector<std::string> names) const {
        for (const Part& part : parts_) {
            const auto known = find_names(part, part.of(names));
            for (std::size_t i = 0; part.attitude && known && !known->is_numbered && i < part.names.size(); ++i) {
                names[part.begin + known->places[i]] = part.names[i];
            }
        }
        return mapped(names, [](const std::string& name) { return name_and_unit(name).first; });
    }

    /// Refuses selected names in another order than the SPEC's, which would give a wrong attitude in silence.
    void refuse_other_order(const stream::ColumnList& columns, std::string_view option) const {
        const auto names = mapped(columns.names(), [](std::string_view name) { return std::string(name); });
        for (const Part& part : parts_) {
            if (const auto wrong = error_of_order(part, part.of(names)); !wrong.empty()) {
                throw Usage("{} {} (if the file is mislabelled, select by index)", option, wrong);
            }
        }
    }

    [[nodiscard]] std::vector<stream::Note> on(const stream::Said& said) const {
        std::vector<stream::Note> notes;
        if (!said.comment.empty()) {
            notes.push_back(
                {Kind::comments, fmt::format("there were only comments, such as {}; if these are rows: --comment none",
                                             quoted(said.comment))});
        }
        if (said.only_header) {
            notes.push_back({Kind::only_header, "the only row was taken for the header; if it is data: --header no"});
        }
        if (said.names.empty()) {
            return notes;
        }
        for (const Part& part : parts_) {
            const auto names = part.of(said.names);
            if (const std::string wrong = wrong_order(part, names); !wrong.empty()) {
                const bool is_error = refuses_ && !error_of_order(part, names).empty();
                notes.push_back(
                    {Kind::order,
                     fmt::format("the header {}{}", wrong, is_error ? " (if it is mislabelled, select by index)" : ""),
                     is_error});
            } else if (part.attitude && is_by_index_ && !find_names(part, names)) {
                add_others(part, names, said.header, notes);
            }
        }
        for (const Part& part : parts_) {
            for (std::size_t i = 0; i < part.names.size(); ++i) {
                const std::string& name = said.names[part.begin + i];
                const auto unit = name_and_unit(name).second;
                if (const std::string told = other_unit(part, i, unit); !told.empty()) {
                    notes.push_back({is_angle(unit) ? Kind::unit : Kind::time_unit,
                                     fmt::format("the header's {} is in {}, but {}", quoted(name), unit, told)});
                }
            }
        }
        return notes;
    }

private:
    /// What is wrong with the order of names; nothing where they are numbers, whose order is not known for sure.
    static std::string error_of_order(const Part& part, std::span<const std::string> names) {
        const auto known = find_names(part, names);
        return known && known->is_numbered ? "" : wrong_order(part, names);
    }

    /// Tells where the header has the names of numbers that are read from other columns.
    static void add_others(const Part& part, std::span<const std::string> names, std::span<const std::string> header,
                           std::vector<stream::Note>& notes) {
        if (const auto others = find_names(part, header); others && !others->is_numbered) {
            const auto& places = others->places;
            const bool is_range = places.back() - places.front() + 1 == places.size() && std::ranges::is_sorted(places);
            notes.push_back(
                {Kind::order,
                 fmt::format("the header has {} at {}, but {} are read", joined(others->of(header)),
                             is_range ? fmt::format("{}-{}", places.front() + 1, places.back() + 1) : others->columns(),
                             joined(names))});
        }
    }

    /// What is to be done about the unit that a header gives to one of the part's numbers, if it is another than that
    /// in which the number is read.
    [[nodiscard]] std::string other_unit(const Part& part, std::size_t at, std::string_view unit) const {
        const bool degrees = unit == "deg";
        if (part.attitude) {
            const Representation& read = representation(part.attitude->name);
            Spec right = *part.attitude;
            right.unit = degrees ? AngleUnit::degrees : AngleUnit::radians;
            return is_angle(unit) && read.has_angles() && at >= read.first_angle && right.unit != part.attitude->unit
                       ? fmt::format("{} reads {}: {}{}", part.attitude->text(), degrees ? "radians" : "degrees",
                                     right.text(), degrees_ ? ", without -d" : "")
                       : "";
        }
        if (part.names.front() == "wx") {
            return is_angle(unit) && degrees != degrees_
                       ? fmt::format("angular velocities are read in {}/s: {} -d", degrees_ ? "deg" : "rad",
                                     degrees ? "add" : "leave out")
                       : "";
        }
        const std::string& name = part.names.front();
        const bool is_time = name == "t" || (name == "key" && !time_unit_.empty());
        const std::string own = time_unit_.empty() ? "s" : time_unit_;
        return is_time && !unit.empty() && !is_angle(unit) && unit != own
                   ? fmt::format("times are read in {}: {} {}", own, time_option_, unit)
                   : "";
    }

    bool degrees_;            ///< angular velocities too
    std::string time_option_; ///< that names the unit
    std::string time_unit_;   ///< empty: keys have none, and times are in seconds
    bool refuses_;            ///< names in another order
    bool is_by_index_;        ///< the columns are selected so, and not by name
    std::vector<Part> parts_; ///< of a row
};

/// The first of the texts that is a change of axes, as an option; nothing where the axes stay as they are.
std::string change_of_axes(std::string_view option,
                           std::initializer_list<std::pair<std::string_view, std::string_view>> pairs) {
    for (const auto& [from, to] : pairs) {
        const std::string change = fmt::format("{}:{}", from, to);
        if (std::holds_alternative<AxesChange>(parse_axes(change))) {
            return from == to ? "" : fmt::format(" {} {}", option, change);
        }
    }
    return "";
}

/// The options that change the axes of --from's project to those of --to's, if no option changes axes.
std::string axes_options(const RowOptions& options) {
    if (options.reference_axes.given() || options.body_axes.given() || options.left.given() || options.right.given()) {
        return "";
    }
    const auto project_of = [](const Option& option) {
        const auto spec = parse_spec(split(option.text(), ',').front()); // all SPECs after -t have the same axes
        return std::holds_alternative<Spec>(spec) ? std::get<Spec>(spec).project : nullptr;
    };
    const Project* const from = project_of(options.from);
    const Project* const to = project_of(options.to);
    if (from == nullptr || to == nullptr) {
        return "";
    }
    // Reference axes that no option can take to others, such as right, up, forward to east, north, up, are those of a
    // body.
    return change_of_axes(
               options.reference_axes.name(),
               {{from->reference, to->reference}, {from->reference, to->body}, {from->body, to->reference}}) +
           change_of_axes(options.body_axes.name(), {{from->body, to->body}});
}

} // namespace

void add_notes(const RowOptions& options, const SelectedColumns& selected, const Option& time_option, bool refuses,
               stream::InputOptions& input) {
    const auto notes = std::make_shared<const Notes>(options, time_option, refuses, input);
    if (refuses && input.columns.has_names()) {
        notes->refuse_other_order(input.columns, selected.option);
    }
    input.notes_of = [notes](const stream::Said& said) { return notes->on(said); };
    input.own_names = [notes](std::vector<std::string> names) { return notes->own_names(std::move(names)); };
}

std::vector<stream::Note> notes_on_options(const RowOptions& options) {
    std::vector<stream::Note> notes;
    if (const std::string change = axes_options(options); !change.empty()) {
        notes.push_back({Kind::axes, fmt::format("{} and {} have different axes, which no SPEC changes:{}",
                                                 options.from.name(), options.to.name(), change)});
    }
    for (const Option* option : {&options.left, &options.right, &options.initial}) {
        if (option->given()) {
            const GivenNumbers read = numbers_of(*option, options.degrees.given());
            if (const double angle = unusual_numbers(read.spec, read.numbers).angle; angle > 0.0) {
                notes.push_back(
                    {Kind::angle, fmt::format("{}: an angle of {:.6g} is read in radians; if it is in degrees: {}",
                                              option->name(), angle, read.spec.in_degrees().text())});
            }
        }
    }
    return notes;
}

} // namespace rotconv::cli
