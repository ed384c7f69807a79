#include <algorithm>
#include <array>
#include <initializer_list>
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

/// The first of a SPEC's numbers that is an angle, as are those after it.
std::size_t first_angle(const Spec& spec) {
    return !representation(spec.name).has_angles() ? spec.size() : spec.name == RepresentationId::axis_angle ? 3 : 0;
}

/// The notes on one stream.
class Notes {
public:
    Notes(const RowOptions& options, const Option& time_option, bool refuses, const stream::InputOptions& input)
        : degrees_(options.degrees.given()), time_option_(time_option.name()),
          refuses_(refuses && input.columns.empty()),
          is_by_index_(!input.columns.empty() && !input.columns.has_names()), units_(input.numbers.names.size()) {
        const std::string& time_unit = (time_option.given() ? time_option : options.time_unit).text();
        const auto& names = input.numbers.names;
        for (std::size_t i = 0; i < names.size(); ++i) {
            const bool is_rate = names[i] == "wx" || names[i] == "wy" || names[i] == "wz";
            const bool is_time = names[i] == "t" || (names[i] == "key" && !time_unit.empty());
            units_[i] = is_rate ? (degrees_ ? "deg" : "rad") : !is_time ? "" : time_unit.empty() ? "s" : time_unit;
        }
        if (input.numbers.attitude) {
            attitudes_.emplace_back(input.numbers.kept, *input.numbers.attitude);
        }
        if (const auto& second = input.numbers.second) {
            attitudes_.emplace_back(names.size() - second->size(), *second);
        }
        for (const auto& [first, spec] : attitudes_) {
            for (std::size_t i = first_angle(spec); i < spec.size(); ++i) {
                units_[first + i] = spec.unit == AngleUnit::degrees ? "deg" : "rad";
            }
        }
        const std::size_t begin = input.numbers.kept + (input.numbers.attitude ? input.numbers.attitude->size() : 0);
        const std::size_t end = names.size() - (input.numbers.second ? input.numbers.second->size() : 0);
        if (begin < end) {
            vector_ = {
                begin,
                {names.begin() + static_cast<std::ptrdiff_t>(begin), names.begin() + static_cast<std::ptrdiff_t>(end)}};
        }
    }

    [[nodiscard]] std::vector<std::string> own_names(std::vector<std::string> names) const {
        for (const auto& [first, spec] : attitudes_) {
            const auto own = std::span(names).subspan(first, spec.size());
            if (const auto known = find_names(spec, own); known && !known->is_numbered) {
                for (std::size_t i = 0; i < own.size(); ++i) {
                    own[known->places[i]] = spec.columns().at(i);
                }
            }
        }
        return mapped(names, [](const std::string& name) { return name_and_unit(name).first; });
    }

    /// Refuses selected names in another order than the SPEC's, which would give a wrong attitude in silence.
    void refuse_other_order(const stream::ColumnList& columns, std::string_view option) const {
        const auto views = columns.names();
        const std::vector<std::string> names(views.begin(), views.end());
        const auto refuse = [&option](const std::string& wrong) {
            if (!wrong.empty()) {
                throw Usage("{} {} (if the file is mislabelled, select by index)", option, wrong);
            }
        };
        refuse(wrong_order(vector_.second, std::span(names).subspan(vector_.first, vector_.second.size())));
        for (const auto& [first, spec] : attitudes_) {
            const std::vector<std::string> own(names.begin() + static_cast<std::ptrdiff_t>(first),
                                               names.begin() + static_cast<std::ptrdiff_t>(first + spec.size()));
            const auto known = find_names(spec, own);
            refuse(known && known->is_numbered ? "" : wrong_order(spec, own));
        }
    }

    [[nodiscard]] std::vector<stream::Note> operator()(const stream::Said& said) const {
        std::vector<stream::Note> notes;
        const auto add = [&notes](Kind kind, const std::string& text, bool ends_run = false) {
            if (!text.empty()) {
                notes.push_back({kind, text, ends_run});
            }
        };
        if (!said.comment.empty()) {
            const std::string comment = quoted(said.comment);
            add(Kind::comments,
                fmt::format("there were only comments, such as {}; if these are rows: --comment none", comment));
        }
        if (said.only_header) {
            add(Kind::only_header, "the only row was taken for the header; if it is data: --header no");
        }
        for (const auto& [first, spec] : attitudes_) {
            if (!said.names.empty()) {
                tell_names(spec, std::span(said.names).subspan(first, spec.size()), said.header, add);
            }
        }
        if (said.names.size() >= vector_.first + vector_.second.size()) {
            add_order(wrong_order(vector_.second, std::span(said.names).subspan(vector_.first, vector_.second.size())),
                      refuses_, add);
        }
        for (std::size_t i = 0; i < said.names.size(); ++i) {
            const auto unit = name_and_unit(said.names[i]).second;
            const std::string& own = units_[i];
            if (!unit.empty() && !own.empty() && unit != own && is_angle(unit) == is_angle(own)) {
                add(is_angle(own) ? Kind::unit : Kind::time_unit,
                    fmt::format("the header's {} is in {}, but {}", quoted(said.names[i]), unit, mend(i, unit)));
            }
        }
        return notes;
    }

private:
    template <class Add> static void add_order(const std::string& wrong, bool is_error, const Add& add) {
        if (!wrong.empty()) {
            add(Kind::order,
                fmt::format("the header {}{}", wrong, is_error ? " (if it is mislabelled, select by index)" : ""),
                is_error);
        }
    }

    /// Tells what the names of the columns that are read say, and the header that they are in.
    template <class Add> void tell_names(const Spec& spec, std::span<const std::string> names,
                                         std::span<const std::string> header, const Add& add) const {
        if (const auto known = find_names(spec, names)) {
            add_order(wrong_order(spec, names), refuses_ && !known->is_numbered, add);
        } else if (const auto others = is_by_index_ ? find_names(spec, header) : known;
                   others && !others->is_numbered) {
            const auto& places = others->places;
            const auto last = std::ranges::adjacent_find(places, [](auto one, auto next) { return next != one + 1; });
            add(Kind::order,
                fmt::format(
                    "the header has {} at {}, but {} are read",
                    fmt::join(mapped(places, [&](auto place) { return header[place]; }), ","),
                    last == places.end()
                        ? fmt::format("{}-{}", places.front() + 1, places.back() + 1)
                        : fmt::format("{}", fmt::join(mapped(places, [](auto place) { return place + 1; }), ",")),
                    fmt::join(names, ",")));
        }
    }

    [[nodiscard]] std::string mend(std::size_t at, std::string_view unit) const {
        if (!is_angle(unit)) {
            return fmt::format("times are read in {}: {} {}", units_[at], time_option_, unit);
        }
        for (const auto& [first, spec] : attitudes_) {
            if (at >= first && at < first + spec.size()) {
                Spec right = spec;
                right.unit = unit == "deg" ? AngleUnit::degrees : AngleUnit::radians;
                return fmt::format("{} reads {}: {}{}", spec.text(),
                                   spec.unit == AngleUnit::degrees ? "degrees" : "radians", right.text(),
                                   degrees_ ? ", without -d" : "");
            }
        }
        return fmt::format("angular velocities are read in {}/s: {} -d", units_[at],
                           unit == "deg" ? "add" : "leave out");
    }

    bool degrees_;                                            ///< angular velocities too
    std::string time_option_;                                 ///< that names the unit
    bool refuses_;                                            ///< names in another order
    bool is_by_index_;                                        ///< the columns are selected so, and not by name
    std::vector<std::string> units_;                          ///< of each number; empty: not one of those in headers
    std::vector<std::pair<std::size_t, Spec>> attitudes_;     ///< each with the place of its first number
    std::pair<std::size_t, std::vector<std::string>> vector_; ///< the names of a vector or of rates, from that place on
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
        const auto spec = parse_spec(items_of(option.text()).front()); // all SPECs after -t have the same axes
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
    const Notes notes(options, time_option, refuses, input);
    if (refuses && input.columns.has_names()) {
        notes.refuse_other_order(input.columns, selected.option);
    }
    input.notes_of = notes;
    input.own_names = [notes](std::vector<std::string> names) { return notes.own_names(std::move(names)); };
}

std::vector<stream::Note> notes_on_options(const RowOptions& options) {
    std::vector<stream::Note> notes;
    if (const std::string change = axes_options(options); !change.empty()) {
        notes.push_back({Kind::axes, fmt::format("{} and {} have different axes, which no SPEC changes:{}",
                                                 options.from.name(), options.to.name(), change)});
    }
    for (const Option* option : {&options.left, &options.right, &options.initial}) {
        if (option->given()) {
            const GivenNumbers read = options.numbers_of(*option);
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
